#include "incision/ros/reconfigure.h"

#include <incision/BodyConfig.h>

#include <cmath>
#include <utility>

#include "incision/base/input_error.h"

namespace incision {
namespace {

/// Messages that may wait for those before them to take effect, which they do between two steps.
constexpr std::uint32_t WAITING = 100;

Refusal kindOf(const dynamic_reconfigure::Config& message) {
  for (const auto& parameter : message.doubles)
    if (!std::isfinite(parameter.value)) return Refusal::NOT_FINITE;
  return Refusal::OUT_OF_RANGE;
}

}  // namespace

Reconfigure::Reconfigure(const ros::NodeHandle& node, const NodeLiveSettings& at_start, SteppingTasks& tasks,
                         PublishingThread* thread, Apply apply, Refuse refuse)
    : tasks_(tasks),
      thread_(thread),
      apply_(std::move(apply)),
      refuse_(std::move(refuse)),
      now_(at_start),
      node_(node),
      descriptions_(node_.advertise<dynamic_reconfigure::ConfigDescription>("parameter_descriptions", 1, true)),
      updates_(thread, node_.advertise<dynamic_reconfigure::Config>("parameter_updates", WAITING, true),
               MessageQueue<dynamic_reconfigure::Config>::ALL),
      service_(node_.advertiseService("set_parameters", &Reconfigure::answer, this)),
      subscriber_(node_.subscribe("parameters", WAITING, &Reconfigure::receive, this)) {
  // What clients show as the default is what holds at the start.
  dynamic_reconfigure::ConfigDescription description = BodyConfig::__getDescriptionMessage__();
  description.dflt = toConfig(now_);
  descriptions_.publish(description);
  publish();
}

bool Reconfigure::answer(Service::Request& request, Service::Response& response) {
  return tasks_.ask([&] {
    take(request.config, service_.getService());
    response.config = toConfig(now_);
  });
}

void Reconfigure::receive(const dynamic_reconfigure::Config& message) {
  try {
    tasks_.ask([&] { take(message, subscriber_.getTopic()); });
  } catch (const std::bad_alloc&) {
    refuse_({Refusal::BY_BODY, "memory ran out"});
  }
}

void Reconfigure::take(const dynamic_reconfigure::Config& message, const std::string& source) {
  try {
    const NodeLiveSettings next = changed(now_, message, source);
    apply_(next);
    now_ = next;
  } catch (const InputError& error) {
    refuse_({kindOf(message), error.what()});
  }
  publish();
}

void Reconfigure::show(const LiveSettings& body) {
  if (now_.body == body) return;
  now_.body = body;
  publish();
}

void Reconfigure::publish() {
  updates_.give([this](dynamic_reconfigure::Config* message) { *message = toConfig(now_); });
  thread_->flush();
}

}  // namespace incision
