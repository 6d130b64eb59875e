#include "incision/run/saved_state.h"

#include <xxhash.h>
#include <zstd.h>
#include <zstd_errors.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <new>
#include <ostream>
#include <stdexcept>
#include <streambuf>
#include <vector>

#include "incision/base/archive.h"
#include "incision/base/input_error.h"
#include "incision/base/parallel.h"
#include "incision/base/printable.h"

namespace incision {
namespace {

/// As PNG's: a file that was copied as if it were text, or by seven bits, no longer begins like this.
constexpr std::array<unsigned char, 8> MAGIC = {0x89, 'I', 'N', 'C', '\r', '\n', 0x1a, '\n'};

/// Unpacked bytes of a section: what one thread packs in some milliseconds.
constexpr std::size_t SECTION = std::size_t{1} << 22;

/// Zstandard's quickest level but for those that hardly pack: it packs faster than a disk writes.
constexpr int LEVEL = 1;

/// Most bytes that a body may take for each element of its mesh, and besides. An element that no crack has met takes
/// some 200, a part that one has met some 1,500.
constexpr std::size_t MOST_PER_ELEMENT = std::size_t{1} << 16, MOST_BESIDES = std::size_t{1} << 26;

struct StateSection {
  std::uint32_t length = 0, stored = 0;  ///< stored as it is where packing it saves nothing
  std::uint64_t hash = 0;                ///< of what is stored
};

template <class Archive>
void serialize(Archive& archive, StateSection& section) {
  auto& [length, stored, hash] = section;
  archive(length, stored, hash);
}

struct StateHeader {
  std::string version;  ///< of the package
  SceneKey key;
  std::uint64_t body = 0;  ///< how long it is; what leads it comes behind
  std::vector<StateSection> sections;
};

template <class Archive>
void serialize(Archive& archive, StateHeader& header) {
  auto& [version, key, body, sections] = header;
  archive(version, key, body, sections);
}

/// Appends to a text that it gives away in the end.
class StringBuffer : public std::streambuf {
 public:
  std::string text;

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    text.append(bytes, static_cast<std::size_t>(count));
    return count;
  }
  int_type overflow(int_type byte) override {
    text.push_back(traits_type::to_char_type(byte));
    return byte;
  }
};

/// Memory that is used up would cut the text short in silence if the stream did not throw.
template <typename Write>
void writeTo(StringBuffer* buffer, const Write& write) {
  std::ostream out(buffer);
  out.exceptions(std::ostream::badbit);
  write(out);
}

/// What comes before the header.
struct Start {
  std::array<unsigned char, 8> magic = MAGIC;
  std::uint32_t format = STATE_FORMAT, length = 0;
  std::uint64_t hash = 0;
};
static_assert(sizeof(Start) == 24);

/// Of all before the header's hash, and of the header.
std::uint64_t hashOf(const Start& start, const std::string& header) {
  return XXH3_64bits_withSeed(header.data(), header.size(), XXH3_64bits(&start, offsetof(Start, hash)));
}

std::size_t mostBytes(const SceneKey& key) {
  return MOST_BESIDES + MOST_PER_ELEMENT * static_cast<std::size_t>(key.elements);
}

void checkStart(const Start& start, std::size_t size) {
  if (start.magic != MAGIC) throw InputError("not a saved body");
  if (start.format != STATE_FORMAT)
    throw InputError("of format " + std::to_string(start.format) + " (allowed: " + std::to_string(STATE_FORMAT) + ")");
  if (start.length > size - sizeof(Start)) throw InputError("cut short");
}

void checkKey(const StateHeader& header, const SceneKey& key) {
  if (header.version != INCISION_VERSION)
    throw InputError("of incision " + printable(header.version) + " (allowed: " INCISION_VERSION ")");
  const SceneKey& other = header.key;
  if (other.mesh != key.mesh || other.nodes != key.nodes || other.elements != key.elements)
    throw InputError("of another mesh, of " + std::to_string(other.nodes) + " nodes and " +
                     std::to_string(other.elements) + " elements (allowed: that of the scene, which has " +
                     std::to_string(key.nodes) + " and " + std::to_string(key.elements) + ")");
  if (other.scene != key.scene)
    throw InputError("of another scene (allowed: the one it was saved with, but for solver.threads)");
}

/// Returns how long the body is. `size`: of what is left of the file.
std::size_t checkSections(const std::vector<StateSection>& sections, std::size_t size, const SceneKey& key) {
  std::size_t length = 0, stored = 0;
  for (const StateSection& section : sections) {
    if (section.length > SECTION || section.stored > section.length)
      throw InputError("a section of " + std::to_string(section.length) + " bytes, stored as " +
                       std::to_string(section.stored) + " (allowed: up to " + std::to_string(SECTION) +
                       ", stored as no more)");
    length += section.length;
    stored += section.stored;
  }
  if (stored > size) throw InputError("cut short");
  if (stored < size) throw InputError("followed by " + std::to_string(size - stored) + " bytes that are not its own");
  if (length > mostBytes(key))
    throw InputError("unpacked, of " + std::to_string(length) + " bytes (allowed: up to " +
                     std::to_string(mostBytes(key)) + " for this mesh)");
  return length;
}

std::string packedSection(std::string_view bytes) {
  std::string to(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size = ZSTD_compress(to.data(), to.size(), bytes.data(), bytes.size(), LEVEL);
  if (ZSTD_isError(size) || size >= bytes.size()) return std::string(bytes);
  to.resize(size);
  return to;
}

bool unpackSection(const StateSection& section, const std::string& stored, char* to) {
  if (XXH3_64bits(stored.data(), stored.size()) != section.hash) return false;
  if (section.stored < section.length) {
    const std::size_t size = ZSTD_decompress(to, section.length, stored.data(), stored.size());
    if (ZSTD_getErrorCode(size) == ZSTD_error_memory_allocation) throw std::bad_alloc();  // not a fault of the file
    return size == section.length;
  }
  std::memcpy(to, stored.data(), stored.size());
  return true;
}

}  // namespace

SavedState savedState(const DeformableBody& body) {
  StringBuffer buffer;
  writeTo(&buffer, [&](std::ostream& out) { body.save(out); });
  return {std::move(buffer.text), {}};
}

std::string packed(const SavedState& state, const SceneKey& key, int threads) {
  const std::size_t size = state.body.size() + state.leads.size();
  if (size > mostBytes(key))
    throw std::length_error("the body takes " + std::to_string(size) + " bytes (allowed: up to " +
                            std::to_string(mostBytes(key)) + " for this mesh)");
  std::vector<std::string_view> pieces;
  for (const std::string_view text : {std::string_view(state.body), std::string_view(state.leads)})
    for (std::size_t at = 0; at < text.size(); at += SECTION) pieces.push_back(text.substr(at, SECTION));
  const auto count = static_cast<int>(pieces.size());
  std::vector<std::string> sections(count);
  StateHeader header{INCISION_VERSION, key, state.body.size(), std::vector<StateSection>(count)};
  parallelFor(count, threads, [&](int i) {
    sections[i] = packedSection(pieces[i]);
    header.sections[i] = {static_cast<std::uint32_t>(pieces[i].size()), static_cast<std::uint32_t>(sections[i].size()),
                          XXH3_64bits(sections[i].data(), sections[i].size())};
  });
  StringBuffer buffer;
  writeTo(&buffer, [&](std::ostream& out) {
    ArchiveWriter archive(out);
    archive(header);
  });
  const std::string& said = buffer.text;
  Start start;
  start.length = static_cast<std::uint32_t>(said.size());
  start.hash = hashOf(start, said);
  std::string file(reinterpret_cast<const char*>(&start), sizeof(start));
  file += said;
  for (const std::string& section : sections) file += section;
  return file;
}

SavedState unpacked(const std::function<void(char* to, std::size_t count)>& read, std::size_t size, const SceneKey& key,
                    int threads) {
  if (size < sizeof(Start)) throw InputError("cut short, or not a saved body");
  Start start;
  read(reinterpret_cast<char*>(&start), sizeof(start));
  checkStart(start, size);
  std::string said(start.length, '\0');
  read(said.data(), said.size());
  if (start.hash != hashOf(start, said)) throw InputError("damaged: its header is not the one that was written");
  StateHeader header;
  ArchiveReader archive(said);
  archive(header);
  checkKey(header, key);
  SavedState state;
  std::string& body = state.body;
  body.resize(checkSections(header.sections, size - sizeof(start) - said.size(), key));
  if (header.body > body.size()) throw InputError("damaged: it is longer than its sections");

  const std::size_t count = header.sections.size();
  std::vector<std::string> sections(count);
  std::vector<char*> to(count, body.data());
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) to[i] = to[i - 1] + header.sections[i - 1].length;
    sections[i].resize(header.sections[i].stored);
    read(sections[i].data(), sections[i].size());
  }
  std::vector<char> fits(count);
  parallelFor(static_cast<int>(count), threads,
              [&](int i) { fits[i] = unpackSection(header.sections[i], sections[i], to[i]); });
  for (std::size_t i = 0; i < count; ++i)
    if (!fits[i])
      throw InputError("damaged: its section " + std::to_string(i + 1) + " of " + std::to_string(count) +
                       " is not the one that was written");
  state.leads = body.substr(header.body);
  body.resize(header.body);
  return state;
}

SavedState unpacked(std::string_view file, const SceneKey& key, int threads) {
  const std::size_t size = file.size();
  const auto read = [&](char* to, std::size_t count) {
    if (count > file.size()) throw InputError("cut short");
    std::memcpy(to, file.data(), count);
    file.remove_prefix(count);
  };
  return unpacked(read, size, key, threads);
}

}  // namespace incision
