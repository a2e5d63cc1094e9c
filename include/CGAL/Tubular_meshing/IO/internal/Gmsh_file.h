// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_GMSH_FILE_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_GMSH_FILE_H

#include <CGAL/Tubular_meshing/IO/internal/Byte_cursor.h>
#include <CGAL/Tubular_meshing/IO/internal/Polygon_soup.h>
#include <CGAL/Tubular_meshing/IO/internal/Text_cursor.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace IO {
namespace internal {

// Gmsh's numbers of the element types that matter here.
namespace gmsh {
enum Type { line = 1, triangle = 2, quad = 3, tetrahedron = 4, hexahedron = 5, prism = 6, pyramid = 7, point = 15 };
}

// The nodes an element of a Gmsh type has; 0 for unknown types.
inline std::size_t number_of_gmsh_nodes(std::int64_t type) {
  static const std::size_t nodes[] = {0, 2, 3, 4, 4, 8, 6, 5, 3, 6, 9, 10, 27, 18, 14, 1, 8, 20, 15, 13};
  return type > 0 && type < 20 ? nodes[type] : 0;
}

struct Gmsh_node_data {
  std::string name;
  std::size_t components = 0;
  std::vector<std::int64_t> nodes; // indices of points
  std::vector<double> values;
};

// Numbers from either form of a .msh file, ASCII or binary, of which each section has its own stretch.
class Gmsh_cursor {
public:
  Gmsh_cursor(const Input_file& file)
      : text(file)
      , bytes_(file, 0, host_is_little_endian()) {}

  Text_cursor text;

  bool binary() const { return binary_; }
  void set_binary(bool swapped) {
    binary_ = true;
    swapped_ = swapped;
  }

  // Between begin and end numbers are read, in binary from the next line on; all else is read by `text`.
  void begin_numbers() {
    if (!binary_)
      return;
    text.line();
    bytes_ = Byte_cursor(text.file(), text.position(), host_is_little_endian() != swapped_);
  }
  void end_numbers() {
    if (binary_)
      text.move_to(bytes_.position());
  }

  std::int64_t integer(const char* what) { return binary_ ? bytes_.number<std::int32_t>(what) : text.integer(what); }
  std::int64_t size(const char* what) {
    return binary_ ? static_cast<std::int64_t>(bytes_.number<std::uint64_t>(what)) : text.integer(what);
  }
  double real(const char* what) { return binary_ ? bytes_.number<double>(what) : text.number(what); }

  // A number of things to come that are at least `bytes` long in binary; for `n` that integer() or size() gave.
  std::size_t checked(std::int64_t n, std::size_t bytes, const char* what) {
    const std::size_t least = binary_ ? bytes : (std::max<std::size_t>)(1, bytes / 8);
    const std::size_t left = binary_ ? bytes_.remaining() : text.remaining() + 1;
    if (n < 0 || static_cast<std::uint64_t>(n) > left / least)
      text.fail(std::string("the number of ") + what + " is said to be " + std::to_string(n) +
                ", which is more than the file can hold; the file is truncated or damaged");
    return static_cast<std::size_t>(n);
  }

private:
  Byte_cursor bytes_;
  bool binary_ = false;
  bool swapped_ = false;
};

// A mesh file of Gmsh, format 2.0 to 2.2, 4.0 or 4.1: nodes and elements sorted by their tags, names, and data at nodes.
class Gmsh_file {
public:
  struct Element {
    std::int64_t tag;
    std::int64_t type;
    std::int64_t physical; // 0: in no group
    std::size_t first_node;
  };

  std::vector<Coordinates> points;
  std::vector<Element> elements;
  std::vector<std::int64_t> element_nodes;          // indices of points
  std::map<std::pair<int, int>, std::string> names; // of physical groups, by dimension and tag
  std::vector<Gmsh_node_data> node_data;

  explicit Gmsh_file(const Input_file& file)
      : in_(file)
      , file_(file) {
    while (!in_.text.at_end())
      read_section(std::string(in_.text.token()));
    if (version_ == 0)
      file.fail("is no Gmsh mesh: it has no section $MeshFormat");
    sort_nodes();
    check_finite(points, file);
    sort_elements();
    for (Gmsh_node_data& d : node_data)
      for (std::int64_t& t : d.nodes)
        t = index_of(t);
  }

  const Input_file& file() const { return file_; }

private:
  // The index of the node with this tag; throws if there is none.
  std::int64_t index_of(std::int64_t tag) const {
    if (tag > 0 && static_cast<std::size_t>(tag) <= points.size() &&
        node_tags_[static_cast<std::size_t>(tag) - 1] == tag)
      return tag - 1;
    const auto i = std::lower_bound(node_tags_.begin(), node_tags_.end(), tag);
    if (i == node_tags_.end() || *i != tag)
      file_.fail("cannot be used: it refers to node " + std::to_string(tag) + ", which it does not contain");
    return i - node_tags_.begin();
  }

  void read_section(const std::string& keyword) {
    if (keyword.empty() || keyword[0] != '$')
      in_.text.fail(printable(keyword) + " stands where a section of a Gmsh mesh should begin");
    if (keyword == "$MeshFormat")
      read_format();
    else if (version_ == 0)
      in_.text.fail("the section $MeshFormat must come first; Gmsh's format 1 is too old, save the file as 4.1 or 2.2");
    else if (keyword == "$PhysicalNames")
      read_names();
    else if (keyword == "$Entities" && version_ == 4)
      read_entities();
    else if (keyword == "$PartitionedEntities" && version_ == 4 && !is_4_0_)
      read_entities(true);
    else if (keyword == "$Nodes")
      version_ == 4 ? read_nodes_4() : read_nodes_2();
    else if (keyword == "$Elements")
      version_ == 4 ? read_elements_4() : read_elements_2();
    else if (keyword == "$NodeData")
      read_node_data();
    skip_to("$End" + keyword.substr(1));
  }

  void skip_to(const std::string& keyword) {
    const std::size_t i = in_.text.rest().find(keyword);
    if (i == std::string::npos)
      in_.text.fail("the section does not end with " + keyword + "; the file is truncated, export or copy it again");
    in_.text.move_to(in_.text.position() + i);
    in_.text.line();
  }

  void read_format() {
    const double version = in_.text.number("version");
    const std::int64_t binary = in_.text.integer("file type"), size = in_.text.integer("data size");
    if ((version < 2 || version > 2.2) && version != 4 && version != 4.1)
      in_.text.fail("the format's version is neither 2.2 nor 4.1; save the file as one of these");
    is_4_0_ = version == 4;
    if (size != 8 || (binary != 0 && binary != 1))
      in_.text.fail("the file type and the data size are not those of a Gmsh mesh");
    version_ = static_cast<int>(version);
    if (binary == 1) {
      in_.set_binary(false);
      in_.begin_numbers();
      in_.set_binary(in_.integer("byte order") != 1);
      in_.end_numbers();
    }
  }

  void read_names() {
    const std::size_t n = in_.text.count("number of physical names", 6);
    for (std::size_t i = 0; i < n; ++i) {
      const int dimension = static_cast<int>(in_.text.integer("dimension"));
      const int tag = static_cast<int>(in_.text.integer("tag"));
      const std::string_view name = trimmed(in_.text.line());
      if (name.size() < 2 || name.front() != '"' || name.back() != '"')
        in_.text.fail("the name of physical group " + std::to_string(tag) + " is not quoted");
      names[{dimension, tag}] = std::string(name.substr(1, name.size() - 2));
    }
  }

  // Only the physical group of each entity matters.
  void read_entities(bool in_parts = false) {
    in_.begin_numbers();
    if (in_parts) {
      in_.size("number of parts");
      for (std::size_t g = 2 * in_.checked(in_.size("number of ghost entities"), 8, "ghost entities"); g > 0; --g)
        in_.integer("ghost entity");
    }
    std::size_t n[4];
    for (std::size_t& k : n)
      k = in_.checked(in_.size("number of entities"), 32, "entities");
    for (int d = 0; d < 4; ++d)
      for (std::size_t i = 0; i < n[d]; ++i)
        read_entity(d, in_parts);
    in_.end_numbers();
  }

  void read_entity(int dimension, bool in_parts) {
    const std::int64_t tag = in_.integer("tag of an entity");
    if (in_parts) {
      in_.integer("dimension of an entity");
      in_.integer("parent of an entity");
      for (std::size_t p = in_.checked(in_.size("number of parts"), 4, "parts"); p > 0; --p)
        in_.integer("part of an entity");
    }
    for (int k = 0; k < (dimension == 0 && !is_4_0_ ? 3 : 6); ++k)
      in_.real("bounding box of an entity");
    const std::size_t groups = in_.checked(in_.size("number of physical groups"), 4, "physical groups");
    for (std::size_t g = 0; g < groups; ++g) {
      const std::int64_t physical = in_.integer("physical group");
      if (g == 0)
        physical_of_entity_[{dimension, tag}] = physical;
    }
    if (dimension > 0)
      for (std::size_t b = in_.checked(in_.size("number of bounding entities"), 4, "bounding entities"); b > 0; --b)
        in_.integer("bounding entity");
  }

  void read_nodes_2() {
    const std::size_t n = in_.text.count("number of nodes", 8);
    in_.begin_numbers();
    for (std::size_t i = 0; i < n; ++i) {
      node_tags_.push_back(in_.integer("number of a node"));
      read_point();
    }
    in_.end_numbers();
  }

  // Format 4.0 has no range of numbers, the entity before its dimension, and each node with its number.
  void read_nodes_4_0() {
    in_.begin_numbers();
    const std::size_t blocks = in_.checked(in_.size("number of node blocks"), 20, "node blocks");
    in_.size("number of nodes");
    for (std::size_t b = 0; b < blocks; ++b) {
      in_.integer("entity of a node block");
      const std::int64_t dimension = in_.integer("dimension of a node block");
      const bool parametric = in_.integer("parametric flag") != 0;
      const std::size_t n = in_.checked(in_.size("number of nodes"), 28, "nodes");
      for (std::size_t i = 0; i < n; ++i) {
        node_tags_.push_back(in_.integer("number of a node"));
        read_point();
        for (std::int64_t k = 0; parametric && k < dimension && k < 3; ++k)
          in_.real("parameter of a node");
      }
    }
    in_.end_numbers();
  }

  void read_nodes_4() {
    if (is_4_0_)
      return read_nodes_4_0();
    in_.begin_numbers();
    const std::size_t blocks = in_.checked(in_.size("number of node blocks"), 20, "node blocks");
    for (int i = 0; i < 3; ++i)
      in_.size("number of nodes");
    for (std::size_t b = 0; b < blocks; ++b) {
      const std::int64_t dimension = in_.integer("dimension of a node block");
      in_.integer("entity of a node block");
      const bool parametric = in_.integer("parametric flag") != 0;
      const std::size_t n = in_.checked(in_.size("number of nodes"), 32, "nodes");
      for (std::size_t i = 0; i < n; ++i)
        node_tags_.push_back(in_.size("number of a node"));
      for (std::size_t i = 0; i < n; ++i) {
        read_point();
        for (std::int64_t k = 0; parametric && k < dimension && k < 3; ++k)
          in_.real("parameter of a node");
      }
    }
    in_.end_numbers();
  }

  void read_point() {
    Coordinates p;
    for (double& x : p)
      x = in_.real("coordinate of a node");
    points.push_back(p);
  }

  void read_elements_2() {
    const std::size_t n = in_.text.count("number of elements", 5);
    in_.begin_numbers();
    for (std::size_t done = 0; done < n;) {
      if (!in_.binary()) {
        const std::int64_t tag = in_.integer("number of an element"), type = in_.integer("type of an element");
        read_element_2(tag, type, in_.integer("number of tags"));
        ++done;
        continue;
      }
      const std::int64_t type = in_.integer("type of elements");
      const std::size_t block = in_.checked(in_.integer("number of elements"), 8, "elements");
      const std::int64_t tags = in_.integer("number of tags");
      if (block == 0 || block > n - done)
        in_.text.fail("the blocks of elements do not add up to their number");
      for (std::size_t i = 0; i < block; ++i)
        read_element_2(in_.integer("number of an element"), type, tags);
      done += block;
    }
    in_.end_numbers();
  }

  void read_element_2(std::int64_t tag, std::int64_t type, std::int64_t tags) {
    std::int64_t physical = 0;
    const std::size_t n = in_.checked(tags, 4, "tags");
    for (std::size_t i = 0; i < n; ++i) {
      const std::int64_t t = in_.integer("tag of an element");
      physical = i == 0 ? t : physical;
    }
    begin_element(tag, type, physical);
    for (std::size_t k = number_of_gmsh_nodes(type); k > 0; --k)
      element_nodes.push_back(in_.integer("node of an element"));
  }

  void read_elements_4() {
    in_.begin_numbers();
    const std::size_t blocks = in_.checked(in_.size("number of element blocks"), 20, "element blocks");
    for (int i = 0; i < (is_4_0_ ? 1 : 3); ++i)
      in_.size("number of elements");
    for (std::size_t b = 0; b < blocks; ++b) {
      std::int64_t dimension = in_.integer("dimension of an element block");
      std::int64_t entity = in_.integer("entity of an element block");
      if (is_4_0_)
        std::swap(dimension, entity);
      const std::int64_t type = in_.integer("type of an element block");
      const std::size_t n = in_.checked(in_.size("number of elements"), is_4_0_ ? 8 : 16, "elements");
      const auto group = physical_of_entity_.find({static_cast<int>(dimension), entity});
      for (std::size_t i = 0; i < n; ++i) {
        begin_element(tag("number of an element"), type, group == physical_of_entity_.end() ? 0 : group->second);
        for (std::size_t k = number_of_gmsh_nodes(type); k > 0; --k)
          element_nodes.push_back(tag("node of an element"));
      }
    }
    in_.end_numbers();
  }

  // Of nodes and elements in format 4.
  std::int64_t tag(const char* what) { return is_4_0_ ? in_.integer(what) : in_.size(what); }

  void begin_element(std::int64_t tag, std::int64_t type, std::int64_t physical) {
    if (number_of_gmsh_nodes(type) == 0)
      in_.text.fail("element " + std::to_string(tag) + " is of type " + std::to_string(type) +
                    ", which is not supported; save the mesh with elements of first order");
    elements.push_back({tag, type, physical, element_nodes.size()});
  }

  void read_node_data() {
    Gmsh_node_data data;
    std::size_t strings = in_.text.count("number of string tags");
    in_.text.line();
    for (; strings > 0; --strings) {
      const std::string_view s = trimmed(in_.text.line());
      if (data.name.empty() && s.size() >= 2)
        data.name = std::string(s.front() == '"' ? s.substr(1, s.size() - 2) : s);
    }
    for (std::size_t reals = in_.text.count("number of real tags"); reals > 0; --reals)
      in_.text.number("real tag");
    std::int64_t tags[3] = {0, 0, 0}; // time step, components, nodes
    const std::size_t integers = in_.text.count("number of integer tags");
    for (std::size_t i = 0; i < integers; ++i) {
      const std::int64_t t = in_.text.integer("integer tag");
      if (i < 3)
        tags[i] = t;
    }
    if (tags[1] < 1 || tags[1] > 9)
      in_.text.fail("the number of components of the node data is not from 1 to 9");
    data.components = static_cast<std::size_t>(tags[1]);
    in_.begin_numbers();
    const std::size_t n = in_.checked(tags[2], 4, "values at nodes");
    for (std::size_t i = 0; i < n; ++i) {
      data.nodes.push_back(in_.integer("number of a node"));
      for (std::size_t k = 0; k < data.components; ++k)
        data.values.push_back(in_.real("value at a node"));
    }
    in_.end_numbers();
    node_data.push_back(std::move(data));
  }

  // Sorted by tag, points come in the order in which this package numbers them when it writes.
  void sort_nodes() {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return node_tags_[a] < node_tags_[b]; });
    std::vector<Coordinates> sorted_points(points.size());
    std::vector<std::int64_t> sorted_tags(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      sorted_points[i] = points[order[i]];
      sorted_tags[i] = node_tags_[order[i]];
      if (i > 0 && sorted_tags[i] == sorted_tags[i - 1])
        file_.fail("cannot be used: it contains node " + std::to_string(sorted_tags[i]) + " twice");
    }
    points.swap(sorted_points);
    node_tags_.swap(sorted_tags);
  }

  void sort_elements() {
    std::stable_sort(elements.begin(), elements.end(),
                     [](const Element& a, const Element& b) { return a.tag < b.tag; });
    for (std::int64_t& node : element_nodes)
      node = index_of(node);
  }

  Gmsh_cursor in_;
  const Input_file& file_;
  int version_ = 0;
  bool is_4_0_ = false;
  std::vector<std::int64_t> node_tags_;
  std::map<std::pair<int, std::int64_t>, std::int64_t> physical_of_entity_;
};

} // namespace internal
} // namespace IO
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_GMSH_FILE_H
