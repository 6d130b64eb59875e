#pragma once

#include <string>

#include "incision/base/line_reader.h"

namespace incision {

/// Moves to the next line of a section, which must not have ended yet.
void nextRecord(LineReader& reader, const std::string& section);

/// Moves to the line that ends the section, which must be the next one.
void endSection(LineReader& reader, const std::string& section);

/// Moves to the line that ends the section.
void skipSection(LineReader& reader, const std::string& section);

}  // namespace incision
