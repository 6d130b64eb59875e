#!/usr/bin/python3
"""Connections that send garbage, or nothing, or half of something, do not disturb the node."""

import random
import socket
import struct
import sys
import unittest
import urllib.parse
import xmlrpc.client

import rospy
import rostest
from incision_client import Client

CONNECTIONS = 10  # of each kind to each port


class Peers(unittest.TestCase):
    def setUp(self):
        self.client = Client()
        uri = rospy.get_master().lookupNode('/incision')[2]
        proxy = xmlrpc.client.ServerProxy(uri)
        protocol = proxy.requestTopic('/peers', '/incision/state', [['TCPROS']])[2]
        self.ports = [urllib.parse.urlsplit(uri).port, protocol[2]]
        self.open = []

    def tearDown(self):
        for connection in self.open:
            connection.close()

    def connect(self, port):
        connection = socket.create_connection(('127.0.0.1', port), timeout=10)
        self.open.append(connection)
        return connection

    def test_garbage_and_silence_leave_the_node_at_work(self):
        draw = random.Random(1)
        header = b'callerid=/nobody\x00topic=/incision/state'
        for port in self.ports:
            for _ in range(CONNECTIONS):
                self.connect(port)  # which stays, and says nothing
                self.send(port, bytes(draw.randrange(256) for _ in range(draw.randint(1, 2000))))
                self.send(port, struct.pack('<I', draw.choice((0, 1, 5, 0x7fffffff, 0xffffffff))) + header)
                self.send(port, b'POST / HTTP/1.1\r\nContent-Length: 1000000\r\n\r\n<?xml')
                self.send(port, b'GET ' + b'a' * 5000)
        before = self.client.next_state()
        after = self.client.after_steps(50)
        self.assertEqual('', after.error)
        self.assertGreater(after.step, before.step)
        self.assertTrue(self.client.pause().success)
        self.assertEqual(2, self.client.cut(point=(0.51, 0, 0)).pieces)

    def send(self, port, data):
        """Some of them are closed at once, others stay."""
        connection = self.connect(port)
        try:
            connection.sendall(data)
        except OSError:  # refused by then
            pass
        if len(self.open) % 2:
            self.open.pop().close()


if __name__ == '__main__':
    rospy.init_node('peers_test')
    rostest.rosrun('incision', 'peers', Peers, sys.argv)
