#!/usr/bin/python3
"""Ten thousand tool poses a second, in the tissue, take nothing from the body."""

import statistics
import sys
import unittest

import rospy
import rostest
from flood import leading, passing, poses_sent, process_of, resident_mb, steps_per_second
from incision_client import Client

SECONDS = 10
RATE = 10000  # poses a second
TIME_STEP = 0.01  # [s]
MEMORY = 5  # [MB] the node may grow: the slit and the lists it fills; the poses alone are 11 MB
PATH = [[0.51, -0.05, 0, 0, 0, 0], [0.51, 0.15, 0, 0, 0, 0]]  # into the bar, and back in the slit


class ToolFlood(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()
        cls.pid = process_of('/incision')

    def test_a_flood_of_poses(self):
        idle = steps_per_second(self.client, passing(self.client, 3))
        with leading('tool', path=PATH, speed=0.2, rate=RATE, loop=True):
            self.client.wait_for(lambda: self.client.reports, 'the report of the stroke, after which all is cut')
            memory, seen = resident_mb(self.pid), len(self.client.states)
            first, start = poses_sent('tool')
            flooded = steps_per_second(self.client, passing(self.client, SECONDS))
            last, end = poses_sent('tool')
            states = self.client.states[seen:]
            tools = [self.client.tool_in(state) for state in states]
            self.assertGreater((last - first) / (end - start), 0.95 * RATE)
        self.assertGreater(flooded, 0.9 * idle)
        self.assertLess(resident_mb(self.pid) - memory, MEMORY)
        # The poses were followed, into the tissue and out of it, and none had to wait.
        self.assertGreater(sum(tool.depth > 0 for tool in tools), len(states) / 4)
        self.assertGreater(sum(tool.depth == 0 for tool in tools), len(states) / 8)
        self.assertLess(statistics.median(tool.latency for tool in tools), TIME_STEP)
        # A busy machine may hold the sender up for a step, now and then.
        self.assertLess(sum(tool.latency == 0 for tool in tools), len(states) / 20)
        self.assertEqual((0, 0), (tools[-1].jumps, states[-1].rejected_overflow))
        self.assertEqual(1, states[-1].cracks)


if __name__ == '__main__':
    rospy.init_node('tool_flood_test')
    rostest.rosrun('incision', 'tool_flood', ToolFlood, sys.argv)
