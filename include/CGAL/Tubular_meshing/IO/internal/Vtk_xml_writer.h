// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_VTK_XML_WRITER_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_VTK_XML_WRITER_H

#include <CGAL/Tubular_meshing/IO/internal/Block_packer.h>
#include <CGAL/Tubular_meshing/IO/internal/Number_writer.h>
#include <CGAL/Tubular_meshing/base/Task_beside.h>
#include <CGAL/Tubular_meshing/base/escaped_for_xml.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

using Tubular_meshing::internal::escaped_for_xml;

template <class T> std::string vtk_xml_type_name() {
  const std::string bits = std::to_string(8 * sizeof(T));
  return (std::is_floating_point<T>::value ? "Float" : std::is_signed<T>::value ? "Int" : "UInt") + bits;
}

class Vtk_xml_writer;

// The first values of an array that are those of another one, of another file or the same: blocks of these are copied as
// they are packed there.
struct Shared_vtk_values {
  const Vtk_xml_writer* file = nullptr;
  std::string array;
  std::size_t values = 0;
};

// Makes a file in VTK's XML formats: data arrays appended raw, compressed by zlib in blocks of 32768 bytes, with
// headers of UInt64. The arrays are kept compressed until write(), since the XML in front says where each begins.
class Vtk_xml_writer {
public:
  typedef Shared_vtk_values Shared;

  // Files that are written one after the other may share a packer, whose tables are larger than a small file.
  explicit Vtk_xml_writer(const std::string& dataset,
                          std::shared_ptr<Window_packer> packer = std::make_shared<Window_packer>())
      : dataset_(dataset)
      , packer_(std::move(packer)) {
    xml_ = "<VTKFile type=\"" + dataset + "\" version=\"1.0\" byte_order=\"" +
           (host_is_little_endian() ? "LittleEndian" : "BigEndian") +
           "\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<" + dataset + ">\n";
  }

  void begin(const std::string& element) { xml_ += "<" + element + ">\n"; }
  void end(const std::string& element) { xml_ += "</" + element + ">\n"; }

  // components 0: plain numbers that say so of themselves by their count, as field data do
  template <class T> void array(const std::string& name, std::size_t components, const std::vector<T>& values) {
    declare<T>(name, components, values.size());
    begin_compressed(values.size() * sizeof(T));
    for (std::size_t i = 0, window = in_window<T>; i < values.size(); i += window) {
      packer_->pack(bytes_of(values.data() + i, (std::min)(window, values.size() - i)));
      append_packed_window();
    }
  }

  // The same of values that are made one after the other, and not kept: for_each(put) calls put(value) for each.
  template <class T, class For_each>
  void array_made(const std::string& name, std::size_t components, std::size_t number, const For_each& for_each,
                  const Shared& shared = {}) {
    declare<T>(name, components, number);
    begin_compressed(number * sizeof(T));
    constexpr std::size_t in_block = block_size / sizeof(T);
    const std::size_t blocks = shared.file == nullptr ? 0 : (std::min)(shared.values, number) / in_block;
    if (blocks > 0)
      copy_blocks(*shared.file, shared.array, blocks);
    const std::size_t passed_over = blocks * in_block;
    if (number > passed_over)
      append_made<T>(passed_over, number - passed_over, for_each);
  }

  // The same of values of which f() gives the next.
  template <class T, class F>
  void array_of(const std::string& name, std::size_t components, std::size_t number, F f, const Shared& shared = {}) {
    array_made<T>(
        name, components, number,
        [&](const auto& put) {
          for (std::size_t i = 0; i < number; ++i)
            put(f());
        },
        shared);
  }

  void write(Output_file& out) const {
    out.write(xml_);
    out.write("</" + dataset_ + ">\n<AppendedData encoding=\"raw\">\n_");
    for (const std::string& piece : data_)
      out.write(piece);
    out.write("\n</AppendedData>\n</VTKFile>\n");
  }

private:
  static constexpr std::size_t block_size = Window_packer::block_size, piece_size = std::size_t(1) << 18;
  template <class T> static constexpr std::size_t in_window = Window_packer::blocks_in_window* block_size / sizeof(T);

  template <class T> static std::string_view bytes_of(const T* values, std::size_t number) {
    return {reinterpret_cast<const char*>(values), number * sizeof(T)};
  }

  template <class T> void declare(const std::string& name, std::size_t components, std::size_t number) {
    xml_ += "<DataArray type=\"" + vtk_xml_type_name<T>() + "\" Name=\"" + escaped_for_xml(name) + "\"";
    if (components == 0)
      xml_ += " NumberOfTuples=\"" + std::to_string(number) + "\"";
    else if (components > 1)
      xml_ += " NumberOfComponents=\"" + std::to_string(components) + "\"";
    xml_ += " format=\"appended\" offset=\"" + std::to_string(data_size_) + "\"/>\n";
    arrays_.push_back({name});
  }

  struct Place {
    std::size_t piece, begin;
  };

  // The sizes of the blocks are filled in as they come.
  void begin_compressed(std::size_t size) {
    const std::size_t blocks = (size + block_size - 1) / block_size;
    std::string& piece = piece_with_room_for((3 + blocks) * sizeof(std::uint64_t));
    data_size_ += (3 + blocks) * sizeof(std::uint64_t);
    append_bytes(piece, std::uint64_t(blocks));
    append_bytes(piece, std::uint64_t(block_size));
    append_bytes(piece, std::uint64_t(size % block_size));
    next_size_ = {data_.size() - 1, piece.size()};
    piece.resize(piece.size() + blocks * sizeof(std::uint64_t));
    arrays_.back().sizes = next_size_;
  }

  // Of the values that for_each() makes, `number` after the first ones: while a window of them is packed, the next is
  // made.
  template <class T, class For_each>
  void append_made(std::size_t passed_over, std::size_t number, const For_each& for_each) {
    Tubular_meshing::internal::run_on(0, [&] {
      std::vector<T> made((std::min)(in_window<T>, number)), packed(number > made.size() ? made.size() : 0);
      Tubular_meshing::internal::Task_beside packing;
      std::size_t n = 0;
      for_each([&](T value) {
        if (passed_over > 0) {
          --passed_over;
          return;
        }
        if (n == made.size()) {
          packing.wait();
          append_packed_window();
          made.swap(packed);
          packing.run([&] { packer_->pack(bytes_of(packed.data(), packed.size())); });
          n = 0;
        }
        made[n++] = value;
      });
      packing.wait();
      append_packed_window();
      packer_->pack(bytes_of(made.data(), n));
      append_packed_window();
    });
  }

  void append_packed_window() {
    packer_->take([&](std::string_view block) { append_packed(block); });
  }

  void append_packed(std::string_view packed) {
    const std::uint64_t size = packed.size();
    std::memcpy(&data_[next_size_.piece][next_size_.begin], &size, sizeof size);
    next_size_.begin += sizeof size;
    std::string& piece = piece_with_room_for(size);
    if (arrays_.back().number_of_blocks++ == 0)
      arrays_.back().first_block = {data_.size() - 1, piece.size()};
    piece.append(packed);
    data_size_ += size;
  }

  std::string& piece_with_room_for(std::size_t size) {
    if (data_.empty() || data_.back().capacity() - data_.back().size() < size) {
      data_.emplace_back();
      data_.back().reserve((std::max)(size, piece_size));
    }
    return data_.back();
  }

  // A block is where the one before ends, or at the beginning of the next piece where that one is full.
  void copy_blocks(const Vtk_xml_writer& file, const std::string& name, std::size_t number) {
    const auto array =
        std::find_if(file.arrays_.rbegin(), file.arrays_.rend(), [&](const Array& a) { return a.name == name; });
    Place place = array->first_block;
    for (std::size_t b = 0; b < number; ++b) {
      std::uint64_t size;
      std::memcpy(&size, &file.data_[array->sizes.piece][array->sizes.begin + b * sizeof size], sizeof size);
      if (file.data_[place.piece].size() - place.begin < size)
        place = {place.piece + 1, 0};
      append_packed(std::string_view(file.data_[place.piece]).substr(place.begin, size));
      place.begin += size;
    }
  }

  struct Array {
    std::string name;
    Place sizes = {0, 0}, first_block = {0, 0};
    std::size_t number_of_blocks = 0;
  };

  std::string dataset_;
  std::string xml_;
  std::vector<std::string> data_; // in pieces, none of which grows
  std::size_t data_size_ = 0;
  Place next_size_ = {0, 0}; // where the size of the next block goes
  std::vector<Array> arrays_;
  std::shared_ptr<Window_packer> packer_;
};

template <class Point> std::vector<double> coordinates_of(const std::vector<Point>& points) {
  std::vector<double> xyz;
  xyz.reserve(3 * points.size());
  for (const Point& p : points)
    for (int k = 0; k < 3; ++k)
      xyz.push_back(double(CGAL::to_double(p[k])));
  return xyz;
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_VTK_XML_WRITER_H
