#!/usr/bin/python3
"""What may be set anew while the node runs takes effect, is checked as at the start, and outlasts a reset."""

import math
import sys
import unittest

import rospy
import rostest
from dynamic_reconfigure import client as reconfigure
from dynamic_reconfigure.encoding import decode_config
from dynamic_reconfigure.msg import Config, DoubleParameter
from dynamic_reconfigure.srv import Reconfigure
from incision_client import TIMEOUT, Client, checkpoint_service, wait_for
from visualization_msgs.msg import MarkerArray

AT_START = {'marker_rate': 0.0, 'marker_field': 'none', 'tolerance': 1e-6, 'gravity_x': 0.0, 'gravity_y': 0.0,
            'gravity_z': -9.81, 'cutting_force_factor': 1.0, 'threads': 1}


def doubles(**values):
    return Config(doubles=[DoubleParameter(name, value) for name, value in values.items()])


class ReconfigureTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()
        cls.updates = []
        rospy.Subscriber('/incision/parameter_updates', Config, lambda message: cls.updates.append(decode_config(message)))
        cls.server = reconfigure.Client('/incision', timeout=TIMEOUT)
        cls.set_raw = rospy.ServiceProxy('/incision/set_parameters', Reconfigure)
        cls.topic = rospy.Publisher('/incision/parameters', Config, queue_size=10)
        wait_for(cls.topic.get_num_connections, 'the node')

    def setUp(self):
        self.client.pause()
        self.server.update_configuration(AT_START)
        self.client.reset()

    def holds(self):
        """What the server says that holds."""
        held = self.server.get_configuration(TIMEOUT)
        return {name: held[name] for name in AT_START}

    def expect(self, **values):
        """The server tells what holds a little after it has answered."""
        wait_for(lambda: self.holds() == {**AT_START, **values}, f'{values} to hold')

    def hash_after(self, steps):
        for _ in range(steps):
            self.client.step()
        return self.client.next_state().state_hash

    def test_gravity_takes_effect_and_outlasts_a_reset(self):
        fallen = self.hash_after(5)
        self.server.update_configuration({'gravity_z': 0.0})
        self.client.reset()
        self.hash_after(5)
        self.assertEqual(0, self.client.next_state().max_displacement)
        self.expect(gravity_z=0.0)
        self.server.update_configuration({'gravity_z': -9.81})
        self.client.reset()
        self.assertEqual(fallen, self.hash_after(5))

    def test_what_holds_is_told(self):
        self.expect()
        self.server.update_configuration({'threads': 2, 'tolerance': 1e-4})
        self.expect(threads=2, tolerance=1e-4)
        wait_for(lambda: self.updates[-1]['threads'] == 2, 'the update')

    def test_what_is_out_of_range_changes_nothing_and_is_counted(self):
        for values, kind in (({'tolerance': 0.5, 'gravity_x': 1}, 'rejected_out_of_range'),
                             ({'gravity_z': math.nan}, 'rejected_not_finite'),
                             ({'gravity': 1}, 'rejected_out_of_range')):
            before = getattr(self.client.next_state(), kind)
            seen = len(self.updates)
            answer = decode_config(self.set_raw(doubles(**values)).config)
            self.assertEqual(AT_START, {name: answer[name] for name in AT_START})
            self.client.wait_for(lambda: getattr(self.client.state, kind) == before + 1, kind)
            wait_for(lambda: len(self.updates) > seen, 'an update')
            self.assertEqual(-9.81, self.updates[-1]['gravity_z'])

    def test_a_message_sets_as_the_service_does(self):
        self.topic.publish(doubles(gravity_x=2.5))
        wait_for(lambda: self.updates[-1]['gravity_x'] == 2.5, 'the update')
        self.expect(gravity_x=2.5)

    def test_a_restored_body_goes_on_with_what_held_when_it_was_saved(self):
        save, restore = (checkpoint_service(name) for name in ('save', 'restore'))
        self.server.update_configuration({'gravity_y': 3.0})
        self.hash_after(2)
        self.assertTrue(save('reconfigured').success)
        later = self.hash_after(3)
        self.server.update_configuration({'gravity_y': 0.0})
        self.assertTrue(restore('reconfigured').success)
        wait_for(lambda: self.updates[-1]['gravity_y'] == 3, 'the update')
        self.assertEqual(later, self.hash_after(3))

    def test_markers_come_and_go(self):
        seen = []
        subscriber = rospy.Subscriber('/incision/markers', MarkerArray, seen.append)
        self.server.update_configuration({'marker_rate': 30.0, 'marker_field': 'stress'})
        wait_for(lambda: seen and any(marker.colors for marker in seen[-1].markers), 'stress')
        self.server.update_configuration({'marker_field': 'none'})
        wait_for(lambda: not any(marker.colors for marker in seen[-1].markers), 'plain markers')
        self.server.update_configuration({'marker_rate': 0.0})
        self.client.next_state()
        subscriber.unregister()

    def test_nothing_is_left_on_the_parameter_server(self):
        """Or it would hold at the next start, in place of what the scene says."""
        self.server.update_configuration({'gravity_z': -1.0})
        self.assertEqual({'scene', 'marker_rate'}, set(rospy.get_param('/incision')))


if __name__ == '__main__':
    rospy.init_node('reconfigure_test')
    rostest.rosrun('incision', 'reconfigure', ReconfigureTest, sys.argv)
