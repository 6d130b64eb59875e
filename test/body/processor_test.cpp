// The dynamic loader is to take the core that was built for this processor; nothing else would show that it does not.
#include <gtest/gtest.h>
#include <link.h>

#include <cstdlib>
#include <string>

#include "incision/run/batch.h"

#ifdef INCISION_V3

namespace incision::test {
namespace {

// Where the core was loaded from.
std::string pathOfCore() {
  std::string path;
  const auto look = [](dl_phdr_info* library, std::size_t, void* found) {
    const std::string name = library->dlpi_name;
    if (name.find("/libincision.so") == std::string::npos) return 0;
    *static_cast<std::string*>(found) = name;
    return 1;
  };
  dl_iterate_phdr(look, &path);
  return path;
}

TEST(Processor, GetsTheCoreBuiltForIt) {
  parseBatchArguments({"--help"});  // the core is needed, so it is loaded
  // Where the loader is told to know of no AVX2, as in the tests of the plain library, it must take that one.
  const char* masked = std::getenv("GLIBC_TUNABLES");
  const bool has_v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                      !(masked && std::string(masked).find("-AVX2") != std::string::npos);
  const std::string folder = "/glibc-hwcaps/x86-64-v3/";
  EXPECT_EQ(pathOfCore().find(folder) != std::string::npos, has_v3) << pathOfCore();
}

}  // namespace
}  // namespace incision::test

#endif
