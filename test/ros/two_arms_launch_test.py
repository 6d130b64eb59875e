#!/usr/bin/python3
"""The demo of two arms: what its page says of it."""

import math
import sys
import unittest

import numpy as np
import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import PoseStamped
from incision.msg import CutReport
from incision_client import Client
from std_msgs.msg import Bool

TIMEOUT = 120  # [s] wall time; the demo takes 11 s
WEIGHT = (0.45, 0.57)  # [N] of the lobe, a tenth of the organ, which the cut's place decides
SIDEWAYS = 0.02  # share of the weight: the lobe still swings


def turned(orientation, vector):
    """The vector, turned by the quaternion."""
    axis = np.array([orientation.x, orientation.y, orientation.z])
    vector = np.array([vector.x, vector.y, vector.z])
    twice = 2 * np.cross(axis, vector)
    return vector + orientation.w * twice + np.cross(axis, twice)


class TwoArmsLaunch(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client(tool='forceps')
        cls.done, cls.poses = set(), []
        for node in ('lead_forceps', 'lead_scalpel'):
            rospy.Subscriber(f'/{node}/done', Bool, lambda message, node=node: message.data and cls.done.add(node))
        rospy.Subscriber('/incision/forceps/measured_cp', PoseStamped, cls.poses.append)

    def test_the_lobe_is_cut_off_and_hangs_in_the_jaws(self):
        self.client.wait_for(lambda: len(self.done) == 2, 'the end of both paths', TIMEOUT)
        self.client.wait_for(lambda: self.client.reports, 'the report')
        self.assertEqual([('scalpel', CutReport.APPLIED, 2)],
                         [(report.label, report.status, report.pieces) for report in self.client.reports])
        self.assertGreater(self.client.next_state().max_displacement, 0.05)
        force = self.client.wait_for(self.hanging, 'the lobe to come to rest')
        self.assertTrue(WEIGHT[0] < -force[2] < WEIGHT[1], force)
        self.assertGreater(self.client.tool.gripped, 0)
        state = self.client.state
        self.assertEqual((0, '', [0, 0], [0, 0]), (state.unsettled_steps, state.error, [t.jumps for t in state.tools],
                                                   [t.refused for t in state.tools]))

    def hanging(self):
        """The force [N] on the forceps in the body's frame, once it points down."""
        x, y, z = turned(self.poses[-1].pose.orientation, self.client.wrenches[-1].wrench.force)
        return (x, y, z) if math.hypot(x, y) < -SIDEWAYS * z else None

    def test_the_robots_base_knows_where_the_body_is(self):
        buffer = tf2_ros.Buffer()
        listener = tf2_ros.TransformListener(buffer)
        self.client.wait_for(lambda: buffer.can_transform('robot_base', 'body', rospy.Time()), 'the transform')
        transform = buffer.lookup_transform('robot_base', 'body', rospy.Time()).transform
        self.assertEqual((0.1, 0.2, 0.3), (transform.translation.x, transform.translation.y, transform.translation.z))
        self.assertAlmostEqual(math.sqrt(0.5), transform.rotation.z, delta=1e-6)
        self.assertAlmostEqual(math.sqrt(0.5), transform.rotation.w, delta=1e-6)
        listener.unregister()


if __name__ == '__main__':
    rospy.init_node('two_arms_launch_test')
    rostest.rosrun('incision', 'two_arms_launch', TwoArmsLaunch, sys.argv)
