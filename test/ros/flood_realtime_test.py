#!/usr/bin/python3
"""A thousand bad messages a second take nothing from the body."""

import math
import sys
import time
import unittest

import rospy
import rostest
from flood import passing, process_of, resident_mb, steps_per_second
from incision.msg import CutReport
from incision_client import Client, cut_plane

SECONDS = 10
RATE = 1000  # bad messages a second
MEMORY = 5   # [MB] the node may grow: the cuts and the lists it fills; the bad messages alone are 2 MB

BAD = [cut_plane(label='bad', point=(math.nan, 0, 0)), cut_plane(label='bad', normal=(0, 0, 0)),
       cut_plane(label='bad', length=-1), cut_plane(label='bad', frame='nowhere'),
       cut_plane(label='bad' * 30)]


class Flood(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()
        cls.pid = process_of('/incision')

    def flood(self):
        start = time.monotonic()
        for second in range(SECONDS):
            # From the free end on, since what is cut off falls away.
            self.client.send(cut_plane(label=f'good {second}', point=(0.95 - 0.09 * second, 0, 0)))
            for i in range(RATE):
                self.client.send(BAD[i % len(BAD)])
                ahead = start + second + i / RATE - time.monotonic()
                if ahead > 0.01:
                    time.sleep(ahead)

    def test_good_cuts_among_bad_ones(self):
        idle = steps_per_second(self.client, passing(self.client, 3))
        memory = resident_mb(self.pid)
        flooded = steps_per_second(self.client, self.flood)
        self.assertGreater(flooded, 0.9 * idle)
        self.assertLess(resident_mb(self.pid) - memory, MEMORY)
        good = self.client.wait_for(self.good_reports, 'the reports of all good cuts')
        self.assertEqual([CutReport.APPLIED] * SECONDS, [report.status for report in good])
        self.client.wait_for(lambda: self.rejected() == SECONDS * RATE, 'all bad messages to be counted')

    def good_reports(self):
        good = [report for report in self.client.reports if report.label.startswith('good')]
        return good if len(good) == SECONDS else None

    def rejected(self):
        state = self.client.state
        return (state.rejected_not_finite + state.rejected_out_of_range + state.rejected_no_transform
                + state.rejected_overflow)


if __name__ == '__main__':
    rospy.init_node('flood_test')
    rostest.rosrun('incision', 'flood', Flood, sys.argv)
