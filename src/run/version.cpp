#include "incision/run/version.h"

#include "incision_description.h"

namespace incision {

std::string version() {
#if defined(INCISION_NATIVE)
  const char* processors = "native";
#elif defined(__AVX2__) && defined(__FMA__)
  const char* processors = "x86-64-v3";
#else
  const char* processors = "plain";
#endif
  return std::string(INCISION_DESCRIPTION) + " " + processors;
}

}  // namespace incision
