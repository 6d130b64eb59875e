#include "incision/solver/block_pool.h"

#include <SuiteSparse_config.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <new>

namespace incision {
namespace {

thread_local BlockPool* active_pool = nullptr;

}  // namespace

BlockPool::BlockPool() {
  static std::once_flag installed;
  std::call_once(installed, [] {
    SuiteSparse_config.malloc_func = allocate;
    SuiteSparse_config.calloc_func = allocateZero;
    SuiteSparse_config.realloc_func = resize;
    SuiteSparse_config.free_func = giveBack;
  });
}

BlockPool::~BlockPool() { release(); }

void BlockPool::release() {
  for (const Block& block : blocks_)
    if (!block.in_use) std::free(block.memory);
  blocks_.erase(std::remove_if(blocks_.begin(), blocks_.end(), [](const Block& block) { return !block.in_use; }),
                blocks_.end());
}

BlockPool::Scope::Scope(BlockPool* pool) : outer_(active_pool) { active_pool = pool; }
BlockPool::Scope::~Scope() { active_pool = outer_; }

void* BlockPool::allocate(std::size_t size) { return active_pool ? active_pool->take(size) : std::malloc(size); }

void* BlockPool::allocateZero(std::size_t count, std::size_t size) {
  if (!active_pool) return std::calloc(count, size);
  if (size > 0 && count > static_cast<std::size_t>(-1) / size) return nullptr;
  void* memory = active_pool->take(count * size);
  if (memory) std::memset(memory, 0, count * size);
  return memory;
}

void* BlockPool::resize(void* memory, std::size_t size) {
  const Block* block = active_pool ? active_pool->find(memory) : nullptr;
  if (!block) return std::realloc(memory, size);
  const std::size_t kept = std::min(block->size, size);
  void* moved = active_pool->take(size);
  if (!moved) return nullptr;
  std::memcpy(moved, memory, kept);
  giveBack(memory);
  return moved;
}

void BlockPool::giveBack(void* memory) {
  if (Block* block = active_pool ? active_pool->find(memory) : nullptr)
    block->in_use = false;
  else
    std::free(memory);
}

BlockPool::Block* BlockPool::find(const void* memory) {
  const auto block = std::find_if(blocks_.begin(), blocks_.end(), [&](const Block& b) { return b.memory == memory; });
  return block == blocks_.end() ? nullptr : &*block;
}

void* BlockPool::take(std::size_t size) {
  const auto free_block =
      std::find_if(blocks_.begin(), blocks_.end(), [&](const Block& b) { return !b.in_use && b.size == size; });
  if (free_block != blocks_.end()) {
    free_block->in_use = true;
    return free_block->memory;
  }
  try {
    blocks_.push_back({nullptr, size, true});
  } catch (const std::bad_alloc&) {  // which must not pass through CHOLMOD
    return nullptr;
  }
  void* memory = std::malloc(size);
  blocks_.back().memory = memory;
  if (!memory) blocks_.pop_back();
  return memory;
}

}  // namespace incision
