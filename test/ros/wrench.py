"""A stamped wrench as vectors."""

import numpy


def rotation(quaternion):
    """Its matrix, from the tool's frame into the body's."""
    x, y, z, w = quaternion
    cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + 2 * w * cross + 2 * cross @ cross


def force(stamped):
    return numpy.array([stamped.wrench.force.x, stamped.wrench.force.y, stamped.wrench.force.z])


def torque(stamped):
    return numpy.array([stamped.wrench.torque.x, stamped.wrench.torque.y, stamped.wrench.torque.z])
