#include "gmsh_sections.h"

namespace incision {
namespace {

std::string endOf(const std::string& section) { return "$End" + section.substr(1); }

}  // namespace

void nextRecord(LineReader& reader, const std::string& section) {
  if (!reader.next()) reader.fail("the file ends inside " + section);
  if (reader.rest().front() == '$')
    reader.fail(section + " ends too early, or a line is missing in it: " + quoted(reader.rest()));
}

void endSection(LineReader& reader, const std::string& section) {
  if (!reader.next()) reader.fail("the file ends inside " + section);
  if (reader.rest() != endOf(section)) reader.fail("expected " + endOf(section) + ", not " + quoted(reader.rest()));
}

void skipSection(LineReader& reader, const std::string& section) {
  const int begin = reader.line();
  while (reader.next())
    if (reader.rest() == endOf(section)) return;
  reader.failAt(begin, quoted(section) + " is never closed by " + quoted(endOf(section)));
}

}  // namespace incision
