#!/usr/bin/python3
"""A clamp goes where tf has its frame, wherever that stood at first, and stays where tf falls silent."""

import math
import sys
import unittest

import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import TransformStamped
from incision_client import Client
from rosgraph_msgs.msg import Log
from visualization_msgs.msg import MarkerArray


class Clamp(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.arrays, cls.warnings = [], []
        rospy.Subscriber('/rosout', Log, lambda log: cls.warnings.append(log.msg))
        rospy.Subscriber('/incision/markers', MarkerArray, cls.arrays.append)
        cls.client = Client()
        cls.tf = tf2_ros.TransformBroadcaster()

    def send(self, x, angle):
        """Moves the frame to (x, −0.5, 0.3), turned about z."""
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id = 'body', 'hand'
        transform.header.stamp = rospy.Time.now()
        transform.transform.translation.x = x
        transform.transform.translation.y, transform.transform.translation.z = -0.5, 0.3
        transform.transform.rotation.z = math.sin(angle / 2)
        transform.transform.rotation.w = math.cos(angle / 2)
        self.tf.sendTransform(transform)

    def skin(self):
        return [(p.x, p.y, p.z) for p in self.arrays[-1].markers[0].points]

    def misses(self, expected):
        """How far the skin's points are from these at most [m]."""
        return max(math.dist(a, b) for a, b in zip(self.skin(), expected))

    def carried(self, points, x, angle):
        """Where points are that go with the frame, which stood at x = 2 unturned, to (x, −0.5, 0.3) and turned."""
        cos, sin = math.cos(angle), math.sin(angle)
        return [(x + cos * (p - 2) - sin * (q + 0.5), -0.5 + sin * (p - 2) + cos * (q + 0.5), r) for p, q, r in points]

    def test_1_stands_still_before_tf_knows_its_frame_and_says_so(self):
        self.client.wait_for(lambda: self.arrays, 'markers')
        type(self).rest = self.skin()
        self.client.wait_for(lambda: any('"hand" of the clamps stays where it is' in w for w in self.warnings), 'a warning')
        self.assertEqual(0, self.client.next_state().max_displacement)

    def test_2_the_first_transform_moves_nothing(self):
        ahead = self.client.next_state().step + 20

        def waited():
            self.send(2, 0)
            return self.client.state.step > ahead
        self.client.wait_for(waited, '20 steps')
        self.assertEqual(0, self.client.state.max_displacement)

    def test_3_the_whole_bar_goes_rigidly_with_the_frame(self):
        start = self.client.next_state().time

        def arrived():
            share = min((self.client.state.time - start) / 2, 1)
            self.send(2 + 0.1 * share, 0.5 * share)
            return share == 1 and self.misses(self.carried(self.rest, 2.1, 0.5)) < 1e-4
        self.client.wait_for(arrived, 'the bar to be where the frame takes it')
        self.assertEqual('', self.client.state.error)

    def test_4_what_falls_silent_is_said_and_stays(self):
        self.client.wait_for(lambda: any('its last transform is older' in w for w in self.warnings), 'a warning')
        self.client.after_steps(20)
        # Its swing, after it was carried there, dies away.
        self.client.wait_for(lambda: self.misses(self.carried(self.rest, 2.1, 0.5)) < 1e-4, 'the bar to rest there')

    def test_5_after_a_reset_the_frame_begins_where_it_is(self):
        self.client.reset()
        state = self.client.after_steps(20)
        self.assertEqual(0, state.max_displacement)


if __name__ == '__main__':
    rospy.init_node('clamp_test')
    rostest.rosrun('incision', 'clamp', Clamp, sys.argv)
