// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_PLY_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_PLY_H

#include <CGAL/Tubular_meshing/IO/internal/Byte_cursor.h>
#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/Text_cursor.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

struct Ply_property {
  std::string name;
  Number_type type;
  Number_type length; // of a list; unknown type: not a list
};

struct Ply_element {
  std::string name;
  std::size_t count = 0;
  std::vector<Ply_property> properties;

  // no record can be shorter
  std::size_t least_bytes(bool ascii) const {
    std::size_t n = 0;
    for (const Ply_property& p : properties)
      n += ascii ? 1 : p.length.is_known() ? p.length.size : p.type.size;
    return n;
  }
};

inline Number_type ply_type(std::string_view name) {
  struct Row {
    const char* name;
    Number_type type;
  };
  static const Row rows[] = {
      {"char", {'i', 1}},  {"int8", {'i', 1}},    {"uchar", {'u', 1}},  {"uint8", {'u', 1}},
      {"short", {'i', 2}}, {"int16", {'i', 2}},   {"ushort", {'u', 2}}, {"uint16", {'u', 2}},
      {"int", {'i', 4}},   {"int32", {'i', 4}},   {"uint", {'u', 4}},   {"uint32", {'u', 4}},
      {"float", {'f', 4}}, {"float32", {'f', 4}}, {"double", {'f', 8}}, {"float64", {'f', 8}},
  };
  for (const Row& r : rows)
    if (name == r.name)
      return r.type;
  return Number_type();
}

// Reads one PLY file: the header says which elements with which properties follow, in ASCII or in binary.
class Ply_reader {
public:
  explicit Ply_reader(const Input_file& file)
      : text_(file)
      , bytes_(file, 0, true) {}

  Polygon_soup read() {
    read_header();
    Polygon_soup soup;
    soup.names = names_;
    soup.region_names = region_names_;
    for (const Ply_element& e : elements_)
      read_element(e, soup);
    return soup;
  }

private:
  void read_header() {
    if (trimmed(text_.line()) != "ply")
      text_.fail("a PLY file starts with the word 'ply'");
    for (;;) {
      const std::string_view word = text_.token();
      if (word.empty())
        text_.fail_at_end("end_header");
      if (word == "end_header")
        break;
      if (word == "format")
        read_format();
      else if (word == "element")
        read_element_header();
      else if (word == "property")
        read_property();
      else if (word == "comment")
        read_comment();
      text_.line();
    }
    text_.line();
    bytes_ = Byte_cursor(text_.file(), text_.position(), little_endian_);
  }

  void read_format() {
    const std::string_view f = text_.token();
    ascii_ = f == "ascii";
    little_endian_ = f == "binary_little_endian";
    if (!ascii_ && !little_endian_ && f != "binary_big_endian")
      text_.fail(printable(f) + " is no format of PLY files");
  }

  void read_element_header() {
    Ply_element e;
    e.name = std::string(text_.token());
    e.count = text_.count("number of elements");
    elements_.push_back(e);
  }

  void read_property() {
    if (elements_.empty())
      text_.fail("a property comes before any element");
    Ply_property p;
    std::string_view type = text_.token();
    const bool is_list = type == "list";
    if (is_list) {
      p.length = ply_type(text_.token());
      type = text_.token();
    }
    p.type = ply_type(type);
    p.name = std::string(text_.token());
    if (!p.type.is_known() || (is_list && (!p.length.is_known() || p.length.kind == 'f')))
      text_.fail("a property has a type that PLY files do not know");
    elements_.back().properties.push_back(p);
  }

  // "patch 2 inlet", as this package writes names, or "region 4 plaque"
  void read_comment() {
    const std::size_t position = text_.position();
    std::string_view line = trimmed(text_.line());
    text_.move_to(position);
    std::int64_t label;
    const bool is_region = line.substr(0, 7) == "region ";
    if (!is_region && line.substr(0, 6) != "patch ")
      return;
    line = trimmed(line.substr(is_region ? 7 : 6));
    const std::size_t end = line.find(' ');
    if (end != line.npos && parse_number(line.substr(0, end), label) && label == static_cast<int>(label))
      (is_region ? region_names_ : names_)[static_cast<int>(label)] = std::string(trimmed(line.substr(end)));
  }

  void read_element(const Ply_element& e, Polygon_soup& soup) {
    if (e.properties.empty())
      return;
    if (e.count > (ascii_ ? text_.remaining() + 1 : bytes_.remaining()) / e.least_bytes(ascii_))
      text_.file().fail("announces " + std::to_string(e.count) + " elements '" + e.name +
                        "', which is more than it can hold; it is truncated or damaged");
    if (e.name == "vertex")
      read_vertices(e, soup);
    else if (e.name == "face")
      read_faces(e, soup);
    else
      for (std::size_t i = 0; i < e.count; ++i)
        for (const Ply_property& p : e.properties)
          skip(p);
  }

  void read_vertices(const Ply_element& e, Polygon_soup& soup) {
    for (const char* name : {"x", "y", "z"})
      if (std::none_of(e.properties.begin(), e.properties.end(),
                       [=](const Ply_property& p) { return p.name == name && !p.length.is_known(); }))
        text_.file().fail(std::string("cannot be used: its vertices have no property '") + name + "'");
    soup.points.reserve(e.count);
    for (std::size_t i = 0; i < e.count; ++i) {
      Coordinates q{0, 0, 0};
      for (const Ply_property& p : e.properties)
        if (!p.length.is_known() && p.name.size() == 1 && p.name[0] >= 'x' && p.name[0] <= 'z')
          q[static_cast<std::size_t>(p.name[0] - 'x')] = number(p.type);
        else
          keep_or_skip(p, soup.point_arrays);
      soup.points.push_back(q);
    }
  }

  void read_faces(const Ply_element& e, Polygon_soup& soup) {
    soup.ends.reserve(e.count);
    for (std::size_t i = 0; i < e.count; ++i) {
      for (const Ply_property& p : e.properties)
        if (p.length.is_known() && (p.name == "vertex_indices" || p.name == "vertex_index")) {
          const std::size_t k = length(p);
          for (std::size_t c = 0; c < k; ++c)
            soup.corners.push_back(corner(p.type));
        } else
          keep_or_skip(p, soup.cell_arrays);
      soup.end_polygon();
    }
  }

  // A single number goes into the array of its name.
  void keep_or_skip(const Ply_property& p, Polygon_soup::Arrays& arrays) {
    if (p.length.is_known())
      skip(p);
    else
      arrays[p.name].push_back(number(p.type));
  }

  double number(Number_type t) { return ascii_ ? text_.number("property") : bytes_.number<double>(t, "property"); }

  std::int64_t corner(Number_type t) {
    const double c = number(t);
    // not every double fits an index; what does not is out of range in any case
    return c >= 0 && c < 9e15 ? static_cast<std::int64_t>(c) : -1;
  }

  std::size_t length(const Ply_property& p) {
    if (ascii_)
      return text_.count("length of a list");
    const std::int64_t n = bytes_.number<std::int64_t>(p.length, "length of a list");
    if (n < 0)
      bytes_.fail("a list has a negative length; the file is damaged");
    return static_cast<std::size_t>(n);
  }

  void skip(const Ply_property& p) {
    const std::size_t n = p.length.is_known() ? length(p) : 1;
    if (!ascii_)
      bytes_.take(n, p.type.size, "property");
    else
      for (std::size_t i = 0; i < n; ++i)
        if (text_.token().empty())
          text_.fail_at_end("property");
  }

  Text_cursor text_;
  Byte_cursor bytes_;
  bool ascii_ = true;
  bool little_endian_ = true;
  std::vector<Ply_element> elements_;
  Label_names names_, region_names_;
};

inline Polygon_soup read_ply(const Input_file& file) {
  return Ply_reader(file).read();
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_READ_PLY_H
