#pragma once

#include <string>
#include <vector>

namespace incision {

/// ", did you mean …?" for a word that is almost one of `words`, else nothing.
std::string suggestion(const std::string& word, const std::vector<std::string>& words);

}  // namespace incision
