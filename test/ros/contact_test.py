#!/usr/bin/python3
"""A block stands on the ground. Cut through by a message, its upper part rests on the lower one."""

import sys
import unittest

import rospy
import rostest
from incision.msg import CutReport
from incision_client import Client

ON_GROUND = 25  # vertices of the block's lower side
ELEMENT = 0.05  # [m]
SETTLED = 0.01  # [m] the block gives way by 3 mm under its own weight
STILL = 1e-5  # [J]


class Contact(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()

    def wait_until_still(self):
        self.client.wait_for(lambda: self.client.state.contacts and self.client.state.kinetic_energy < STILL,
                             'the body to come to rest')
        return self.client.next_state()

    def test_1_the_block_stands_on_the_ground(self):
        state = self.wait_until_still()
        self.assertEqual(ON_GROUND, state.contacts)
        self.assertLess(0, state.deepest_contact)
        self.assertLess(state.deepest_contact, 0.01 * ELEMENT)

    def test_2_a_part_that_is_cut_off_rests_on_the_other(self):
        time = self.client.state.time
        report = self.client.cut(point=(0.1, 0.1, 0.17), normal=(0, 0.05, 1))
        self.assertEqual((CutReport.APPLIED, 2), (report.status, report.pieces))
        self.client.wait_for(lambda: self.client.state.time > time + 1, 'a second to pass')
        state = self.wait_until_still()
        self.assertEqual(2, state.pieces)
        self.assertGreater(state.contacts, 2 * ON_GROUND)
        self.assertLess(state.deepest_contact, 0.01 * ELEMENT)
        self.assertLess(state.max_displacement, SETTLED)
        self.assertEqual('', state.error)


if __name__ == '__main__':
    rospy.init_node('contact_test')
    rostest.rosrun('incision', 'contact', Contact, sys.argv)
