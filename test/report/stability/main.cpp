// Stability on stiff and extreme cases: each is run to its end, and what it must keep is measured.

#include "stability.h"

int main(int argc, char** argv) {
  incision::report::Findings findings(argc, argv);
  incision::report::Matrix matrix(&findings);
  incision::report::mapOfStiffness(&matrix);
  incision::report::extremeShapes(&matrix);
  incision::report::cutsAndGeometry(&matrix);
  incision::report::smallParts(&matrix);
  incision::report::manyCuts(&matrix);
  incision::report::extremeMotion(&matrix);
  incision::report::extremeElements(&matrix);
  return findings.write();
}
