#!/usr/bin/python3
"""Where memory runs out again and again a cut is refused, a step fails, a checkpoint is not saved or not restored, each
is told, and the node serves on."""

import os
import signal
import sys
import unittest

import rospy
import rostest
from flood import process_of
from incision.msg import CutReport
from incision_client import Client, checkpoint_service, cut_plane

CUTS = 40


class ShortMemory(unittest.TestCase):
    def test_each_cut_is_answered_once_and_the_node_serves_on(self):
        client, node = Client(), process_of('/incision')
        save, restore = checkpoint_service('save'), checkpoint_service('restore')
        checkpoints = []
        client.pause(False)
        os.kill(node, signal.SIGUSR1)
        for k in range(CUTS):
            label = f'cut {k}'
            client.send(cut_plane(label=label, point=(0.97 - 0.02 * k, 0.1, 0.1), normal=(1, 0.2, 0.1), tangent=(0, 1, 0),
                                  length=0.1, width=0.3))
            client.wait_for(lambda name=label: any(report.label == name for report in client.reports), 'a report')
            checkpoints += [save('whole') for _ in range(10)] + [restore('whole')]
            try:
                client.pause(False)  # a step may have failed
            except rospy.ServiceException:
                pass
        os.kill(node, signal.SIGUSR2)
        client.pause(False)
        client.after_steps(5)
        self.assertEqual('', client.state.error)
        self.assertEqual(CutReport.APPLIED, client.cut(label='last', point=(0.1, 0, 0)).status)
        self.assertEqual(sorted([f'cut {k}' for k in range(CUTS)] + ['last']),
                         sorted(report.label for report in client.reports))
        self.assertEqual({'memory ran out'}, {answer.message for answer in checkpoints if not answer.success})
        refused = [report for report in client.reports if report.status == CutReport.REJECTED]
        self.assertGreater(len(refused), CUTS / 10)
        self.assertEqual({'memory ran out'}, {report.reason for report in refused})
        self.assertEqual(len(refused), client.next_state().rejected_by_body)
        client.reset()
        client.wait_for(lambda: client.state.parts == client.state.elements, 'the body as it was at first')


if __name__ == '__main__':
    rospy.init_node('short_memory_test')
    rostest.rosrun('incision', 'short_memory', ShortMemory, sys.argv)
