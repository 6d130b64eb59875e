#include "incision/solver/block_pool.h"

#include <SuiteSparse_config.h>
#include <gtest/gtest.h>

#include <cstring>

namespace incision {
namespace {

TEST(BlockPool, GivesOutAgainWhatCameBack) {
  BlockPool pool;
  const BlockPool::Scope scope(&pool);
  void* first = SuiteSparse_config.malloc_func(100);
  void* second = SuiteSparse_config.malloc_func(100);
  EXPECT_NE(first, second);
  SuiteSparse_config.free_func(first);
  void* other_size = SuiteSparse_config.malloc_func(101);
  EXPECT_NE(other_size, first);
  EXPECT_EQ(SuiteSparse_config.calloc_func(10, 10), first);
  EXPECT_EQ(*static_cast<char*>(first), 0);
  for (void* memory : {first, second, other_size}) SuiteSparse_config.free_func(memory);
}

TEST(BlockPool, KeepsTheValuesWhenABlockGrows) {
  BlockPool pool;
  const BlockPool::Scope scope(&pool);
  char* memory = static_cast<char*>(SuiteSparse_config.malloc_func(6));
  std::memcpy(memory, "tissue", 6);
  memory = static_cast<char*>(SuiteSparse_config.realloc_func(memory, 1000));
  EXPECT_EQ(std::memcmp(memory, "tissue", 6), 0);
  SuiteSparse_config.free_func(memory);
}

TEST(BlockPool, LeavesMemoryFromElsewhereAlone) {
  void* outside = SuiteSparse_config.malloc_func(10);
  BlockPool pool;
  const BlockPool::Scope scope(&pool);
  SuiteSparse_config.free_func(outside);
  SuiteSparse_config.free_func(nullptr);
}

TEST(BlockPool, RefusesSizesThatOverflow) {
  BlockPool pool;
  const BlockPool::Scope scope(&pool);
  EXPECT_EQ(SuiteSparse_config.calloc_func(static_cast<std::size_t>(-1), 16), nullptr);
}

}  // namespace
}  // namespace incision
