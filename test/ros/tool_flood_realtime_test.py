#!/usr/bin/python3
"""Ten thousand tool poses a second, in the tissue, take nothing from the body."""

import contextlib
import statistics
import subprocess
import sys
import time
import unittest
import xmlrpc.client

import roslib.packages
import rospy
import rosgraph
import rostest
from geometry_msgs.msg import PoseStamped
from incision_client import TIMEOUT, Client

SECONDS = 10
RATE = 10000  # poses a second
TIME_STEP = 0.01  # [s]
MEMORY = 5  # [MB] the node may grow: the slit and the lists it fills; the poses alone are 11 MB
PATH = [[0.51, -0.05, 0, 0, 0, 0], [0.51, 0.15, 0, 0, 0, 0]]  # into the bar, and back in the slit


def resident_mb(pid):
    with open(f'/proc/{pid}/status', encoding='ascii') as status:
        return next(int(line.split()[1]) for line in status if line.startswith('VmRSS')) / 1024


@contextlib.contextmanager
def scalpel(**parameters):
    """A node that leads the tool."""
    rospy.set_param('/knife', parameters)
    program = roslib.packages.find_node('incision', 'incision_scalpel')[0]
    node = subprocess.Popen([program, '__name:=knife', '/knife/pose:=/incision/tool/servo_cp'])
    try:
        yield
    finally:
        node.terminate()
        node.wait(TIMEOUT)


def poses_sent():
    """And when. Listens no longer than it takes, since Python is too slow for all of them."""
    pose = rospy.wait_for_message('/incision/tool/servo_cp', PoseStamped, TIMEOUT)
    return pose.header.seq, time.monotonic()


class ToolFlood(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()
        uri = rosgraph.Master('/tool_flood_test').lookupNode('/incision')
        cls.pid = xmlrpc.client.ServerProxy(uri).getPid('/tool_flood_test')[2]

    def steps_per_second(self, seconds):
        first, start = self.client.next_state().step, time.monotonic()
        self.client.wait_for(lambda: time.monotonic() > start + seconds, 'time to pass', seconds + TIMEOUT)
        return (self.client.next_state().step - first) / (time.monotonic() - start)

    def test_a_flood_of_poses(self):
        idle = self.steps_per_second(3)
        with scalpel(path=PATH, speed=0.2, rate=RATE, loop=True):
            self.client.wait_for(lambda: self.client.reports, 'the report of the stroke, after which all is cut')
            memory, seen = resident_mb(self.pid), len(self.client.states)
            first, start = poses_sent()
            flooded = self.steps_per_second(SECONDS)
            last, end = poses_sent()
            states = self.client.states[seen:]
            tools = [self.client.tool_in(state) for state in states]
            self.assertGreater((last - first) / (end - start), 0.95 * RATE)
        self.assertGreater(flooded, 0.9 * idle)
        self.assertLess(resident_mb(self.pid) - memory, MEMORY)
        # The poses were followed, into the tissue and out of it, and none had to wait.
        self.assertGreater(sum(tool.depth > 0 for tool in tools), len(states) / 4)
        self.assertGreater(sum(tool.depth == 0 for tool in tools), len(states) / 8)
        self.assertLess(statistics.median(tool.latency for tool in tools), TIME_STEP)
        # A busy machine may hold the sender up for a step, now and then.
        self.assertLess(sum(tool.latency == 0 for tool in tools), len(states) / 20)
        self.assertEqual((0, 0), (tools[-1].jumps, states[-1].rejected_overflow))
        self.assertEqual(1, states[-1].cracks)


if __name__ == '__main__':
    rospy.init_node('tool_flood_test')
    rostest.rosrun('incision', 'tool_flood', ToolFlood, sys.argv)
