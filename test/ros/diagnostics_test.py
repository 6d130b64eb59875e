#!/usr/bin/python3
"""What /diagnostics says of a node that is well, and of one that is not."""

import math
import sys
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from dynamic_reconfigure.client import Client as Reconfigure
from incision_client import TIMEOUT, Client, tool_pose, wait_for

OK, WARN, ERROR = DiagnosticStatus.OK, DiagnosticStatus.WARN, DiagnosticStatus.ERROR
TASKS = ('pace', 'numerics', 'input', 'memory')
OUTSIDE = (0.51, -0.05, 0)  # [m] of the bar


class Diagnostics(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.told = []
        rospy.Subscriber('/diagnostics', DiagnosticArray, lambda message: cls.told.extend(message.status))
        cls.client = Client()

    def setUp(self):
        self.client.reset()
        self.client.pause(False)

    def expect(self, task, level, words, node='incision'):
        """Waits for a status from now on."""
        seen = len(self.told)
        name = f'{node}: {task}'
        wait_for(lambda: any(s.name == name and s.level == level and words in s.message for s in self.told[seen:]),
                 f'{name} at {level} with "{words}", not {[s.message for s in self.told if s.name == name][-1:]}')

    def test_a_node_that_is_well_says_so_in_each_task(self):
        for task, words in zip(TASKS, ('in real time', 'sound', 'all was followed', 'MB')):
            self.expect(task, OK, words)
        values = {value.key: value.value for s in self.told if s.name == 'incision: pace' for value in s.values}
        self.assertGreater(float(values['step [ms], mean']), 0)
        self.assertIn('%', values['what takes the time'])

    def test_paused_is_well(self):
        self.client.pause()
        self.expect('pace', OK, 'paused at step')

    def test_a_slow_body_is_warned_of(self):
        self.expect('pace', WARN, 'slower than real time', node='slow')

    def test_refused_messages_are_warned_of_once(self):
        self.client.cut(point=(math.nan, 0, 0))
        self.expect('input', WARN, '1 messages refused')
        self.expect('input', OK, 'all was followed')

    def test_a_stale_tool_is_warned_of(self):
        self.client.move_tool(tool_pose(OUTSIDE))
        self.expect('input', WARN, 'no poses come for tool')

    def test_a_failed_step_is_an_error_until_one_is_taken(self):
        """Weight beyond all numbers."""
        server = Reconfigure('/incision', timeout=TIMEOUT)
        server.update_configuration({'gravity_z': -1e308})
        self.expect('numerics', ERROR, 'a step failed')
        self.expect('pace', OK, 'paused')
        server.update_configuration({'gravity_z': 0.0})
        self.client.pause(False)
        self.expect('numerics', OK, 'sound')


if __name__ == '__main__':
    rospy.init_node('diagnostics_test')
    rostest.rosrun('incision', 'diagnostics', Diagnostics, sys.argv)
