#!/usr/bin/python3
"""What the node tells of cracks that the body grows by itself."""

import math
import sys
import unittest

import rospy
import rostest
from incision.msg import CrackEvent
from incision_client import Client, TIMEOUT


class Fracture(unittest.TestCase):
    def test_others_hear_of_every_crack(self):
        client, events = Client(), []
        client.pause()
        subscriber = rospy.Subscriber('/incision/crack_event', CrackEvent, events.append, queue_size=1000)
        client.wait_for(subscriber.get_num_connections, 'the crack events')
        client.reset()
        client.pause(False)
        client.wait_for(lambda: client.state.pieces > 1, 'the bar to break', 2 * TIMEOUT)
        client.pause()
        state = client.next_state()  # elements can be split twice
        client.wait_for(lambda: sum(event.elements for event in events) >= state.crack_elements, 'all events')
        self.assertEqual(CrackEvent.STARTED, events[0].change)
        client.wait_for(lambda: {event.crack for event in events} == set(range(state.cracks)), 'every crack')
        self.assertTrue(all(event.header.frame_id == 'body' for event in events))
        self.assertTrue(all(event.kind == CrackEvent.TENSION and event.stress > 0 for event in events))
        # The pull was 1e4 Pa when a strain of 0.01 was reached, after a second.
        self.assertAlmostEqual(1, events[0].time, delta=0.1)
        self.assertGreaterEqual(events[0].stress, 1e4)
        self.assertLess(events[0].stress, 1.1e4)
        normal = events[0].normal
        self.assertAlmostEqual(1, math.hypot(normal.x, normal.y, normal.z), places=9)
        self.assertGreater(abs(normal.x), 0.99)
        self.assertTrue(0 < events[0].where.x < 1.02 and 0 < events[0].where.y < 0.26)


if __name__ == '__main__':
    rospy.init_node('fracture_test')
    rostest.rosrun('incision', 'fracture', Fracture, sys.argv)
