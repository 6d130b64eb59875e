#pragma once

namespace incision {

/// A probe has nothing beside what all tools have.
struct ProbeSettings {};

}  // namespace incision
