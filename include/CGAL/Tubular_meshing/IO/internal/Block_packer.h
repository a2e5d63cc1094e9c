// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_BLOCK_PACKER_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_BLOCK_PACKER_H

#include <CGAL/Tubular_meshing/base/parallel.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

// Compresses block after block, as compress2() does, but keeps its tables, which are larger than the blocks.
class Block_packer {
public:
  // The fastest level: coordinates gain little from more, and indices nothing worth the time.
  Block_packer()
      : stream_(new z_stream()) {
    if (deflateInit(stream_.get(), Z_BEST_SPEED) != Z_OK) {
      delete stream_.release(); // there is nothing to be ended
      throw std::bad_alloc();
    }
  }

  // Appends a block as it is packed to `packed`; returns its size.
  std::size_t pack(std::string_view block, std::string& packed) {
    const std::size_t before = packed.size();
    deflateReset(stream_.get());
    packed.resize(before + compressBound(static_cast<uLong>(block.size())));
    stream_->next_in = reinterpret_cast<Bytef*>(const_cast<char*>(block.data()));
    stream_->avail_in = static_cast<uInt>(block.size());
    stream_->next_out = reinterpret_cast<Bytef*>(&packed[before]);
    stream_->avail_out = static_cast<uInt>(packed.size() - before);
    deflate(stream_.get(), Z_FINISH);
    packed.resize(packed.size() - stream_->avail_out);
    return packed.size() - before;
  }

private:
  struct End {
    void operator()(z_stream* s) const {
      deflateEnd(s);
      delete s;
    }
  };
  std::unique_ptr<z_stream, End> stream_; // its tables know where it is
};

/* Compresses a window of blocks on all threads, each run of blocks with a packer of its own. What comes out does not
 * depend on the threads. It takes as much memory as two windows, at most. */
class Window_packer {
public:
  static constexpr std::size_t block_size = 32768;
  static constexpr std::size_t blocks_in_window = 32;

  // Packs at most a window of bytes; the last block may be shorter. What was packed before is given up.
  void pack(std::string_view bytes) {
    const std::size_t blocks = (bytes.size() + block_size - 1) / block_size;
    used_ = (std::min)(blocks, runs_.size());
    Tubular_meshing::internal::for_each_task(used_, 0, [&](std::size_t r) {
      Run& run = runs_[r];
      if (!run.packer)
        run.packer = std::make_unique<Block_packer>();
      run.packed.clear();
      run.sizes.clear();
      for (std::size_t b = r * blocks / used_; b < (r + 1) * blocks / used_; ++b)
        run.sizes.push_back(run.packer->pack(bytes.substr(b * block_size, block_size), run.packed));
    });
  }

  // Calls f(block) for each block that was packed, in their order, and forgets them.
  template <class F> void take(F f) {
    for (std::size_t r = 0; r < used_; ++r) {
      std::string_view rest = runs_[r].packed;
      for (std::size_t size : runs_[r].sizes) {
        f(rest.substr(0, size));
        rest.remove_prefix(size);
      }
    }
    used_ = 0;
  }

private:
  struct Run {
    std::unique_ptr<Block_packer> packer;
    std::string packed;
    std::vector<std::size_t> sizes; // of its blocks
  };
  std::array<Run, 8> runs_;
  std::size_t used_ = 0;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_BLOCK_PACKER_H
