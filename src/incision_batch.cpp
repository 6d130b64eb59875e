#include <iostream>

#include "incision/run/batch.h"

int main(int argc, char** argv) {
  incision::stopAtSignals();
  return static_cast<int>(incision::runBatch({argv + 1, argv + argc}, std::cout, std::cerr));
}
