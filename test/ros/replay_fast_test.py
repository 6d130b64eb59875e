#!/usr/bin/python3
"""Of a bag that is played faster than the body keeps up, the node says what it leaves out."""

import subprocess
import sys
import tempfile
import unittest

import rosbag
import rospy
import rostest
from incision_client import Client, tool_pose
from rosgraph_msgs.msg import Log

START, DURATION, POSES = 1000.0, 6.0, 1000  # [s] of the clock, [s], poses a second: more wait than are kept
RATE = 8


def write_bag(path):
    with rosbag.Bag(path, 'w') as bag:
        for k in range(int(DURATION * POSES)):
            time = rospy.Time.from_sec(START + k / POSES)
            pose = tool_pose((2 + 1e-5 * k, 0, 0))
            pose.header.stamp = time
            bag.write('/incision/tool/servo_cp', pose, time)


class ReplayFast(unittest.TestCase):
    def test_what_is_left_out_is_counted_and_said(self):
        warnings = []
        rospy.Subscriber('/rosout', Log, lambda log: warnings.append(log.msg))
        client = Client()
        with tempfile.NamedTemporaryFile(suffix='.bag') as file:
            write_bag(file.name)
            subprocess.run(['rosbag', 'play', '--clock', '--quiet', '--wait-for-subscribers', '--queue=10000', '--rate',
                            str(RATE), file.name], check=True, stdin=subprocess.DEVNULL)
        client.wait_for(lambda: client.state.skipped_time > 0 and client.state.thinned_poses > 0, 'time to be skipped')
        client.wait_for(lambda: any('s of /clock' in text and 'slower' in text for text in warnings), 'a warning of it')
        client.wait_for(lambda: any('are left out so far' in text for text in warnings), 'a warning of poses')
        # What the clock has gone through is what was simulated and what is skipped.
        client.wait_for(lambda: client.state.clock_lag < 0.02, 'the body to catch up')
        state = client.next_state()
        self.assertLess(state.step, 100 * DURATION - 50)
        self.assertAlmostEqual(DURATION, state.time + state.skipped_time, delta=0.2)


if __name__ == '__main__':
    rospy.init_node('replay_fast_test')
    rostest.rosrun('incision', 'replay_fast', ReplayFast, sys.argv)
