#include "incision/run/output_file.h"

#include <cerrno>
#include <cstring>
#include <limits>

#include "incision/base/input_error.h"
#include "incision/base/printable.h"

namespace incision {

std::ofstream openOutput(const std::string& path) {
  std::ofstream file(path);
  if (!file) throw InputError(printable(path) + ": cannot be written: " + std::strerror(errno));
  file.precision(std::numeric_limits<double>::max_digits10);
  return file;
}

}  // namespace incision
