#!/usr/bin/python3
"""Two bodies side by side know nothing of each other."""

import sys
import unittest

import rospy
import rostest
from incision_client import Client


class Namespaces(unittest.TestCase):
    def test_a_cut_reaches_one_body_only(self):
        left, right = Client('/left/incision'), Client('/right/incision')
        self.assertEqual(2, left.cut(frame='', point=(0.51, 0, 0)).pieces)
        self.assertEqual((2, 1), (left.next_state().pieces, right.next_state().pieces))
        self.assertFalse(right.reports)
        self.assertEqual(('left_body', 'right_body'), (left.state.header.frame_id, right.state.header.frame_id))

    def test_one_pauses_while_the_other_goes_on(self):
        left, right = Client('/left/incision'), Client('/right/incision')
        left.pause()
        step, other = left.next_state().step, right.next_state().step
        right.wait_for(lambda: right.state.step > other + 20, 'steps')
        self.assertEqual(step, left.next_state().step)


if __name__ == '__main__':
    rospy.init_node('namespaces_test')
    rostest.rosrun('incision', 'namespaces', Namespaces, sys.argv)
