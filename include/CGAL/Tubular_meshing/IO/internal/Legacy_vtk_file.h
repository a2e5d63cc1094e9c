// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_LEGACY_VTK_FILE_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_LEGACY_VTK_FILE_H

#include <CGAL/Tubular_meshing/IO/internal/Byte_cursor.h>
#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/Text_cursor.h>

#include <map>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

// Cells as VTK 5 lists them: corners of cell i end before ends[i].
struct Vtk_cells {
  std::vector<std::int64_t> corners;
  std::vector<std::int64_t> ends;
};

inline Number_type legacy_vtk_type(std::string_view name) {
  struct Row {
    const char* name;
    Number_type type;
  };
  static const Row rows[] = {
      {"char", {'i', 1}},           {"signed_char", {'i', 1}},   {"unsigned_char", {'u', 1}},
      {"short", {'i', 2}},          {"int", {'i', 4}},           {"unsigned_short", {'u', 2}},
      {"unsigned_int", {'u', 4}},   {"long", {'i', 8}},          {"float", {'f', 4}},
      {"unsigned_long", {'u', 8}},  {"vtktypeint64", {'i', 8}},  {"vtktypeuint64", {'u', 8}},
      {"double", {'f', 8}},         {"vtkIdType", {'i', 4}},     {"vtktypeint8", {'i', 1}},
      {"vtktypeuint8", {'u', 1}},   {"vtktypeint16", {'i', 2}},  {"vtktypeuint16", {'u', 2}},
      {"vtktypeint32", {'i', 4}},   {"vtktypeuint32", {'u', 4}}, {"vtktypefloat32", {'f', 4}},
      {"vtktypefloat64", {'f', 8}}, {"long_long", {'i', 8}},     {"unsigned_long_long", {'u', 8}},
  };
  for (const Row& r : rows)
    if (equal_ignoring_case(name, r.name))
      return r.type;
  return Number_type();
}

// A legacy VTK file with a POLYDATA or an UNSTRUCTURED_GRID, ASCII or binary (which is big endian), versions 1 to 4.2
// and 5.x: points, cells and the arrays at points. All else is passed over.
class Legacy_vtk_file {
public:
  std::vector<Coordinates> points;
  std::map<std::string, Vtk_cells> cells; // POLYDATA: LINES, POLYGONS, …; else CELLS
  std::vector<int> cell_types;
  std::map<std::string, std::vector<double>> point_arrays, cell_arrays, fields;

  bool is_polydata() const { return dataset_ == "POLYDATA"; }
  const Input_file& file() const { return text_.file(); }

  explicit Legacy_vtk_file(const Input_file& file)
      : text_(file) {
    read_header();
    while (!text_.at_end())
      read_section(std::string(text_.token()));
    for (const auto& a : point_arrays)
      if (a.second.size() % (points.empty() ? 1 : points.size()) != 0)
        file.fail("cannot be used: its point array " + printable(a.first) + " does not have a value for each point");
    for (const auto& c : cells)
      check_cells(c.second);
  }

private:
  void read_header() {
    if (text_.line().substr(0, 14) != "# vtk DataFile")
      text_.fail("a legacy VTK file starts with '# vtk DataFile Version'");
    text_.line(); // title
    const std::string_view mode = text_.token();
    ascii_ = equal_ignoring_case(mode, "ASCII");
    if (!ascii_ && !equal_ignoring_case(mode, "BINARY"))
      text_.fail(printable(mode) + " stands where ASCII or BINARY should be");
    if (!equal_ignoring_case(text_.token(), "DATASET"))
      text_.fail("the word DATASET is missing");
    dataset_ = std::string(text_.token());
    if (dataset_ != "POLYDATA" && dataset_ != "UNSTRUCTURED_GRID")
      text_.fail("the dataset is " + printable(dataset_) + "; it should be POLYDATA or UNSTRUCTURED_GRID");
  }

  void read_section(const std::string& word) {
    if (word == "POINTS")
      read_points();
    else if (word == "LINES" || word == "POLYGONS" || word == "VERTICES" || word == "TRIANGLE_STRIPS" ||
             word == "CELLS")
      read_cells(cells[word]);
    else if (word == "CELL_TYPES")
      read_cell_types();
    else if (word == "POINT_DATA" || word == "CELL_DATA") {
      tuples_ = text_.count("number of values", 1);
      place_ = word == "POINT_DATA" ? &point_arrays : &cell_arrays;
    } else if (word == "METADATA")
      skip_metadata();
    else if (word == "FIELD")
      read_field();
    else
      read_attribute(word);
  }

  // Up to an empty line; but one may be the name of a component that has none, and more comes behind it.
  void skip_metadata() {
    text_.line();
    while (text_.remaining() > 0)
      if (trimmed(text_.line()).empty() && text_.peek() != "INFORMATION")
        return;
  }

  void read_points() {
    const std::size_t n = text_.count("number of points", 2);
    const std::vector<double> xyz = numbers<double>(3, n, text_.token(), "points");
    points.resize(n);
    for (std::size_t i = 0; i < n; ++i)
      points[i] = {xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]};
    check_finite(points, file());
  }

  void read_cells(Vtk_cells& c) {
    const std::size_t first = text_.count("number of cells"), second = text_.count("number of corners of cells");
    const std::size_t position = text_.position();
    if (text_.token() == "OFFSETS") { // version 5
      c.ends = numbers<std::int64_t>(1, first, text_.token(), "offsets of cells");
      if (!c.ends.empty())
        c.ends.erase(c.ends.begin());
      if (text_.token() != "CONNECTIVITY")
        text_.fail("the word CONNECTIVITY is missing behind the offsets of the cells");
      c.corners = numbers<std::int64_t>(1, second, text_.token(), "corners of cells");
      return;
    }
    text_.move_to(position);
    const std::vector<std::int64_t> list = numbers<std::int64_t>(1, second, "int", "cells");
    c.corners.reserve(second);
    c.ends.reserve(first);
    for (std::size_t i = 0; i < list.size();) {
      const std::int64_t k = list[i++];
      if (k < 0 || static_cast<std::size_t>(k) > list.size() - i)
        text_.fail("cell " + std::to_string(c.ends.size()) + " is said to have " + std::to_string(k) +
                   " corners, which is more than there are");
      const auto begin = list.begin() + static_cast<std::ptrdiff_t>(i);
      c.corners.insert(c.corners.end(), begin, begin + static_cast<std::ptrdiff_t>(k));
      c.ends.push_back(static_cast<std::int64_t>(c.corners.size()));
      i += static_cast<std::size_t>(k);
    }
    if (c.ends.size() != first)
      text_.fail("there are " + std::to_string(c.ends.size()) + " cells instead of the " + std::to_string(first) +
                 " announced");
  }

  void read_cell_types() {
    const std::size_t n = text_.count("number of cell types");
    for (std::int64_t t : numbers<std::int64_t>(1, n, "int", "cell types"))
      cell_types.push_back(static_cast<int>(t));
  }

  void read_attribute(const std::string& word) {
    const std::string name(text_.token());
    if (word == "LOOKUP_TABLE") {
      const std::size_t n = text_.count("size of the lookup table");
      numbers<double>(4, n, ascii_ ? "float" : "unsigned_char", "lookup table");
      return;
    }
    if (word == "COLOR_SCALARS") {
      const std::size_t k = text_.count("number of colour components");
      numbers<double>(k, tuples_, ascii_ ? "float" : "unsigned_char", "colours");
      return;
    }
    std::size_t components = word == "SCALARS" || word == "GLOBAL_IDS" || word == "PEDIGREE_IDS" || word == "EDGE_FLAGS"
                                 ? 1
                             : word == "VECTORS" || word == "NORMALS" ? 3
                             : word == "TENSORS"                      ? 9
                             : word == "TENSORS6"                     ? 6
                             : word == "TEXTURE_COORDINATES"          ? 2
                                                                      : 0;
    if (components == 0)
      text_.fail(printable(word) + " is no section of a legacy VTK file; if it was truncated, copy or export it again");
    if (word == "TEXTURE_COORDINATES")
      components = text_.count("number of texture coordinates");
    const std::string type(text_.token());
    if (word == "SCALARS")
      components = read_rest_of_scalars();
    if (type == "string")
      return skip_strings(components * tuples_);
    store(name, numbers<double>(components, tuples_, type, "array"));
  }

  // "SCALARS name type [components]", and on the next line "LOOKUP_TABLE name"
  std::size_t read_rest_of_scalars() {
    std::int64_t components = 1;
    const std::string_view given = trimmed(text_.line());
    if (!given.empty() && (!parse_number(given, components) || components < 1 || components > 9))
      text_.fail(printable(given) + " stands where the number of components should be");
    if (text_.peek() == "LOOKUP_TABLE") {
      text_.token();
      text_.token();
    }
    return static_cast<std::size_t>(components);
  }

  void read_field() {
    text_.token(); // its name
    const std::size_t arrays = text_.count("number of arrays", 4);
    for (std::size_t a = 0; a < arrays; ++a) {
      while (text_.peek() == "METADATA")
        read_section(std::string(text_.token()));
      const std::string name(text_.token());
      const std::size_t components = text_.count("number of components"), tuples = text_.count("number of values");
      const std::string type(text_.token());
      if (type == "string")
        skip_strings(components * tuples);
      else
        store(name, numbers<double>(components, tuples, type, "array"));
    }
  }

  void store(const std::string& name, std::vector<double> values) { (*place_)[name] = std::move(values); }

  // n tuples of numbers. The cursor stands behind the type's name or the sizes; binary data begins on the next line.
  template <class T>
  std::vector<T> numbers(std::size_t components, std::size_t n, std::string_view type_name, const char* what) {
    if (type_name == "bit")
      return bits<T>(components * n, what);
    const Number_type type = legacy_vtk_type(type_name);
    if (!type.is_known() || (std::is_integral<T>::value && type.kind == 'f'))
      text_.fail(printable(type_name) + " is no type that the " + what + " can have");
    if (components != 0 && n > text_.remaining() / components)
      text_.fail(std::string("the file ends within the ") + what + "; it is truncated, export or copy it again");
    if (!ascii_) {
      end_line();
      Byte_cursor in(file(), text_.position(), false);
      std::vector<T> values = in.numbers<T>(components * n, type, what);
      text_.move_to(in.position());
      return values;
    }
    std::vector<T> values(components * n);
    for (T& v : values)
      if constexpr (std::is_integral<T>::value)
        v = text_.integer(what);
      else
        v = text_.number(what);
    return values;
  }

  // Behind the type's name or the sizes, before binary data.
  void end_line() {
    if (text_.remaining() > 0 && text_.rest().front() != '\n' && is_space(text_.rest().front()))
      text_.line();
    else if (text_.remaining() > 0 && text_.rest().front() == '\n')
      text_.move_to(text_.position() + 1);
  }

  // In binary eight to a byte, the first one highest.
  template <class T> std::vector<T> bits(std::size_t n, const char* what) {
    if (n / 8 > text_.remaining())
      text_.fail(std::string("the file ends within the ") + what + "; it is truncated, export or copy it again");
    std::vector<T> values(n);
    if (ascii_) {
      for (T& v : values)
        v = static_cast<T>(text_.integer(what));
      return values;
    }
    end_line();
    Byte_cursor in(file(), text_.position(), false);
    const std::string_view bytes = in.take((n + 7) / 8, what);
    for (std::size_t i = 0; i < n; ++i)
      values[i] = static_cast<T>(static_cast<unsigned char>(bytes[i / 8]) >> (7 - i % 8) & 1);
    text_.move_to(in.position());
    return values;
  }

  // In ASCII a line each; in binary each with its length, in 1, 2, 4 or 8 bytes as its first two bits say.
  void skip_strings(std::size_t n) {
    text_.line();
    for (std::size_t i = 0; i < n && ascii_; ++i)
      if (text_.remaining() == 0)
        text_.fail_at_end("string");
      else
        text_.line();
    if (ascii_)
      return;
    Byte_cursor in(file(), text_.position(), false);
    for (std::size_t i = 0; i < n; ++i) {
      const unsigned first = in.number<std::uint8_t>("string");
      std::uint64_t length = first & 63;
      for (int more = first >> 6 == 3 ? 0 : first >> 6 == 2 ? 1 : first >> 6 == 1 ? 3 : 7; more > 0; --more)
        length = length << 8 | in.number<std::uint8_t>("string");
      in.take(static_cast<std::size_t>(length), "string");
    }
    text_.move_to(in.position());
  }

  void check_cells(const Vtk_cells& c) const {
    std::int64_t previous = 0;
    for (std::size_t i = 0; i < c.ends.size(); previous = c.ends[i], ++i)
      if (c.ends[i] < previous || c.ends[i] > static_cast<std::int64_t>(c.corners.size()))
        file().fail("cannot be used: the offset of cell " + std::to_string(i) + " is " + std::to_string(c.ends[i]) +
                    ", which is out of range; it is damaged");
    for (std::size_t i = 0; i < c.corners.size(); ++i)
      check_index(c.corners[i], points.size(), "corner", i, file());
  }

  Text_cursor text_;
  bool ascii_ = true;
  std::string dataset_;
  std::size_t tuples_ = 0;
  std::map<std::string, std::vector<double>>* place_ = &fields; // that arrays belong to
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_LEGACY_VTK_FILE_H
