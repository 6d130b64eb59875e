#!/usr/bin/python3
"""The example for an arm of a da Vinci research kit, with a stand-in that publishes what such an arm does."""

import sys
import unittest

import rospy
import rostest
from geometry_msgs.msg import PoseStamped
from incision_client import Client
from sensor_msgs.msg import JointState

HEIGHT = 0.04  # of the tissue [m]
# Straight down in the arm's base, jaws opening across the tissue: about x by pi, then about the vertical by pi/2, as the
# tissue lies turned by that.
DOWN = (0.7071068, 0.7071068, 0, 0)


class Arm:
    """Publishes where an arm's instrument is and how far its jaws are open, as the arm's own node does."""

    def __init__(self, name):
        self.frame = name + '_base'
        self.pose = rospy.Publisher(name + '/measured_cp', PoseStamped, queue_size=10)
        self.jaw = rospy.Publisher(name + '/jaw/measured_js', JointState, queue_size=10)
        self.height, self.angle = HEIGHT + 0.04, 1.3
        rospy.Timer(rospy.Duration(0.01), self.publish)

    def publish(self, _event):
        pose = PoseStamped()
        pose.header.stamp = rospy.Time.now()
        pose.header.frame_id = self.frame
        pose.pose.position.y = 0.05
        pose.pose.position.z = -0.15 + self.height
        (pose.pose.orientation.x, pose.pose.orientation.y, pose.pose.orientation.z, pose.pose.orientation.w) = DOWN
        self.pose.publish(pose)
        self.jaw.publish(JointState(name=['jaw'], position=[self.angle], velocity=[0], effort=[-0.1]))

    def go(self, height, angle, steps=50):
        """Evenly, in so many hundredths of a second."""
        start = self.height, self.angle
        rate = rospy.Rate(100)
        for i in range(1, steps + 1):
            self.height = start[0] + (height - start[0]) * i / steps
            self.angle = start[1] + (angle - start[1]) * i / steps
            rate.sleep()


class Dvrk(unittest.TestCase):
    def test_the_arms_forceps_grip_the_tissue_and_feel_its_pull(self):
        client = Client(tool='forceps')
        arm = Arm('PSM1')
        client.wait_for(lambda: client.tool.in_place, 'the forceps')
        arm.go(HEIGHT + 0.003, 1.3)
        arm.go(HEIGHT + 0.003, 0)
        client.wait_for(lambda: client.tool.gripped > 1, 'the grip')
        arm.go(HEIGHT + 0.009, 0)
        # Towards the tissue: its jaws point there along z.
        client.wait_for(lambda: client.wrenches[-1].wrench.force.z > 0.1, 'the pull of the tissue')
        self.assertEqual(0, client.tool.refused)


if __name__ == '__main__':
    rospy.init_node('dvrk_test')
    rostest.rosrun('incision', 'dvrk', Dvrk, sys.argv)
