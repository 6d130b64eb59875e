#pragma once

#include <cstddef>
#include <vector>

namespace incision {

/// Keeps the memory that SuiteSparse gives back for its next request of the same size: CHOLMOD asks for workspace in
/// every factorisation and solve, always as much, and a step must not allocate. A pool serves the thread in which a
/// Scope of it stands; all other use of SuiteSparse in the process goes to malloc and free as always.
class BlockPool {
 public:
  BlockPool();
  ~BlockPool();
  BlockPool(const BlockPool&) = delete;

  /// Gives back to the system what is not in use.
  void release();

  class Scope {
   public:
    explicit Scope(BlockPool* pool);
    ~Scope();
    Scope(const Scope&) = delete;

   private:
    BlockPool* outer_;
  };

 private:
  struct Block {
    void* memory;
    std::size_t size;
    bool in_use;
  };

  static void* allocate(std::size_t size);
  static void* allocateZero(std::size_t count, std::size_t size);
  static void* resize(void* memory, std::size_t size);
  static void giveBack(void* memory);
  Block* find(const void* memory);
  void* take(std::size_t size);

  std::vector<Block> blocks_;
};

}  // namespace incision
