#include "incision/contact/settings.h"

#include "incision/base/yaml_reader.h"

namespace incision {

ContactSettings parseContact(const YamlValue& value) {
  const YamlMap map = value.map({"ground", "obstacles", "friction", "self"});
  ContactSettings contact;
  if (const auto ground = map.find("ground")) contact.ground = ground->number();
  if (const auto obstacles = map.find("obstacles")) contact.obstacles = obstacles->path();
  contact.friction = map.number("friction", contact.friction, FRICTION);
  if (const auto self = map.find("self")) contact.self = self->boolean();
  return contact;
}

}  // namespace incision
