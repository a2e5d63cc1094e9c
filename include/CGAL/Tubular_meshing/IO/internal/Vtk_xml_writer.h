// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_VTK_XML_WRITER_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_VTK_XML_WRITER_H

#include <CGAL/Tubular_meshing/IO/internal/Number_writer.h>
#include <CGAL/Tubular_meshing/base/escaped_for_xml.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <zlib.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

using Tubular_meshing::internal::escaped_for_xml;

template <class T> std::string vtk_xml_type_name() {
  const std::string bits = std::to_string(8 * sizeof(T));
  return (std::is_floating_point<T>::value ? "Float" : std::is_signed<T>::value ? "Int" : "UInt") + bits;
}

// Makes a file in VTK's XML formats: data arrays appended raw, compressed by zlib in blocks of 32768 bytes, with
// headers of UInt64. The arrays are kept compressed until write(), since the XML in front says where each begins.
class Vtk_xml_writer {
public:
  explicit Vtk_xml_writer(const std::string& dataset)
      : dataset_(dataset) {
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
    const char* const bytes = reinterpret_cast<const char*>(values.data());
    for (std::size_t i = 0, size = values.size() * sizeof(T); i < size; i += block_size)
      append_block(bytes + i, (std::min)(block_size, size - i));
  }

  // The same of values that are made one after the other, and not kept: for_each(put) calls put(value) for each.
  template <class T, class For_each>
  void array_made(const std::string& name, std::size_t components, std::size_t number, const For_each& for_each) {
    declare<T>(name, components, number);
    begin_compressed(number * sizeof(T));
    std::vector<T> block;
    block.reserve(block_size / sizeof(T));
    const auto append = [&] {
      append_block(reinterpret_cast<const char*>(block.data()), block.size() * sizeof(T));
      block.clear();
    };
    for_each([&](T value) {
      block.push_back(value);
      if (block.size() * sizeof(T) == block_size)
        append();
    });
    if (!block.empty())
      append();
  }

  // The same of values of which f() gives the next.
  template <class T, class F> void array_of(const std::string& name, std::size_t components, std::size_t number, F f) {
    array_made<T>(name, components, number, [&](const auto& put) {
      for (std::size_t i = 0; i < number; ++i)
        put(f());
    });
  }

  void write(Output_file& out) {
    out.write(xml_);
    out.write("</" + dataset_ + ">\n<AppendedData encoding=\"raw\">\n_");
    for (std::string& piece : data_) {
      out.write(piece);
      std::string().swap(piece);
    }
    out.write("\n</AppendedData>\n</VTKFile>\n");
  }

private:
  static constexpr std::size_t block_size = 32768, piece_size = std::size_t(1) << 18;

  template <class T> void declare(const std::string& name, std::size_t components, std::size_t number) {
    xml_ += "<DataArray type=\"" + vtk_xml_type_name<T>() + "\" Name=\"" + escaped_for_xml(name) + "\"";
    if (components == 0)
      xml_ += " NumberOfTuples=\"" + std::to_string(number) + "\"";
    else if (components > 1)
      xml_ += " NumberOfComponents=\"" + std::to_string(components) + "\"";
    xml_ += " format=\"appended\" offset=\"" + std::to_string(data_size_) + "\"/>\n";
  }

  // The sizes of the blocks are filled in as they come.
  void begin_compressed(std::size_t size) {
    const std::size_t blocks = (size + block_size - 1) / block_size;
    data_.emplace_back();
    header_ = data_.size() - 1;
    next_size_ = 3 * sizeof(std::uint64_t);
    append_bytes(data_.back(), std::uint64_t(blocks));
    append_bytes(data_.back(), std::uint64_t(block_size));
    append_bytes(data_.back(), std::uint64_t(size % block_size));
    data_.back().resize(next_size_ + blocks * sizeof(std::uint64_t));
    data_size_ += data_.back().size();
  }

  void append_block(const char* bytes, std::size_t size) {
    packed_.resize(compressBound(block_size));
    uLongf n = static_cast<uLongf>(packed_.size());
    // the fastest level: coordinates gain little from more, and indices nothing worth the time
    compress2(packed_.data(), &n, reinterpret_cast<const Bytef*>(bytes), static_cast<uLong>(size), Z_BEST_SPEED);
    const std::uint64_t packed_size = n;
    std::memcpy(&data_[header_][next_size_], &packed_size, sizeof packed_size);
    next_size_ += sizeof packed_size;
    if (data_.size() - 1 == header_ || data_.back().capacity() - data_.back().size() < n) {
      data_.emplace_back();
      data_.back().reserve(piece_size);
    }
    data_.back().append(reinterpret_cast<const char*>(packed_.data()), n);
    data_size_ += n;
  }

  std::string dataset_;
  std::string xml_;
  std::vector<std::string> data_; // in pieces, none of which grows
  std::size_t data_size_ = 0;
  std::size_t header_ = 0, next_size_ = 0; // where the size of the next block goes
  std::vector<Bytef> packed_;
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
