#!/usr/bin/python3
"""Each cut that is asked for has one report in the end, whatever it waits for and whatever happens meanwhile."""

import collections
import signal
import subprocess
import sys
import unittest

import roslib.packages
import rosnode
import rospy
import rostest
from incision.msg import CutPlane, CutReport
from incision_client import TIMEOUT, Client, cut_plane, wait_for
from rosgraph_msgs.msg import Clock, Log

NODE = roslib.packages.find_node('incision', 'incision_node')[0]
SCENE = {'body': {'grid': {'cells': [2, 1, 1]}}, 'gravity': [0, 0, 0]}
APPLIED, MISSED, REJECTED = CutReport.APPLIED, CutReport.MISSED, CutReport.REJECTED

# The lists of the node.
MOST_CUTS, MOST_TRANSFORMS = 1000, 256


class Answers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.warnings = []
        rospy.Subscriber('/rosout', Log, lambda log: cls.warnings.append(log.msg))
        cls.clock = rospy.Publisher('/clock', Clock, queue_size=100)
        cls.client = Client()
        wait_for(lambda: cls.clock.get_num_connections() >= 2, 'the node to hear the clock')
        cls.now = 100.0

    def setUp(self):
        self.client.pause(False)
        self.client.reset()
        self.client.reports.clear()
        self.warnings.clear()

    def pass_time(self, seconds):
        """The clock goes on, in steps that are no jumps, and the node has seen it."""
        for _ in range(round(20 * seconds)):
            type(self).now += 0.05
            self.clock.publish(Clock(rospy.Time.from_sec(self.now)))
            rospy.rostime.wallsleep(0.001)

    def ahead(self, seconds):
        return rospy.Time.from_sec(self.now + seconds)

    def ask(self, count, **fields):
        labels = [f'{fields.get("frame", "body")} {i}' for i in range(count)]
        for label in labels:
            self.client.send(cut_plane(label=label, **fields))
        return labels

    def answers(self, count, what):
        """The statuses of that many reports by label, when as many have come; each label has one."""
        self.client.wait_for(lambda: len(self.client.reports) >= count, f'{count} reports {what}')
        self.pass_time(0.1)
        self.client.next_state()
        of_label = collections.Counter(report.label for report in self.client.reports)
        self.assertEqual([], [label for label, reports in of_label.items() if reports != 1])
        self.assertEqual(count, len(of_label))
        return {report.label: report.status for report in self.client.reports}

    def test_full_lists_are_answered_at_a_reset(self):
        state = self.client.next_state()
        self.assertEqual((0, 0), (state.waiting_for_step, state.waiting_for_transform))
        labels = self.ask(MOST_CUTS, stamp=self.ahead(1e6)) + self.ask(MOST_TRANSFORMS, frame='nowhere')
        self.client.wait_for(lambda: (self.client.state.waiting_for_step, self.client.state.waiting_for_transform)
                             == (MOST_CUTS, MOST_TRANSFORMS), 'full lists')
        self.assertEqual([], self.client.reports)
        self.client.reset()
        answers = self.answers(len(labels), 'of the reset')
        self.assertEqual({label: REJECTED for label in labels}, answers)
        self.assertEqual({'the body was reset before it took effect'},
                         {report.reason for report in self.client.reports})

    def test_what_the_lists_have_no_room_for_is_answered_at_once(self):
        labels = self.ask(MOST_CUTS + 5, stamp=self.ahead(1e6)) + self.ask(MOST_TRANSFORMS + 5, frame='nowhere')
        self.client.wait_for(lambda: len(self.client.reports) >= 10, '10 reports')
        self.client.reset()
        self.assertEqual(set(labels), set(self.answers(len(labels), 'of the reset')))

    def test_a_pause_answers_cuts_when_the_clock_reaches_them(self):
        self.pass_time(0.1)
        self.client.send(cut_plane(label='reached', stamp=self.ahead(0.5), point=(0.55, 0, 0)))
        self.client.send(cut_plane(label='not reached', stamp=self.ahead(500)))
        self.client.wait_for(lambda: self.client.state.waiting_for_step == 2, 'both to wait')
        self.client.pause()
        self.pass_time(0.4)
        self.client.next_state()
        self.assertEqual([], self.client.reports)
        self.pass_time(0.2)
        self.assertEqual({'reached': APPLIED}, self.answers(1, 'in a pause'))
        self.client.pause(False)
        self.pass_time(0.2)
        self.client.reset()
        self.assertEqual({'reached': APPLIED, 'not reached': REJECTED}, self.answers(2, 'in the end'))

    def test_a_cut_that_waits_long_is_warned_of(self):
        self.pass_time(0.1)
        self.client.send(cut_plane(label='of wall time', stamp=rospy.Time(1764000000)))

        def warning():
            self.pass_time(0.05)
            return [text for text in self.warnings if "the cut 'of wall time' has waited" in text]
        text = self.client.wait_for(warning, 'a warning')[0]
        self.assertIn('is it wall time, while the clock is simulated?', text)
        self.assertEqual(1, self.client.next_state().waiting_for_step)
        self.assertEqual([], self.client.reports)

    def test_a_step_that_fails_loses_no_report(self):
        with self.node('failing', scene={**SCENE, 'gravity': [0, 0, -1e300]}) as node:
            for label, seconds in (('due', 0.01), ('later', 0.5), ('far', 500)):
                node.send(cut_plane(label=label, stamp=self.ahead(seconds), point=(0.4 + seconds / 5 % 1, 0, 0)))
            node.wait_for(lambda: node.state.waiting_for_step == 3, 'the cuts to wait')

            def failed():
                self.pass_time(0.05)
                return node.state.error and node.state.paused
            node.wait_for(failed, 'a step to fail')
            self.pass_time(1)
            node.wait_for(lambda: len(node.reports) >= 2, 'the reports of cuts that are reached')
            node.reset()
            node.wait_for(lambda: len(node.reports) >= 3, 'the report of the other')
            self.assertEqual([('due', APPLIED), ('later', APPLIED), ('far', REJECTED)],
                             [(report.label, report.status) for report in node.reports])

    def node(self, name, **parameters):
        return RunningNode(name, parameters)

    def test_the_end_of_the_node_answers_all_that_waits(self):
        ends = {'interrupted': lambda process, name: process.send_signal(signal.SIGINT),
                'terminated': lambda process, name: process.send_signal(signal.SIGTERM),
                'killed': lambda process, name: rosnode.kill_nodes([name]),
                'replaced': lambda process, name: RunningNode(name[1:], {'scene': SCENE}).start()}
        for name, end in ends.items():
            with self.node(name, scene=SCENE, transform_timeout=60) as node:
                for i in range(MOST_TRANSFORMS):
                    node.send(cut_plane(label=f'far {i}', stamp=self.ahead(1e6)))
                    node.send(cut_plane(label=f'adrift {i}', frame='nowhere'))
                node.wait_for(lambda: (node.state.waiting_for_step, node.state.waiting_for_transform)
                              == (MOST_TRANSFORMS, MOST_TRANSFORMS), 'the cuts to wait')
                new = end(node.process, '/' + name)
                self.assertEqual(0, node.process.wait(TIMEOUT), name)
                node.wait_for(lambda: len(node.reports) >= 2 * MOST_TRANSFORMS, f'the reports of {name}')
                self.assertEqual(2 * MOST_TRANSFORMS, len({report.label for report in node.reports}))
                self.assertEqual(2 * MOST_TRANSFORMS, len(node.reports))
                self.assertEqual({'the node has ended before it took effect'},
                                 {report.reason for report in node.reports})
                if name == 'replaced':
                    new.stop()


class RunningNode(Client):
    """A node of its own, and its client."""

    def __init__(self, name, parameters):
        self._name, self._parameters, self.process = '/' + name, parameters, None

    def start(self):
        rospy.set_param(self._name, self._parameters)
        self.process = subprocess.Popen([NODE, '__name:=' + self._name[1:]])
        return self

    def stop(self):
        if self.process.poll() is None:
            self.process.terminate()
        self.process.wait(TIMEOUT)

    def __enter__(self):
        self.start()
        super().__init__(self._name)
        return self

    def __exit__(self, *_):
        self.stop()


if __name__ == '__main__':
    rospy.init_node('answers_test')
    rostest.rosrun('incision', 'answers', Answers, sys.argv)
