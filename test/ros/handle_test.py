#!/usr/bin/python3
"""The tool and the cut plane that are dragged in rviz; the test stands in for rviz and its user."""

import math
import sys
import time
import unittest

import roslib.packages
import rospy
import rostest
from geometry_msgs.msg import PoseStamped
from incision.msg import CutPlane, CutReport
from incision_client import Client, run_to_its_end, tool_pose
from sensor_msgs.msg import JointState
from std_msgs.msg import Bool
from visualization_msgs.msg import InteractiveMarkerFeedback, InteractiveMarkerInit

NODE = roslib.packages.find_node('incision', 'incision_handle')[0]
UNBOUNDED, RECTANGLE = 'cut along the whole plane', 'cut the rectangle'
SQRT_HALF = math.sqrt(0.5)

BAD = {
    "rate: '0' (allowed: 1 to 1000)": {'rate': 0},
    "tool_size: '-1' (allowed: above 0, up to 1000)": {'tool_size': -1},
    'plane_size: a list of 3 (allowed: a list of 2)': {'plane_size': [1, 1, 1]},
    "plane_pose.3: 'up' (allowed: -1e+09 to 1e+09)": {'plane_pose': [0, 0, 0, 'up', 0, 0]},
    "tool_axis: 'w' (allowed: x, y, z)": {'tool_axis': 'w'},
    "plane: '2' (allowed: true, false)": {'plane': 2},
    'the key jaw_closed is missing': {'jaw_open': 0.5},
    "jaw_closed: '.nan' (allowed: -1e+09 to 1e+09)": {'jaw_open': 0.5, 'jaw_closed': math.nan},
    'plane_sise: unknown key, did you mean plane_size?': {'plane_sise': [1, 1]},
}


def entry_of(marker, title):
    """Number of the menu's entry that ends with this."""
    return next(entry.id for entry in marker.menu_entries if entry.title.endswith(title))


class Handle(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()
        cls.poses, cls.active, cls.planes, cls.shown = [], [], [], []
        rospy.Subscriber('/incision/tool/servo_cp', PoseStamped, cls.poses.append)
        rospy.Subscriber('/incision/tool/active', Bool, lambda message: cls.active.append(message.data))
        rospy.Subscriber('/incision/cut_plane', CutPlane, cls.planes.append)
        rospy.Subscriber('/incision_handle/markers/update_full', InteractiveMarkerInit, cls.shown.append)
        cls.feedback = rospy.Publisher('/incision_handle/markers/feedback', InteractiveMarkerFeedback, queue_size=100)
        cls.client.wait_for(lambda: cls.feedback.get_num_connections() and cls.poses and cls.shown, 'the handle')

    def setUp(self):
        self.client.reset()

    def markers(self):
        return {marker.name: marker for marker in self.shown[-1].markers}

    def drag(self, name, position, orientation=(0, 0, 0, 1), frame='body'):
        pose = tool_pose(position, orientation, frame)
        self.feedback.publish(InteractiveMarkerFeedback(
            header=pose.header, client_id='test', marker_name=name, pose=pose.pose,
            event_type=InteractiveMarkerFeedback.POSE_UPDATE))

    def select(self, name, title):
        self.feedback.publish(InteractiveMarkerFeedback(
            client_id='test', marker_name=name, menu_entry_id=entry_of(self.markers()[name], title),
            event_type=InteractiveMarkerFeedback.MENU_SELECT))

    def wait_for_pose(self, y):
        self.client.wait_for(lambda: self.poses[-1].pose.position.y == y, f'the tool at {y}')

    def report(self, action):
        seen = len(self.client.reports)
        action()
        return self.client.wait_for(lambda: self.client.reports[seen:], 'a report')[0]

    def test_both_can_be_moved_and_turned_in_the_frame_of_the_body(self):
        self.assertEqual({'tool', 'plane'}, set(self.markers()))
        for marker in self.markers().values():
            self.assertEqual('body', marker.header.frame_id)
            self.assertTrue(marker.header.stamp.is_zero())  # or rviz would answer in its own fixed frame
            self.assertEqual(7, len(marker.controls))

    def test_dragging_the_scalpel_cuts(self):
        def drag():
            for step in range(20):
                self.drag('tool', (0.51, -0.05 + 0.02 * step, 0))
                time.sleep(0.02)
        report = self.report(drag)
        self.assertEqual(('tool', CutReport.APPLIED, 2), (report.label, report.status, report.pieces), report.reason)

    def test_the_last_pose_is_repeated(self):
        self.drag('tool', (0.51, -0.2, 0), frame='table')
        self.wait_for_pose(-0.2)
        seen = len(self.poses)
        self.client.wait_for(lambda: len(self.poses) > seen + 5, 'the pose to be repeated')
        self.assertEqual({(-0.2, 'table')}, {(p.pose.position.y, p.header.frame_id) for p in self.poses[seen:]})

    def test_a_pose_that_is_none_is_not_followed(self):
        self.drag('tool', (0.51, -0.3, 0))
        self.wait_for_pose(-0.3)
        self.drag('tool', (0.51, math.nan, 0))
        self.drag('tool', (0.51, -0.4, 0), orientation=(0, 0, 0, 0))
        seen = len(self.poses)
        self.client.wait_for(lambda: len(self.poses) > seen + 5, 'the pose to be repeated')
        self.assertEqual({-0.3}, {p.pose.position.y for p in self.poses[seen:]})

    def test_the_menu_turns_the_blade_off_and_on(self):
        self.assertEqual([True], self.active)
        self.select('tool', 'on')
        self.client.wait_for(lambda: self.active == [True, False], 'the blade to be off')
        self.select('tool', 'on')
        self.client.wait_for(lambda: self.active == [True, False, True], 'the blade to be on')

    def test_the_plane_cuts_where_it_stands(self):
        """Upright across the bar; the rectangle reaches 0.1 m down from the bar's top, and across all of it."""
        upright = (0, SQRT_HALF, 0, SQRT_HALF)
        self.drag('plane', (0.3, 0.125, 0.25), upright)
        slit = self.report(lambda: self.select('plane', RECTANGLE))
        self.assertEqual((CutReport.APPLIED, 1), (slit.status, slit.pieces), slit.reason)
        self.drag('plane', (0.7, 0.125, 0.25), upright)
        cut = self.report(lambda: self.select('plane', UNBOUNDED))
        self.assertEqual((CutReport.APPLIED, 2), (cut.status, cut.pieces), cut.reason)
        self.assertNotEqual(slit.label, cut.label)
        self.client.wait_for(lambda: len(self.planes) == 2, 'both planes')
        first, second = self.planes
        self.assertEqual([(0.2, 0.5), (0, 0)], [(plane.length, plane.width) for plane in (first, second)])
        self.assertEqual((0.3, 0.7), (first.point.x, second.point.x))
        self.assertAlmostEqual(1, first.normal.x, delta=1e-12)
        self.assertAlmostEqual(-1, first.tangent.z, delta=1e-12)

    def test_the_menu_moves_a_jaw_evenly(self):
        shown, angles, planes = [], [], []
        rospy.Subscriber('/jaw_handle/markers/update_full', InteractiveMarkerInit, shown.append)
        rospy.Subscriber('/jaw_handle/jaw', JointState, angles.append)
        rospy.Subscriber('/jaw_handle/cut_plane', CutPlane, planes.append)
        feedback = rospy.Publisher('/jaw_handle/markers/feedback', InteractiveMarkerFeedback, queue_size=10)
        self.client.wait_for(lambda: feedback.get_num_connections() and angles and shown, 'the handle with a jaw')
        self.assertEqual(['tool'], [marker.name for marker in shown[-1].markers])
        self.assertEqual((0.8,), angles[0].position)
        for title, angle in (('jaw closed', 0.2), ('jaw half open', 0.5), ('jaw open', 0.8)):
            seen = len(angles)
            feedback.publish(InteractiveMarkerFeedback(
                client_id='test', marker_name='tool', menu_entry_id=entry_of(shown[-1].markers[0], title),
                event_type=InteractiveMarkerFeedback.MENU_SELECT))
            self.client.wait_for(lambda: abs(angles[-1].position[0] - angle) < 1e-12, title)
            self.check_pace(angles[seen:])

    def check_pace(self, angles):
        """Open to closed takes a second, and none is skipped."""
        for a, b in zip(angles, angles[1:]):
            passed = (b.header.stamp - a.header.stamp).to_sec()
            self.assertLess(abs(b.position[0] - a.position[0]), 0.6 * passed + 1e-9)
            self.assertLess(abs(b.position[0] - a.position[0]), 0.6 / 50 + 1e-9)

    def test_bad_parameters_end_the_node(self):
        for said, parameters in BAD.items():
            status, errors = run_to_its_end(NODE, parameters)
            self.assertEqual(1, status, errors)
            self.assertIn('/bad: ' + said, errors)


if __name__ == '__main__':
    rospy.init_node('handle_test')
    rostest.rosrun('incision', 'handle', Handle, sys.argv)
