#!/usr/bin/python3
"""A blade that follows tool poses. It is a wire along z; the bar reaches from y = 0 to y = 0.25."""

import sys
import unittest

import rospy
import rostest
from incision.msg import CutReport
from incision_client import Client, tool_line
from visualization_msgs.msg import MarkerArray

X = 0.51  # where along the bar the blade cuts
WIDTH, HEIGHT = 0.25, 0.25  # [m] of the bar along y and along z
STOP = 0.1  # [m] how deep the blade goes that stays in the body; nearer to this side than to any other
ELEMENT = WIDTH / 8  # [m] along y
EXACT = 1e-3  # [m] what rounding to mesh nodes may move a cut face by


class ToolStroke(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()
        cls.arrays = []
        rospy.Subscriber('/incision/markers', MarkerArray, cls.arrays.append)

    def setUp(self):
        self.client.reset()
        self.start = self.client.state.header.stamp

    def draw(self, start, end):
        self.client.lead_tool(tool_line((X, start, 0), (X, end, 0)))
        return self.client.after_steps(10)

    def new_reports(self):
        return self.client.reports_after(self.start)

    def cut_faces(self):
        """Their corners in the deformed body as it is drawn now."""
        seen = len(self.arrays)
        self.client.wait_for(lambda: len(self.arrays) > seen + 1, 'markers')
        return next(marker.points for marker in self.arrays[-1].markers if marker.id == 1)

    def test_a_stroke_into_the_body_opens_a_slit(self):
        state = self.draw(-0.05, STOP)
        self.assertEqual(1, state.pieces)
        self.assertEqual(1, state.cracks)
        self.assertGreater(state.crack_elements, 0)
        self.assertEqual([], self.new_reports())

    def test_the_slit_ends_where_the_blade_stopped(self):
        state = self.draw(-0.05, STOP)
        faces = self.cut_faces()
        self.assertAlmostEqual(STOP, max(point.y for point in faces), delta=ELEMENT)
        self.assertAlmostEqual(0, min(point.y for point in faces), delta=EXACT)
        self.assertAlmostEqual(0, min(point.z for point in faces), delta=EXACT)
        self.assertAlmostEqual(HEIGHT, max(point.z for point in faces), delta=EXACT)
        for point in faces:
            self.assertAlmostEqual(X, point.x, delta=EXACT)
        self.assertAlmostEqual(STOP, self.client.tool_in(state).depth, delta=ELEMENT / 4)
        self.assertAlmostEqual(STOP * HEIGHT, self.client.tool_in(state).area, delta=ELEMENT * HEIGHT / 8)

    def test_a_stroke_that_stops_and_goes_on_is_one(self):
        self.draw(-0.05, STOP)
        self.draw(STOP, WIDTH + 0.05)
        report, = self.new_reports()
        self.assertEqual((CutReport.APPLIED, 'tool', 1, 2),
                         (report.status, report.label, report.cracks, report.pieces), report.reason)

    def test_a_stroke_drawn_through_separates(self):
        state = self.draw(-0.05, WIDTH + 0.05)
        self.assertEqual((1, 2), (state.cracks, state.pieces))
        self.assertEqual(0, self.client.tool_in(state).depth)
        self.assertAlmostEqual(WIDTH * HEIGHT, self.client.tool_in(state).area, delta=0.01 * WIDTH * HEIGHT)
        report, = self.new_reports()
        self.assertEqual((CutReport.APPLIED, 'tool', 1, 2),
                         (report.status, report.label, report.cracks, report.pieces), report.reason)

    def test_the_way_back_through_the_slit_cuts_nothing(self):
        first = self.draw(-0.05, STOP)
        back = self.draw(STOP, -0.05)
        self.assertEqual((first.cracks, first.copies), (back.cracks, back.copies))
        self.assertEqual(['tool'], [report.label for report in self.new_reports()])
        again = self.draw(-0.05, STOP - ELEMENT)
        self.assertEqual((first.cracks, first.copies), (again.cracks, again.copies))

    def test_a_blade_led_past_the_body_cuts_nothing(self):
        """The wire turned along y, so that its end passes the bar by a tenth of a metre."""
        turned = (0.5 ** 0.5, 0, 0, 0.5 ** 0.5)
        self.client.lead_tool(tool_line((X, WIDTH + 0.6, -0.1), (X, WIDTH + 0.6, 0.3), turned))
        state = self.client.after_steps(10)
        tool = self.client.tool_in(state)
        self.assertEqual((0, 0, 0), (state.crack_elements, tool.depth, tool.area))
        self.assertEqual([], self.new_reports())
        # The same wire drawn along the same way, but across the bar: it was the place that cut nothing.
        self.client.lead_tool(tool_line((X, 0.1, -0.1), (X, 0.1, 0.3), turned))
        self.assertEqual(2, self.client.after_steps(10).pieces)


if __name__ == '__main__':
    rospy.init_node('tool_stroke_test')
    rostest.rosrun('incision', 'tool_stroke', ToolStroke, sys.argv)
