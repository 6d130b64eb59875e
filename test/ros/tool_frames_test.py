#!/usr/bin/python3
"""A blade whose pose stays the same in a frame that moves, and one that is such a frame itself."""

import sys
import unittest

import rosgraph
import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import TransformStamped
from incision.msg import CutReport
from incision_client import Client, tool_pose

X = 0.51  # where along the bar the blade cuts
YS = [-0.05 + 0.005 * i for i in range(71)]  # of the moving frame [m]; the bar reaches from 0 to 0.25
IN_ARM = (0, -0.1, 0)  # where the arm, turned by a quarter about z, holds the blade [m]
QUARTER = 0.5 ** 0.5  # sine and cosine of half the turn
PERIOD = 0.01  # [s] between stamps


class ToolFrames(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.client = Client()
        cls.by_tf = Client('/by_tf')
        cls.tf = tf2_ros.TransformBroadcaster()
        cls.client.wait_for(lambda: cls.tf.pub_tf.get_num_connections() >= 2, 'both nodes to listen to tf')

    def setUp(self):
        for client in (self.client, self.by_tf):
            client.reset()
        self.seen = {client: (len(client.states), client.state.header.stamp) for client in (self.client, self.by_tf)}

    def send_transform(self, frame, position, stamp, turn=(1, 0)):
        """`turn`: about z, cosine and sine of half the angle."""
        transform = TransformStamped()
        transform.header.frame_id, transform.child_frame_id, transform.header.stamp = 'body', frame, stamp
        translation, rotation = transform.transform.translation, transform.transform.rotation
        translation.x, translation.y, translation.z = position
        rotation.w, rotation.z = turn
        self.tf.sendTransform(transform)

    def send_arm(self, frame, y, stamp):
        """Where the arm must be for its blade to be at y."""
        self.send_transform(frame, (X - 0.1, y, 0), stamp, (QUARTER, QUARTER))

    def check_separated(self, client):
        """By one stroke."""
        client.wait_for(lambda: client.state.pieces == 2, 'the bar to be cut in two')
        states, stamp = self.seen[client]
        client.wait_for(lambda: client.reports_after(stamp), 'the report, which comes over a connection of its own')
        self.assertEqual([('tool', CutReport.APPLIED, 2)],
                         [(report.label, report.status, report.pieces) for report in client.reports_after(stamp)])
        self.assertFalse(any(client.tool_in(state).stale for state in client.states[states:]))
        self.assertEqual(1, client.state.cracks)

    def test_poses_without_stamp_take_the_frame_where_it_is_now(self):
        for y in YS:
            self.send_arm('arm', y, rospy.Time.now())
            self.client.lead_tool([tool_pose(IN_ARM, frame='arm')])
        self.check_separated(self.client)

    def test_stamped_poses_take_the_frame_where_it_was(self):
        """All transforms come first, and the stamps lie between theirs; they are older than tool.timeout."""
        start = rospy.Time.now() - rospy.Duration(2)
        for i, y in enumerate(YS):
            self.send_arm('past_arm', y, start + rospy.Duration(i * PERIOD))
        for i in range(len(YS) - 1):
            pose = tool_pose(IN_ARM, frame='past_arm')
            pose.header.stamp = start + rospy.Duration((i + 0.5) * PERIOD)
            self.client.lead_tool([pose])
        self.check_separated(self.client)

    def lead_frame(self, x, ys):
        """The tool's own frame, one transform a step."""
        for y in ys:
            seen = len(self.by_tf.states)
            self.send_transform('scalpel', (x, y, 0), rospy.Time.now())
            self.by_tf.wait_for(lambda: len(self.by_tf.states) > seen, 'a step')

    def test_the_tool_may_be_a_frame_of_tf(self):
        wrenches = len(self.by_tf.wrenches)
        self.lead_frame(X, YS)
        self.check_separated(self.by_tf)
        self.assertEqual({'scalpel'}, {wrench.header.frame_id for wrench in self.by_tf.wrenches[wrenches:]})

    def test_a_frame_that_is_sent_no_more_is_stale(self):
        self.lead_frame(X, YS[:30])
        self.by_tf.wait_for(lambda: self.by_tf.tool.stale, 'the tool to be stale')
        held = self.by_tf.state
        self.assertGreater(held.crack_elements, 0)
        self.assertEqual(held.crack_elements, self.by_tf.after_steps(10).crack_elements)
        self.lead_frame(X, YS[30:])
        self.assertFalse(self.by_tf.tool.stale)
        self.by_tf.wait_for(lambda: self.by_tf.state.pieces == 2, 'the bar to be cut in two')

    def test_poses_go_unheard_where_the_tool_is_a_frame(self):
        _, subscribers, _ = rosgraph.Master('/tool_frames_test').getSystemState()
        heard = {topic: nodes for topic, nodes in subscribers}
        self.assertIn('/incision', heard.get('/incision/tool/servo_cp', []))
        self.assertNotIn('/by_tf', heard.get('/by_tf/tool/servo_cp', []))


if __name__ == '__main__':
    rospy.init_node('tool_frames_test')
    rostest.rosrun('incision', 'tool_frames', ToolFrames, sys.argv)
