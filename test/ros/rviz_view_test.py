#!/usr/bin/python3
"""What rviz is started with: a view in which the body is. A program in rviz's place keeps the configuration."""

import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import roslib.packages
import rospy
import rostest
import yaml
from incision_client import TIMEOUT
from visualization_msgs.msg import Marker, MarkerArray

PACKAGE = pathlib.Path(roslib.packages.get_pkg_dir('incision'))
PROGRAM = PACKAGE / 'launch' / 'incision_rviz'
CONFIG = PACKAGE / 'config' / 'incision.rviz'
STATUS = 3  # with which the program in rviz's place ends
ASPECT = 4 / 3


def manager(config):
    return config['Visualization Manager']


def view(config):
    return manager(config)['Views']['Current']


def in_window(points, camera):
    """Of points, where rviz's orbiting camera has them: 1 is the window's edge; not in it what lies behind."""
    yaw, pitch, distance = camera['Yaw'], camera['Pitch'], camera['Distance']
    focus = [camera['Focal Point'][axis] for axis in 'XYZ']
    back = (math.cos(yaw) * math.cos(pitch), math.sin(yaw) * math.cos(pitch), math.sin(pitch))
    right = (-math.sin(yaw), math.cos(yaw), 0)
    up = (back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2],
          back[0] * right[1] - back[1] * right[0])
    slope = math.tan(camera['Field of View'] / 2)
    places = []
    for point in points:
        away = [p - f for p, f in zip(point, focus)]
        x, y, z = (sum(a * b for a, b in zip(away, axis)) for axis in (right, up, back))
        depth = distance - z
        places.append(max(abs(x) / ASPECT, abs(y)) / (depth * slope) if depth > camera['Near Clip Distance'] else math.inf)
    return max(places)


class RvizView(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        array = rospy.wait_for_message('/incision/markers', MarkerArray, TIMEOUT)
        cls.points = [(p.x, p.y, p.z) for marker in array.markers if marker.type == Marker.TRIANGLE_LIST
                      for p in marker.points]

    def start(self, config, *arguments):
        """What rviz gets: its configuration, and its other arguments."""
        with tempfile.TemporaryDirectory() as folder:
            given, kept = os.path.join(folder, 'given.rviz'), os.path.join(folder, 'kept')
            with open(given, 'w') as file:
                yaml.safe_dump(config, file)
            rviz = pathlib.Path(folder, 'rviz')
            rviz.write_text(f'#!/bin/sh\ncp "$2" {kept}\nshift 2\necho "$@" >> {kept}.arguments\nexit {STATUS}\n')
            rviz.chmod(0o755)
            ended = subprocess.run([PROGRAM, '-d', given, *arguments], timeout=TIMEOUT,
                                   env={**os.environ, 'PATH': folder + ':' + os.environ['PATH']})
            self.assertEqual(STATUS, ended.returncode)
            with open(kept) as file, open(kept + '.arguments') as words:
                return yaml.safe_load(file), words.read().split()

    def setUp(self):
        with open(CONFIG) as file:
            self.config = yaml.safe_load(file)

    def test_the_body_fits_the_view_and_fills_most_of_it(self):
        for distance in 0.001, 1000:
            view(self.config)['Distance'] = distance
            shown, arguments = self.start(self.config, '--fullscreen', '__name:=rviz')
            self.assertTrue(0.4 < in_window(self.points, view(shown)) < 1, (distance, view(shown)))
            self.assertEqual(['--fullscreen', '__name:=rviz'], arguments)

    def test_a_view_in_which_the_body_is_well_stays(self):
        view(self.config).update({'Distance': 4, 'Focal Point': {'X': 0.4, 'Y': 0, 'Z': 0}})
        self.assertLess(in_window(self.points, view(self.config)), 1)
        self.assertEqual(self.config, self.start(self.config)[0])

    def test_where_no_body_comes_the_configuration_stays(self):
        self.assertEqual(self.config, self.start(self.config, '/incision/markers:=/nothing')[0])

    def test_a_configuration_with_another_view_stays(self):
        manager(self.config)['Views']['Current'] = {'Class': 'rviz/TopDownOrtho', 'Scale': 10}
        self.assertEqual(self.config, self.start(self.config)[0])

    def test_a_configuration_without_a_body_stays(self):
        manager(self.config)['Displays'] = []
        self.assertEqual(self.config, self.start(self.config)[0])

    def test_the_fixed_frame_is_that_of_the_body_unless_another_was_chosen(self):
        view(self.config)['Distance'] = 1000
        manager(self.config)['Global Options']['Fixed Frame'] = 'base_link'
        shown = self.start(self.config)[0]
        self.assertEqual('base_link', manager(shown)['Global Options']['Fixed Frame'])
        self.assertEqual('body', view(shown)['Target Frame'])


if __name__ == '__main__':
    rospy.init_node('rviz_view_test')
    rostest.rosrun('incision', 'rviz_view', RvizView, sys.argv)
