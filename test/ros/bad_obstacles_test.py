#!/usr/bin/python3
"""With a bad description of the obstacles the node ends at once, in order, and says why."""

import sys
import unittest

import roslib.packages
import rospy
import rostest

from incision_client import run_to_its_end

NODE = roslib.packages.find_node('incision', 'incision_node')[0]

SCENE = {'body': {'grid': {'cells': [1, 1, 1]}}}

BAD = {
    'link \'post\': mesh \'a.stl\' is relative, and the description comes from no file': '<mesh filename="a.stl"/>',
    'link \'post\': the sphere\'s radius -1 (allowed': '<sphere radius="-1"/>',
    'link \'post\': a collision shape cannot be read: radius [nan] is not a valid float': '<sphere radius="nan"/>',
}


def described(geometry):
    return f'<robot name="r"><link name="post"><collision><geometry>{geometry}</geometry></collision></link></robot>'


class BadObstacles(unittest.TestCase):
    def check_refused(self, said, scene=None, description=None):
        parameters = {'scene': scene or SCENE}
        if description is not None:
            parameters['obstacle_description'] = description
        status, errors = run_to_its_end(NODE, parameters)
        self.assertEqual(1, status, errors)
        self.assertIn(said, errors)

    def test_bad_shapes(self):
        for said, geometry in BAD.items():
            self.check_refused('/bad/obstacle_description: ' + said, description=described(geometry))

    def test_no_shapes(self):
        self.check_refused('0 collision shapes (allowed: 1 to 1000)',
                           description='<robot name="r"><link name="a"/></robot>')

    def test_not_a_description(self):
        for text in ('', 'no xml', '<robot'):
            self.check_refused('/bad/obstacle_description: not a robot description', description=text)

    def test_too_large(self):
        self.check_refused('the text is too large (allowed: up to 1048576 bytes)', description=' ' * (2 ** 20 + 1))

    def test_deep_nesting(self):
        self.check_refused('elements (allowed: up to 10000)', description='<robot name="r">' + '<a>' * 300000)

    def test_not_a_text(self):
        self.check_refused('/bad/obstacle_description: not a text', description=7)

    def test_missing_file(self):
        self.check_refused('/no/such/room.urdf: cannot be opened',
                           scene={**SCENE, 'contact': {'obstacles': '/no/such/room.urdf'}})


if __name__ == '__main__':
    rospy.init_node('bad_obstacles_test')
    rostest.rosrun('incision', 'bad_obstacles', BadObstacles, sys.argv)
