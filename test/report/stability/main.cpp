// Stability on stiff and extreme cases: each is run to its end, and what it must keep is measured.

#include "stability.h"

int main(int argc, char** argv) {
  using namespace incision::report;
  return writeSection(argc, argv, [](bool quick, nlohmann::json* data) {
    Matrix matrix(quick, data);
    for (const auto group : {mapOfStiffness, extremeShapes, cutsAndGeometry, smallParts, manyCuts, extremeMotion,
                             extremeElements, contactEnsembles})
      group(&matrix);
  });
}
