#include "urdf_text.h"

#include <set>

#include "incision/base/input_error.h"
#include "incision/rigid/description.h"

namespace incision {

namespace {

/// The link that a joint's `parent` or `child` names; empty where it names none.
std::string linkOf(const TiXmlElement& joint, const char* end) {
  const TiXmlElement* element = joint.FirstChildElement(end);
  const char* link = element ? element->Attribute("link") : nullptr;
  return link ? link : "";
}

}  // namespace

UrdfText::UrdfText(const std::string& urdf) {
  document_.Parse(urdf.c_str());
  if (document_.Error()) document_.Clear();
}

const TiXmlElement* UrdfText::first(const char* element) const {
  const TiXmlElement* robot = document_.FirstChildElement("robot");
  return robot ? robot->FirstChildElement(element) : nullptr;
}

void UrdfText::checkTree(const std::string& name) const {
  std::map<std::string, std::string> parents;
  for (const auto* joint = first("joint"); joint; joint = joint->NextSiblingElement("joint")) {
    const std::string child = linkOf(*joint, "child");
    if (!parents.emplace(child, linkOf(*joint, "parent")).second && !child.empty())
      throw InputError(linkInMessage(name, child) + ": two parents (allowed: one)");
  }
  std::set<std::string> hanging;  // on a link that has no parent
  for (const auto& [child, parent] : parents) {
    std::set<std::string> path;
    for (auto link = parents.find(child); link != parents.end(); link = parents.find(link->second)) {
      if (hanging.count(link->first)) break;
      if (!path.insert(link->first).second)
        throw InputError(linkInMessage(name, link->first) + ": joints that go in a circle (allowed: a tree)");
    }
    hanging.merge(path);
  }
}

std::map<std::string, std::size_t> UrdfText::countCollisions() const {
  std::map<std::string, std::size_t> counts;
  for (const auto* link = first("link"); link; link = link->NextSiblingElement("link")) {
    if (!link->Attribute("name")) continue;
    std::size_t& count = counts[link->Attribute("name")];
    for (const auto* c = link->FirstChildElement("collision"); c; c = c->NextSiblingElement("collision")) ++count;
  }
  return counts;
}

}  // namespace incision
