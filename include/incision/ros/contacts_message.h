#pragma once

#include <incision/Contacts.h>

#include <string>
#include <vector>

#include "incision/body/deformable_body.h"

namespace incision {

/// Who is who in a message of contacts.
struct ContactNames {
  std::vector<std::string> shapes;  ///< of each shape of the obstacles: its link, or "ground"
  std::vector<std::string> tools;
  std::vector<std::string> links;  ///< of the obstacles
  bool has_ground = false;
};

ContactNames contactNames(const Obstacles& obstacles, const std::vector<std::string>& tools);

/// What presses on the body and what bears it; the header is left to the caller.
Contacts toContacts(const BodyWrenches& wrenches, const ContactNames& names);

}  // namespace incision
