#include "incision/run/run_record.h"

#include "incision/body/quantities.h"
#include "incision/run/output_file.h"

namespace incision {
namespace {

constexpr const char* AXES[] = {"_x", "_y", "_z"};

/// Calls f(column, value) for each number of the quantities that go into the record.
template <typename Function>
void forEachColumn(const std::vector<Quantity>& quantities, const Function& f) {
  for (const Quantity& quantity : quantities) {
    if (!quantity.in_record) continue;
    if (const Vec3* vector = std::get_if<Vec3>(&quantity.value))
      for (int i = 0; i < 3; ++i) f(quantity.name + AXES[i], (*vector)[i]);
    else if (const double* number = std::get_if<double>(&quantity.value))
      f(quantity.name, *number);
    else
      f(quantity.name, std::get<std::int64_t>(quantity.value));
  }
}

std::vector<Quantity> recorded(const DeformableBody& body, const StepResult& step) {
  std::vector<Quantity> quantities = quantitiesOf(body, step);
  for (const Quantity& wrench : wrenchQuantitiesOf(body)) quantities.push_back(wrench);
  for (std::size_t i = 0; i < body.tools(); ++i)
    for (Quantity of_tool : toolQuantitiesOf(body, i, step)) {
      of_tool.name = "tool_" + body.scene().tools[i].name + "_" + of_tool.name;
      quantities.push_back(of_tool);
    }
  return quantities;
}

}  // namespace

RunRecord::RunRecord(const std::string& path, const DeformableBody& body, bool hashed)
    : file_(openOutput(path)), hashed_(hashed) {
  file_ << "step,time,";
  forEachColumn(recorded(body, StepResult()), [&](const std::string& column, auto) { file_ << column << ','; });
  file_ << "step_ms" << (hashed_ ? ",state_hash" : "") << '\n' << std::flush;
}

void RunRecord::write(const DeformableBody& body, const StepResult& step) {
  file_ << body.steps() << ',' << body.time() << ',';
  forEachColumn(recorded(body, step), [&](const std::string&, auto value) { file_ << value << ','; });
  file_ << step.step_ms;
  if (hashed_) file_ << ',' << hexadecimal(body.stateHash());
  file_ << '\n' << std::flush;
}

}  // namespace incision
