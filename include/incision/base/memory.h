#pragma once

#include <any>
#include <utility>

#include "incision/base/archive.h"

namespace incision {

/// Something that has a memory: the value that outlasts a step. All else in it is scratch, found again from the memory
/// and from the mesh. The retry of a step in halves and a reset keep memories and recall them; a body that is saved
/// writes them.
class Remembers {
 public:
  virtual ~Remembers() = default;

  /// A copy of the memory.
  virtual std::any keep() const = 0;

  /// Puts a memory back that keep() of an object of this type has returned.
  virtual void recall(const std::any& kept) = 0;

  /// Writes a memory that keep() has returned.
  virtual void write(const std::any& kept, ArchiveWriter* archive) const = 0;

  /// Reads what write() of an object of this type has written: a memory to recall. Throws InputError where it cannot be
  /// one of a body with the reader's limits.
  virtual std::any read(ArchiveReader* archive) const = 0;
};

/// Remembers::write and read for a memory of a known type.
template <class Memory>
void writeKept(const std::any& kept, ArchiveWriter* archive) {
  (*archive)(std::any_cast<const Memory&>(kept));
}
template <class Memory>
std::any readKept(ArchiveReader* archive) {
  Memory memory;
  (*archive)(memory);
  check(memory, archive->limits);  // which stands beside the memory
  return memory;
}

/// A `Base`, which derives from Remembers, with a memory of a copyable type. A class that has scratch which depends on
/// the memory overrides recall() and calls this one first.
template <class Base, class Memory>
class WithMemory : public Base {
 public:
  explicit WithMemory(Memory memory = {}) : memory_(std::move(memory)) {}
  std::any keep() const override { return memory_; }
  void recall(const std::any& kept) override { memory_ = std::any_cast<const Memory&>(kept); }
  void write(const std::any& kept, ArchiveWriter* archive) const override { writeKept<Memory>(kept, archive); }
  std::any read(ArchiveReader* archive) const override { return readKept<Memory>(archive); }

 protected:
  Memory memory_;
};

}  // namespace incision
