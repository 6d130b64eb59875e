#!/usr/bin/python3
"""A bag of commands, some in a moving frame, played twice under its own clock ends in the same state."""

import math
import subprocess
import sys
import tempfile
import unittest

import rosbag
import rospy
import rostest
from geometry_msgs.msg import TransformStamped
from incision_client import Client, cut_plane
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage

START, DURATION = 1000.0, 3.0  # [s] of the clock
CUTS = {0.503: ('body', 0.81), 1.234: ('knife', 0.0), 2.117: ('knife', 0.0)}  # time: frame, x in it


def knife(time):
    """A frame that moves along the bar, from its free end on."""
    transform = TransformStamped()
    transform.header.stamp = rospy.Time.from_sec(START + time)
    transform.header.frame_id = 'body'
    transform.child_frame_id = 'knife'
    transform.transform.translation.x = 0.9 - 0.25 * time
    transform.transform.rotation.z = math.sin(0.1 * time)
    transform.transform.rotation.w = math.cos(0.1 * time)
    return TFMessage([transform])


def write_bag(path):
    messages = [(k / 100, '/clock', Clock(rospy.Time.from_sec(START + k / 100))) for k in range(int(100 * DURATION) + 1)]
    messages += [(k / 20 + 0.001, '/tf', knife(k / 20 + 0.001)) for k in range(int(20 * DURATION))]
    for time, (frame, x) in CUTS.items():
        cut = cut_plane(frame=frame, stamp=rospy.Time.from_sec(START + time), label=str(time), point=(x, 0, 0))
        messages.append((time, '/incision/cut_plane', cut))
    with rosbag.Bag(path, 'w') as bag:
        for time, topic, message in sorted(messages, key=lambda entry: entry[0]):
            bag.write(topic, message, rospy.Time.from_sec(START + time))


class Replay(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()

    def play(self, path, rate):
        """Resets, plays, and returns the hash after each step."""
        self.client.reset()
        self.client.states.clear()
        self.client.reports.clear()
        subprocess.run(['rosbag', 'play', '--quiet', '--wait-for-subscribers', '--rate', str(rate), path], check=True,
                       stdin=subprocess.DEVNULL)
        last = int(100 * DURATION) + 1
        self.client.wait_for(lambda: self.client.state.step == last, f'step {last}')
        self.assertEqual([str(time) for time in CUTS], [report.label for report in self.client.reports])
        self.assertEqual(1 + len(CUTS), self.client.state.pieces)
        self.assertEqual(0, self.client.state.late_commands)
        return {state.step: state.state_hash for state in self.client.states}

    def test_a_bag_played_twice_gives_the_same_state(self):
        with tempfile.NamedTemporaryFile(suffix='.bag') as file:
            write_bag(file.name)
            first, second = self.play(file.name, 1), self.play(file.name, 1.5)
        self.assertEqual(first[max(first)], second[max(second)])
        common = sorted(set(first) & set(second))
        self.assertGreater(len(common), 0.9 * max(first))
        self.assertEqual([first[step] for step in common], [second[step] for step in common])


if __name__ == '__main__':
    rospy.init_node('replay_test')
    rostest.rosrun('incision', 'replay', Replay, sys.argv)
