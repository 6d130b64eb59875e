#!/usr/bin/python3
"""A blade that is switched off, whose poses stop, or jump. It is a wire along z; the bar ends at y = 0.25."""

import math
import sys
import unittest

import rospy
import rostest
from incision.msg import CutReport
from incision_client import Client, tool_line, tool_pose

TIMEOUT = 1  # [s] tool.timeout of the scene: far more than lies between two poses on a busy machine
X = 0.51  # where along the bar the blade cuts
BEFORE, INSIDE, DEEPER, BEYOND = -0.05, 0.1, 0.15, 0.3  # y of the blade [m]


def norm(vector):
    return math.hypot(vector.x, vector.y, vector.z)


def of_cuts(state):
    """What every cut changes."""
    return state.cracks, state.crack_elements, state.parts, state.copies


class ToolDropout(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()

    def setUp(self):
        self.client.reset()
        self.client.activate_tool()
        self.start, self.jumps = self.client.state.header.stamp, self.client.tool.jumps

    def draw(self, *ys):
        """Leads the blade from each y to the next."""
        for start, end in zip(ys, ys[1:]):
            self.client.lead_tool(tool_line((X, start, 0), (X, end, 0)))
        return self.client.after_steps(10)

    def check_reports(self, *pieces):
        """One report for each stroke that has ended, with the number of pieces then."""
        reports = self.client.reports_after(self.start)
        self.assertEqual([('tool', CutReport.APPLIED, count) for count in pieces],
                         [(report.label, report.status, report.pieces) for report in reports])

    def jumped(self):
        return self.client.tool.jumps - self.jumps

    def wait_for_stale(self):
        return self.client.wait_for(lambda: self.client.tool.stale and self.client.state, 'the tool to be stale')

    def test_a_blade_that_is_off_cuts_nothing(self):
        self.client.activate_tool(False)
        state = self.draw(BEFORE, BEYOND)
        self.assertEqual((0, 1, 0), (state.crack_elements, state.pieces, self.client.tool_in(state).area))
        self.check_reports()
        self.client.activate_tool()
        self.assertEqual(2, self.draw(BEYOND, BEFORE).pieces)
        self.check_reports(2)

    def test_a_blade_switched_off_in_the_body_ends_its_stroke(self):
        cut = self.draw(BEFORE, INSIDE)
        self.client.activate_tool(False)
        self.client.wait_for(lambda: self.client.reports_after(self.start), 'the report of the stroke')
        self.assertEqual(of_cuts(cut), of_cuts(self.draw(INSIDE, DEEPER, INSIDE)))
        self.check_reports(1)
        self.client.activate_tool()
        self.assertEqual(2, self.draw(INSIDE, BEYOND).pieces)
        self.check_reports(1, 2)

    def test_a_blade_switched_on_in_the_body_cuts_from_there(self):
        self.client.activate_tool(False)
        self.draw(BEFORE, INSIDE)
        self.client.activate_tool()
        state = self.draw(INSIDE, BEYOND)
        self.assertGreater(state.crack_elements, 0)
        self.assertEqual(1, state.pieces)
        self.check_reports(1)

    def test_the_tool_is_not_stale_before_its_time(self):
        self.draw(BEFORE, INSIDE - 0.01)
        seen, last = len(self.client.states), rospy.Time.now()
        self.client.move_tool(tool_pose((X, INSIDE, 0)))
        self.wait_for_stale()
        first = next(state for state in self.client.states[seen:] if self.client.tool_in(state).stale)
        self.assertGreaterEqual((first.header.stamp - last).to_sec(), TIMEOUT)

    def test_a_stale_wrench_is_told_once(self):
        seen = len(self.client.wrenches)
        self.draw(BEFORE, INSIDE)
        self.client.wait_for(lambda: any(w.header.stamp.is_zero() for w in self.client.wrenches[seen:]),
                             'the stale wrench')
        self.wait_for_stale()
        self.client.after_steps(30)
        *good, stale = self.client.wrenches[seen:]
        self.assertTrue(good)
        self.assertFalse(any(wrench.header.stamp.is_zero() for wrench in good))
        self.assertTrue(stale.header.stamp.is_zero())
        self.assertEqual((0, 0), (norm(stale.wrench.force), norm(stale.wrench.torque)))

    def test_a_stale_tool_holds_still_and_goes_on(self):
        cut = self.draw(BEFORE, INSIDE)
        self.wait_for_stale()
        held = self.client.after_steps(30)
        self.assertTrue(self.client.tool_in(held).stale)
        self.assertEqual(of_cuts(cut), of_cuts(held))
        then, now = self.client.tool_in(cut), self.client.tool_in(held)
        self.assertEqual((then.depth, then.area), (now.depth, now.area))
        self.check_reports()
        seen = len(self.client.wrenches)
        self.assertEqual(2, self.draw(INSIDE, BEYOND).pieces)
        self.check_reports(2)
        self.assertTrue(self.client.wrenches[seen:])
        self.assertFalse(any(wrench.header.stamp.is_zero() for wrench in self.client.wrenches[seen:]))
        self.assertEqual(0, self.jumped())

    def test_poses_that_are_refused_do_not_keep_the_tool_alive(self):
        self.draw(BEFORE, INSIDE)

        def stale():
            self.client.move_tool(tool_pose((X, math.nan, 0)))
            return self.client.tool.stale
        self.client.wait_for(stale, 'the tool to be stale')

    def test_a_jump_across_the_body_cuts_nothing(self):
        self.client.lead_tool(tool_line((X, BEFORE - 0.02, 0), (X, BEFORE, 0)))
        state = self.draw(BEYOND, BEYOND + 0.05)
        self.assertEqual((0, 1, 0), (state.crack_elements, state.pieces, self.client.tool_in(state).area))
        self.check_reports()
        self.assertEqual(1, self.jumped())
        self.assertEqual(2, self.draw(BEYOND + 0.05, BEFORE).pieces)
        self.assertEqual(1, self.jumped())

    def test_a_jump_out_of_the_body_ends_the_stroke(self):
        cut = self.draw(BEFORE, INSIDE)
        after = self.draw(BEYOND, BEYOND + 0.05)
        self.assertEqual(of_cuts(cut), of_cuts(after))
        self.assertEqual(0, self.client.tool_in(after).depth)
        self.check_reports(1)
        self.assertEqual(1, self.jumped())

    def test_a_jump_within_the_body_begins_another_stroke(self):
        self.draw(BEFORE, INSIDE)
        self.client.lead_tool(tool_line((X + 0.2, INSIDE, 0), (X + 0.2, BEYOND, 0)))
        state = self.client.after_steps(10)
        self.assertEqual((2, 1), (state.cracks, state.pieces))
        self.check_reports(1, 1)
        self.assertEqual(1, self.jumped())


if __name__ == '__main__':
    rospy.init_node('tool_dropout_test')
    rostest.rosrun('incision', 'tool_dropout', ToolDropout, sys.argv)
