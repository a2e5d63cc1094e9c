// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_VTK_XML_WRITER_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_VTK_XML_WRITER_H

#include <CGAL/Tubular_meshing/IO/internal/Number_writer.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <zlib.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

inline std::string escaped_for_xml(std::string_view text) {
  std::string out;
  for (char c : text)
    switch (c) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    default:
      out += c;
    }
  return out;
}

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
    xml_ += "<DataArray type=\"" + vtk_xml_type_name<T>() + "\" Name=\"" + escaped_for_xml(name) + "\"";
    if (components == 0)
      xml_ += " NumberOfTuples=\"" + std::to_string(values.size()) + "\"";
    else if (components > 1)
      xml_ += " NumberOfComponents=\"" + std::to_string(components) + "\"";
    xml_ += " format=\"appended\" offset=\"" + std::to_string(data_.size()) + "\"/>\n";
    append_compressed(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }

  void write(Output_file& out) {
    out.write(xml_);
    out.write("</" + dataset_ + ">\n<AppendedData encoding=\"raw\">\n_");
    out.write(data_);
    out.write("\n</AppendedData>\n</VTKFile>\n");
  }

private:
  void append_compressed(const char* bytes, std::size_t size) {
    const std::size_t block = 32768;
    const std::size_t blocks = (size + block - 1) / block;
    const std::size_t header = data_.size();
    append_bytes(data_, std::uint64_t(blocks));
    append_bytes(data_, std::uint64_t(block));
    append_bytes(data_, std::uint64_t(size % block));
    data_.resize(data_.size() + blocks * sizeof(std::uint64_t));
    std::vector<Bytef> packed(compressBound(block));
    for (std::size_t b = 0; b < blocks; ++b) {
      uLongf n = static_cast<uLongf>(packed.size());
      const std::size_t length = (std::min)(block, size - b * block);
      // the fastest level: coordinates gain little from more, and indices nothing worth the time
      compress2(packed.data(), &n, reinterpret_cast<const Bytef*>(bytes + b * block), static_cast<uLong>(length),
                Z_BEST_SPEED);
      const std::uint64_t packed_size = n;
      std::memcpy(&data_[header + (3 + b) * sizeof(std::uint64_t)], &packed_size, sizeof packed_size);
      data_.append(reinterpret_cast<const char*>(packed.data()), n);
    }
  }

  std::string dataset_;
  std::string xml_;
  std::string data_;
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
