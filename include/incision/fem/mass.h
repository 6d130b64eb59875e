#pragma once

namespace incision {

enum class Mass { LUMPED, CONSISTENT };

}  // namespace incision
