#include "report/contact/problems.h"

namespace incision::report {

using nlohmann::json;

json toJson(const ContactProblem& problem) {
  json found = {{"name", problem.name}, {"quantity", problem.quantity}};
  for (const ContactCurve& curve : problem.curves) {
    json points = json::array();
    for (const ContactRun& run : curve.runs)
      points.push_back({{"elements", run.elements},
                        {"across", run.across},
                        {"time_step", run.time_step},
                        {"ms", run.ms},
                        {"value", run.value},
                        {"error", run.value / curve.answer - 1},
                        {"unsettled", run.unsettled}});
    found["curves"].push_back({{"name", curve.name}, {"answer", curve.answer}, {"points", points}});
  }
  return found;
}

Vec3 meanDisplacement(const DeformableBody& body, double z, std::optional<double> x) {
  const std::vector<Vec3>& X = body.mesh().mesh().nodes;
  const std::vector<Vec3> now = body.nodePositions();
  Vec3 sum = Vec3::Zero();
  int count = 0;
  for (std::size_t n = 0; n < X.size(); ++n) {
    if (std::abs(X[n].z() - z) > 1e-9 || (x && std::abs(X[n].x() - *x) > 1e-9)) continue;
    sum += now[n] - X[n];
    ++count;
  }
  return sum / count;
}

}  // namespace incision::report
