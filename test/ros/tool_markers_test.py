#!/usr/bin/python3
"""What rviz is given to draw of the tool: a die above a block that reaches up to z = 0.2."""

import sys
import unittest

import rospy
import rostest
from incision_client import Client, tool_line, tool_pose
from visualization_msgs.msg import Marker, MarkerArray

DIE = 0.5  # [m] its edges; its origin is its middle
ABOVE = (0.1, 0.1, 0.46)  # of the die: it does not touch the block
PRESSING = (0.1, 0.1, 0.44)  # [m]
ON_ITS_SIDE = (0.5 ** 0.5, 0, 0, 0.5 ** 0.5)  # z points to -y
EDGE = [(1, 1, -0.1), (1, 1, 0.1)]  # in the die's frame


def as_tuple(vector):
    return vector.x, vector.y, vector.z


class ToolMarkers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client(tool='die')
        cls.arrays = []
        rospy.Subscriber('/incision/tool_markers', MarkerArray, cls.arrays.append)

    def setUp(self):
        self.client.reset()

    def drawn(self):
        """The markers now, by type."""
        seen = len(self.arrays)
        self.client.wait_for(lambda: len(self.arrays) > seen + 1, 'markers')
        markers = self.arrays[-1].markers
        self.assertEqual({'body'}, {marker.header.frame_id for marker in markers})
        self.assertEqual(len(markers), len({(marker.ns, marker.id) for marker in markers}))
        return {marker.type: marker for marker in markers if marker.action == Marker.ADD}

    def test_no_tool_is_drawn_before_its_first_pose(self):
        self.assertEqual({}, self.drawn())

    def test_a_reset_takes_the_tool_away(self):
        self.client.lead_tool([tool_pose(ABOVE)])
        self.client.wait_for(lambda: Marker.CUBE in self.drawn(), 'the die')
        self.client.reset()
        self.assertEqual({}, self.drawn())

    def test_the_tool_is_drawn_where_it_is(self):
        self.client.lead_tool([tool_pose(ABOVE, ON_ITS_SIDE)])
        self.client.after_steps(10)
        drawn = self.drawn()
        die = drawn[Marker.CUBE]
        self.assertEqual((DIE,) * 3, as_tuple(die.scale))
        self.assertEqual(ABOVE, as_tuple(die.pose.position))
        turn = die.pose.orientation
        for expected, value in zip(ON_ITS_SIDE, (turn.x, turn.y, turn.z, turn.w)):
            self.assertAlmostEqual(expected, value, delta=1e-12)
        ends = sorted(as_tuple(point) for point in drawn[Marker.LINE_LIST].points)
        for expected, end in zip(sorted((ABOVE[0] + x, ABOVE[1] - z, ABOVE[2] + y) for x, y, z in EDGE), ends):
            for a, b in zip(expected, end):
                self.assertAlmostEqual(a, b, delta=1e-12)

    def test_the_force_on_the_tool_is_an_arrow(self):
        self.client.lead_tool(tool_line(ABOVE, PRESSING))
        self.client.wait_for(lambda: Marker.ARROW in self.drawn(), 'the force')
        tail, head = (as_tuple(point) for point in self.drawn()[Marker.ARROW].points)
        self.assertEqual(PRESSING, tail)
        self.assertAlmostEqual(PRESSING[0], head[0], delta=1e-3)
        self.assertAlmostEqual(PRESSING[1], head[1], delta=1e-3)
        self.assertGreater(head[2], PRESSING[2])
        self.client.lead_tool(tool_line(PRESSING, ABOVE))
        self.client.wait_for(lambda: Marker.ARROW not in self.drawn(), 'the force to vanish')


if __name__ == '__main__':
    rospy.init_node('tool_markers_test')
    rostest.rosrun('incision', 'tool_markers', ToolMarkers, sys.argv)
