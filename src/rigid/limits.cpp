#include "limits.h"

#include <sstream>

#include "incision/base/input_error.h"

namespace incision {
namespace {

/// NaN is outside of every range.
void checkRange(double value, double least, double most, const std::string& what) {
  if (value >= least && value <= most) return;
  std::ostringstream text;
  text << what << ' ' << value << " (allowed: " << least << " to " << most << " m)";
  throw InputError(text.str());
}

}  // namespace

void checkLength(double length, const std::string& what) { checkRange(length, MIN_SIZE, MAX_LENGTH, what); }

void checkCoordinate(double coordinate, const std::string& what) {
  checkRange(coordinate, -MAX_LENGTH, MAX_LENGTH, what);
}

}  // namespace incision
