// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_VTK_XML_FILE_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_VTK_XML_FILE_H

#include <CGAL/Tubular_meshing/IO/internal/Byte_cursor.h>
#include <CGAL/Tubular_meshing/IO/internal/Encoded_stream.h>
#include <CGAL/Tubular_meshing/IO/internal/Text_cursor.h>
#include <CGAL/Tubular_meshing/IO/internal/decompress.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

inline Number_type vtk_xml_type(std::string_view name) {
  const std::string_view digits = name.substr((std::min)(name.find_first_of("0123456789"), name.size()));
  const unsigned size = digits == "8" ? 1 : digits == "16" ? 2 : digits == "32" ? 4 : digits == "64" ? 8 : 0;
  const std::string_view kind = name.substr(0, name.size() - digits.size());
  if (kind == "Float" && size >= 4)
    return {'f', size};
  if (kind == "Int" || kind == "UInt")
    return {kind == "Int" ? 'i' : 'u', size};
  return Number_type();
}

// A file in VTK's XML formats (.vtp, .vtu): its elements, and the numbers of its data arrays in any of the encodings.
class Vtk_xml_file {
public:
  // `dataset` is PolyData or UnstructuredGrid.
  Vtk_xml_file(const Input_file& file, const char* dataset)
      : file_(file) {
    parse();
    const pugi::xml_node root = document_.child("VTKFile");
    if (!root)
      file_.fail("is no VTK XML file: it has no element VTKFile");
    dataset_ = root.child(dataset);
    if (!dataset_)
      file_.fail(std::string("cannot be used: it should hold a ") + dataset + ", but holds a " +
                 printable(root.attribute("type").value()));
    swapped_ = host_is_little_endian() != (std::string_view(root.attribute("byte_order").value()) != "BigEndian");
    header_type_ = vtk_xml_type(root.attribute("header_type").as_string("UInt32"));
    const std::string_view compressor = root.attribute("compressor").value();
    compression_ = vtk_compression(compressor);
    if (compression_ == Compression::unknown || (compression_ == Compression::lzma && !has_lzma()))
      file_.fail("cannot be used: it is compressed with " + printable(compressor) +
                 (compression_ == Compression::lzma ? ", which this program was built without" : "") +
                 "; write it with zlib or without compression");
    if (header_type_.kind != 'u' || header_type_.size < 4)
      file_.fail("cannot be used: its header_type is neither UInt32 nor UInt64");
  }

  const Input_file& file() const { return file_; }
  pugi::xml_node dataset() const { return dataset_; }

  // The array with this Name among the children of `parent`; with an empty name the first. May be null.
  static pugi::xml_node find(pugi::xml_node parent, std::string_view name) {
    for (const pugi::xml_node a : parent.children("DataArray"))
      if (name.empty() || name == a.attribute("Name").value())
        return a;
    return pugi::xml_node();
  }

  static bool is_numeric(pugi::xml_node array) { return vtk_xml_type(array.attribute("type").value()).is_known(); }

  // The numbers of an array. An array that is not there is empty.
  template <class T> std::vector<T> values(pugi::xml_node array) const {
    if (!array)
      return {};
    const std::string_view format = array.attribute("format").as_string("ascii");
    if (format == "ascii")
      return values_of_text<T>(array.text().get());
    const Number_type type = vtk_xml_type(array.attribute("type").value());
    if (!type.is_known() || (type.kind == 'f' && std::is_integral<T>::value))
      file_.fail("cannot be used: its array " + printable(array.attribute("Name").value()) + " is of type " +
                 printable(array.attribute("type").value()) + ", which does not fit its purpose");
    const std::string bytes = decoded(stream_of(array, format));
    count_decoded(bytes.size());
    return decode_all<T>(bytes, type, swapped_);
  }

  // The same, where the number of numbers is known.
  template <class T> std::vector<T> values(pugi::xml_node array, std::size_t n) const {
    std::vector<T> v = values<T>(array);
    if (v.size() != n)
      file_.fail("cannot be used: its array " + printable(array.attribute("Name").value()) + " holds " +
                 std::to_string(v.size()) + " numbers instead of " + std::to_string(n) + "; it is damaged");
    return v;
  }

  // The points of a piece; none if it has none.
  std::vector<std::array<double, 3>> points(pugi::xml_node piece) const {
    const std::size_t n = count(piece, "NumberOfPoints");
    if (n > file_.bytes.size() * (best_ratio(compression_) / 2)) // twelve bytes of a point take no less
      file_.fail("announces " + std::to_string(n) + " points, which is more than it can hold; it is damaged");
    const std::vector<double> xyz = values<double>(find(piece.child("Points"), ""), 3 * n);
    std::vector<std::array<double, 3>> points(n);
    for (std::size_t i = 0; i < n; ++i)
      points[i] = {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
    return points;
  }

  static std::size_t count(pugi::xml_node piece, const char* attribute) {
    return static_cast<std::size_t>(piece.attribute(attribute).as_ullong());
  }

private:
  // Appended data is not XML: what stands before it is parsed, with the end tags added.
  void parse() {
    const std::string& bytes = file_.bytes;
    const std::size_t tag = bytes.find("<AppendedData");
    pugi::xml_parse_result result;
    if (tag == std::string::npos)
      result = document_.load_buffer(bytes.data(), bytes.size());
    else {
      const std::size_t end = bytes.find('>', tag);
      const std::size_t data = end == std::string::npos ? end : bytes.find('_', end);
      if (data == std::string::npos)
        file_.fail("ends before its appended data; it is truncated, export or copy it again");
      appended_ = std::string_view(bytes).substr(data + 1);
      appended_ = appended_.substr(0, appended_.rfind("</AppendedData"));
      const std::string text = bytes.substr(0, end) + "/></VTKFile>";
      result = document_.load_buffer(text.data(), text.size());
      appended_base64_ =
          std::string_view(document_.child("VTKFile").child("AppendedData").attribute("encoding").value()) == "base64";
    }
    if (!result)
      file_.fail("is no VTK XML file: at byte " + std::to_string(result.offset) + ", " + result.description());
  }

  template <class T> std::vector<T> values_of_text(const char* text) const {
    std::vector<T> values;
    Text_cursor in(file_, text);
    while (!in.at_end()) {
      const std::string_view word = in.token();
      std::conditional_t<std::is_integral<T>::value, std::int64_t, double> x;
      if (!parse_number(word, x))
        file_.fail("cannot be used: " + printable(word) + " stands in a data array where a number should be");
      values.push_back(static_cast<T>(x));
    }
    return values;
  }

  Encoded_stream stream_of(pugi::xml_node array, std::string_view format) const {
    if (format == "binary")
      return Encoded_stream(trimmed(array.text().get()), true, file_);
    const unsigned long long offset = array.attribute("offset").as_ullong();
    if (format != "appended" || offset > appended_.size())
      file_.fail("cannot be used: the data of its array " + printable(array.attribute("Name").value()) +
                 " is not there; it is truncated or damaged");
    return Encoded_stream(appended_.substr(static_cast<std::size_t>(offset)), appended_base64_, file_);
  }

  std::uint64_t header(Encoded_stream& in) const {
    return decode<std::uint64_t>(in.read(header_type_.size).data(), header_type_, swapped_);
  }

  std::string decoded(Encoded_stream in) const {
    if (compression_ != Compression::none)
      return inflated(in);
    const std::uint64_t n = header(in);
    if (n > in.most_bytes())
      in.fail();
    return in.read(static_cast<std::size_t>(n));
  }

  std::string inflated(Encoded_stream& in) const {
    const std::uint64_t blocks = header(in), block_bytes = header(in), last_block_bytes = header(in);
    if (blocks > in.most_bytes() / header_type_.size)
      in.fail();
    std::vector<std::uint64_t> packed_bytes(static_cast<std::size_t>(blocks));
    for (std::uint64_t& n : packed_bytes)
      n = header(in);
    std::string out;
    for (std::size_t first = 0; first < packed_bytes.size(); first += blocks_in_window) {
      const std::size_t end = (std::min)(first + blocks_in_window, packed_bytes.size());
      std::vector<Packed_block> window;
      for (std::size_t b = first; b < end; ++b) {
        const bool last = b + 1 == packed_bytes.size() && last_block_bytes != 0;
        window.push_back(packed_block(in, packed_bytes[b], last ? last_block_bytes : block_bytes));
      }
      if (!inflate(window, out))
        in.fail();
    }
    return out;
  }

  // Blocks are independent, and inflated on all threads, a window of them at a time.
  struct Packed_block {
    std::string packed;
    std::size_t bytes; // that are packed in it
  };
  static constexpr std::size_t blocks_in_window = 64;

  Packed_block packed_block(Encoded_stream& in, std::uint64_t packed_bytes, std::uint64_t bytes) const {
    if (packed_bytes > in.most_bytes() || bytes > best_ratio(compression_) * packed_bytes)
      in.fail();
    return {in.read(static_cast<std::size_t>(packed_bytes)), static_cast<std::size_t>(bytes)};
  }

  // Appends the bytes of the blocks; false if one is damaged.
  bool inflate(const std::vector<Packed_block>& blocks, std::string& out) const {
    std::vector<std::size_t> begin(1, out.size());
    for (const Packed_block& b : blocks)
      begin.push_back(begin.back() + b.bytes);
    out.resize(begin.back());
    std::vector<char> sound(blocks.size());
    Tubular_meshing::internal::for_each_task(blocks.size(), 0, [&](std::size_t b) {
      sound[b] = decompress(compression_, blocks[b].packed, &out[begin[b]], blocks[b].bytes);
    });
    return std::find(sound.begin(), sound.end(), 0) == sound.end();
  }

  // Arrays that all point at the same data would multiply it.
  void count_decoded(std::size_t bytes) const {
    decoded_bytes_ += bytes;
    if (decoded_bytes_ / best_ratio(compression_) > file_.bytes.size())
      file_.fail("cannot be used: its data arrays hold more than fits into it, as several have the same data; it is "
                 "damaged");
  }

  const Input_file& file_;
  mutable std::uint64_t decoded_bytes_ = 0;
  pugi::xml_document document_;
  pugi::xml_node dataset_;
  std::string_view appended_;
  bool appended_base64_ = false;
  Compression compression_ = Compression::none;
  bool swapped_ = false;
  Number_type header_type_;
};

// Calls f(begin, end) for the range of `connectivity` that is cell i, for each cell, after checking the offsets.
template <class F>
void for_each_vtk_cell(const std::vector<std::int64_t>& offsets, std::size_t connectivity, const Input_file& file,
                       F f) {
  std::size_t begin = 0;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    if (offsets[i] < static_cast<std::int64_t>(begin) || static_cast<std::size_t>(offsets[i]) > connectivity)
      file.fail("cannot be used: the offset of cell " + std::to_string(i) + " is " + std::to_string(offsets[i]) +
                ", outside the " + std::to_string(connectivity) + " corners there are; it is damaged");
    const std::size_t end = static_cast<std::size_t>(offsets[i]);
    f(begin, end);
    begin = end;
  }
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_VTK_XML_FILE_H
