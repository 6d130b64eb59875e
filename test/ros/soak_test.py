#!/usr/bin/python3
"""Random cuts, strokes, grasps, checkpoints and resets, with garbage between them, for as long as is asked for: memory
stays flat, energy bounded, and the same commands give the same states once more."""

import math
import random
import sys
import time
import unittest
import xmlrpc.client

import rospy
import rostest
from geometry_msgs.msg import PoseStamped
from incision_client import Client, checkpoint_service, cut_plane, time_of, tool_pose
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import JointState

MOST_ENERGY = 1.0  # [J] kinetic and elastic: the body's weight falls through some 6e-3
MOST_GROWTH = 5  # [MiB] of the node's memory, in as much work as had been done before: what the heap leaves between
TIMEOUT = 300  # [s] for the steps of an action: that they are quick is held elsewhere
MOST_PIECES = 20  # of rubble beyond that a step takes a second, and an hour has few actions
NAMES = ('a', 'b', 'c')


def memory_of(pid):
    """[MiB] that the process has in memory."""
    with open(f'/proc/{pid}/status', encoding='ascii') as status:
        return next(int(line.split()[1]) / 1024 for line in status if line.startswith('VmRSS'))


def pid_of(name):
    return xmlrpc.client.ServerProxy(rospy.get_master().lookupNode(name)[2]).getPid('/soak')[2]


class Soak(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.clock_publisher = rospy.Publisher('/clock', Clock, queue_size=1000)
        cls.scalpel, cls.forceps = Client(tool='scalpel'), Client(tool='forceps')
        cls.client = cls.scalpel
        cls.services = {name: checkpoint_service(name) for name in ('save', 'restore')}
        cls.ticks = 100_000
        cls.pid = pid_of('/incision')

    def stamp(self, step):
        """Of a step of the action that comes."""
        return time_of(self.ticks + 1 + step)

    def take_steps(self, count, sent=0):
        """When as many commands are known as were `sent`."""
        self.client.wait_for(lambda: self.client.state.waiting_for_step == sent, 'the commands to be known')
        last = self.client.state.step + count
        for _ in range(count):
            type(self).ticks += 1
            self.clock_publisher.publish(Clock(time_of(self.ticks)))
        self.client.wait_for(lambda: self.client.state.step == last, f'step {last}', TIMEOUT)

    def cut(self, draw):
        normal = [draw.uniform(-1, 1) for _ in range(3)]
        self.client.send(cut_plane(stamp=self.stamp(0), label='random', normal=normal,
                                   point=(draw.uniform(0, 0.08), draw.uniform(-0.015, 0.015), draw.uniform(0, 0.02)),
                                   tangent=(normal[1], -normal[0], 0), length=draw.choice((0, 0.02)), width=0))
        self.take_steps(5, 1)

    def stroke(self, draw):
        x, y, angle = draw.uniform(0.01, 0.07), draw.choice((-0.03, 0.03)), draw.uniform(-1, 1)
        for k in range(30):
            pose = tool_pose((x + 0.0005 * k * math.sin(angle), y - 2 * y * k / 30, 0.01))
            pose.header.stamp = self.stamp(k)
            self.scalpel.move_tool(pose)
        self.take_steps(32, 30)

    def grasp(self, draw):
        y = draw.uniform(-0.01, 0.01)
        for k in range(40):
            pose = tool_pose((-0.012 - 0.0003 * max(0, k - 15), y, 0.01 + 0.0002 * max(0, k - 15)))
            pose.header.stamp = self.stamp(k)
            self.forceps.move_tool(pose)
            self.forceps.send_jaw(jaw_at(0.5 - 0.04 * min(k, 12) if k < 35 else 0.5, self.stamp(k)))
        self.take_steps(42, 80)

    def rest(self, draw):
        self.take_steps(draw.randint(1, 30))

    def save(self, draw):
        self.saved.add(name := draw.choice(NAMES))
        self.assertTrue(self.services['save'](name).success)

    def restore(self, draw):
        name = draw.choice(NAMES)
        if name in self.saved:  # and not left by the run before
            self.assertTrue(self.services['restore'](name).success)
            self.client.next_state()

    def reset(self, draw):
        del draw
        self.client.reset()

    def garbage(self, draw):
        """None of which changes anything."""
        nan = draw.choice((math.nan, math.inf, 1e300))
        self.client.send(cut_plane(stamp=self.stamp(0), label='x' * draw.randint(0, 300), point=(nan, 0, 0)))
        self.client.send(cut_plane(stamp=self.stamp(0), normal=(0, 0, 0)))
        self.client.send(cut_plane(stamp=self.stamp(0), frame='nowhere/at all'))
        self.scalpel.move_tool(PoseStamped())
        pose = tool_pose((nan, 0, 0), orientation=(nan, 0, 0, 1))
        pose.header.stamp = self.stamp(1)
        self.scalpel.move_tool(pose)
        self.forceps.send_jaw(JointState(position=[nan]))
        self.forceps.send_jaw(JointState(position=[0.1] * draw.choice((0, 2, 50))))
        self.take_steps(2)

    def run_actions(self, seed, until):
        """Does random things until `until(count)`: the hash after each."""
        draw = random.Random(seed)
        self.client.reset()
        self.saved, hashes, slowest = set(), [], 0
        while not until(len(hashes)):
            action = draw.choice((self.cut, self.stroke, self.stroke, self.grasp, self.grasp, self.rest, self.save,
                                  self.restore, self.restore, self.garbage, self.garbage)
                                 if draw.random() > 0.02 else (self.reset,))
            action(draw)
            if self.client.state.pieces > MOST_PIECES:
                self.client.reset()
            state = self.client.state
            slowest = max([slowest] + [known.step_ms for known in self.client.states])
            self.assertEqual('', state.error)
            self.assertLess(state.kinetic_energy + state.elastic_energy, MOST_ENERGY, f'after {len(hashes)} actions')
            hashes.append((action.__name__, state.step, state.state_hash))
            if len(hashes) % 100 == 0:
                rospy.loginfo('%d actions; %.1f MiB; %.3g J; a step of %.0f ms', len(hashes), memory_of(self.pid),
                              state.kinetic_energy + state.elastic_energy, slowest)
            for client in (self.scalpel, self.forceps):
                for kept in (client.states, client.reports, client.wrenches, client.jaws):
                    del kept[:-5]
        return hashes

    def test_hours_of_work_leave_nothing_behind(self):
        deadline = time.monotonic() + rospy.get_param('~minutes') * 60 / 3
        first = self.run_actions(1, lambda count: count >= 20 and time.monotonic() > deadline)
        memory = [memory_of(self.pid)]
        for _ in range(2):
            again = self.run_actions(1, lambda count: count == len(first))
            for count, (one, other) in enumerate(zip(first, again)):
                self.assertEqual(one, other, f'after {count} actions')
            memory.append(memory_of(self.pid))
        rospy.loginfo('%d actions three times; after each of these %s MiB', len(first), memory)
        self.assertLess(memory[2] - memory[1], MOST_GROWTH)


def jaw_at(angle, stamp):
    message = JointState(position=[angle])
    message.header.stamp = stamp
    return message


if __name__ == '__main__':
    rospy.init_node('soak_test', disable_rostime=True)
    rostest.rosrun('incision', 'soak', Soak, sys.argv)
