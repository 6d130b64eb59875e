#!/usr/bin/python3
"""Cuts the demo's body: by messages while it moves, then with a blade that follows tool poses."""

import math
import sys
import threading
import time

import rospy
from geometry_msgs.msg import Point, PoseStamped, Quaternion, TransformStamped, Vector3
from incision.msg import BodyState, CutPlane, CutReport
from tf2_ros import StaticTransformBroadcaster
from visualization_msgs.msg import Marker, MarkerArray

BLADE_LENGTH = 0.06    # [m] edge of config/scalpel.urdf, from the link's origin along z
BLADE_WIDTH = 0.012    # [m] along x
REACH = 0.4            # [m] from where the body hangs; what is farther away has fallen off
SLAB = 0.015           # [m] half the thickness of a section
SWEEP = 0.08           # [m] how far to each side of the body the blade starts and ends
SWEEP_SPEED = 0.08     # [m/s]
STARTUP = 60           # [s] wall time to wait for the node
REPORT_TIMEOUT = 20    # [s] wall time
COMMANDS = 4           # the cuts of the demo, the blade's among them
PIECES = 3  # at least: the end and what the blade cuts off come free
SQRT_HALF = math.sqrt(0.5)


def add(a, b, factor=1.0):
    return tuple(x + factor * y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def middle(points):
    """Of the box round the points."""
    return tuple((min(p[i] for p in points) + max(p[i] for p in points)) / 2 for i in range(3))


class Body:
    """What the node says of the body, and the commands it takes."""

    def __init__(self):
        self.reports, self.step_ms, self.factors = [], [], []
        self.applied = 0
        self.state, self._points, self._root = None, [], None
        self._news = threading.Condition()
        self.cuts = rospy.Publisher('incision/cut_plane', CutPlane, queue_size=10)
        self.poses = rospy.Publisher('incision/scalpel/servo_cp', PoseStamped, queue_size=100)
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

    def wait_for(self, condition, timeout=math.inf):
        """False when ROS ends first, or the timeout [s] of wall time."""
        deadline = time.monotonic() + timeout
        with self._news:
            while not condition():
                if rospy.is_shutdown() or time.monotonic() > deadline:
                    return False
                self._news.wait(0.1)
        return True

    def wait_until(self, simulated):
        """Simulated time [s]."""
        return self.wait_for(lambda: self.state.time >= simulated)

    def ready(self):
        return self.state and self._points and self.cuts.get_num_connections() and self.poses.get_num_connections()

    def find_root(self):
        """Where the body hangs from: its held end at small x, which does not move."""
        left = min(p[0] for p in self._points)
        self._root = middle([p for p in self._points if p[0] < left + 0.02])

    def centre(self, share):
        """Centre of the section at a share of the way from the root to the far end, and this way as a unit vector. The
        body sways in the plane y = 0, and so does its way."""
        near = [p for p in self._points if math.dist(p, self._root) < REACH]
        ways = [add(p, self._root, -1) for p in near]
        x, _, z = max(ways, key=lambda way: math.hypot(way[0], way[2]))
        length = math.hypot(x, z)
        way = (x / length, 0, z / length)
        return middle([p for p in near if abs(dot(add(p, self._root, -1), way) - share * length) < SLAB]), way

    def cut(self, label, share, tilt=0.0, side=0.0, size=0.0):
        """Asks for a cut across the body, its plane tilted about the way. With a size it is a square, moved to one side
        along y."""
        centre, way = self.centre(share)
        plane = CutPlane(label=label, point=Point(*add(centre, (0, side, 0))), tangent=Vector3(0, 1, 0),
                         normal=Vector3(*add(way, (0, tilt, 0))), length=size, width=size)
        plane.header.frame_id = self.state.header.frame_id
        self.await_report(lambda: self.cuts.publish(plane))

    def await_report(self, action):
        """Does what leads to a report and logs it."""
        seen = len(self.reports)
        action()
        self.wait_for(lambda: self.reports[seen:], REPORT_TIMEOUT)
        report = next(iter(self.reports[seen:]), None)
        if rospy.is_shutdown():
            return
        if report is None:
            rospy.logerr('%5.2f s: nothing was cut', self.state.time)
        elif report.status != CutReport.APPLIED:
            rospy.logerr('%5.2f s: %s: not cut because %s', self.state.time, report.label, report.reason)
        else:
            self.applied += 1
            rospy.loginfo('%5.2f s: %s: %d elements split, %d freedoms added, pieces now: %d', self.state.time,
                          report.label, report.parts_split, 3 * report.copies_added, report.pieces)

    def draw_blade(self, share):
        """Leads the blade through the body along y, its edge across the way."""
        centre, way = self.centre(share)
        edge = (-way[2], 0, way[0])
        # The blade's x axis, away from its edge, points back along y; then its z axis is turned into the edge.
        half = math.atan2(edge[0], edge[2]) / 2
        orientation = Quaternion(-math.sin(half) * SQRT_HALF, math.sin(half) * SQRT_HALF, -math.cos(half) * SQRT_HALF,
                                 math.cos(half) * SQRT_HALF)
        origin = add(centre, edge, -BLADE_LENGTH / 2)
        start = self.state.time
        while not rospy.is_shutdown() and self.state.time < start + 2 * SWEEP / SWEEP_SPEED:
            self.move_blade(add(origin, (0, SWEEP_SPEED * (self.state.time - start) - SWEEP, 0)), orientation)
            self.wait_for(lambda seen=self.state: self.state is not seen)

    def move_blade(self, position, orientation):
        pose = PoseStamped()
        pose.header.frame_id = self.state.header.frame_id
        pose.pose.position, pose.pose.orientation = Point(*position), orientation
        self.poses.publish(pose)
        self._blade.publish(blade_marker(pose))


def blade_marker(pose):
    """A rectangle, to be seen from both sides."""
    marker = Marker(header=pose.header, ns='blade', type=Marker.TRIANGLE_LIST, pose=pose.pose)
    marker.scale = Vector3(1, 1, 1)
    marker.color.r, marker.color.g, marker.color.b, marker.color.a = 0.6, 0.62, 0.66, 1
    corners = [Point(0, 0, 0), Point(BLADE_WIDTH, 0, 0), Point(BLADE_WIDTH, 0, BLADE_LENGTH), Point(0, 0, BLADE_LENGTH)]
    marker.points = [corners[i] for i in (0, 1, 2, 0, 2, 3, 2, 1, 0, 3, 2, 0)]
    return marker


def show_frame(frame):
    """Makes tf know the body's frame, which rviz asks for."""
    transform = TransformStamped(child_frame_id=frame)
    transform.header.frame_id = 'world'
    transform.header.stamp = rospy.Time.now()
    transform.transform.rotation.w = 1
    broadcaster = StaticTransformBroadcaster()
    broadcaster.sendTransform(transform)
    return broadcaster


def perform(body, duration):
    """The demo itself; times are simulated."""
    body.wait_until(1)
    body.cut('incision while it swings', share=0.35, side=0.05, size=0.09)
    body.wait_until(2)
    body.cut('end', share=0.85, tilt=0.3)
    body.wait_until(4)
    body.await_report(lambda: body.draw_blade(share=0.75))
    body.wait_until(8)
    body.cut('second incision', share=0.6, side=-0.05, size=0.09)
    body.wait_until(duration)


def summary(body):
    state = body.state
    step_ms = sorted(body.step_ms)
    return (f'Summary of the demo after {state.time:.2f} s simulated:\n'
            f'  cuts              {body.applied} of {COMMANDS}\n'
            f'  pieces            {state.pieces}\n'
            f'  crack elements    {state.crack_elements} of {state.elements}\n'
            f'  freedoms          {state.dofs}\n'
            f'  step time         {step_ms[len(step_ms) // 2]:.2f} ms median, {step_ms[-1]:.2f} ms at most\n'
            f'  real-time factor  {sum(body.factors) / len(body.factors):.3f} mean\n')


def main():
    rospy.init_node('demo')
    body = Body()
    if not body.wait_for(body.ready, STARTUP):
        sys.exit('the demo: no body to cut')
    frame = show_frame(body.state.header.frame_id)
    body.find_root()
    perform(body, rospy.get_param('~duration', 15))
    if rospy.is_shutdown():
        sys.exit('the demo: ended before its end')
    print(summary(body), end='', flush=True)
    if body.applied != COMMANDS or body.state.pieces < PIECES:
        sys.exit('the demo: not every cut was applied, or a piece hangs on, see above')
    del frame


if __name__ == '__main__':
    main()
