#include <csignal>
#include <iostream>

#include "incision/ros/bag/bag_steps.h"

int main(int argc, char** argv) {
  const auto stop = [](int signal) {
    incision::stopBatch();
    std::signal(signal, SIG_DFL);  // a second Ctrl-C does not wait for the step to end
  };
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
  return static_cast<int>(incision::runProgram(incision::BAG, {argv + 1, argv + argc}, std::cout, std::cerr));
}
