#!/usr/bin/python3
"""A blade that cuts against a resistance. It is a wire along z; the bar reaches from y = 0 to y = 0.25."""

import sys
import unittest

import numpy
import rospy
import rostest
from incision_client import Client, tool_line
from wrench import force, rotation, torque

CUTTING_FORCE = 50  # [N/m] of edge in the tissue
X, WIDTH, HEIGHT = 0.51, 0.25, 0.25  # [m]: where along the bar the blade cuts; the bar's sides along y and z


class ToolResistance(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()

    def draw(self, orientation):
        """The wrenches on the blade while it is drawn through the bar along y, seen from the body's axes."""
        self.client.reset()
        seen = len(self.client.wrenches)
        self.client.lead_tool(tool_line((X, -0.05, 0), (X, WIDTH + 0.05, 0), orientation, 0.0025))
        self.assertEqual(2, self.client.after_steps(20).pieces)
        to_body = rotation(orientation)
        wrenches = self.client.wrenches[seen:]
        self.assertTrue(wrenches)
        self.assertEqual({'tool'}, {wrench.header.frame_id for wrench in wrenches})
        return [(to_body @ force(wrench), to_body @ torque(wrench)) for wrench in wrenches]

    def check_resistance(self, wrenches):
        """The resistance is that of the edge in the tissue, against the way of the blade, and acts at half the bar's
        height. The blade's own axes may be turned about z; its origin is at the bar's bottom."""
        bound = CUTTING_FORCE * HEIGHT
        self.assertLess(max(numpy.linalg.norm(f) for f, _ in wrenches), 1.03 * bound)
        against = [-f[1] for f, _ in wrenches]
        self.assertGreater(max(against), 0.9 * bound)
        # The bar swings a little, but on the whole it is pushed ahead of the blade.
        self.assertGreater(numpy.mean(against), 0.5 * bound)
        f, t = max(wrenches, key=lambda wrench: -wrench[0][1])
        numpy.testing.assert_allclose(t, numpy.cross([0, 0, HEIGHT / 2], f), atol=0.1 * bound * HEIGHT / 2)

    def test_the_tissue_resists_the_blade(self):
        self.check_resistance(self.draw((0, 0, 0, 1)))

    def test_the_resistance_is_told_in_the_blades_frame(self):
        self.check_resistance(self.draw((0, 0, 1, 0)))

    def test_the_blade_is_told_when_it_has_left(self):
        self.draw((0, 0, 0, 1))
        last = self.client.wrenches[-1]
        self.assertFalse(last.header.stamp.is_zero())
        self.assertEqual([0] * 6, [*force(last), *torque(last)])


if __name__ == '__main__':
    rospy.init_node('tool_resistance_test')
    rostest.rosrun('incision', 'tool_resistance', ToolResistance, sys.argv)
