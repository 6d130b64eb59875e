#include <iostream>

#include "incision/ros/bag/bag_steps.h"

int main(int argc, char** argv) {
  incision::stopAtSignals();
  return static_cast<int>(incision::runProgram(incision::BAG, {argv + 1, argv + argc}, std::cout, std::cerr));
}
