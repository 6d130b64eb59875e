#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "incision/body/quantities.h"

namespace incision {

/// Where a run's steps come from that are not the scene's alone.
class StepSource {
 public:
  virtual ~StepSource() = default;

  /// Whether there is another step; what is to be done before it has been told to the body then. Throws InputError
  /// where the source cannot be read on.
  virtual bool prepare() = 0;

  /// The step that was prepared has been taken.
  virtual void taken(const StepResult& step) = 0;

  /// There are no more steps. What waits is answered; of a step that failed come `cuts` that took effect before it.
  virtual void finish(const std::vector<CutResult>& cuts) = 0;

  /// How what moves is led, as far as that outlasts a step, in the bytes of a saved body's `leads`; and to go on from
  /// such bytes, the body having been restored, before the first step. Throws InputError where they are of another
  /// scene.
  virtual std::string leads() const = 0;
  virtual void recall(const std::string& leads) = 0;

  /// What has become of each cut so far.
  virtual const std::vector<CutResult>& cuts() const = 0;

  /// About how many steps there are.
  virtual std::int64_t steps() const = 0;

  /// What there is to say since the last call, each in a line.
  virtual std::vector<std::string> takeRemarks() = 0;

  /// What the summary says of it, in a group of this name.
  virtual std::string name() const = 0;
  virtual std::vector<Quantity> quantities() const = 0;
};

}  // namespace incision
