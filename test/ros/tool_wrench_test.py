#!/usr/bin/python3
"""What a pressed block does to the die that presses it. The block is held at its bottom."""

import sys
import unittest

import numpy
import rospy
import rostest
from incision_client import Client, tool_line, tool_pose
from wrench import force, rotation, torque

MODULUS, SIDE, ELEMENT = 1e5, 0.2, 0.05  # [Pa], [m], [m]
DIE = 0.25  # [m] from the die's origin to each of its faces
PRESSED = 0.01  # [m] that the die presses the block down by
STIFFNESS = 200  # of contact, in E/h an area
OFF_AXIS = (0.03, -0.02)  # [m] of the die's origin from the block's axis, along x and y
STILL = 1e-5  # of the force that presses: how far that of a block at rest changes
WATCHED = 40  # [steps] in a row for which the force has to hold still: longer than the block's slowest swing

UPRIGHT = (0, 0, 0, 1)
UPSIDE_DOWN = (1, 0, 0, 0)  # z points down, y to the other side
LYING = (0, 0.5 ** 0.5, 0, 0.5 ** 0.5)  # x points down, z along x


class ToolWrench(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client(tool='die')

    def setUp(self):
        self.client.reset()
        self.client.activate_tool(False)
        # The reset ends what the last test was told with a wrench that is not valid.
        self.client.wait_for(lambda: not self.has_wrench(), 'a wrench that is not valid')
        self.seen = len(self.client.wrenches)

    def has_wrench(self):
        return any(not wrench.header.stamp.is_zero() for wrench in self.client.wrenches[-1:])

    def position(self, above):
        """Of the die, when its lower face is that high above the block at rest."""
        return (SIDE / 2 + OFF_AXIS[0], SIDE / 2 + OFF_AXIS[1], SIDE + DIE + above)

    def press(self, orientation):
        """The wrench on the die when it has pressed the block down and all is at rest."""
        down = tool_line(self.position(0.01), self.position(-PRESSED), orientation, 0.001)
        self.client.lead_tool(down)
        self.client.wait_for(lambda: self.stays(down[-1]), 'the block to come to rest')
        return self.client.wrenches[-1]

    def stays(self, pose):
        """Whether the block is pressed and its force steady. Its pose is told again meanwhile, lest the tool become
        stale."""
        self.client.move_tool(pose)
        told = [force(wrench) for wrench in self.client.wrenches[self.seen:][-WATCHED:]]
        pressed = self.client.state.max_displacement > 0.9 * PRESSED
        return pressed and len(told) == WATCHED and numpy.ptp(told, axis=0).max() < STILL * numpy.linalg.norm(told[-1])

    def check_press(self, orientation):
        """Block and contact are two springs in a row: E A / L, and 200 E/h A where h is within a factor 2 of the
        elements' size. The die's origin is off the block's axis, so that the force turns it."""
        linear = MODULUS * SIDE * PRESSED
        least = linear / (1 + 2 * ELEMENT / STIFFNESS / SIDE)
        wrench = self.press(orientation)
        to_body = rotation(orientation)
        in_body = to_body @ force(wrench)
        self.assertGreater(in_body[2], least)
        self.assertLess(in_body[2], linear * 1.0001)
        numpy.testing.assert_allclose(in_body[:2], 0, atol=1e-3 * linear)
        lever = numpy.array([-OFF_AXIS[0], -OFF_AXIS[1], 0])
        numpy.testing.assert_allclose(to_body @ torque(wrench), numpy.cross(lever, in_body),
                                      atol=1e-3 * linear * OFF_AXIS[0])
        self.assertEqual('die', wrench.header.frame_id)

    def test_a_die_that_presses_down_is_pushed_up(self):
        self.check_press(UPRIGHT)
        self.assertGreater(force(self.client.wrenches[-1])[2], 0)

    def test_in_a_tool_frame_that_points_down_the_force_is_negative(self):
        self.check_press(UPSIDE_DOWN)
        self.assertLess(force(self.client.wrenches[-1])[2], 0)

    def test_in_a_tool_frame_that_lies_the_force_is_along_its_x(self):
        self.check_press(LYING)
        self.assertLess(force(self.client.wrenches[-1])[0], 0)

    def test_a_blade_that_is_on_elsewhere_presses_alike(self):
        self.client.activate_tool()
        self.check_press(UPRIGHT)
        self.assertEqual(0, self.client.state.cracks)

    def test_there_is_a_wrench_every_step(self):
        pose = tool_pose(self.position(-PRESSED), UPRIGHT)
        self.press(UPRIGHT)
        wrenches, step = len(self.client.wrenches), self.client.state.step
        self.client.lead_tool([pose] * 50)
        steps = self.client.state.step - step
        # What the two topics bring may be a message or two apart.
        self.assertAlmostEqual(steps, len(self.client.wrenches) - wrenches, delta=3)
        stamps = [wrench.header.stamp for wrench in self.client.wrenches[self.seen:]]
        self.assertEqual(sorted(set(stamps)), stamps)
        self.assertLess(abs((rospy.Time.now() - stamps[-1]).to_sec()), 1)

    def test_a_die_that_touches_nothing_feels_nothing(self):
        self.client.lead_tool(tool_line(self.position(0.05), self.position(0.005), UPRIGHT))
        self.client.after_steps(10)
        told = self.client.wrenches[self.seen:]
        self.assertTrue(told)
        for wrench in told:
            self.assertFalse(wrench.header.stamp.is_zero())
            self.assertEqual([0] * 6, [*force(wrench), *torque(wrench)])

    def test_a_die_that_is_lifted_feels_nothing_any_more(self):
        self.press(UPRIGHT)
        self.assertTrue(numpy.any(force(self.client.wrenches[-1])))
        self.client.lead_tool(tool_line(self.position(-PRESSED), self.position(0.2), UPRIGHT))
        self.client.lead_tool([tool_pose(self.position(0.2), UPRIGHT)] * 10)
        last = self.client.wrenches[-1]
        self.assertFalse(last.header.stamp.is_zero())
        self.assertEqual([0] * 6, [*force(last), *torque(last)])

    def test_before_its_first_pose_and_after_a_reset_there_is_no_wrench(self):
        self.client.after_steps(10)
        self.assertEqual([], self.client.wrenches[self.seen:])
        self.press(UPRIGHT)
        self.client.reset()
        self.client.wait_for(lambda: not self.has_wrench(), 'a wrench that is not valid')


if __name__ == '__main__':
    rospy.init_node('tool_wrench_test')
    rostest.rosrun('incision', 'tool_wrench', ToolWrench, sys.argv)
