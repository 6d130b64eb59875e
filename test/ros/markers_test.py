#!/usr/bin/python3
"""What rviz is given to draw: a closed, finite surface in the body's frame."""

import collections
import math
import sys
import unittest

import rospy
import rostest
from incision_client import Client
from visualization_msgs.msg import Marker, MarkerArray

VOLUME = 1 * 0.25 * 0.25  # [m3] of the bar


def surface(array):
    return [marker for marker in array.markers if marker.type == Marker.TRIANGLE_LIST]


def triangles(array):
    points = [(p.x, p.y, p.z) for marker in surface(array) for p in marker.points]
    return list(zip(points[0::3], points[1::3], points[2::3]))


def signed_volume(faces):
    return sum(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
               + a[2] * (b[0] * c[1] - b[1] * c[0]) for a, b, c in faces) / 6


def edge_balance(faces):
    """How often each edge is run one way less how often the other way, equal points taken as one."""
    balance = collections.Counter()
    for face in faces:
        for i in range(3):
            a, b = face[i], face[(i + 1) % 3]
            balance[min(a, b), max(a, b)] += 1 if a < b else -1
    return balance


class Markers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()
        cls.client.pause()
        cls.arrays = []
        rospy.Subscriber('/incision/markers', MarkerArray, cls.arrays.append)

    def setUp(self):
        self.client.reset()

    def next_array(self):
        seen = len(self.arrays)
        return self.client.wait_for(lambda: len(self.arrays) > seen + 1 and self.arrays[-1], 'markers')

    def check_surface(self, array):
        faces = triangles(array)
        self.assertTrue(all(math.isfinite(x) for face in faces for point in face for x in point))
        self.assertAlmostEqual(VOLUME, signed_volume(faces), delta=1e-9)
        self.assertEqual({0}, set(edge_balance(faces).values()))
        for marker in array.markers:
            self.assertEqual('body', marker.header.frame_id)
            self.assertFalse(marker.colors)

    def test_the_uncut_body_is_all_skin(self):
        array = self.next_array()
        self.check_surface(array)
        self.assertEqual(['skin'], [marker.ns for marker in surface(array) if marker.action == Marker.ADD])

    def test_the_cut_body_is_closed_by_cut_faces(self):
        ids = [(marker.ns, marker.id) for marker in self.next_array().markers]
        self.client.cut(point=(0.51, 0, 0), normal=(1, 0.3, 0.1))
        array = self.next_array()
        self.check_surface(array)
        self.assertEqual(['skin', 'cut faces'],
                         [marker.ns for marker in surface(array) if marker.action == Marker.ADD])
        self.assertEqual(ids, [(marker.ns, marker.id) for marker in array.markers])

    def test_what_is_held_stands_as_spheres(self):
        clamps = next(marker for marker in self.next_array().markers if marker.ns == 'clamps')
        self.assertEqual((Marker.SPHERE_LIST, Marker.ADD), (clamps.type, clamps.action))
        self.assertEqual({0.0}, {point.x for point in clamps.points})

    def test_a_reset_takes_the_cut_faces_away(self):
        self.client.cut(point=(0.51, 0, 0))
        self.client.reset()
        self.assertEqual(Marker.DELETE, self.next_array().markers[1].action)


if __name__ == '__main__':
    rospy.init_node('markers_test')
    rostest.rosrun('incision', 'markers', Markers, sys.argv)
