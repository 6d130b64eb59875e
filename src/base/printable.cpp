#include "incision/base/printable.h"

#include <algorithm>

namespace incision {

namespace {
constexpr std::size_t MAX_SHOWN = 200;  // bytes: a message stays one line that can be read
}

std::string printable(const std::string& text) {
  std::string shown = text.substr(0, MAX_SHOWN);
  std::replace_if(
      shown.begin(), shown.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return text.size() > MAX_SHOWN ? shown + "..." : shown;
}

}  // namespace incision
