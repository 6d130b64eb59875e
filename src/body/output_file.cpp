#include "incision/body/output_file.h"

#include <cerrno>
#include <cstring>
#include <limits>

#include "incision/body/printable.h"
#include "incision/mesh/input_error.h"

namespace incision {

std::ofstream openOutput(const std::string& path) {
  std::ofstream file(path);
  if (!file) throw InputError(printable(path) + ": cannot be written: " + std::strerror(errno));
  file.precision(std::numeric_limits<double>::max_digits10);
  return file;
}

}  // namespace incision
