#pragma once

#include <tinyxml.h>

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace incision {

/// A link's name, and which of its collisions.
using CollisionPlace = std::pair<std::string, std::size_t>;

/// What must be known of a URDF before urdfdom reads it, or what urdfdom keeps to itself. A text that is no XML holds
/// nothing.
class UrdfText {
 public:
  explicit UrdfText(const std::string& urdf);

  /// Throws InputError when the text is for xacro, which makes a URDF of it. One that xacro has made may still name it
  /// in its first element and in comments.
  void checkExpanded(const std::string& name) const;

  /// Throws InputError when a link has two parents, or joints go in a circle: urdfdom never frees a circle.
  void checkTree(const std::string& name) const;

  /// How many collisions each link has: urdfdom leaves out those that it cannot read.
  std::map<std::string, std::size_t> countCollisions() const;

  /// Makes cylinders of the capsules, which urdfdom does not know, and returns where they were: <capsule radius
  /// length/>, also with the prefix of Drake.
  std::set<CollisionPlace> takeCapsules();

  /// The text as it is now.
  std::string print() const;

 private:
  const TiXmlElement* first(const char* element) const;

  TiXmlDocument document_;
};

}  // namespace incision
