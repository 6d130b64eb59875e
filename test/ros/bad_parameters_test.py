#!/usr/bin/python3
"""With a parameter that it does not know, or one out of range, the node ends at once, in order, and says why."""

import sys
import unittest

import roslib.packages
import rospy
import rostest

from incision_client import run_to_its_end

NODE = roslib.packages.find_node('incision', 'incision_node')[0]

SCENE = {'body': {'grid': {'cells': [1, 1, 1]}}}

BAD = {
    "marker_rat: unknown key, did you mean marker_rate?": {'marker_rat': 15},
    "scene_folder: 'meshes' (allowed: package://NAME/FOLDER or an absolute path)": {'scene_folder': 'meshes'},
    "scene_folder: package no_such_package not found": {'scene_folder': 'package://no_such_package/scenes'},
    "speed: unknown key": {'speed': 1},
    "marker_rate: '1001' (allowed: 0 to 1000)": {'marker_rate': 1001},
    "marker_field: 'pressure' (allowed: none, region, stress)": {'marker_field': 'pressure'},
    "transform_timeout: 'soon' (allowed: 0 to 60)": {'transform_timeout': 'soon'},
    "max_lag: '0.5' (allowed: 1 to 1e+06)": {'max_lag': 0.5},
}


class BadParameters(unittest.TestCase):
    def test_bad_parameters_end_the_node(self):
        for said, parameters in BAD.items():
            status, errors = run_to_its_end(NODE, {'scene': SCENE, **parameters})
            self.assertEqual(1, status, errors)
            self.assertIn('/bad: ' + said, errors)

    def test_a_node_without_a_scene_ends(self):
        status, errors = run_to_its_end(NODE, {'marker_rate': 15})
        self.assertEqual(1, status, errors)
        self.assertIn('/bad/scene: this parameter is missing', errors)

    def test_a_group_that_the_mesh_has_not_ends_the_node(self):
        scene = {'body': {'mesh': 'package://incision/test/ros/rib.msh'}, 'boundary': [{'group': 'rob'}]}
        status, errors = run_to_its_end(NODE, {'scene': scene})
        self.assertEqual(1, status, errors)
        self.assertIn("/bad/scene: boundary.0.group: 'rob', did you mean rib?", errors)

    def test_a_region_that_the_mesh_has_not_ends_the_node(self):
        body = {'mesh': 'package://incision/test/ros/rib.msh', 'regions': [{'group': 'tisue', 'cutting_force': 60}]}
        status, errors = run_to_its_end(NODE, {'scene': {'body': body}})
        self.assertEqual(1, status, errors)
        self.assertIn("/bad/scene: body.regions.0.group: 'tisue', did you mean tissue?", errors)


if __name__ == '__main__':
    rospy.init_node('bad_parameters_test')
    rostest.rosrun('incision', 'bad_parameters', BadParameters, sys.argv)
