// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_DECOMPRESS_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_DECOMPRESS_H

#include <zlib.h>

#ifdef CGAL_TUBULAR_MESHING_WITH_LZMA
#include <lzma.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace CGAL::Tubular_meshing::IO::internal {

enum class Compression { none, zlib, lz4, lzma, unknown };

// By the name of VTK's class.
inline Compression vtk_compression(std::string_view compressor) {
  return compressor.empty()                      ? Compression::none
         : compressor == "vtkZLibDataCompressor" ? Compression::zlib
         : compressor == "vtkLZ4DataCompressor"  ? Compression::lz4
         : compressor == "vtkLZMADataCompressor" ? Compression::lzma
                                                 : Compression::unknown;
}

inline bool has_lzma() {
#ifdef CGAL_TUBULAR_MESHING_WITH_LZMA
  return true;
#else
  return false;
#endif
}

// No more bytes than this can be made of one.
inline std::uint64_t best_ratio(Compression c) {
  return c == Compression::lzma ? 10000 : c == Compression::lz4 ? 256 : 1032;
}

// A block of LZ4 (github.com/lz4/lz4, doc/lz4_Block_format.md): runs of bytes as they are, each but the last followed by
// a copy of bytes before it.
class Lz4_block {
public:
  Lz4_block(std::string_view packed, char* out, std::size_t bytes)
      : packed_(packed)
      , out_(out)
      , bytes_(bytes) {}

  // False if the block is damaged, or does not fill `out` exactly.
  bool decode() {
    while (read_ < packed_.size()) {
      const unsigned token = byte();
      std::size_t literals = token >> 4, copied = token & 15;
      if (!extend(literals) || literals > packed_.size() - read_ || literals > bytes_ - write_)
        return false;
      std::copy_n(packed_.data() + read_, literals, out_ + write_);
      read_ += literals;
      write_ += literals;
      if (read_ == packed_.size())
        break;
      if (packed_.size() - read_ < 2)
        return false;
      const std::size_t low = byte(), offset = low | std::size_t(byte()) << 8;
      if (offset == 0 || offset > write_ || !extend(copied))
        return false;
      copied += 4;
      if (copied > bytes_ - write_)
        return false;
      for (; copied > 0; --copied, ++write_) // which may copy what it has just written
        out_[write_] = out_[write_ - offset];
    }
    return write_ == bytes_;
  }

private:
  unsigned byte() { return static_cast<unsigned char>(packed_[read_++]); }

  // Of four bits that are all set, more bytes add up to the number.
  bool extend(std::size_t& n) {
    if (n != 15)
      return true;
    for (unsigned more = 255; more == 255; n += more) {
      if (read_ == packed_.size())
        return false;
      more = byte();
    }
    return true;
  }

  std::string_view packed_;
  char* const out_;
  const std::size_t bytes_;
  std::size_t read_ = 0, write_ = 0;
};

inline bool decompress_zlib(std::string_view packed, char* out, std::size_t bytes) {
  uLongf n = static_cast<uLongf>(bytes);
  return uncompress(reinterpret_cast<Bytef*>(out), &n, reinterpret_cast<const Bytef*>(packed.data()),
                    static_cast<uLong>(packed.size())) == Z_OK &&
         n == bytes;
}

inline bool decompress_lzma(std::string_view packed, char* out, std::size_t bytes) {
#ifdef CGAL_TUBULAR_MESHING_WITH_LZMA
  std::uint64_t memory = std::uint64_t(1) << 30;
  std::size_t read = 0, written = 0;
  return lzma_stream_buffer_decode(&memory, 0, nullptr, reinterpret_cast<const std::uint8_t*>(packed.data()), &read,
                                   packed.size(), reinterpret_cast<std::uint8_t*>(out), &written, bytes) == LZMA_OK &&
         written == bytes;
#else
  (void)packed;
  (void)out;
  (void)bytes;
  return false;
#endif
}

// Writes the bytes of a block to `out`; false if it is damaged, or holds another number of them.
inline bool decompress(Compression c, std::string_view packed, char* out, std::size_t bytes) {
  return c == Compression::zlib   ? decompress_zlib(packed, out, bytes)
         : c == Compression::lz4  ? Lz4_block(packed, out, bytes).decode()
         : c == Compression::lzma ? decompress_lzma(packed, out, bytes)
                                  : false;
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_DECOMPRESS_H
