#!/usr/bin/python3
"""A node that saves by itself goes on where the one before it was killed, whenever that was."""

import os
import random
import signal
import subprocess
import sys
import tempfile
import time
import unittest

import roslib.packages
import rospy
import rostest
from incision.msg import BodyState
from incision_client import run_to_its_end, wait_for

NODE = roslib.packages.find_node('incision', 'incision_node')[0]
TIME_STEP, PERIOD = 0.01, 0.5  # [s]


class Autosave(unittest.TestCase):
    def setUp(self):
        self.scene = rospy.get_param('~scene')
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.parameters = {'scene': self.scene, 'checkpoint_folder': folder.name, 'autosave': PERIOD, 'restore': 'last'}
        self.folder = folder.name

    def live(self, life):
        """A node that lives for so long [s] after its first state, and is then killed: the steps that it was seen at."""
        rospy.set_param('/mortal', self.parameters)
        node = subprocess.Popen([NODE, '__name:=mortal'])
        states = []
        subscriber = rospy.Subscriber('/mortal/state', BodyState, states.append)
        try:
            wait_for(lambda: states, 'a state')
            deadline = time.monotonic() + life
            wait_for(lambda: time.monotonic() > deadline, 'its end')
        finally:
            node.send_signal(signal.SIGKILL)
            node.wait()
            subscriber.unregister()
        return states[0], states[-1]

    def test_a_node_killed_at_any_moment_is_at_most_a_period_older_than_its_last_checkpoint(self):
        kills = rospy.get_param('~kills')
        draw = random.Random(kills)
        _, last = self.live(1)
        for _ in range(kills):
            first, now = self.live(draw.uniform(0, 2 * PERIOD))
            self.assertLessEqual((last.step - first.step) * TIME_STEP, PERIOD)
            self.assertGreater(first.step, 0)
            last = now
        self.assertGreater(last.step, 100)
        self.assertEqual(3 if last.time > 4.02 else 2, last.pieces)
        names = sorted(os.listdir(self.folder))
        self.assertEqual(['autosave_1.state', 'autosave_2.state'], [name for name in names if not name.endswith('.tmp')])

    def test_a_node_starts_from_a_checkpoint_of_its_scene_or_not_at_all(self):
        self.live(1.5)
        del self.parameters['restore']
        first, _ = self.live(0)
        self.assertLess(first.step, 100)
        for restore, why in (('none', "no checkpoint 'none' (there are: autosave_1"), ('../x', 'no name of a checkpoint')):
            status, said = run_to_its_end(NODE, dict(self.parameters, restore=restore))
            self.assertEqual(1, status)
            self.assertIn(why, said)
        other = dict(self.scene, gravity=[0, 0, 1])
        status, said = run_to_its_end(NODE, dict(self.parameters, scene=other, restore='last'))
        self.assertEqual(1, status)
        self.assertIn('of another scene', said)


if __name__ == '__main__':
    rospy.init_node('autosave_test')
    rostest.rosrun('incision', 'autosave', Autosave, sys.argv)
