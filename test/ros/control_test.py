#!/usr/bin/python3
"""Pause, step and reset."""

import sys
import unittest

import rospy
import rostest
from incision_client import Client


class Control(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()

    def setUp(self):
        self.client.pause()
        self.client.reset()

    def steps(self, count):
        for _ in range(count):
            response = self.client.step()
            self.assertTrue(response.success, response.message)

    def test_steps_go_on_only_while_not_paused(self):
        self.assertEqual(0, self.client.next_state().step)
        self.client.pause(False)
        self.client.wait_for(lambda: self.client.state.step > 10, 'steps')
        self.assertFalse(self.client.step().success)
        self.client.pause()
        state = self.client.next_state()
        self.assertTrue(state.paused)
        self.assertEqual(state.state_hash, self.client.next_state().state_hash)

    def test_one_step_at_a_time(self):
        self.steps(3)
        self.assertEqual((3, 0.03), (self.client.next_state().step, round(self.client.state.time, 12)))

    def test_the_same_commands_after_a_reset_give_the_same_state(self):
        hashes = []
        for _ in range(2):
            self.client.reset()
            self.steps(5)
            self.assertEqual(2, self.client.cut(point=(0.51, 0, 0)).pieces)
            self.steps(5)
            hashes.append(self.client.next_state().state_hash)
        self.assertEqual(hashes[0], hashes[1])

    def test_when_the_cut_comes_matters(self):
        """Or the test above would show nothing."""
        hashes = []
        for before in (5, 6):
            self.client.reset()
            self.steps(before)
            self.client.cut(point=(0.51, 0, 0))
            self.steps(10 - before)
            hashes.append(self.client.next_state().state_hash)
        self.assertNotEqual(hashes[0], hashes[1])

    def test_the_body_keeps_pace_with_wall_time(self):
        self.client.pause(False)
        self.client.wait_for(lambda: self.client.state.time > 1.5, 'a second and a half')
        self.assertAlmostEqual(1, self.client.state.real_time_factor, delta=0.1)


if __name__ == '__main__':
    rospy.init_node('control_test')
    rostest.rosrun('incision', 'control', Control, sys.argv)
