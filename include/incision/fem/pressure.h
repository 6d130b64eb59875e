#pragma once

namespace incision {

/// What pressure in nearly incompressible tissue is reckoned from: the volume change of each element, or the mean over
/// the elements of a patch (Patches).
enum class Pressure { ELEMENT, AVERAGED };

}  // namespace incision
