#pragma once

#include <dynamic_reconfigure/Config.h>
#include <rosgraph_msgs/Clock.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <memory>
#include <string>
#include <vector>

#include "incision/pace/pace_watch.h"
#include "incision/pace/step_input.h"
#include "incision/ros/bag/bag_answers.h"
#include "incision/ros/bag/bag_reader.h"
#include "incision/ros/bag/silence.h"
#include "incision/ros/tf_frames.h"
#include "incision/run/batch.h"
#include "incision/run/step_source.h"

namespace incision {

/// The program that runs a bag of messages to the node, without one.
extern const BatchProgram BAG;

/// The steps that the node takes when `rosbag play --clock` plays a bag to it, if it keeps up whatever it costs. The
/// time of recording stands for that of receipt, and steps take none of it. Where the bag has no /clock, the time of
/// recording is the clock, in ticks at the starts of steps.
class BagSteps : public StepSource {
 public:
  /// Throws InputError where the bag cannot be used. `body` must outlive this.
  BagSteps(const BatchOptions& options, DeformableBody* body);

  bool prepare() override;
  void taken(const StepResult& step) override;
  void finish(const std::vector<CutResult>& cuts) override;
  std::string leads() const override { return toBytes(input_.keep()); }
  void recall(const std::string& leads) override;
  const std::vector<CutResult>& cuts() const override { return answers_.cuts(); }
  std::int64_t steps() const override;
  std::vector<std::string> takeRemarks() override { return answers_.takeRemarks(); }
  std::string name() const override { return "bag"; }
  std::vector<Quantity> quantities() const override;

 private:
  std::vector<BagTopic> topics(const std::string& node);
  void receive(const rosgraph_msgs::Clock& message, SteadyTime received);
  void receive(const tf2_msgs::TFMessage& message, bool is_static);
  void receive(const dynamic_reconfigure::Config& message);
  bool advance();
  SteadyTime nextTick() const;
  void tick();

  const Silence silence_;
  DeformableBody& body_;
  const double time_step_;
  const CommandSettings settings_;
  BagAnswers answers_;
  tf2::BufferCore buffer_;
  const TfFrames frames_;
  Wakeup wakeup_;  ///< of nobody: there is one thread
  Commands commands_;
  CommandMessages messages_;
  ClockPacer pacer_;
  StepInput input_;
  PaceWatch watch_;
  BagReader reader_;
  const bool has_clock_;

  SteadyTime now_;
  std::int64_t ticks_ = 0;                ///< where the bag has no clock
  Nanoseconds clock_ = 0, tf_clock_ = 0;  ///< the last tick; at the last transform
};

}  // namespace incision
