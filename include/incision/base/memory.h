#pragma once

#include <any>
#include <utility>

#include "incision/base/archive.h"

namespace incision {

/// The value of type `Memory` in `kept`, made there where it holds something else: so what it held keeps its room.
template <class Memory>
Memory& memoryIn(std::any* kept) {
  if (auto* there = std::any_cast<Memory>(kept)) return *there;
  return kept->emplace<Memory>();
}

/// Something that has a memory: the value that outlasts a step. All else in it is scratch, found again from the memory
/// and from the mesh. The retry of a step in halves, what undoes a step and a reset keep memories and recall them; a
/// body that is saved writes them.
class Remembers {
 public:
  virtual ~Remembers() = default;

  /// Copies the memory into `kept`, which keeps the room that it has where it held one before: what is kept before each
  /// step takes nothing from the heap.
  virtual void keepIn(std::any* kept) const = 0;

  /// A copy of the memory.
  std::any keep() const {
    std::any kept;
    keepIn(&kept);
    return kept;
  }

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
  void keepIn(std::any* kept) const override { memoryIn<Memory>(kept) = memory_; }
  void recall(const std::any& kept) override { memory_ = std::any_cast<const Memory&>(kept); }
  void write(const std::any& kept, ArchiveWriter* archive) const override { writeKept<Memory>(kept, archive); }
  std::any read(ArchiveReader* archive) const override { return readKept<Memory>(archive); }

 protected:
  Memory memory_;
};

}  // namespace incision
