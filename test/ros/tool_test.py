#!/usr/bin/python3
"""A blade that follows tool poses. It is a wire along z; the bar reaches from y = 0 to y = 0.25."""

import math
import sys
import unittest

import rospy
import rostest
from incision.msg import CutReport
from incision_client import Client, tool_pose

X = 0.51  # where along the bar the blade cuts


class Tool(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()

    def setUp(self):
        self.client.pause()
        self.client.reset()

    def draw(self, poses):
        """Leads the blade along the poses in one step."""
        refused = self.client.state.rejected_not_finite
        for pose in poses:
            self.client.move_tool(pose)
        # Poses come in order: when one that is refused has been counted, those before it have come.
        self.client.move_tool(tool_pose((math.nan, 0, 0)))
        self.client.wait_for(lambda: self.client.state.rejected_not_finite > refused, 'the poses to come')
        self.client.step()
        return self.client.next_state()

    def test_a_stroke_into_the_body_opens_a_slit(self):
        state = self.draw([tool_pose((X, y, 0)) for y in (-0.05, 0.04, 0.12, 0.2)])
        self.assertGreater(state.crack_elements, 0)
        self.assertEqual(1, state.pieces)

    def test_a_stroke_drawn_through_separates(self):
        seen = len(self.client.reports)
        state = self.draw([tool_pose((X, -0.05 + 0.02 * i, 0)) for i in range(20)])
        report = self.client.wait_for(lambda: self.client.reports[seen:], 'the report of the stroke')[0]
        self.assertEqual((CutReport.APPLIED, 2), (report.status, report.pieces), report.reason)
        self.assertEqual(2, state.pieces)

    def test_poses_in_another_direction_of_the_blade_cut_nothing(self):
        """The blade turned along y and led past the bar."""
        before = self.client.next_state()
        self.draw([tool_pose((X, 1.5 + 0.08 * i, 0), (0.5 ** 0.5, 0, 0, 0.5 ** 0.5)) for i in range(20)])
        self.assertEqual(2, self.client.cut(point=(0.26, 0, 0)).pieces)
        self.assertEqual(before.cracks + 1, self.client.next_state().cracks)


if __name__ == '__main__':
    rospy.init_node('tool_test')
    rostest.rosrun('incision', 'tool', Tool, sys.argv)
