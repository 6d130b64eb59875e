#!/usr/bin/python3
"""A mesh that a scene names by a relative path is taken from the scene's folder, and the log says what body it is."""

import os
import subprocess
import sys
import unittest

import roslib.packages
import rospy
import rostest
from incision.msg import BodyState

from incision_client import TIMEOUT

NODE = roslib.packages.find_node('incision', 'incision_node')[0]


class SceneFolder(unittest.TestCase):
    def test_relative_paths_are_taken_from_it(self):
        for node in '/by_launch_file', '/by_hand':
            state = rospy.wait_for_message(node + '/state', BodyState, TIMEOUT)
            self.assertGreater(state.elements, 0)
            self.assertEqual(state.nodes, state.held_nodes)

    def test_the_log_tells_the_body(self):
        rospy.set_param('/told', {'scene': {'body': {'grid': {'cells': [1, 1, 1]}}}})
        node = subprocess.Popen([NODE, '__name:=told'], stdout=subprocess.PIPE,
                                env={**os.environ, 'ROSCONSOLE_STDOUT_LINE_BUFFERED': '1'})
        try:
            line = next(line.decode() for line in node.stdout if b'a body of' in line)
            self.assertIn('a body of 6 elements in frame "body", from (0, 0, 0) to (1, 1, 1) m, of 1000 kg, '
                          '0 of its 8 nodes held', line)
        finally:
            node.terminate()
            node.wait(TIMEOUT)


if __name__ == '__main__':
    rospy.init_node('scene_folder_test')
    rostest.rosrun('incision', 'scene_folder', SceneFolder, sys.argv)
