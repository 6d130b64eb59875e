#!/usr/bin/python3
"""A ball that tf moves pushes the bar; the other obstacles stay where their description has them."""

import sys
import unittest

import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import TransformStamped
from incision_client import Client
from visualization_msgs.msg import Marker, MarkerArray

START = -0.3  # y of the ball as described [m]; its radius is 0.1, and the bar begins at y = 0
SPEED = 0.3  # at which it is moved [m/s]
PUSHED = 0.03  # [m] far more than the bar moves by itself


class Obstacle(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()
        cls.arrays = []
        cls.tf = tf2_ros.TransformBroadcaster()
        rospy.Subscriber('/incision/obstacles', MarkerArray, cls.arrays.append)

    def move_ball(self, y):
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id = 'body', 'ball'
        transform.header.stamp = rospy.Time.now()
        transform.transform.translation.x, transform.transform.translation.z = 0.95, 0.125
        transform.transform.translation.y = y
        transform.transform.rotation.w = 1
        self.tf.sendTransform(transform)

    def ball_at(self):
        """y of the ball as it is drawn."""
        return self.arrays and self.arrays[-1].markers[0].pose.position.y

    def lead_ball(self, y):
        """Repeats its pose until the node has it there."""
        def there():
            self.move_ball(y)
            return abs(self.ball_at() - y) < 1e-6
        self.client.wait_for(there, f'the ball at {y}')

    def test_1_shapes_are_drawn_where_they_are_described(self):
        self.client.wait_for(lambda: self.arrays, 'markers')
        ball, post, ground = self.arrays[-1].markers
        self.assertEqual([Marker.SPHERE, Marker.CYLINDER, Marker.CUBE], [ball.type, post.type, ground.type])
        self.assertEqual(['ball', 'post', 'ground'], [ball.ns, post.ns, ground.ns])
        self.assertEqual([0, 1, 2], [ball.id, post.id, ground.id])
        self.assertEqual((0.2, 0.2, 0.2), (ball.scale.x, ball.scale.y, ball.scale.z))
        self.assertEqual((0.1, 0.1, 1), (post.scale.x, post.scale.y, post.scale.z))
        self.assertEqual((START, 0), (ball.pose.position.y, post.pose.position.y))
        self.assertAlmostEqual(-0.5, ground.pose.position.z + ground.scale.z / 2, delta=1e-15)
        self.assertEqual('body', ball.header.frame_id)

    def test_2_a_jump_across_the_bar_leaves_it_alone(self):
        self.lead_ball(START)
        self.lead_ball(3)  # faster than the limit, even in the longest time that one transform is followed
        self.lead_ball(START)
        self.assertLess(self.client.next_state().max_displacement, 1e-9)

    def test_3_a_moved_ball_pushes_the_bar(self):
        self.lead_ball(START)
        start = self.client.next_state().time

        def pushed():
            self.move_ball(min(START + SPEED * (self.client.state.time - start), 0))
            return self.client.state.max_displacement > PUSHED
        self.client.wait_for(pushed, 'the bar to be pushed')
        self.assertGreater(self.ball_at(), -0.1)
        self.assertEqual(0, self.arrays[-1].markers[1].pose.position.y)
        self.assertEqual('', self.client.state.error)


if __name__ == '__main__':
    rospy.init_node('obstacle_test')
    rostest.rosrun('incision', 'obstacle', Obstacle, sys.argv)
