#include "incision/tool/blade.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>

#include "incision/mesh/input_error.h"

namespace incision {

namespace {

// urdfdom's XML parser calls itself for every nested element, at under 400 bytes of stack each: this many fit twice
// into the usual 8 MB. A large humanoid has some 5,000.
constexpr std::ptrdiff_t MAX_ELEMENTS = 10'000;

// Bytes: what people write is a hundredth of it.
constexpr std::size_t MAX_DESCRIPTION = std::size_t{1} << 20;

// urdfdom's XML parser trusts the first byte of a character, which promises up to four, and reads past the end of a
// text that breaks off within one. These come after it.
constexpr const char* PADDING = "    ";

// Keeps urdfdom from printing and remembers its first complaint, for as long as it lives. urdfdom hands text of the
// description to printf as the format: where a '%' may be in it, written out or as a reference, it is not heard at all.
class QuietConsole : public console_bridge::OutputHandler {
 public:
  explicit QuietConsole(const std::string& urdf) : previous_(console_bridge::getOutputHandler()) {
    const bool may_be_heard = urdf.find_first_of("%&") == std::string::npos;
    console_bridge::useOutputHandler(may_be_heard ? this : nullptr);
  }
  ~QuietConsole() override { console_bridge::useOutputHandler(previous_); }
  QuietConsole(const QuietConsole&) = delete;
  QuietConsole& operator=(const QuietConsole&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (complaint_.empty() && level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) complaint_ = ": " + text;
  }
  /// ": reason", or nothing.
  const std::string& complaint() const { return complaint_; }

 private:
  console_bridge::OutputHandler* previous_;
  std::string complaint_;
};

std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text;
}

void checkSize(const std::string& urdf, const std::string& name) {
  if (urdf.size() > MAX_DESCRIPTION) {
    throw InputError(name + ": the description is too large (allowed: up to " + std::to_string(MAX_DESCRIPTION) +
                     " bytes)");
  }
  std::ptrdiff_t elements = 0;
  for (std::size_t i = 0; i + 1 < urdf.size(); ++i) elements += urdf[i] == '<' && urdf[i + 1] != '/';
  if (elements > MAX_ELEMENTS) {
    throw InputError(name + ": " + std::to_string(elements) + " elements (allowed: up to " +
                     std::to_string(MAX_ELEMENTS) + ")");
  }
}

urdf::ModelInterfaceSharedPtr parseDescription(const std::string& urdf, const std::string& name) {
  checkSize(urdf, name);
  QuietConsole console(urdf);
  try {
    if (const auto model = urdf::parseURDF(urdf + PADDING)) return model;
  } catch (const std::exception& error) {
    throw InputError(name + ": not a robot description: " + oneLine(error.what()));
  }
  throw InputError(name + ": not a robot description" + oneLine(console.complaint()));
}

Vec3 toVec3(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

// The first collision of the link that is a box.
const urdf::Collision* firstBox(const urdf::Link& link) {
  for (const auto& collision : link.collision_array) {
    if (collision && collision->geometry && collision->geometry->type == urdf::Geometry::BOX) return collision.get();
  }
  return nullptr;
}

Edge checkedEdge(const Edge& edge, const std::string& where) {
  if (!edge[0].allFinite() || !edge[1].allFinite() || !((edge[1] - edge[0]).norm() > 0)) {
    throw InputError(where + ": the blade's edge (allowed: two different points with finite coordinates)");
  }
  return edge;
}

// Along the box's longest axis (of equal ones the first), where the other two coordinates are smallest.
Edge longestEdge(const urdf::Collision& collision, const std::string& where) {
  const Vec3 size = toVec3(static_cast<const urdf::Box&>(*collision.geometry).dim);
  const urdf::Rotation& turn = collision.origin.rotation;
  const Eigen::Quaterniond rotation(turn.w, turn.x, turn.y, turn.z);
  const Vec3 origin = toVec3(collision.origin.position);
  if (!size.allFinite() || !(size.array() > 0).all()) {
    throw InputError(where + ": the box's size (allowed: three finite numbers above 0)");
  }
  if (!origin.allFinite() || !rotation.coeffs().allFinite()) {
    throw InputError(where + ": the box's origin (allowed: finite numbers)");
  }
  int axis = 0;
  size.maxCoeff(&axis);
  const Vec3 begin = -size / 2;
  Vec3 end = begin;
  end[axis] = -begin[axis];
  return checkedEdge({origin + rotation.normalized() * begin, origin + rotation.normalized() * end}, where);
}

}  // namespace

Edge bladeEdge(const ToolSettings& tool, const std::string& urdf, const std::string& name) {
  if (tool.edge) return checkedEdge(*tool.edge, name);
  const urdf::ModelInterfaceSharedPtr model = parseDescription(urdf, name);
  const std::string where = name + ": link '" + oneLine(tool.link) + "'";
  const urdf::LinkConstSharedPtr link = model->getLink(tool.link);
  if (!link) throw InputError(where + " does not exist (allowed: a link of the description)");
  const urdf::Collision* box = firstBox(*link);
  if (!box) throw InputError(where + " has no collision box to take the edge from");
  return longestEdge(*box, where);
}

Edge placed(const Edge& edge, const ToolPose& pose) {
  return {pose.position + pose.orientation * edge[0], pose.position + pose.orientation * edge[1]};
}

}  // namespace incision
