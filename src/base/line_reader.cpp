#include "incision/base/line_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "incision/base/input_error.h"

namespace incision {
namespace {

constexpr std::string_view BLANKS = " \t\r";

void skipBlanks(std::string_view& text) { text.remove_prefix(std::min(text.find_first_not_of(BLANKS), text.size())); }

/// Whether all of the word reads as a number; the error of from_chars says whether it fits the type.
template <typename Number>
bool parse(std::string_view word, Number& value, std::errc& error) {
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  error = result.ec;
  return result.ptr == word.data() + word.size() && error != std::errc::invalid_argument;
}

}  // namespace

bool LineReader::next() {
  do {
    if (unread_.empty()) return false;
    const std::size_t end = std::min(unread_.find('\n'), unread_.size());
    rest_ = unread_.substr(0, end);
    unread_.remove_prefix(std::min(end + 1, unread_.size()));
    ++line_;
    skipBlanks(rest_);
  } while (rest_.empty());
  rest_ = rest_.substr(0, rest_.find_last_not_of(BLANKS) + 1);
  return true;
}

std::int64_t LineReader::integer(const char* what, std::int64_t smallest) {
  const std::string_view text = word(what);
  std::int64_t value = 0;
  std::errc error;
  if (!parse(text, value, error)) fail(std::string(what) + ": " + quoted(text) + " is not a whole number");
  if (error != std::errc()) fail(std::string(what) + ": " + quoted(text) + " does not fit 64 bits");
  if (value < smallest) fail(std::string(what) + ": " + quoted(text) + " must be at least " + std::to_string(smallest));
  return value;
}

double LineReader::real(const char* what) {
  const std::string_view text = word(what);
  double value = 0;
  std::errc error;
  if (!parse(text, value, error)) fail(std::string(what) + ": " + quoted(text) + " is not a number");
  if (error != std::errc() || !std::isfinite(value))
    fail(std::string(what) + ": " + quoted(text) + " is not a finite number of double precision");
  return value;
}

int LineReader::count(const char* what, int smallest, int bytes_each) {
  const std::int64_t value = integer(what, smallest);
  const std::int64_t room = static_cast<std::int64_t>(unread_.size()) / bytes_each;
  if (value > room)
    fail(std::string(what) + ": " + std::to_string(value) + " cannot be in the " + std::to_string(unread_.size()) +
         " bytes that follow");
  return static_cast<int>(value);
}

void LineReader::endOfLine() const {
  if (!rest_.empty()) fail("the line should have ended before " + quoted(rest_));
}

void LineReader::failAt(int line, const std::string& reason) const {
  throw InputError(name_ + ":" + std::to_string(line) + ": " + reason);
}

std::string_view LineReader::word(const char* what) {
  if (rest_.empty()) fail(std::string(what) + " is missing at the end of the line");
  const std::string_view result = rest_.substr(0, rest_.find_first_of(BLANKS));
  rest_.remove_prefix(result.size());
  skipBlanks(rest_);
  return result;
}

std::string quoted(std::string_view text) {
  constexpr std::size_t MAX_SHOWN = 40;
  std::string shown = "\"";
  for (char c : text.substr(0, MAX_SHOWN)) shown += c >= ' ' && c <= '~' ? c : '?';
  return shown + (text.size() > MAX_SHOWN ? "…\"" : "\"");
}

}  // namespace incision
