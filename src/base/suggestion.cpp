#include "incision/base/suggestion.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace incision {
namespace {

/// Levenshtein's distance: how many letters to add, drop or change.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t change = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string suggestion(const std::string& word, const std::vector<std::string>& words) {
  constexpr std::size_t MAX_TYPOS = 3;
  for (std::size_t typos = 0; typos <= std::min(MAX_TYPOS, word.size() / 2); ++typos) {
    for (const std::string& known : words) {
      if (word.size() <= known.size() + MAX_TYPOS && editDistance(word, known) == typos) {
        return ", did you mean " + known + "?";
      }
    }
  }
  return "";
}

}  // namespace incision
