// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_EXAMPLES_COMMAND_LINE_HUGE_PAGES_H
#define TUBULAR_MESHING_EXAMPLES_COMMAND_LINE_HUGE_PAGES_H

/* Replaces what a program allocates with, so that large arrays are on huge pages where Linux gives these to who asks
 * (transparent_hugepage/enabled is `madvise`): a page is made when it is first written to, and a large mesh has 512 times
 * fewer of these. To be included by one file of a program, never by a library.
 *
 * use_huge_pages() is to be called first: smaller blocks stay with the program then when they are freed, to be used
 * again, and large ones never do. */

#include <cstddef>
#include <cstdlib>
#include <new>

#if defined(__linux__) && __has_include(<sys/mman.h>)
#include <malloc.h>
#include <sys/mman.h>
#endif

namespace command_line {

// Of blocks so large, the pages that are filled up at their ends do not count.
constexpr std::size_t huge_page = std::size_t(1) << 21, least_for_huge_pages = 2 * huge_page;

inline void* allocate(std::size_t size) {
#ifdef MADV_HUGEPAGE
  if (size >= least_for_huge_pages) {
    const std::size_t page = 4096, rounded = (size + page - 1) / page * page;
    void* block = rounded >= size ? std::aligned_alloc(huge_page, rounded) : nullptr;
    if (block != nullptr)
      madvise(block, rounded, MADV_HUGEPAGE); // a wish: without it there are more pages
    return block;
  }
#endif
  return std::malloc(size > 0 ? size : 1);
}

inline void use_huge_pages() {
#ifdef M_TRIM_THRESHOLD // glibc's: set, they do not change any more
  mallopt(M_MMAP_THRESHOLD, int(least_for_huge_pages));
  mallopt(M_TRIM_THRESHOLD, 1 << 28);
#endif
}

} // namespace command_line

void* operator new(std::size_t size) {
  for (;;) {
    if (void* block = command_line::allocate(size))
      return block;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr)
      throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* block) noexcept {
  std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
  std::free(block);
}

#endif // TUBULAR_MESHING_EXAMPLES_COMMAND_LINE_HUGE_PAGES_H
