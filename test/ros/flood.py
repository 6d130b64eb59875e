"""What the tests share in which a node is flooded with messages."""

import contextlib
import subprocess
import time
import xmlrpc.client

import roslib.packages
import rosgraph
import rospy
from geometry_msgs.msg import PoseStamped
from incision_client import TIMEOUT


def process_of(node):
    """The number of the node's process."""
    caller = rospy.get_name()
    return xmlrpc.client.ServerProxy(rosgraph.Master(caller).lookupNode(node)).getPid(caller)[2]


def resident_mb(pid):
    with open(f'/proc/{pid}/status', encoding='ascii') as status:
        return next(int(line.split()[1]) for line in status if line.startswith('VmRSS')) / 1024


def steps_per_second(client, during):
    """While `during` runs."""
    first, start = client.next_state().step, time.monotonic()
    during()
    return (client.next_state().step - first) / (time.monotonic() - start)


def passing(client, seconds):
    """What lets so much time pass."""
    def wait():
        start = time.monotonic()
        client.wait_for(lambda: time.monotonic() > start + seconds, 'time to pass', seconds + TIMEOUT)
    return wait


@contextlib.contextmanager
def leading(tool, **parameters):
    """A node that leads the tool."""
    name = 'lead_' + tool
    rospy.set_param('/' + name, parameters)
    program = roslib.packages.find_node('incision', 'incision_scalpel')[0]
    node = subprocess.Popen([program, '__name:=' + name, f'/{name}/pose:=/incision/{tool}/servo_cp',
                             f'/{name}/jaw:=/incision/{tool}/jaw/servo_jp'])
    try:
        yield
    finally:
        node.terminate()
        node.wait(TIMEOUT)


def poses_sent(tool):
    """And when. Listens no longer than it takes, since Python is too slow for all of them."""
    pose = rospy.wait_for_message(f'/incision/{tool}/servo_cp', PoseStamped, TIMEOUT)
    return pose.header.seq, time.monotonic()
