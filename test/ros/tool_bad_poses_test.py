#!/usr/bin/python3
"""Poses that are no poses leave a stroke under way as it is, and the counters tell how many there were."""

import math
import sys
import unittest

import rospy
import rostest
from incision.msg import CutReport
from incision_client import Client, tool_line, tool_pose

NAN, INF = math.nan, math.inf
X = 0.51  # where along the bar the blade cuts; the bar reaches from y = 0 to y = 0.25
BEFORE, INSIDE, BEYOND = -0.05, 0.1, 0.3  # y of the blade [m]
HERE = (X, INSIDE, 0)

BAD = {
    'not_finite': [tool_pose((NAN, 0, 0)), tool_pose((X, INF, 0)), tool_pose((X, 0, -INF)), tool_pose((NAN, NAN, NAN)),
                   tool_pose(HERE, (0, 0, 0, NAN)), tool_pose(HERE, (INF, 0, 0, 1)), tool_pose(HERE, (NAN,) * 4)],
    'out_of_range': [tool_pose(HERE, (0, 0, 0, 0)), tool_pose(HERE, (0, 0, 0, 3)), tool_pose(HERE, (0.5, 0, 0, 0.5)),
                     tool_pose(HERE, (0, 0, 0, 1e-200)), tool_pose(HERE, (1e200, 0, 0, 1)),
                     tool_pose((2e9, 0, 0)), tool_pose((X, -1e300, 0)), tool_pose((X, 0, 1.7e308))],
}
ALL = [(kind, pose) for kind, poses in BAD.items() for pose in poses]


class ToolBadPoses(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()

    def setUp(self):
        self.client.pause(False)
        self.client.reset()
        self.start, self.jumps = self.client.state.header.stamp, self.client.tool.jumps
        self.client.lead_tool(tool_line((X, BEFORE, 0), HERE))
        self.in_body = self.client.after_steps(10)

    def rejected(self):
        return {kind: getattr(self.client.state, 'rejected_' + kind) for kind in BAD}

    def test_they_change_nothing_in_a_body_at_rest(self):
        self.client.pause()
        before = self.client.next_state()
        for kind, pose in ALL:
            count = self.rejected()
            count[kind] += 1
            self.client.move_tool(pose)
            self.client.wait_for(lambda: self.rejected() == count, f'{kind} to count {pose}')
        self.assertEqual(before.state_hash, self.client.next_state().state_hash)

    def test_a_stroke_goes_on_among_them(self):
        """A bad pose with each good one."""
        count = self.rejected()
        for i, pose in enumerate(tool_line(HERE, (X, BEYOND, 0))):
            kind, bad = ALL[i % len(ALL)]
            count[kind] += 1
            self.client.move_tool(bad)
            self.client.lead_tool([pose])
        self.assertEqual(2, self.client.after_steps(10).pieces)
        self.assertEqual([('tool', CutReport.APPLIED, 2)], [(report.label, report.status, report.pieces)
                                                            for report in self.client.reports_after(self.start)])
        self.assertEqual((count, self.jumps), (self.rejected(), self.client.tool.jumps))

    def test_a_tool_far_away_has_jumped(self):
        """As far as a pose may be, which no stroke follows, and back."""
        for position in ((1e9, -1e9, 1e9), (X, BEFORE, 0)):
            self.client.move_tool(tool_pose(position))
            self.client.after_steps(10)
        self.assertEqual(self.jumps + 2, self.client.tool.jumps)
        self.assertEqual((self.in_body.crack_elements, 1), (self.client.state.crack_elements, self.client.state.pieces))
        self.client.lead_tool(tool_line((X, BEFORE, 0), (X, BEYOND, 0)))
        self.assertEqual(2, self.client.after_steps(10).pieces)
        self.assertEqual('', self.client.state.error)


if __name__ == '__main__':
    rospy.init_node('tool_bad_poses_test')
    rostest.rosrun('incision', 'tool_bad_poses', ToolBadPoses, sys.argv)
