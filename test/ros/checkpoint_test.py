#!/usr/bin/python3
"""A body saved and restored goes on as if it had never been saved: its branches differ by nothing but the commands."""

import sys
import unittest

import rospy
import rostest
from geometry_msgs.msg import TransformStamped
from incision_client import Client, checkpoint_service, cut_plane, time_of, tool_pose
from rosgraph_msgs.msg import Clock
from tf2_msgs.msg import TFMessage

BATCH = 18  # steps whose commands are sent at once
SHARE = 30  # of the way from one end of a tool's path to the other, in the shortest run [steps]


class Checkpoints(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.clock_publisher = rospy.Publisher('/clock', Clock, queue_size=100)
        cls.tf = rospy.Publisher('/tf', TFMessage, queue_size=100)
        cls.ticks = 100_000  # of a time step each
        cls.scalpel, cls.hook = Client(tool='scalpel'), Client(tool='hook')
        cls.client = cls.scalpel
        cls.client.wait_for(cls.tf.get_num_connections, 'the node to listen to tf')
        cls.save, cls.restore = checkpoint_service('save'), checkpoint_service('restore')
        cls.saved, cls.end = rospy.get_param('~saved'), rospy.get_param('~end')  # [steps]

    def setUp(self):
        self.client.reset()
        self.far_cuts = 0  # that wait for their stamp for long

    def tick(self):
        self.clock_publisher.publish(Clock(time_of(self.ticks)))

    def on_the_way(self, step):
        """As many steps of the shortest run."""
        return step * SHARE / self.end

    def send_hand(self, step, stamp):
        """The clamp's frame, every third step only: it is then led there over three."""
        transform = TransformStamped()
        transform.header.stamp, transform.header.frame_id, transform.child_frame_id = stamp, 'body', 'hand'
        transform.transform.translation.x = -1e-4 * self.on_the_way(step)
        transform.transform.rotation.w = 1
        self.tf.publish(TFMessage([transform]))

    def run_steps(self, first, last, cuts=()):
        """Takes the steps from `first` to `last`, with what is commanded in them: the hash after each."""
        hashes = []
        while first < last:
            end = min(last, first + BATCH)
            hashes += self.run_batch(first, end, cuts)
            first = end
        return hashes

    def run_batch(self, first, last, cuts):
        start, sent = self.ticks + 1, 0
        for k in range(first, last):
            if k % 3 == 0:
                self.send_hand(k, time_of(start + k - first))
        for k in range(first, last):
            stamp = time_of(start + k - first)
            sent += 1 + (k % 2 == 0) + (k in cuts)
            if k % 2 == 0:  # led there over two steps
                self.scalpel.move_tool(stamped(tool_pose((0.03, -0.015 + 0.001 * self.on_the_way(k), 0.01)), stamp))
            self.hook.move_tool(stamped(tool_pose((0.05, 0.015 - 0.001 * self.on_the_way(k), 0.01)), stamp))
            if k in cuts:
                self.client.send(cut_plane(stamp=stamp, label=f'at {k}', point=(0.015 if k < self.saved else 0.065, 0, 0)))
        waiting = sent + self.far_cuts
        self.client.wait_for(lambda: self.client.state.waiting_for_step == waiting, 'the commands to be known')
        seen = len(self.client.states)
        for _ in range(first, last):
            type(self).ticks += 1
            self.tick()
        self.client.wait_for(lambda: self.client.state.step == last, f'step {last}')
        self.assertEqual(0, self.client.state.late_commands)
        hashes = {state.step: state.state_hash for state in self.client.states[seen:]}
        return [hashes[k + 1] for k in range(first, last)]

    def call(self, service, name):
        answer = service(name)
        self.assertTrue(answer.success, answer.message)
        return answer

    def test_branches_of_a_body_are_as_if_it_had_never_been_saved(self):
        self.run_steps(0, self.saved, cuts=[5])
        self.assertEqual(self.saved, self.call(self.save, 'middle').step)
        on = self.run_steps(self.saved, self.end)
        self.assertGreater(self.client.state.pieces, 2)
        self.assertGreater(self.client.state.contacts, 0)
        for branch in range(rospy.get_param('~branches')):
            if branch == 3:  # on the way from another state
                self.client.reset()
                self.run_steps(0, 4)
            self.assertEqual(self.saved, self.call(self.restore, 'middle').step)
            self.assertEqual(on, self.run_steps(self.saved, self.end), f'branch {branch}')
        self.call(self.restore, 'middle')
        other = self.run_steps(self.saved, self.saved + 18, cuts=[self.saved + 3])
        self.assertEqual(on[:3], other[:3])
        self.assertNotEqual(on[3], other[3])

    def test_a_cut_that_waits_is_answered_at_a_restore(self):
        self.run_steps(0, 2)
        self.call(self.save, 'early')
        seen = len(self.client.reports)
        far = time_of(self.ticks + 1000)
        self.client.send(cut_plane(stamp=far, label='far', point=(0.015, 0, 0)))
        self.far_cuts = 1
        self.run_steps(2, 4)
        self.call(self.restore, 'early')
        report = self.client.wait_for(lambda: self.client.reports[seen:], 'the report')[0]
        self.assertEqual(('far', report.REJECTED), (report.label, report.status))
        self.assertIn('restored', report.reason)

    def test_what_cannot_be_is_refused_in_words_and_changes_nothing(self):
        self.run_steps(0, 3)
        before = self.client.state.state_hash
        for service, name, why in ((self.save, '', 'no name'), (self.save, '../a', 'no name'), (self.save, 'last', 'taken'),
                                   (self.restore, '../a', 'no name'), (self.restore, 'nothing', 'there are: '),
                                   (self.restore, 'last', 'checkpoint_folder')):
            answer = service(name)
            self.assertFalse(answer.success)
            self.assertIn(why, answer.message)
        self.assertEqual(before, self.client.next_state().state_hash)


def stamped(pose, stamp):
    pose.header.stamp = stamp
    return pose


if __name__ == '__main__':
    rospy.init_node('checkpoint_test', disable_rostime=True)
    rostest.rosrun('incision', 'checkpoint', Checkpoints, sys.argv)
