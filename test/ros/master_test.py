#!/usr/bin/python3
"""A master that goes, and one that comes, do not disturb the node."""

import os
import signal
import socket
import struct
import subprocess
import sys
import unittest
import xmlrpc.client

import roslib.packages
import rospy
import rostest
from incision.msg import BodyState
from incision_client import TIMEOUT, wait_for

NODE = roslib.packages.find_node('incision', 'incision_node')[0]


def listen(node, topic):
    """A subscriber that needs no master: the bytes of each message of a node's topic."""
    port = xmlrpc.client.ServerProxy(node).requestTopic('/listener', topic, [['TCPROS']])[2][2]
    connection = socket.create_connection(('127.0.0.1', port), timeout=TIMEOUT)
    fields = [b'callerid=/listener', b'topic=' + topic.encode(), b'type=*', b'md5sum=*']
    header = b''.join(struct.pack('<I', len(field)) + field for field in fields)
    connection.sendall(struct.pack('<I', len(header)) + header)
    stream = connection.makefile('rb')
    while True:
        yield stream.read(struct.unpack('<I', stream.read(4))[0])


class Master(unittest.TestCase):
    """A master of its own, so that the others do not miss it."""

    def start_master(self, port):
        master = subprocess.Popen(['rosmaster', '--core', '-p', str(port)], stdout=subprocess.DEVNULL)
        self.addCleanup(master.wait)
        self.addCleanup(master.kill)
        proxy = xmlrpc.client.ServerProxy(f'http://127.0.0.1:{port}/')

        def answers():
            try:
                return proxy.getUri('/test')
            except OSError:
                return None
        wait_for(answers, 'the master')
        return master, proxy

    def steps_on(self, states, count):
        last = BodyState().deserialize(next(states)).step
        for state in states:
            if BodyState().deserialize(state).step > last + count:
                return

    def test_the_body_goes_on_without_a_master_and_when_it_is_back(self):
        with socket.socket() as free:
            free.bind(('127.0.0.1', 0))
            port = free.getsockname()[1]
        master, proxy = self.start_master(port)
        proxy.setParam('/test', '/lone/scene', {'body': {'grid': {'cells': [2, 1, 1]}}})
        node = subprocess.Popen([NODE, '__name:=lone'], env=dict(os.environ, ROS_MASTER_URI=f'http://127.0.0.1:{port}/'))
        self.addCleanup(node.kill)
        wait_for(lambda: '/lone/state' in dict(proxy.getSystemState('/test')[2][0]), 'the node')
        uri = proxy.lookupNode('/test', '/lone')[2]
        states = listen(uri, '/lone/state')
        next(states)  # the header of the connection
        self.steps_on(states, 20)
        master.kill()
        master.wait()
        self.steps_on(states, 100)
        self.start_master(port)
        self.steps_on(states, 50)
        node.send_signal(signal.SIGINT)
        self.assertEqual(0, node.wait(TIMEOUT))


if __name__ == '__main__':
    rospy.init_node('master_test')
    rostest.rosrun('incision', 'master', Master, sys.argv)
