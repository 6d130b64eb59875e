#!/usr/bin/python3
"""A plane that is pulled tears from a notch that a message cuts into it."""

import sys
import unittest

import rospy
import rostest
from incision.msg import CrackEvent, CutReport
from incision_client import Client

NOTCH = dict(label='notch', point=(0.154, 0.2, 0.005), normal=(1, 0.02, 0), tangent=(0, 1, 0), length=0.07)
TORN = 2.5  # [s] simulated; the notched plane is in two pieces before, the whole one holds for longer


class SlitPlane(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.events = []
        rospy.Subscriber('/incision/crack_event', CrackEvent, cls.events.append)
        cls.client = Client()

    def setUp(self):
        self.client.pause()
        self.client.reset()
        self.events.clear()

    def run_until(self, condition):
        self.client.pause(False)
        self.client.wait_for(lambda: condition(self.client.state), 'the plane')
        return self.client.state

    def test_a_notched_plane_tears_in_two(self):
        notch = self.client.cut(**NOTCH)
        self.assertEqual((CutReport.APPLIED, 1), (notch.status, notch.pieces), notch.reason)
        torn = self.run_until(lambda state: state.pieces > 1)
        self.assertEqual(2, torn.pieces)
        self.assertLess(torn.time, TORN)
        self.client.wait_for(lambda: self.events, 'a crack event')
        first = self.events[0]
        self.assertEqual('body', first.header.frame_id)

    def test_a_whole_plane_holds(self):
        held = self.run_until(lambda state: state.time >= TORN)
        self.assertEqual((1, 0, 0), (held.pieces, held.cracks, len(self.events)))


if __name__ == '__main__':
    rospy.init_node('slit_plane_test')
    rostest.rosrun('incision', 'slit_plane', SlitPlane, sys.argv)
