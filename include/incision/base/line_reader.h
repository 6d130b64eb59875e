#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace incision {

/// Reads a text line by line and each line word by word; every failure names the text and the line. Blank lines are
/// passed over, and lines may end in LF or CRLF.
class LineReader {
 public:
  /// The text must outlive the reader; `name` is what errors call it.
  LineReader(std::string_view text, std::string name) : unread_(text), name_(std::move(name)) {}

  /// Moves to the next line that is not blank; false at the end of the text.
  bool next();

  /// What is left of the current line.
  std::string_view rest() const { return rest_; }

  /// Number of the current line, counted from 1.
  int line() const { return line_; }

  /// Takes the next word of the line as a number. `what` names it in errors. Numbers must be whole words of plain
  /// decimal digits, integers ≥ `smallest`, reals finite.
  std::int64_t integer(const char* what, std::int64_t smallest);
  double real(const char* what);

  /// Takes the next word of the line, whatever it is.
  void skip(const char* what) { word(what); }

  /// Takes the number of items that follow, and fails when so many cannot be in the rest of the text, `bytes_each`
  /// being the least that one takes. So memory may be reserved by it.
  int count(const char* what, int smallest, int bytes_each);

  /// Fails unless the whole line has been taken.
  void endOfLine() const;

  /// Throws InputError "name:line: reason", for the current line unless another one is given.
  [[noreturn]] void fail(const std::string& reason) const { failAt(std::max(line_, 1), reason); }
  [[noreturn]] void failAt(int line, const std::string& reason) const;

 private:
  std::string_view word(const char* what);

  std::string_view unread_;  // the text after the current line
  std::string_view rest_;    // the current line after the words taken
  std::string name_;
  int line_ = 0;
};

/// Text as it can be shown in an error: in quotes, shortened, without unprintable characters.
std::string quoted(std::string_view text);

}  // namespace incision
