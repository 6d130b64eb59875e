#!/usr/bin/python3
"""Messages that are no commands leave the body's state as it is, and the reports and counters say why."""

import math
import sys
import unittest

import rospy
import rostest
from incision.msg import CutReport
from incision_client import Client, tool_pose

NAN, INF = math.nan, math.inf

BAD_CUTS = {
    'not_finite': [{'point': (NAN, 0, 0)}, {'normal': (INF, 0, 0)}, {'tangent': (0, NAN, 0), 'length': 1},
                   {'length': INF}, {'width': NAN}],
    'out_of_range': [{'normal': (0, 0, 0)}, {'length': -1}, {'width': -1e-3}, {'length': 1e300},
                     {'point': (1e200, 0, 0)}, {'length': 1}, {'tangent': (2, 0, 0), 'width': 1},
                     {'label': 'x' * 65}, {'frame': 'f' * 10000}],
    'no_transform': [{'frame': 'nowhere'}, {'frame': 'no where \u00e9'},
                     {'frame': 'nowhere', 'stamp': rospy.Time(4294967295)}],
}

BAD_POSES = {
    'not_finite': [tool_pose((NAN, 0, 0)), tool_pose((0, 0, 0), (0, 0, 0, NAN)), tool_pose((0, 0, -INF))],
    'out_of_range': [tool_pose((0, 0, 0), (0, 0, 0, 0)), tool_pose((0, 0, 0), (0, 0, 0, 3)), tool_pose((0, 1e300, 0))],
    'no_transform': [tool_pose((0, 0, 0), frame='nowhere')],
}


class BadMessages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()
        cls.client.pause()
        cls.client.reset()

    def rejected(self, kind):
        return getattr(self.client.state, 'rejected_' + kind)

    def test_bad_cuts_change_nothing(self):
        before = self.client.next_state()
        for kind, cuts in BAD_CUTS.items():
            for fields in cuts:
                count = self.rejected(kind)
                report = self.client.cut(**fields)
                self.assertEqual(CutReport.REJECTED, report.status, fields)
                self.assertTrue(report.reason, fields)
                self.assertEqual(1, report.pieces)
                self.client.wait_for(lambda: self.rejected(kind) == count + 1, f'{kind} to count {fields}')
        self.assertEqual(before.state_hash, self.client.next_state().state_hash)

    def test_bad_tool_poses_change_nothing(self):
        before = self.client.next_state()
        for kind, poses in BAD_POSES.items():
            for pose in poses:
                count = self.rejected(kind)
                self.client.move_tool(pose)
                self.client.wait_for(lambda: self.rejected(kind) == count + 1, f'{kind} to count {pose}')
        self.assertEqual(before.state_hash, self.client.next_state().state_hash)

    def test_a_good_cut_still_works(self):
        self.assertEqual(2, self.client.cut(point=(0.51, 0, 0)).pieces)
        self.client.reset()


if __name__ == '__main__':
    rospy.init_node('bad_messages_test')
    rostest.rosrun('incision', 'bad_messages', BadMessages, sys.argv)
