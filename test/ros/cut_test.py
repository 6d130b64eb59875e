#!/usr/bin/python3
"""Cuts that arrive as messages."""

import math
import sys
import threading
import unittest

import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import TransformStamped
from incision.msg import CutReport
from incision_client import Client


class Cuts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()

    def setUp(self):
        self.client.pause(False)
        self.client.reset()

    def test_a_cut_splits_the_body(self):
        report = self.client.cut(label='half', point=(0.51, 0, 0))
        self.assertEqual(CutReport.APPLIED, report.status, report.reason)
        self.assertEqual((1, 2), (report.cracks, report.pieces))
        self.assertGreater(report.copies_added, 0)
        self.assertEqual('body', report.header.frame_id)
        state = self.client.next_state()
        self.assertEqual((2, 1), (state.pieces, state.cracks))
        self.assertEqual(3 * state.copies, state.dofs)
        self.assertAlmostEqual(62.5, state.mass, delta=1e-9)

    def test_an_empty_frame_is_the_body_s(self):
        self.assertEqual(2, self.client.cut(frame='', point=(0.51, 0, 0)).pieces)

    def test_crossing_cuts_make_four_pieces(self):
        self.client.cut(point=(0.51, 0, 0))
        self.assertEqual(4, self.client.cut(point=(0, 0.13, 0), normal=(0, 1, 0)).pieces)

    def test_a_rectangle_inside_leaves_one_piece(self):
        report = self.client.cut(point=(0.51, 0.05, 0), tangent=(0, 1, 0), length=0.3)
        self.assertEqual((CutReport.APPLIED, 1), (report.status, report.pieces), report.reason)

    def test_a_cut_beside_the_body_is_missed(self):
        report = self.client.cut(point=(7, 0, 0))
        self.assertEqual((CutReport.MISSED, 1), (report.status, report.pieces))
        self.assertTrue(report.reason)

    def test_a_cut_while_paused_is_applied_at_once(self):
        self.client.pause()
        step = self.client.next_state().step
        self.assertEqual(2, self.client.cut(point=(0.51, 0, 0)).pieces)
        state = self.client.next_state()
        self.assertEqual((step, 2), (state.step, state.pieces))

    def test_a_cut_in_a_moving_frame(self):
        """The frame turns about z at the middle of the bar: its x axis becomes the bar's y axis in a quarter turn."""
        broadcaster = tf2_ros.TransformBroadcaster()
        self.client.wait_for(broadcaster.pub_tf.get_num_connections, 'the node to listen to tf')
        start = rospy.Time.now()
        done = threading.Event()

        def turn():
            while not done.is_set():
                now = rospy.Time.now()
                broadcaster.sendTransform(self.turned(now, min(1, (now - start).to_sec()) * math.pi / 2))
                done.wait(0.02)

        thread = threading.Thread(target=turn)
        thread.start()
        try:
            self.client.wait_for(lambda: rospy.Time.now() > start + rospy.Duration(1.2), 'the turn')
            along = self.client.cut(frame='knife', stamp=rospy.Time.now(), label='along')
            self.assertEqual((CutReport.APPLIED, 2), (along.status, along.pieces), along.reason)
            # Where the frame was at the start, its x axis was the bar's.
            across = self.client.cut(frame='knife', stamp=start + rospy.Duration(0.05), label='across')
            self.assertEqual((CutReport.APPLIED, 4), (across.status, across.pieces), across.reason)
        finally:
            done.set()
            thread.join()

    @staticmethod
    def turned(stamp, angle):
        transform = TransformStamped()
        transform.header.stamp = stamp
        transform.header.frame_id = 'body'
        transform.child_frame_id = 'knife'
        transform.transform.translation.x = 0.51
        transform.transform.translation.y = 0.13
        transform.transform.rotation.z = math.sin(angle / 2)
        transform.transform.rotation.w = math.cos(angle / 2)
        return transform


if __name__ == '__main__':
    rospy.init_node('cut_test')
    rostest.rosrun('incision', 'cuts', Cuts, sys.argv)
