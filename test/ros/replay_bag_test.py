#!/usr/bin/python3
"""A bag of all that leads a body gives the node and incision_bag the same state after each step, also one that the page's
script has put in order."""

import csv
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile
import unittest

import genpy
import roslib.packages
import rosbag
import rostest
import rospy
from geometry_msgs.msg import TransformStamped
from incision_client import Client, cut_plane, tool_pose
from sensor_msgs.msg import JointState
from std_msgs.msg import Bool
from tf2_msgs.msg import TFMessage

START, DURATION = 1000.0, 2.0  # [s] of the clock
AHEAD = 0.1  # [s] by which messages come before their stamps: more than a busy machine makes them late
CUTS = {0.303: ('body', 0.81), 0.934: ('table', -0.5), 1.517: ('table', -0.7)}  # stamp: frame, x in it
PACKAGE = roslib.packages.get_pkg_dir('incision')
SCENE = os.path.join(PACKAGE, 'test', 'ros', 'replayed.yaml')
PROGRAM = roslib.packages.find_node('incision', 'incision_bag')[0]


def stamp(time):
    return rospy.Time.from_sec(START + time)


def transform(frame, time, position, turn=0.0):
    result = TransformStamped()
    result.header.stamp = stamp(time)
    result.header.frame_id, result.child_frame_id = 'body', frame
    result.transform.translation.x, result.transform.translation.y, result.transform.translation.z = position
    result.transform.rotation.z, result.transform.rotation.w = math.sin(turn / 2), math.cos(turn / 2)
    return result


def moving(time):
    """The clamp's frame and the ball, which comes to press the tip."""
    ball = (0.95, -0.3 + 0.15 * min(time, 1), 0.125)
    return TFMessage([transform('hand', time, (0.02 * math.sin(4 * time), 0, 0), 0.1 * math.sin(3 * time)),
                      transform('ball', time, ball)])


def knife(time):
    """Drawn through the bar's side, in a frame that stands still."""
    pose = tool_pose((-0.95, -0.05 + 0.15 * time, 0.125), frame='table')
    pose.header.stamp = stamp(time)
    return pose


def jaw(time):
    state = JointState(position=[0.3 * abs(math.sin(5 * time))])
    state.header.stamp = stamp(time)
    return state


def messages():
    """(stamp, topic, message); a switch of the blade, which has no stamp, stands between two poses."""
    all_of_them = [(0, '/tf_static', TFMessage([transform('table', 0, (1.3, 0, 0))]))]
    for k in range(int(100 * DURATION) + 1):
        time = k / 100
        all_of_them.append((time, '/tf', moving(time)))
        if k > 0:  # the first step is taken before the first message has come
            all_of_them += [(time, '/incision/knife/servo_cp', knife(time)), (time, '/incision/forceps/jaw/servo_jp', jaw(time))]
    for time, (frame, x) in CUTS.items():
        all_of_them.append((time, '/incision/cut_plane', cut_plane(frame=frame, stamp=stamp(time), label=str(time),
                                                                     point=(x, 0, 0))))
    for time, active in ((0.705, False), (1.105, True)):
        all_of_them.append((time, '/incision/knife/active', Bool(active)))
    return sorted(all_of_them, key=lambda entry: entry[0])


def write_bag(path, recorded):
    """`recorded` says when a message of that stamp and topic was recorded."""
    with rosbag.Bag(path, 'w') as bag:
        for time, topic, message in sorted(((recorded(time, topic), topic, message) for time, topic, message in messages()),
                                           key=lambda entry: entry[0]):
            bag.write(topic, message, rospy.Time.from_sec(START + max(time, 0)))


def run_bag(path, *options):
    """What incision_bag says in the end, and its hashes by step."""
    with tempfile.NamedTemporaryFile(suffix='.csv') as record:
        run = subprocess.run([PROGRAM, path, SCENE, '--record', record.name, *options], stdout=subprocess.PIPE, check=True,
                             env={**os.environ, 'ROS_MASTER_URI': 'http://localhost:1'})  # needs no master
        with open(record.name, encoding='ascii') as file:
            return json.loads(run.stdout), {int(row['step']): row['state_hash'] for row in csv.DictReader(file)}


class ReplayBag(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.ahead = os.path.join(cls.folder.name, 'ahead.bag')
        write_bag(cls.ahead, lambda time, topic: time - AHEAD)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_the_node_and_incision_bag_take_the_same_steps(self):
        line, expected = run_bag(self.ahead)
        strokes = 2  # the switch ends one, and the end of the bag none
        self.assertEqual((len(CUTS) + strokes, 0, 0), tuple(line['bag']['cuts_' + kind] for kind in ('applied', 'missed', 'rejected')))
        for nothing in ('refused_messages', 'late_commands', 'thinned_poses', 'ignored_transforms', 'skipped_time'):
            self.assertEqual(0, line['bag'][nothing], nothing)
        self.assertGreater(line['tools']['knife']['area'], 0.01)
        self.assertGreater(line['contacts']['count'], 0)

        client = Client(tool='knife')
        client.states.clear()
        subprocess.run(['rosbag', 'play', '--clock', '--quiet', '--wait-for-subscribers', self.ahead], check=True,
                       stdin=subprocess.DEVNULL)
        last = int(100 * (DURATION - AHEAD)) - 2
        client.wait_for(lambda: client.state.step >= last, f'step {last}')
        self.assertEqual((0, 0, 0), (client.state.late_commands, client.state.skipped_time, client.state.thinned_poses))
        played = {state.step: state.state_hash for state in client.states if state.step > 0}
        common = sorted(set(played) & set(expected))
        self.assertGreater(len(common), 0.9 * last)
        self.assertEqual([], [step for step in common if played[step] != expected[step]])
        self.assertEqual(len(expected), len(set(expected.values())))  # or equal hashes would say little

    def test_the_pages_script_puts_a_recorded_bag_in_order(self):
        with open(os.path.join(PACKAGE, 'msg', 'README.md'), encoding='utf-8') as page:
            script = re.search(r'```python\n(import genpy\n.*?)```', page.read(), re.DOTALL).group(1)
        delays = random.Random(1)
        write_bag(os.path.join(self.folder.name, 'commands.bag'),
                  lambda time, topic: time + (0.004 + 0.08 * (topic == '/tf') + 0.002 * delays.random()))
        subprocess.run(['/usr/bin/python3', '-c', script], cwd=self.folder.name, check=True)
        write_bag(os.path.join(self.folder.name, 'in_time.bag'), lambda time, topic: time)
        recorded, exact, in_time = (run_bag(os.path.join(self.folder.name, name + '.bag'), '--steps', '190')
                                    for name in ('commands', 'exact', 'in_time'))
        self.assertEqual(in_time[1], exact[1])
        self.assertEqual(in_time[0]['bag'], exact[0]['bag'])
        self.assertNotEqual(in_time[1], recorded[1])  # or there would have been nothing to put in order
        with rosbag.Bag(os.path.join(self.folder.name, 'exact.bag')) as bag:
            self.assertEqual(len(messages()) + 1, bag.get_message_count())  # and the end
            for topic, message, time in bag:
                if topic == '/tf' and message.transforms:
                    self.assertEqual(genpy.Time(time.secs, time.nsecs), message.transforms[0].header.stamp)


if __name__ == '__main__':
    rospy.init_node('replay_bag_test')
    rostest.rosrun('incision', 'replay_bag', ReplayBag, sys.argv)
