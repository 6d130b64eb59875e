#!/usr/bin/python3
"""The node that leads a tool along a path."""

import contextlib
import math
import subprocess
import sys
import time
import unittest

import roslib.packages
import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import PoseStamped
from incision_client import run_to_its_end, wait_for
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import JointState
from std_msgs.msg import Bool

NODE = roslib.packages.find_node('incision', 'incision_scalpel')[0]
TIMEOUT = 30   # [s] wall time; far above what ending takes
START = [0.1, -0.2, 0.3, 0, 0, 0]
END = [0.1, 0.2, 0.3, 0, 0, math.pi / 2]  # 0.4 m farther along y
EXACT = 1e-8   # [m], [s]: stamps hold nanoseconds

BAD = {
    'the key path is missing': {},
    "path: '3' (allowed: a list)": {'path': 3},
    'path: a list of 0 (allowed: one waypoint': {'path': []},
    'path.0: a list of 5 (allowed: a list of 6)': {'path': [START[:5]]},
    "path.0.2: '.inf' (allowed: -1e+09 to 1e+09)": {'path': [[0, 0, math.inf, 0, 0, 0]]},
    'path.1: at the position of the waypoint before it': {'path': [START, START[:3] + [1, 0, 0]]},
    "rate: '0.5' (allowed: 1 to 20000)": {'path': [START], 'rate': 0.5},
    "rate: 'fast' (allowed: 1 to 20000)": {'path': [START], 'rate': 'fast'},
    "speed: '0' (allowed: above 0, up to 100)": {'path': [START], 'speed': 0},
    'jaw: a list of 2 (allowed: a list of 1)': {'path': [START], 'jaw': [0.1, 0.2]},
    "jaw.0: '.nan' (allowed: -1e+09 to 1e+09)": {'path': [START], 'jaw': [math.nan]},
    'leg_times: a list of 2 (allowed: a list of 1)': {'path': [START, END], 'leg_times': [1, 2]},
    'leg_times: a list of 1 (allowed: a list of 2)': {'path': [START, END], 'leg_times': [1], 'loop': True},
    "leg_times.0: '-1' (allowed: 0 to 1e+06)": {'path': [START, END], 'leg_times': [-1]},
    'path.2: at the position of the waypoint before it': {'path': [START, END, END], 'leg_times': [1, 0]},
    "loop: '2' (allowed: true, false)": {'path': [START], 'loop': 2},
    "frame: '/body' (allowed: a tf2 frame": {'path': [START], 'frame': '/body'},
    "tool_frame: '' (allowed: text of 1 to": {'path': [START], 'tool_frame': ''},
    'sped: unknown key, did you mean speed?': {'path': [START], 'sped': 1},
}


class Listener:
    """What a scalpel says; its subscribers are there before the scalpel is."""

    def __init__(self):
        self.poses, self.angles, self.done = [], [], []
        self._subscribers = [rospy.Subscriber('/knife/pose', PoseStamped, self.poses.append, tcp_nodelay=True),
                             rospy.Subscriber('/knife/jaw', JointState, self.angles.append, tcp_nodelay=True),
                             rospy.Subscriber('/knife/done', Bool, lambda message: self.done.append(message.data))]

    def close(self):
        for subscriber in self._subscribers:
            subscriber.unregister()


@contextlib.contextmanager
def scalpel(**parameters):
    """A running node, with a listener to it."""
    rospy.set_param('/knife', parameters)
    listener = Listener()
    node = subprocess.Popen([NODE, '__name:=knife'])
    try:
        yield listener
    finally:
        node.terminate()
        node.wait(TIMEOUT)
        listener.close()
        rospy.delete_param('/knife')


def y_of(pose):
    return pose.pose.position.y


def seconds(pose):
    return pose.header.stamp.to_sec()


class Scalpel(unittest.TestCase):
    def check_on_path(self, poses, speed, start):
        """`start`: stamp of the first pose of the path."""
        for pose in poses:
            share = min(speed * (pose.header.stamp - start).to_sec() / 0.4, 1)
            self.assertAlmostEqual(-0.2 + 0.4 * share, y_of(pose), delta=EXACT)
            self.assertAlmostEqual(0.1, pose.pose.position.x, delta=EXACT)
            self.assertAlmostEqual(0.3, pose.pose.position.z, delta=EXACT)
            self.assertAlmostEqual(math.sin(math.pi / 4 * share), pose.pose.orientation.z, delta=EXACT)

    def test_the_path_is_followed_and_its_end_held(self):
        with scalpel(path=[START, END], speed=0.4, rate=200, frame='table') as said:
            wait_for(lambda: True in said.done, 'the end of the path')
            held = len(said.poses)
            wait_for(lambda: len(said.poses) > held + 100, 'the last pose to be repeated')
            self.check_on_path(said.poses, 0.4, said.poses[0].header.stamp)
            self.assertEqual([False, True], said.done)
            self.assertEqual({'table'}, {pose.header.frame_id for pose in said.poses})
            self.assertEqual(-0.2, y_of(said.poses[0]))

    def test_a_leg_takes_its_time_and_the_jaw_turns_on_it(self):
        """The jaw closes in place, goes along open by half, and stays so."""
        with scalpel(path=[START, START, END], jaw=[0.9, 0.1, 0.5], leg_times=[0.5, 1], speed=100, rate=200) as said:
            wait_for(lambda: True in said.done, 'the end of the path')
            held = len(said.angles)
            wait_for(lambda: len(said.angles) > held + 20 and len(said.poses) > held + 20, 'the last angle repeated')
            start = said.poses[0].header.stamp
            for pose, angle in zip(said.poses, said.angles):
                self.assertEqual(pose.header.stamp, angle.header.stamp)
                seconds = (angle.header.stamp - start).to_sec()
                way = min(max(seconds - 0.5, 0), 1)
                self.assertAlmostEqual(-0.2 + 0.4 * way, y_of(pose), delta=EXACT)
                self.assertAlmostEqual(0.9 - 1.6 * min(seconds, 0.5) + 0.4 * way, angle.position[0], delta=EXACT)
            self.assertEqual({(1, 0, 0)}, {(len(angle.position), len(angle.name), len(angle.effort))
                                           for angle in said.angles})

    def test_a_loop_comes_back(self):
        with scalpel(path=[START, END], speed=2, loop=True) as said:
            wait_for(lambda: len(said.poses) > 100, 'poses')  # two rounds and a half
            turns = [a for a, b, c in zip(said.poses, said.poses[1:], said.poses[2:])
                     if (y_of(b) - y_of(a)) * (y_of(c) - y_of(b)) < 0]
            self.assertGreaterEqual(len(turns), 4)
            self.assertNotIn(True, said.done)

    def test_no_pose_of_a_high_rate_is_lost_and_their_stamps_are_exact(self):
        rate, count = 5000, 15000
        with scalpel(path=[START], rate=rate) as said:
            wait_for(lambda: len(said.poses) >= count, 'poses')
            self.assertEqual(list(range(said.poses[0].header.seq, said.poses[0].header.seq + count)),
                             [pose.header.seq for pose in said.poses[:count]])
            first, last = said.poses[0].header.stamp, said.poses[count - 1].header.stamp
            self.assertAlmostEqual((count - 1) / rate, (last - first).to_sec(), delta=EXACT)

    def test_the_tool_is_a_frame_of_tf(self):
        buffer = tf2_ros.Buffer()
        listener = tf2_ros.TransformListener(buffer)
        with scalpel(path=[START], frame='table', tool_frame='edge'):
            wait_for(lambda: buffer.can_transform('table', 'edge', rospy.Time()), 'the transform')
            at = buffer.lookup_transform('table', 'edge', rospy.Time()).transform.translation
            self.assertEqual((0.1, -0.2, 0.3), (at.x, at.y, at.z))
        listener.unregister()

    def test_the_path_follows_the_clock(self):
        """The clock is made quicker than time, then jumps ahead and back: the tool does not."""
        rospy.set_param('/use_sim_time', True)
        clock = rospy.Publisher('/clock', Clock, queue_size=1000, latch=True)
        try:
            with scalpel(path=[START, END], speed=0.04, rate=50) as said:
                for first in (100, 200, 50):
                    self.run_clock(clock, said, first)
                ys = [y_of(pose) for pose in said.poses]
                self.assertEqual(sorted(ys), ys)
                self.assertLess(max(b - a for a, b in zip(ys, ys[1:])), 0.04 / 50 + EXACT)
        finally:
            rospy.delete_param('/use_sim_time')
            clock.unregister()

    def run_clock(self, clock, said, first):
        """Two seconds from `first` [s] on."""
        for tick in range(200):
            clock.publish(Clock(rospy.Time.from_sec(first + 0.01 * tick)))
            if tick == 0:
                wait_for(lambda: said.poses and abs(seconds(said.poses[-1]) - first) < 0.1, 'the first pose')
            time.sleep(0.002)
        wait_for(lambda: seconds(said.poses[-1]) > first + 1.9, 'the last pose')

    def test_bad_parameters_end_the_node(self):
        for said, parameters in BAD.items():
            status, errors = run_to_its_end(NODE, {'rate': 100, **parameters})
            self.assertEqual(1, status, errors)
            self.assertIn('/bad: ' + said, errors)


if __name__ == '__main__':
    rospy.init_node('scalpel_test')
    rostest.rosrun('incision', 'scalpel', Scalpel, sys.argv)
