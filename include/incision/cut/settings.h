#pragma once

#include "incision/cut/plane_cut.h"

namespace incision {

class YamlValue;

struct ScheduledCut {
  double time = 0;  ///< takes effect before the step that starts at the first k Δt ≥ time
  PlaneCut plane;
};

/// An entry of the section `cuts`. Throws InputError.
ScheduledCut parseCut(const YamlValue& value);

}  // namespace incision
