"""What the tests of the node share: its topics and services, and waiting for what they say."""

import threading
import time

import rospy
from geometry_msgs.msg import Point, PoseStamped, Quaternion, Vector3
from incision.msg import BodyState, CutPlane, CutReport
from std_srvs.srv import SetBool, Trigger

TIMEOUT = 15.0  # [s] wall time; far above what anything here takes


class Client:
    """Talks to one node and remembers what it says."""

    def __init__(self, name='/incision'):
        self.states, self.reports = [], []
        self._news = threading.Condition()
        rospy.Subscriber(name + '/state', BodyState, lambda message: self._keep(self.states, message))
        rospy.Subscriber(name + '/cut_report', CutReport, lambda message: self._keep(self.reports, message))
        self._cuts = rospy.Publisher(name + '/cut_plane', CutPlane, queue_size=10000, tcp_nodelay=True)
        self._poses = rospy.Publisher(name + '/tool_pose', PoseStamped, queue_size=1000)
        self._services = {}
        for service, kind in (('pause', SetBool), ('step', Trigger), ('reset', Trigger)):
            rospy.wait_for_service(f'{name}/{service}', TIMEOUT)
            self._services[service] = rospy.ServiceProxy(f'{name}/{service}', kind)
        self.wait_for(lambda: self._cuts.get_num_connections() and self._poses.get_num_connections(), 'the node')
        self.wait_for(lambda: self.states, 'a state')

    def _keep(self, kept, message):
        with self._news:
            kept.append(message)
            self._news.notify_all()

    def wait_for(self, condition, what, timeout=TIMEOUT):
        """Waits until `condition` gives something that counts as true, and returns it."""
        deadline = time.monotonic() + timeout
        with self._news:
            while True:
                result = condition()
                if result:
                    return result
                if time.monotonic() > deadline:
                    raise AssertionError(f'waited {timeout} s for {what}')
                self._news.wait(0.05)

    @property
    def state(self):
        return self.states[-1]

    def next_state(self):
        """A state that was published after this call."""
        seen = len(self.states)
        self.wait_for(lambda: len(self.states) > seen + 1, 'the next state')
        return self.state

    def pause(self, paused=True):
        return self._services['pause'](paused)

    def step(self):
        return self._services['step']()

    def reset(self):
        """Returns when a state after the reset has come, so that no test sees what the one before it left."""
        answer = self._services['reset']()
        self.next_state()
        return answer

    def cut(self, **fields):
        """Asks for a cut and waits for its report."""
        plane = cut_plane(**fields)
        seen = len(self.reports)
        self._cuts.publish(plane)
        return self.wait_for(
            lambda: next((r for r in self.reports[seen:] if r.label == plane.label[:64]), None), 'a report')

    def send(self, plane):
        self._cuts.publish(plane)

    def move_tool(self, pose):
        self._poses.publish(pose)


def wait_for(condition, what, timeout=TIMEOUT):
    """The same without a client."""
    deadline = time.monotonic() + timeout
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError(f'waited {timeout} s for {what}')
        time.sleep(0.01)


def cut_plane(frame='body', stamp=None, label='cut', point=(0, 0, 0), normal=(1, 0, 0), tangent=(0, 0, 0), length=0,
              width=0):
    plane = CutPlane(label=label, point=Point(*point), normal=Vector3(*normal), tangent=Vector3(*tangent),
                     length=length, width=width)
    plane.header.frame_id = frame
    if stamp is not None:
        plane.header.stamp = stamp
    return plane


def tool_pose(position, orientation=(0, 0, 0, 1), frame='body'):
    pose = PoseStamped()
    pose.header.frame_id = frame
    pose.pose.position = Point(*position)
    pose.pose.orientation = Quaternion(*orientation)
    return pose
