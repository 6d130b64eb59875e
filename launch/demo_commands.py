#!/usr/bin/python3
"""Cuts the demo's body: by messages while it moves, then with a blade that follows tool poses."""

import math
import sys
import threading

import rospy
from geometry_msgs.msg import Point, PoseStamped, Vector3
from incision.msg import BodyState, CutPlane, CutReport
from tf2_ros import StaticTransformBroadcaster
from geometry_msgs.msg import TransformStamped
from visualization_msgs.msg import Marker, MarkerArray

BLADE_LENGTH = 0.06    # [m] edge of config/scalpel.urdf, from the link's origin along z
SWEEP = 0.10           # [m] how far to each side of the body the blade starts and ends
SWEEP_SPEED = 0.08     # [m/s]
POSE_RATE = 100        # [Hz]
STARTUP = 60           # [s] wall time to wait for the node


def add(a, b, factor=1.0):
    return tuple(x + factor * y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return tuple(x / math.sqrt(dot(a, a)) for x in a)


def middle(points):
    """Of the box round the points."""
    return tuple((min(p[i] for p in points) + max(p[i] for p in points)) / 2 for i in range(3))


def quaternion(x, y, z):
    """x, y, z, w of the rotation whose columns are three unit vectors; good where its angle is not near 180 degrees."""
    w = math.sqrt(max(1e-12, 1 + x[0] + y[1] + z[2])) / 2
    return ((y[2] - z[1]) / (4 * w), (z[0] - x[2]) / (4 * w), (x[1] - y[0]) / (4 * w), w)


class Body:
    """What the node says of the body, and the commands it takes."""

    def __init__(self):
        self.reports, self.step_ms, self.factors = [], [], []
        self.state, self._points = None, []
        self._news = threading.Condition()
        self.cuts = rospy.Publisher('incision/cut_plane', CutPlane, queue_size=10)
        self.poses = rospy.Publisher('incision/tool_pose', PoseStamped, queue_size=100)
        self._blade = rospy.Publisher('~blade', Marker, queue_size=1)
        rospy.Subscriber('incision/cut_report', CutReport, self.reports.append)
        rospy.Subscriber('incision/state', BodyState, self._keep_state)
        rospy.Subscriber('incision/markers', MarkerArray, self._keep_points, queue_size=1)

    def _keep_state(self, state):
        with self._news:
            self.state = state
            self.step_ms.append(state.step_ms)
            self.factors.append(state.real_time_factor)
            self._news.notify_all()

    def _keep_points(self, array):
        with self._news:
            self._points = [(p.x, p.y, p.z) for marker in array.markers for p in marker.points]
            self._news.notify_all()

    def wait_for(self, condition):
        """False when ROS ends first."""
        with self._news:
            while not condition():
                if rospy.is_shutdown():
                    return False
                self._news.wait(0.1)
        return True

    def wait_until(self, time):
        """Simulated time."""
        return self.wait_for(lambda: self.state and self.state.time >= time)

    def ready(self):
        return self.state and self._points and self.cuts.get_num_connections() and self.poses.get_num_connections()

    def axis(self):
        """Where the body hangs from, and the way from there to its far end as a unit vector and a length. The body's
        own y axis stays level, so this way is taken across it."""
        points = self._points
        left = min(p[0] for p in points)
        root = middle([p for p in points if p[0] < left + 0.02])
        ways = [add(p, root, -1) for p in points]
        x, _, z = max(ways, key=lambda way: math.hypot(way[0], way[2]))
        return root, unit((x, 0, z)), math.hypot(x, z)

    def centre(self, share):
        """Centre of the section at a share of the way, and the way."""
        root, way, length = self.axis()
        slab = [p for p in self._points if abs(dot(add(p, root, -1), way) - share * length) < 0.012]
        return middle(slab), way

    def cut(self, label, share, tilt=0.0, tangent=None, size=0.0):
        """Asks for a cut across the body, the plane tilted about its way; bounded when it has a size."""
        point, way = self.centre(share)
        plane = CutPlane(label=label, point=Point(*point), normal=Vector3(*unit(add(way, (0, 1, 0), tilt))))
        plane.header.frame_id = self.state.header.frame_id
        if tangent:
            plane.tangent, plane.length, plane.width = Vector3(*tangent), size, size
        seen = len(self.reports)
        self.cuts.publish(plane)
        self.wait_for(lambda: len(self.reports) > seen)
        self.say(self.reports[-1])

    def say(self, report):
        outcome = {CutReport.APPLIED: 'cut', CutReport.MISSED: 'missed', CutReport.REJECTED: 'rejected'}[report.status]
        rospy.loginfo('%6.2f s: %s: %s %s (%d parts split, %d pieces now)', self.state.time, report.label or 'stroke',
                      outcome, report.reason, report.parts_split, report.pieces)

    def draw_blade(self, share):
        """Leads the blade through the body along y, its edge across the way."""
        centre, way = self.centre(share)
        y = (0.0, 1.0, 0.0)
        edge = cross(way, y)
        origin = add(centre, edge, -BLADE_LENGTH / 2)
        orientation = quaternion((0.0, -1.0, 0.0), cross(edge, (0.0, -1.0, 0.0)), edge)
        start = self.state.time
        while not rospy.is_shutdown() and self.state.time < start + 2 * SWEEP / SWEEP_SPEED:
            travelled = SWEEP_SPEED * (self.state.time - start) - SWEEP
            self.move_blade(add(origin, y, travelled), orientation)
            rospy.sleep(1 / POSE_RATE)

    def move_blade(self, position, orientation):
        pose = PoseStamped()
        pose.header.frame_id = self.state.header.frame_id
        pose.pose.position = Point(*position)
        (pose.pose.orientation.x, pose.pose.orientation.y, pose.pose.orientation.z, pose.pose.orientation.w) = orientation
        self.poses.publish(pose)
        self._blade.publish(self.blade_marker(pose))
