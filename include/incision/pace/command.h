#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <variant>

#include "incision/cut/crack.h"
#include "incision/rigid/pose.h"

namespace incision {

/// Wall time that never jumps.
using SteadyTime = std::chrono::steady_clock::time_point;

inline SteadyTime steadyNow() { return std::chrono::steady_clock::now(); }

/// ROS time [ns]. Plain integers, because differences of ros::Time throw where a hostile stamp makes them overflow.
using Nanoseconds = std::int64_t;

inline double toSeconds(Nanoseconds time) { return 1e-9 * static_cast<double>(time); }

/// Whether it is one that a message can say: from 1970 on, in seconds of 32 bits.
inline bool isRosTime(Nanoseconds time) { return 0 <= time && time < Nanoseconds{1'000'000'000} << 32; }

/// Where a tool's link shall go.
struct ToolPose {
  int tool;  ///< index of it
  Pose pose;
};

/// What a message asks for.
using Action = std::variant<PlaneCut, ToolPose>;

/// A message that passed validation.
struct Command {
  Action action;      ///< in `frame`
  std::string frame;  ///< tf frame, without a leading slash
  Nanoseconds stamp;  ///< time of the frame; 0: now
  SteadyTime received;
};

/// The command as the body's frame sees it, in which its own frame stands at this pose.
Command inBodyFrame(const Command& command, const Pose& frame, const std::string& body_frame);

/// Why a message was refused.
enum class Refusal { NOT_FINITE, OUT_OF_RANGE, NO_TRANSFORM, TOO_MANY, BY_BODY, BY_RESET };
inline constexpr int NUM_REFUSALS = 6;

struct Refused {
  Refusal kind;
  std::string reason;  ///< in words, for the sender
};

}  // namespace incision
