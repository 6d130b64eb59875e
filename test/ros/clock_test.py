#!/usr/bin/python3
"""Wherever the clock has been before a reset, the same commands at the same steps after it give the same states."""

import random
import sys
import unittest

import rospy
import rostest
from incision_client import STEPS_A_SECOND, Client, cut_plane, time_of, tool_pose
from rosgraph_msgs.msg import Clock

STEPS = 12
LAST = (1 << 32) * STEPS_A_SECOND - 1000  # ticks that ROS can say, and some less


class ClockJumps(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.clock = rospy.Publisher('/clock', Clock, queue_size=1000)
        cls.client = Client(tool='scalpel')

    def send_clock(self, tick):
        self.clock.publish(Clock(time_of(tick)))

    def run_steps(self, start):
        """From a reset, when the clock stands at a tick: the last hash."""
        self.client.reset()
        for k in range(STEPS):
            pose = tool_pose((0.03, -0.015 + 0.003 * k, 0.01))
            pose.header.stamp = time_of(start + k)
            self.client.move_tool(pose)
        self.client.send(cut_plane(stamp=time_of(start + 5), point=(0.055, 0, 0), normal=(1, 0.1, 0)))
        self.client.wait_for(lambda: self.client.state.waiting_for_step == STEPS + 1, 'the commands to be known')
        for k in range(STEPS):
            self.send_clock(start + k)
        self.client.wait_for(lambda: self.client.state.step == STEPS, f'step {STEPS}')
        return self.client.state.state_hash

    def wander(self, draw, tick):
        """Sends the clock to and fro, and returns where it stands in the end."""
        for _ in range(draw.randint(0, 4)):
            kind = draw.choice(('back', 'forward', 'standing', 'jump', 'start', 'end'))
            tick = {'back': max(1000, tick - draw.randint(1, 10_000)), 'forward': tick + draw.randint(1, 50),
                    'standing': tick, 'jump': draw.randint(1000, LAST), 'start': 0, 'end': LAST}[kind]
            for _ in range(draw.randint(1, 5)):
                self.send_clock(min(tick, LAST))
                tick += kind == 'forward'
        return tick

    def test_resets_under_a_clock_that_jumps_give_the_same_state(self):
        draw, tick = random.Random(1), 100_000
        first = self.run_steps(tick)
        self.assertGreater(self.client.state.pieces, 1)
        for k in range(rospy.get_param('~rounds')):
            tick = self.wander(draw, tick)
            seen = self.client.next_state()  # so that steps of the way there have been taken
            self.assertEqual('', seen.error)
            tick = min(max(1000, tick + draw.randint(1, 1000)), LAST)
            self.assertEqual(first, self.run_steps(tick), f'round {k}, from tick {tick} on')
            del self.client.states[:-5]


if __name__ == '__main__':
    rospy.init_node('clock_test', disable_rostime=True)
    rostest.rosrun('incision', 'clock', ClockJumps, sys.argv)
