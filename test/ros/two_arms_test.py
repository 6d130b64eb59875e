#!/usr/bin/python3
"""Forceps and a blade at one bar, led by messages at the same time."""

import math
import sys
import unittest

import rospy
import rostest
from incision.msg import CutReport
from incision_client import Client, tool_pose
from sensor_msgs.msg import JointState
from std_msgs.msg import Header

NAN, INF = math.nan, math.inf
AT_BAR = (0.106, 0.01, 0.004)    # [m] of the palm: its jaws point against x, round the bar's free end
BACKWARDS = (0, 0, 1, 0)
OPEN, CLOSED = 0.7, 0.2          # [rad]; the latter is that of the scene
CUT_X = 0.052                    # [m] where along the bar the knife cuts
LIFT, PULL = 0.01, 0.01          # [m]
STEPS = 30                       # in which something is led from one place to another

BAD = {
    'not_finite': [JointState(position=[NAN]), JointState(position=[INF]), JointState(name=['jaw'], position=[-INF])],
    'out_of_range': [
        JointState(), JointState(position=[0.3, 0.4]), JointState(name=['jaw'], effort=[1]), JointState(velocity=[1]),
        JointState(name=['jaw', 'tail'], position=[0.3, 0.3]), JointState(name=['jaw', 'jaw'], position=[0.3]),
        JointState(name=['tail'], position=[0.3]), JointState(name=['x' * 10000], position=[0.3]),
        JointState(position=[0.81]), JointState(position=[-0.06]), JointState(position=[-1.7e308]),
        JointState(position=[0.3] * 100000), JointState(header=Header(frame_id='f' * 300), position=[0.3])],
}


def palm(x=0.0, z=0.0):
    """A pose of the forceps, so far from where it holds the bar."""
    return tool_pose((AT_BAR[0] + x, AT_BAR[1], AT_BAR[2] + z), BACKWARDS)


def shares(count=STEPS):
    return [(i + 1) / count for i in range(count)]


class TwoArms(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client(tool='forceps')
        cls.knife = Client(tool='knife')

    def setUp(self):
        self.client.pause(False)
        self.client.activate_tool()
        self.client.reset()
        self.start, self.jumps = self.client.state.header.stamp, self.client.tool.jumps

    def step_with(self, *actions):
        """Does these between two steps of the body."""
        seen = len(self.client.states)
        for action in actions:
            action()
        self.client.wait_for(lambda: len(self.client.states) > seen, 'a step')

    def hold_until(self, condition, what, pose):
        """Repeats the pose, so that the forceps do not go stale."""
        def repeated():
            self.client.move_tool(pose)
            return condition()
        return self.client.wait_for(repeated, what)

    def grip(self):
        """Opens the jaws, puts them round the bar's end, closes them."""
        self.client.move_jaw(OPEN)
        self.client.wait_for(lambda: self.client.tool.jaw == OPEN, 'open jaws')
        for share in shares():
            self.step_with(lambda: self.client.move_tool(palm()),
                           lambda: self.client.move_jaw(OPEN + share * (CLOSED - OPEN)))
        self.hold_until(lambda: self.client.tool.gripped > 0, 'a grip', palm())

    def test_the_jaws_close_on_the_bar_and_tell_of_it(self):
        self.grip()
        for share in shares():
            self.step_with(lambda: self.client.move_tool(palm(x=share * PULL)))
        # The bar pulls back against x, in which the link's x axis points.
        wrench = self.hold_until(lambda: self.client.wrenches[-1].wrench.force.x > 0.5 and self.client.wrenches[-1],
                                 'a force', palm(x=PULL))
        self.assertEqual('palm', wrench.header.frame_id)
        jaw = self.client.jaws[-1]
        self.assertEqual((['jaw'], 1, 1), (jaw.name, len(jaw.position), len(jaw.effort)))
        self.assertAlmostEqual(CLOSED, jaw.position[0], delta=1e-12)
        self.assertGreater(jaw.effort[0], 0)  # the bar presses them open
        self.assertGreater(self.client.next_state().max_displacement, PULL / 2)
        self.client.move_jaw(OPEN)
        self.client.wait_for(lambda: self.client.tool.gripped == 0, 'the grip to end')

    def test_the_bar_is_cut_while_it_is_lifted(self):
        """Both are led in each step; the piece that comes off goes along with the forceps."""
        self.grip()
        for share in shares():
            self.step_with(lambda: self.client.move_tool(palm(z=share * LIFT)),
                           lambda: self.knife.move_tool(tool_pose((CUT_X, -0.02 + 0.06 * share, 0.004))))
        self.hold_until(lambda: self.client.state.pieces == 2, 'two pieces', palm(z=LIFT))
        reports = self.client.wait_for(lambda: self.client.reports_after(self.start), 'the report')
        self.assertEqual([('knife', CutReport.APPLIED, 2)], [(r.label, r.status, r.pieces) for r in reports])
        for share in shares():
            self.step_with(lambda: self.client.move_tool(palm(x=0.06 * share, z=LIFT)))
        self.hold_until(lambda: self.client.state.max_displacement > 0.05, 'the piece to be carried away', palm(0.06, LIFT))
        self.assertGreater(self.client.tool.gripped, 0)
        self.assertEqual((0, self.jumps), (self.client.state.unsettled_steps, self.client.tool.jumps))

    def test_bad_angles_change_nothing(self):
        self.grip()
        self.client.pause()
        before = self.client.next_state()
        refused, jaw = self.client.tool.refused, self.client.tool.jaw
        count = {kind: getattr(before, 'rejected_' + kind) for kind in BAD}
        for kind, messages in BAD.items():
            for message in messages:
                count[kind], refused = count[kind] + 1, refused + 1
                self.client.send_jaw(message)
                self.client.wait_for(
                    lambda: ({k: getattr(self.client.state, 'rejected_' + k) for k in BAD}, self.client.tool.refused) ==
                    (count, refused), f'{kind} to count a message of {len(message.position)} positions')
        self.assertEqual(before.state_hash, self.client.next_state().state_hash)
        self.assertEqual(0, self.knife.tool_in(self.client.state).refused)
        self.client.pause(False)
        after = self.client.after_steps(10)
        self.assertEqual((jaw, ''), (self.client.tool_in(after).jaw, after.error))
        self.assertGreater(self.client.tool_in(after).gripped, 0)

    def test_angles_with_a_name_and_more_are_followed(self):
        for angle, message in ((0.5, JointState(name=['jaw'], position=[0.5])),
                               (0.6, JointState(position=[0.6], velocity=[NAN], effort=[1, 2, 3])),
                               (0.8, JointState(position=[0.8])), (-0.05, JointState(position=[-0.05]))):
            self.client.send_jaw(message)
            self.client.wait_for(lambda: self.client.tool.jaw == angle, f'the jaw at {angle}')

    def test_stale_forceps_hold_still(self):
        self.grip()
        self.client.wait_for(lambda: self.client.tool.stale, 'stale forceps')
        tool = self.client.tool_in(self.client.after_steps(20))
        self.assertEqual((True, True), (tool.in_place, tool.stale))
        self.assertGreater(tool.gripped, 0)
        self.client.wait_for(lambda: self.client.wrenches[-1].header.stamp.is_zero(), 'the wrench of a stale tool')
        self.hold_until(lambda: not self.client.tool.stale, 'the forceps to go on', palm())
        self.assertGreater(self.client.tool.gripped, 0)
        self.assertEqual(self.jumps, self.client.tool.jumps)

    def test_stale_forceps_can_be_opened(self):
        self.grip()
        self.client.wait_for(lambda: self.client.tool.stale, 'stale forceps')
        self.client.move_jaw(OPEN)
        self.client.wait_for(lambda: self.client.tool.gripped == 0, 'the grip to end')
        self.assertTrue(self.client.tool.stale)

    def test_forceps_that_jump_let_go(self):
        self.grip()
        self.client.move_tool(palm(x=0.2))
        self.client.wait_for(lambda: self.client.tool.jumps == self.jumps + 1, 'the jump')
        self.client.wait_for(lambda: self.client.tool.gripped == 0, 'the grip to end')
        self.assertLess(self.client.next_state().max_displacement, 0.05)

    def test_forceps_that_are_switched_off_let_go(self):
        self.grip()
        self.client.activate_tool(False)
        self.client.wait_for(lambda: self.client.tool.gripped == 0, 'the grip to end')
        self.assertEqual(CLOSED, self.client.tool.jaw)


if __name__ == '__main__':
    rospy.init_node('two_arms_test')
    rostest.rosrun('incision', 'two_arms', TwoArms, sys.argv)
