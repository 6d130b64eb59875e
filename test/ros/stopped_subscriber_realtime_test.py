#!/usr/bin/python3
"""A subscriber that has stopped, whose connection takes no more, neither slows steps nor fills the memory."""

import re
import signal
import statistics
import subprocess
import sys
import time
import unittest
import xmlrpc.client

import rosgraph
import rospy
import rostest
from geometry_msgs.msg import PoseStamped
from incision.msg import BodyState
from incision_client import tool_pose, wait_for

SLOWER = 1.15  # as many times longer may a step take: what a machine that does nothing else varies by
GROWTH = 8.0  # [MB] that the node may grow by while nothing more is taken; its queues are full long before
WINDOW = 0.5  # [s]
FULL_TIMEOUT = 100  # [s]

SUBSCRIBER = """
import rospy
from geometry_msgs.msg import PoseStamped
from incision.msg import BodyState
rospy.init_node('stopped')
for name, kind in (('state', BodyState), ('tool/measured_cp', PoseStamped)):
    rospy.Subscriber('/incision/' + name, kind, lambda message: None, buff_size=4096)
rospy.wait_for_message('/incision/tool/measured_cp', PoseStamped, 20)
print('ready', flush=True)
rospy.spin()
"""


def node_pid():
    uri = rosgraph.Master('/test').lookupNode('/incision')
    return xmlrpc.client.ServerProxy(uri).getPid('/test')[2]


def resident(pid):
    """[MB]"""
    with open(f'/proc/{pid}/status', encoding='ascii') as status:
        return int(re.search(r'VmRSS:\s+(\d+)', status.read()).group(1)) / 1024


def unsent():
    """Bytes that wait in the fullest connection of this machine."""
    with open('/proc/net/tcp', encoding='ascii') as table:
        return max(int(line.split()[4].split(':')[0], 16) for line in table.readlines()[1:])


def step_time(seconds):
    """The median [s], over windows, of what a step takes with all that is published of it."""
    times = []
    for _ in range(round(seconds / WINDOW)):
        first = rospy.wait_for_message('/incision/state', BodyState, 20)
        time.sleep(WINDOW)
        last = rospy.wait_for_message('/incision/state', BodyState, 20)
        times.append((last.header.stamp - first.header.stamp).to_sec() / (last.step - first.step))
    return statistics.median(times)


def wait_until_full():
    """Until the connections have taken nothing for two seconds."""
    deadline, last, since = time.monotonic() + FULL_TIMEOUT, -1, time.monotonic()
    while time.monotonic() < deadline:
        now = unsent()
        if now != last:
            last, since = now, time.monotonic()
        if now > 100_000 and time.monotonic() - since > 2:
            return
        time.sleep(0.1)
    raise AssertionError(f'the connection still takes messages, with {last} bytes unsent')


class StoppedSubscriber(unittest.TestCase):
    def test_steps_take_as_long_and_the_memory_stays(self):
        poses = rospy.Publisher('/incision/tool/servo_cp', PoseStamped, queue_size=10)
        wait_for(poses.get_num_connections, 'the node')
        poses.publish(tool_pose((0.51, -0.05, 0)))  # from then on there is something to tell of the tool
        listener = subprocess.Popen([sys.executable, '-c', SUBSCRIBER], stdout=subprocess.PIPE)
        try:
            self.assertEqual(b'ready\n', listener.stdout.readline())
            before = step_time(5)
            listener.send_signal(signal.SIGSTOP)
            wait_until_full()
            pid = node_pid()
            memory = resident(pid)
            stopped = step_time(rospy.get_param('~seconds'))
            if rospy.get_param('~timed'):
                self.assertLess(stopped, SLOWER * before)
            self.assertLess(resident(pid) - memory, GROWTH)
            print(f'a step takes {1e6 * before:.0f} us with a listener, {1e6 * stopped:.0f} us with one that has stopped')
        finally:
            listener.kill()
            listener.wait()


if __name__ == '__main__':
    rospy.init_node('stopped_subscriber_realtime_test')
    rostest.rosrun('incision', 'stopped_subscriber_realtime', StoppedSubscriber, sys.argv)
