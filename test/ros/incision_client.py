"""What the tests of the node share: its topics and services, and waiting for what they say."""

import math
import subprocess
import threading
import time

import rospy
from geometry_msgs.msg import Point, PoseStamped, Quaternion, Vector3, WrenchStamped
from incision.msg import BodyState, CutPlane, CutReport
from incision.srv import Checkpoint
from sensor_msgs.msg import JointState
from std_msgs.msg import Bool
from std_srvs.srv import SetBool, Trigger

TIMEOUT = 40.0  # [s] wall time; far above what anything here takes, on a busy machine too


STEPS_A_SECOND = 100  # of the scenes whose clock a test leads step by step


def time_of(tick):
    """Exactly: a time that is made from a double is rounded down."""
    return rospy.Time(tick // STEPS_A_SECOND, tick % STEPS_A_SECOND * (1_000_000_000 // STEPS_A_SECOND))


def checkpoint_service(name):
    """`save` or `restore` of /incision, when it is there."""
    rospy.wait_for_service(f'/incision/{name}', TIMEOUT)
    return rospy.ServiceProxy(f'/incision/{name}', Checkpoint)


class Client:
    """Talks to one node and remembers what it says."""

    def __init__(self, name='/incision', tool='tool'):
        """`tool`: name of the scene's, or of one of them."""
        self.tool_name = tool
        self.states, self.reports, self.wrenches, self.jaws = [], [], [], []
        self._news = threading.Condition()
        rospy.Subscriber(name + '/state', BodyState, lambda message: self._keep(self.states, message))
        rospy.Subscriber(name + '/cut_report', CutReport, lambda message: self._keep(self.reports, message))
        rospy.Subscriber(f'{name}/{tool}/measured_cf', WrenchStamped, lambda message: self._keep(self.wrenches, message))
        self._cuts = rospy.Publisher(name + '/cut_plane', CutPlane, queue_size=10000, tcp_nodelay=True)
        self._poses = rospy.Publisher(f'{name}/{tool}/servo_cp', PoseStamped, queue_size=1000)
        self._tool_active = rospy.Publisher(f'{name}/{tool}/active', Bool, queue_size=10, latch=True)
        of_tool = rospy.get_param(f'{name}/scene/tools', {}).get(tool, {'frame': None})
        needed = [self._cuts] if 'frame' in of_tool else [self._cuts, self._poses]
        if 'joint' in of_tool:
            rospy.Subscriber(f'{name}/{tool}/jaw/measured_js', JointState, lambda message: self._keep(self.jaws, message))
            self._jaws = rospy.Publisher(f'{name}/{tool}/jaw/servo_jp', JointState, queue_size=1000)
            needed.append(self._jaws)
        self._services = {}
        for service, kind in (('pause', SetBool), ('step', Trigger), ('reset', Trigger)):
            rospy.wait_for_service(f'{name}/{service}', TIMEOUT)
            self._services[service] = rospy.ServiceProxy(f'{name}/{service}', kind)
        self.wait_for(lambda: all(topic.get_num_connections() for topic in needed), 'the node')
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

    def tool_in(self, state):
        """What a state says of the tool."""
        return next(tool for tool in state.tools if tool.name == self.tool_name)

    @property
    def tool(self):
        return self.tool_in(self.state)

    def next_state(self):
        """A state that was published after this call."""
        seen = len(self.states)
        self.wait_for(lambda: len(self.states) > seen + 1, 'the next state')
        return self.state

    def after_steps(self, count):
        """The state that many steps later."""
        last = self.next_state().step + count
        return self.wait_for(lambda: self.state.step >= last and self.state, f'{count} steps')

    def reports_after(self, stamp):
        """Those made later. The report of a stroke that a reset ended may come when the reset has been answered."""
        return [report for report in self.reports if report.header.stamp > stamp]

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

    def lead_tool(self, poses):
        """One pose a step. The last one has not been followed yet when this returns."""
        for pose in poses:
            seen = len(self.states)
            self.move_tool(pose)
            self.wait_for(lambda: len(self.states) > seen, 'a step')

    def move_jaw(self, angle):
        self.send_jaw(JointState(position=[angle]))

    def send_jaw(self, message):
        self._jaws.publish(message)

    def activate_tool(self, active=True):
        self._tool_active.publish(active)
        self.wait_for(lambda: self.tool.active == active, f'the tool to be active: {active}')


def wait_for(condition, what, timeout=TIMEOUT):
    """Waits without a client until `condition` gives something that counts as true."""
    deadline = time.monotonic() + timeout
    while not condition():
        if time.monotonic() > deadline:
            raise AssertionError(f'waited {timeout} s for {what}')
        time.sleep(0.01)


def run_to_its_end(program, parameters):
    """Starts a node as /bad with these parameters; its exit status, and what it says of errors."""
    rospy.set_param('/bad', parameters)
    run = subprocess.run([program, '__name:=bad'], stderr=subprocess.PIPE, timeout=TIMEOUT, check=False)
    rospy.delete_param('/bad')
    return run.returncode, run.stderr.decode()


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


def tool_line(start, end, orientation=(0, 0, 0, 1), step=0.005):
    """Poses from `start` to `end` in the body's frame, evenly, up to `step` [m] apart."""
    count = math.ceil(math.dist(start, end) / step)
    return [tool_pose([a + (b - a) * i / count for a, b in zip(start, end)], orientation) for i in range(count + 1)]
