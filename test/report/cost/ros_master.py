"""A ROS master for this program alone."""

import contextlib
import os
import socket
import subprocess
import tempfile
import time
import xmlrpc.client


def free_port():
    with socket.socket() as probe:
        probe.bind(('127.0.0.1', 0))
        return probe.getsockname()[1]


@contextlib.contextmanager
def running():
    """Environment of programs that are to find it, while it runs."""
    port = free_port()
    with tempfile.TemporaryDirectory() as home:
        environment = {'ROS_MASTER_URI': f'http://127.0.0.1:{port}', 'ROS_HOSTNAME': '127.0.0.1', 'ROS_HOME': home}
        process = subprocess.Popen(['rosmaster', '--core', '-p', str(port)], stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL, env={**os.environ, **environment})
        try:
            wait_for(environment['ROS_MASTER_URI'])
            yield environment
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
