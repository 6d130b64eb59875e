#!/usr/bin/python3
"""What is sent in vain leaves no trace: among a thousand bad cuts and ten thousand poses a second good cuts give, under
one clock, the states that they give alone."""

import itertools
import math
import sys
import threading
import time
import unittest

import rospy
import rostest
from flood import leading
from incision.msg import CutReport
from incision_client import STEPS_A_SECOND, Client, cut_plane, time_of
from rosgraph_msgs.msg import Clock

RATE = 1000  # bad cuts a second
POSES = 10000  # a second of the clock
AHEAD = 20  # steps by which the clock is at most ahead of the body
BESIDE = [[1.5, -0.1, 0, 0, 0, 0], [1.5, 0.3, 0, 0, 0, 0]]  # the bar, and what is cut off it
PACE = 1 / STEPS_A_SECOND  # [s] of a tick; a busy machine takes longer

BAD = [cut_plane(label='bad', point=(math.nan, 0, 0)), cut_plane(label='bad', normal=(0, 0, 0)),
       cut_plane(label='bad', length=-1), cut_plane(label='bad' * 30)]


class FloodUnderAClock(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.clock = rospy.Publisher('/clock', Clock, queue_size=1000)
        cls.client = Client()
        cls.ticks = 100_000
        cls.seconds = rospy.get_param('~seconds')

    def run_cuts(self):
        """A cut a second, from a reset on: the hash after each step."""
        self.client.reset()
        self.client.states[:-1], self.client.reports[:] = [], []
        start, steps = self.ticks + 1, self.seconds * STEPS_A_SECOND
        for second in range(self.seconds):
            # From the free end on, and not along the faces of elements.
            at = 0.97 - 0.94 * second / self.seconds
            self.client.send(cut_plane(stamp=time_of(start + second * STEPS_A_SECOND + 50), label=f'good {second}',
                                       point=(at, 0.1, 0.1), normal=(1, 0.1, 0.05), tangent=(0, 1, 0), length=0.15,
                                       width=0.3))
        self.client.wait_for(lambda: self.client.state.waiting_for_step >= self.seconds, 'the cuts to be known')
        next_tick = time.monotonic()
        for k in range(steps):
            type(self).ticks += 1
            self.clock.publish(Clock(time_of(self.ticks)))
            self.client.wait_for(lambda k=k: self.client.state.step > k - AHEAD, f'step {k - AHEAD + 1}')
            next_tick = max(next_tick + PACE, time.monotonic())
            time.sleep(max(0, next_tick - time.monotonic()))
        self.client.wait_for(lambda: self.client.state.step == steps, f'step {steps}')
        good = self.client.wait_for(self.good_reports, 'the reports of all good cuts')
        self.assertEqual({CutReport.APPLIED}, {report.status for report in good})
        return {state.step: state.state_hash for state in self.client.states if state.step > 0}

    def good_reports(self):
        good = [report for report in self.client.reports if report.label.startswith('good')]
        return good if len(good) == self.seconds else None

    def rejected(self):
        state = self.client.state
        return state.rejected_not_finite + state.rejected_out_of_range

    def flood(self, until):
        """Returns how many bad cuts have been sent."""
        start = time.monotonic()
        for sent in itertools.count():
            if until.is_set():
                return sent
            self.client.send(BAD[sent % len(BAD)])
            ahead = start + sent / RATE - time.monotonic()
            if ahead > 0.01:
                time.sleep(ahead)

    def test_good_cuts_do_as_without_the_bad(self):
        alone = self.run_cuts()
        self.assertEqual(0, self.rejected())
        over, sent = threading.Event(), []
        flooding = threading.Thread(target=lambda: sent.append(self.flood(over)))
        with leading('tool', path=BESIDE, speed=0.2, rate=POSES, loop=True):
            flooding.start()
            try:
                flooded = self.run_cuts()
                self.assertTrue(self.client.tool.in_place)
            finally:
                over.set()
                flooding.join()
        common = sorted(set(alone) & set(flooded))
        self.assertGreater(len(common), 0.9 * len(alone))
        self.assertEqual([alone[step] for step in common], [flooded[step] for step in common])
        self.assertGreater(sent[0], 0.5 * RATE * self.seconds)
        self.client.wait_for(lambda: self.rejected() == sent[0], 'all bad cuts to be counted')


if __name__ == '__main__':
    rospy.init_node('flood_clock_test', disable_rostime=True)
    rostest.rosrun('incision', 'flood_clock', FloodUnderAClock, sys.argv)
