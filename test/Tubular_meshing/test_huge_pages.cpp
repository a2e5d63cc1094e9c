// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What tubular_mesh allocates with, here and in this program alone.

#include "../../examples/Tubular_meshing/command_line/huge_pages.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <thread>
#include <utility>
#include <vector>

namespace {

TEST(Huge_pages, Blocks_of_all_sizes_are_apart_and_keep_what_is_written) {
  command_line::use_huge_pages();
  std::vector<std::pair<unsigned char*, std::size_t>> blocks;
  for (std::size_t size : {std::size_t(0), std::size_t(1), std::size_t(4095), command_line::least_for_huge_pages - 1,
                           command_line::least_for_huge_pages, command_line::least_for_huge_pages + 1,
                           5 * command_line::huge_page + 4097, std::size_t(3)}) {
    blocks.emplace_back(static_cast<unsigned char*>(::operator new(size)), size);
    ASSERT_NE(blocks.back().first, nullptr);
    std::memset(blocks.back().first, int(blocks.size()), size);
  }
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (std::size_t i = 0; i < blocks[b].second; ++i)
      ASSERT_EQ(blocks[b].first[i], b + 1) << b << ", " << i;
    ::operator delete(blocks[b].first);
  }
}

#ifdef MADV_HUGEPAGE
TEST(Huge_pages, Large_blocks_begin_with_a_page) {
  for (std::size_t size : {command_line::least_for_huge_pages, 3 * command_line::huge_page + 5}) {
    const std::unique_ptr<char[]> block(new char[size]);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block.get()) % command_line::huge_page, 0u);
  }
}
#endif

TEST(Huge_pages, What_cannot_be_had_is_refused) {
  volatile std::size_t largest = (std::numeric_limits<std::size_t>::max)(); // which the compiler is not to look through
  const std::size_t most = largest;
  for (std::size_t size : {most, most - 4095, most - command_line::huge_page, most / 2})
    EXPECT_THROW(::operator delete(::operator new(size)), std::bad_alloc) << size;
  static int asked = 0;
  std::set_new_handler([] {
    if (++asked == 3)
      std::set_new_handler(nullptr);
  });
  EXPECT_THROW(::operator delete(::operator new(most)), std::bad_alloc);
  EXPECT_EQ(asked, 3);
}

TEST(Huge_pages, Several_threads_grow_arrays) {
  std::vector<std::thread> threads;
  std::vector<std::size_t> sums(3, 0);
  for (std::size_t t = 0; t < sums.size(); ++t)
    threads.emplace_back([&sums, t] {
      std::vector<std::size_t> values;
      for (std::size_t i = 0; i < 3000000; ++i)
        values.push_back(i);
      for (std::size_t v : values)
        sums[t] += v;
    });
  for (std::thread& t : threads)
    t.join();
  for (std::size_t s : sums)
    EXPECT_EQ(s, std::size_t(3000000) * 2999999 / 2);
}

} // namespace
