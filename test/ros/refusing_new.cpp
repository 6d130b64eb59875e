// Loaded before the node's libraries it takes the place of `new`: between two signals, SIGUSR1 and SIGUSR2, it refuses
// every PERIOD-th call from the core. Calls from other libraries, which end the process or lose messages where there is
// no memory, are not refused.
#include <dlfcn.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <new>

namespace {

/// A cut of the small body of the test takes some thousands, which succeed now and then.
constexpr unsigned PERIOD = 3001;

std::atomic<bool> refusing{false};
std::atomic<unsigned> calls{0};

bool isOfTheCore(const void* caller) {
  Dl_info found;
  return dladdr(caller, &found) != 0 && std::strstr(found.dli_fname, "libincision.so") != nullptr;
}

[[maybe_unused]] const bool listening = [] {
  std::signal(SIGUSR1, [](int) { refusing = true; });
  std::signal(SIGUSR2, [](int) { refusing = false; });
  return true;
}();

}  // namespace

void* operator new(std::size_t size) {
  const bool refused = refusing && isOfTheCore(__builtin_return_address(0)) && ++calls % PERIOD == 0;
  void* const memory = refused ? nullptr : std::malloc(size > 0 ? size : 1);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
