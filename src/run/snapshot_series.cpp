#include "incision/run/snapshot_series.h"

#include <cstdio>
#include <filesystem>

#include "incision/base/input_error.h"
#include "incision/base/printable.h"
#include "incision/run/output_file.h"
#include "incision/run/snapshot.h"

namespace incision {
namespace {

constexpr const char* END = "</Collection>\n</VTKFile>\n";

std::string stemOf(const std::string& path) {
  const std::filesystem::path name(path);
  if (name.extension() != ".pvd" || name.stem().empty())
    throw InputError("--series: '" + printable(path) + "' (allowed: a name that ends in .pvd)");
  return (name.parent_path() / name.stem()).string();
}

std::string numbered(const std::string& stem, const char* kind, std::int64_t step) {
  char digits[24];
  std::snprintf(digits, sizeof digits, "%08lld", static_cast<long long>(step));
  return stem + "_" + kind + "_" + digits + ".vtu";
}

}  // namespace

SnapshotSeries::SnapshotSeries(const std::string& path, std::int64_t every)
    : stem_(stemOf(path)), every_(every), list_(openOutput(path)) {
  list_ << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
        << "<Collection>\n";
}

/// The list is whole after each snapshot, so that a run that is stopped can be looked at.
void SnapshotSeries::add(const DeformableBody& body, bool must) {
  if (body.steps() == last_ || (!must && body.steps() % every_ != 0)) return;
  last_ = body.steps();
  int block = 0;
  for (const auto& [kind, write] : {std::pair{"surface", &writeSnapshot}, std::pair{"volume", &writeVolumeSnapshot}}) {
    const std::string path = numbered(stem_, kind, last_);
    try {
      std::ofstream file = openOutput(path);
      write(file, body);
      good_ = file.flush() && good_;
    } catch (const InputError&) {  // the folder is no longer there, or the disk is full
      good_ = false;
    }
    list_ << "<DataSet timestep=\"" << body.time() << "\" part=\"" << block++ << "\" name=\"" << kind << "\" file=\""
          << std::filesystem::path(path).filename().string() << "\"/>\n";
  }
  const auto end = list_.tellp();
  list_ << END;
  good_ = list_.flush() && good_;
  list_.seekp(end);
}

}  // namespace incision
