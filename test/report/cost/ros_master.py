"""A ROS master for this program alone."""

import contextlib
import os
import socket
import subprocess
import time
import xmlrpc.client


def free_port():
    with socket.socket() as probe:
        probe.bind(('127.0.0.1', 0))
        return probe.getsockname()[1]


@contextlib.contextmanager
def running():
    """Environment of programs that are to find it, while it runs."""
    address = f'http://127.0.0.1:{free_port()}'
    process = subprocess.Popen(['rosmaster', '--core', '-p', address.rsplit(':', 1)[1]], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL, env={**os.environ, 'ROS_MASTER_URI': address})
    try:
        wait_for(address)
        yield {'ROS_MASTER_URI': address, 'ROS_IP': '127.0.0.1'}
    finally:
        process.terminate()
        process.wait()


def wait_for(address):
    deadline = time.monotonic() + 30
    while True:
        try:
            return xmlrpc.client.ServerProxy(address).getPid('/cost')
        except OSError:
            if time.monotonic() > deadline:
                raise
            time.sleep(0.05)
