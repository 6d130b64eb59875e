#pragma once

// The package's messages and the core share the namespace `incision`, and both have a CutPlane. To ROS it is the
// message's name on the wire, so in our own code the message yields and is called CutPlaneMessage.
#define CutPlane CutPlaneMessage
#include <incision/CutPlane.h>
#undef CutPlane

#include <incision/BodyState.h>
#include <incision/CutReport.h>
