#!/usr/bin/python3
"""A body whose steps take longer than their time still answers services."""

import sys
import unittest

import rospy
import rostest
from incision_client import Client, checkpoint_service


class SlowSteps(unittest.TestCase):
    def test_services_are_answered_within_two_steps(self):
        client = Client()
        save = checkpoint_service('save')
        save('first')
        for _ in range(30):
            before = client.next_state()
            answer = save('again')
            self.assertTrue(answer.success, answer.message)
            self.assertLessEqual(answer.step, before.step + 2)
        self.assertLess(client.state.real_time_factor, 0.8)


if __name__ == '__main__':
    rospy.init_node('slow_steps_test')
    rostest.rosrun('incision', 'slow_steps', SlowSteps, sys.argv)
