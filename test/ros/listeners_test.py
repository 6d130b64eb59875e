#!/usr/bin/python3
"""What others can hear of a body: its surface, its contacts, the stress of its regions."""

import math
import sys
import unittest

import rospy
import rostest
from incision.msg import Contacts
from incision_client import Client
from sensor_msgs import point_cloud2
from sensor_msgs.msg import PointCloud2
from visualization_msgs.msg import Marker, MarkerArray

MASS = 0.15 * 0.15 * 0.2 * 1000  # [kg]


class Listeners(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()
        cls.clouds, cls.contacts, cls.arrays = [], [], []
        rospy.Subscriber('/incision/surface', PointCloud2, cls.clouds.append)
        rospy.Subscriber('/incision/contacts', Contacts, cls.contacts.append)
        rospy.Subscriber('/incision/markers', MarkerArray, cls.arrays.append)

    def next_of(self, kept, what):
        seen = len(kept)
        return self.client.wait_for(lambda: len(kept) > seen + 1 and kept[-1], what)

    def test_the_surface_has_normals_regions_and_stress(self):
        cloud = self.next_of(self.clouds, 'the surface')
        self.assertEqual('body', cloud.header.frame_id)
        names = ['x', 'y', 'z', 'normal_x', 'normal_y', 'normal_z', 'von_mises', 'region', 'cut']
        self.assertEqual(names, [field.name for field in cloud.fields])
        points = list(point_cloud2.read_points(cloud))
        self.assertEqual(2 * 16 + 3 * 12, len(points))
        for x, y, z, nx, ny, nz, stress, region, cut in points:
            self.assertAlmostEqual(1, math.sqrt(nx * nx + ny * ny + nz * nz), places=5)
            outward = nx * (x - 0.075) + ny * (y - 0.075) + nz * (z - 0.1)
            self.assertLess(0, outward)
            self.assertEqual(0, cut)
            self.assertLessEqual(0, stress)
            if z < 0.09 or z > 0.11:
                self.assertEqual(int(z > 0.1), region)
        self.assertLess(0, max(point[6] for point in points))

    def test_a_cut_is_told_on_the_surface(self):
        self.client.cut(point=(0.075, 0.075, 0.17), normal=(0, 0.1, 1))
        self.client.wait_for(lambda: self.clouds and any(
            point[0] for point in point_cloud2.read_points(self.clouds[-1], ('cut',))), 'cut faces')
        self.client.reset()

    def test_forces_of_ground_and_clamp_bear_the_weight(self):
        # What the clamp presses on grows slowly, so the body is at rest but for that.
        self.client.wait_for(lambda: self.client.state.time > 2, 'the block to rest')
        message = self.next_of(self.contacts, 'contacts')
        self.assertEqual({'ground'}, set(message.partners))
        self.assertEqual(16, len(message.points))
        for point, normal, force, depth in zip(message.points, message.normals, message.forces, message.depths):
            self.assertAlmostEqual(0, point.z + depth, places=9)
            self.assertEqual((0, 0, 1), (normal.x, normal.y, normal.z))
            self.assertLess(0, force.z)
        self.assertEqual(['ground', 'clamp_0'], message.bearers)
        ground, clamp = message.wrenches
        self.assertAlmostEqual(-sum(force.z for force in message.forces), ground.force.z, delta=1e-9)
        self.assertAlmostEqual(-9.81 * MASS, ground.force.z + clamp.force.z, delta=0.01 * 9.81 * MASS)

    def test_the_state_tells_the_stress_of_regions(self):
        state = self.client.wait_for(lambda: self.client.state.regions and self.client.state, 'regions')
        self.assertEqual(['body', 'region_0'], state.regions)
        for mean, largest in zip(state.region_mean_stress, state.region_largest_stress):
            self.assertTrue(0 < mean < largest)

    def test_markers_have_a_colour_for_each_region(self):
        markers = [m for m in self.next_of(self.arrays, 'markers').markers
                   if m.type == Marker.TRIANGLE_LIST and m.action == Marker.ADD]
        self.assertEqual(['skin', 'skin'], [marker.ns for marker in markers])
        self.assertNotEqual(markers[0].color, markers[1].color)
        self.assertFalse(markers[0].colors)


if __name__ == '__main__':
    rospy.init_node('listeners_test')
    rostest.rosrun('incision', 'listeners', Listeners, sys.argv)
