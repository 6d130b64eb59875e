#!/usr/bin/python3
"""Five thousand messages a second to each of four tools take nothing from the body."""

import contextlib
import statistics
import sys
import unittest

import rospy
import rostest
from flood import leading, passing, poses_sent, process_of, resident_mb, steps_per_second
from incision_client import Client

SECONDS = 10
RATE = 5000  # poses a second to each tool, and as many angles to the jaw
TIME_STEP = 0.01  # [s]
MEMORY = 5  # [MB] the node may grow: the slits and the lists it fills
LED = {'rate': RATE, 'speed': 0.2, 'loop': True}
BESIDE = [[1.2, 0, 0, 0, 0, 0], [1.2, 0.2, 0, 0, 0, 0]]  # the bar
BLADES = {'left': 0.24, 'middle': 0.51, 'right': 0.76}  # x [m] where each cuts


def path(x):
    """Into the bar, and back in the slit."""
    return [[x, -0.05, 0, 0, 0, 0], [x, 0.15, 0, 0, 0, 0]]


class ToolFlood4(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client(tool='forceps')
        cls.pid = process_of('/incision')

    def test_a_flood_for_each_tool(self):
        idle = steps_per_second(self.client, passing(self.client, 3))
        with contextlib.ExitStack() as leaders:
            for name, x in BLADES.items():
                leaders.enter_context(leading(name, path=path(x), **LED))
            leaders.enter_context(leading('forceps', path=BESIDE, jaw=[0.7, 0.2], **LED))
            self.client.wait_for(lambda: {report.label for report in self.client.reports} == set(BLADES),
                                 'the reports of the strokes, after which all is cut')
            memory, seen = resident_mb(self.pid), len(self.client.states)
            sent = {tool: poses_sent(tool) for tool in (*BLADES, 'forceps')}
            flooded = steps_per_second(self.client, passing(self.client, SECONDS))
            states = self.client.states[seen:]
            for tool, (first, start) in sent.items():
                last, end = poses_sent(tool)
                self.assertGreater((last - first) / (end - start), 0.95 * RATE, tool)
        self.assertGreater(flooded, 0.9 * idle)
        self.assertLess(resident_mb(self.pid) - memory, MEMORY)
        self.assertEqual((0, len(BLADES)), (states[-1].rejected_overflow, states[-1].cracks))
        for index in range(len(states[-1].tools)):
            self.check_tool([state.tools[index] for state in states])

    def check_tool(self, tools):
        """All were followed, and none had to wait."""
        if tools[0].name in BLADES:
            self.assertGreater(sum(tool.depth > 0 for tool in tools), len(tools) / 4)
            self.assertGreater(sum(tool.depth == 0 for tool in tools), len(tools) / 8)
        else:
            self.assertLess(min(tool.jaw for tool in tools), 0.3)
            self.assertGreater(max(tool.jaw for tool in tools), 0.6)
        self.assertLess(statistics.median(tool.latency for tool in tools), TIME_STEP)
        # A busy machine may hold a sender up for a step, now and then.
        self.assertLess(sum(tool.latency == 0 for tool in tools), len(tools) / 20)
        self.assertEqual((0, 0), (tools[-1].jumps, tools[-1].refused))


if __name__ == '__main__':
    rospy.init_node('tool_flood4_test')
    rostest.rosrun('incision', 'tool_flood4', ToolFlood4, sys.argv)
