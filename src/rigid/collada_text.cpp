#include "collada_text.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "incision/base/input_error.h"
#include "incision/base/printable.h"

namespace incision {
namespace {

/// Elements within elements: what people write has ten. A reader takes less than a kilobyte of stack for each.
constexpr std::size_t MAX_DEPTH = 200;

/// Nodes, those counted in full that are instances of others: a model of a whole building has a tenth of it.
constexpr double MAX_NODES = 100'000;

/// Numbers that belong to one vertex: places, normals, some colours and textures.
constexpr std::size_t MAX_STRIDE = 1000;

/// One tag, from its '<' on.
struct Tag {
  std::string name;
  std::string text;  // all of it
  bool closes = false, is_empty = false, is_none = false;
};

/// Reads the tag at `*at` and moves on behind it.
Tag readTag(const std::string& text, std::size_t* at) {
  Tag tag;
  const auto skipTo = [&](const char* end) {
    const std::size_t found = text.find(end, *at);
    *at = found == std::string::npos ? text.size() : found + std::string(end).size();
    tag.is_none = true;
    return tag;
  };
  if (text.compare(*at, 4, "<!--") == 0) return skipTo("-->");
  if (text.compare(*at, 9, "<![CDATA[") == 0) return skipTo("]]>");
  if (text.compare(*at, 2, "<?") == 0 || text.compare(*at, 2, "<!") == 0) return skipTo(">");
  const std::size_t begin = *at;
  char quote = 0;
  for (++*at; *at < text.size() && (quote != 0 || text[*at] != '>'); ++*at) {
    const char c = text[*at];
    if (quote != 0 ? c == quote : c == '"' || c == '\'') quote = quote != 0 ? '\0' : c;
  }
  tag.text = text.substr(begin, *at - begin);
  tag.closes = tag.text.compare(0, 2, "</") == 0;
  tag.is_empty = tag.text.back() == '/';
  const std::size_t name = tag.closes ? 2 : 1;
  tag.name = tag.text.substr(name, tag.text.find_first_of(" \t\r\n/", name) - name);
  return tag;
}

/// The value of an attribute, or nothing.
std::string attribute(const Tag& tag, const std::string& name) {
  for (std::size_t at = tag.text.find(name); at != std::string::npos; at = tag.text.find(name, at + 1)) {
    const std::size_t open = tag.text.find_first_of("\"'", at);
    if (open == std::string::npos) break;
    const bool is_it = tag.text[at - 1] <= ' ' && tag.text.find_first_not_of(" \t\r\n=", at + name.size()) == open;
    if (is_it) return tag.text.substr(open + 1, tag.text.find(tag.text[open], open + 1) - open - 1);
  }
  return "";
}

/// Refuses a number of things that is no number or of more than are `allowed`; returns it otherwise, and 0 for none.
std::size_t checkedCount(const std::string& what, const std::string& value, std::size_t allowed) {
  // No more digits than a number of 64 bits holds for certain.
  const bool is_number = value.size() < 19 && value.find_first_not_of("0123456789") == std::string::npos;
  const std::size_t count = is_number && !value.empty() ? std::stoull(value) : 0;
  if (is_number && count <= allowed) return count;
  throw InputError("has the " + what + " '" + printable(value) + "' (allowed: whole numbers up to " +
                   std::to_string(allowed) + ")");
}

/// A reader makes room for as many numbers as these attributes promise, of which each takes a byte of the text.
void checkCounts(const Tag& tag, std::size_t length) {
  checkedCount("count", attribute(tag, "count"), length);
  checkedCount("stride", attribute(tag, "stride"), MAX_STRIDE);
  checkedCount("offset", attribute(tag, "offset"), MAX_STRIDE);
}

/// Refuses a list of polygons' counts of corners, which begins at `at`, that promises more of them than the text can
/// hold.
void checkCorners(const std::string& text, std::size_t at) {
  std::istringstream counts(text.substr(at, text.find('<', at) - at));
  std::size_t corners = 0;
  for (std::string count; counts >> count;) {
    corners += checkedCount("vcount", count, text.size());
    checkedCount("sum of vcount", std::to_string(corners), text.size());
  }
}

/// A reader never comes past what is no number in a list of indices, which begins at `at`.
void checkIndices(const std::string& text, std::size_t at) {
  const std::size_t wrong = text.find_first_not_of("0123456789+- \t\r\n", at);
  if (wrong != std::string::npos && text.compare(wrong, 3, "</p") != 0)
    throw InputError("has indices <p> with '" + printable(text.substr(wrong, 1)) + "' (allowed: whole numbers)");
}

/// Nodes, and what lies within each.
class Nodes {
 public:
  /// Whatever an instance may mean by its address is a name of the node.
  int add(const Tag& tag, int parent) {
    const int node = static_cast<int>(within_.size());
    within_.emplace_back();
    instances_.emplace_back();
    for (const char* name : {"id", "name", "sid"}) called_.emplace(attribute(tag, name), node);
    if (parent >= 0) within_[parent].push_back(node);
    return node;
  }
  void addInstance(const Tag& tag, int parent) {
    const std::string url = attribute(tag, "url");
    if (parent >= 0) instances_[parent].push_back(url.substr(std::min<std::size_t>(url.size(), url[0] == '#')));
  }

  void check() {
    counts_.assign(within_.size(), UNKNOWN);
    for (int node = 0; node < static_cast<int>(within_.size()); ++node) count(node, 0);
  }

 private:
  static constexpr double UNKNOWN = -1, BEING_COUNTED = -2;

  double count(int node, std::size_t depth) {
    if (counts_[node] == BEING_COUNTED || depth > MAX_DEPTH)
      throw InputError("has nodes that go in a circle or too deep (allowed: up to " + std::to_string(MAX_DEPTH) + ")");
    if (counts_[node] != UNKNOWN) return counts_[node];
    counts_[node] = BEING_COUNTED;
    double sum = 1;
    for (const int child : within_[node]) sum += count(child, depth + 1);
    for (const std::string& name : instances_[node]) {
      const auto [begin, end] = called_.equal_range(name);
      double most = 0;
      for (auto it = begin; it != end; ++it) most = std::max(most, count(it->second, depth + 1));
      sum += most;
    }
    if (sum > MAX_NODES) throw InputError("has too many nodes (allowed: up to 100000)");
    return counts_[node] = sum;
  }

  std::vector<std::vector<int>> within_;
  std::vector<std::vector<std::string>> instances_;
  std::multimap<std::string, int> called_;
  std::vector<double> counts_;
};

}  // namespace

void checkCollada(const std::string& text) {
  Nodes nodes;
  std::vector<int> open;  // for each open element the innermost node
  constexpr int NONE = -1;
  for (std::size_t at = text.find('<'); at < text.size(); at = text.find('<', at)) {
    const Tag tag = readTag(text, &at);
    if (tag.is_none) continue;
    if (tag.closes) {
      if (!open.empty()) open.pop_back();
      continue;
    }
    checkCounts(tag, text.size());
    const std::size_t content = std::min(at + 1, text.size());
    if (tag.name == "vcount") checkCorners(text, content);
    if (tag.name == "p" && !tag.is_empty) checkIndices(text, content);
    const int parent = open.empty() ? NONE : open.back();
    const int node = tag.name == "node" ? nodes.add(tag, parent) : parent;
    if (tag.name == "instance_node") nodes.addInstance(tag, parent);
    if (!tag.is_empty) open.push_back(node);
    if (open.size() > MAX_DEPTH)
      throw InputError("has elements too deep in others (allowed: up to " + std::to_string(MAX_DEPTH) + ")");
  }
  nodes.check();
}

}  // namespace incision
