#!/usr/bin/python3
"""A tool whose poses stop is stale as soon as its time is over."""

import sys
import unittest

import rospy
import rostest
from incision_client import Client, tool_pose

TIMEOUT = 0.3  # [s] tool.timeout of the scene
NOTICED = 0.2  # [s] within which a time-out is noticed: some steps
OUTSIDE = (0.51, -0.05, 0)  # [m] of the bar


class ToolTimeout(unittest.TestCase):
    def test_the_tool_is_stale_when_its_poses_stop(self):
        client = Client()
        seen, last = len(client.states), rospy.Time.now()
        client.move_tool(tool_pose(OUTSIDE))
        client.wait_for(lambda: any(client.tool_in(state).stale for state in client.states[seen:]), 'the tool to be stale')
        stale = next(state for state in client.states[seen:] if client.tool_in(state).stale)
        self.assertGreaterEqual((stale.header.stamp - last).to_sec(), TIMEOUT)
        self.assertLess((stale.header.stamp - last).to_sec(), TIMEOUT + NOTICED)


if __name__ == '__main__':
    rospy.init_node('tool_timeout_realtime_test')
    rostest.rosrun('incision', 'tool_timeout_realtime', ToolTimeout, sys.argv)
