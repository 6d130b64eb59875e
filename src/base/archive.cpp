#include "incision/base/archive.h"

#include <string>

#include "incision/base/input_error.h"

namespace incision {

/// The first byte is what the writer begins with: the order of the bytes in its numbers.
ArchiveReader::ArchiveReader(std::string_view bytes) : InputArchive(this), left_(bytes) {
  std::uint8_t little_endian = 0;
  takeNumbers(&little_endian, 1);
  if (little_endian != cereal::portable_binary_detail::is_little_endian())
    throw InputError("the numbers of the saved body are of a machine with another order of bytes");
}

void require(bool holds, const char* what) {
  if (!holds) throw InputError(std::string("the saved body cannot be: ") + what);
}

void ArchiveReader::failAtEnd() { throw InputError("the bytes of the saved body end early"); }

void ArchiveReader::failAtNumber() {
  throw InputError("a number of the saved body is none that there can be (allowed: finite ones)");
}

}  // namespace incision
