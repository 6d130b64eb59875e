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

/// Whether it is an element of xacro's, or one whose attributes xacro has to reckon.
bool isForXacro(const TiXmlElement& element) {
  if (element.ValueStr().rfind("xacro:", 0) == 0) return true;
  for (const TiXmlAttribute* a = element.FirstAttribute(); a; a = a->Next())
    if (a->ValueStr().find("${") != std::string::npos || a->ValueStr().find("$(") != std::string::npos) return true;
  return false;
}

/// The element that comes after this one in the text, or null.
const TiXmlElement* after(const TiXmlElement* element) {
  if (const TiXmlElement* child = element->FirstChildElement()) return child;
  for (const TiXmlNode* node = element; node; node = node->Parent())
    if (const TiXmlElement* next = node->NextSiblingElement()) return next;
  return nullptr;
}

/// The capsule of a collision; null where it has another shape.
TiXmlElement* capsuleOf(TiXmlElement* collision) {
  TiXmlElement* geometry = collision->FirstChildElement("geometry");
  TiXmlElement* shape = geometry ? geometry->FirstChildElement() : nullptr;
  return shape && (shape->ValueStr() == "capsule" || shape->ValueStr() == "drake:capsule") ? shape : nullptr;
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

void UrdfText::checkExpanded(const std::string& name) const {
  for (const TiXmlElement* element = document_.RootElement(); element; element = after(element))
    if (isForXacro(*element))
      throw InputError(name + ": a xacro file (allowed: a URDF; this makes one of it: xacro in.xacro > out.urdf)");
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

std::set<CollisionPlace> UrdfText::takeCapsules() {
  std::set<CollisionPlace> places;
  TiXmlElement* robot = document_.FirstChildElement("robot");
  for (auto* link = robot ? robot->FirstChildElement("link") : nullptr; link; link = link->NextSiblingElement("link")) {
    std::size_t index = 0;
    for (auto* c = link->FirstChildElement("collision"); c; c = c->NextSiblingElement("collision"), ++index) {
      TiXmlElement* capsule = capsuleOf(c);
      if (!capsule || !link->Attribute("name")) continue;
      capsule->SetValue("cylinder");
      places.emplace(link->Attribute("name"), index);
    }
  }
  return places;
}

std::string UrdfText::print() const {
  TiXmlPrinter printer;
  printer.SetStreamPrinting();
  document_.Accept(&printer);
  return printer.Str();
}

}  // namespace incision
