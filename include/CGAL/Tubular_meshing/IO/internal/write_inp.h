// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_INP_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_INP_H

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Fibre_directions.h>
#include <CGAL/Tubular_meshing/IO/internal/Mesh_nodes.h>
#include <CGAL/Tubular_meshing/IO/internal/Number_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/element_kinds.h>
#include <CGAL/Tubular_meshing/IO/internal/names_in_files.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

/* How input decks of Abaqus and CalculiX name a kind of cells and number the faces of one: by its corners, in the order
 * of Mixed_mesh, which is theirs. */
template <std::size_t N> struct Inp_cell;

template <> struct Inp_cell<4> {
  static constexpr const char *type = "C3D4", *quadratic = "C3D10";
  static constexpr std::array<std::array<int, 4>, 4> faces = {
      {{{0, 1, 2, -1}}, {{0, 3, 1, -1}}, {{1, 3, 2, -1}}, {{2, 3, 0, -1}}}};
};
// A brick whose second face has shrunk to the apex. CalculiX has no element of five nodes, and that of Abaqus has five
// faces numbered like these.
template <> struct Inp_cell<5> {
  static constexpr const char *type = "C3D8", *quadratic = "C3D20";
  static constexpr std::array<std::array<int, 4>, 6> faces = {
      {{{0, 1, 2, 3}}, {{-1, -1, -1, -1}}, {{0, 1, 4, -1}}, {{1, 2, 4, -1}}, {{2, 3, 4, -1}}, {{3, 0, 4, -1}}}};
};
template <> struct Inp_cell<6> {
  static constexpr const char *type = "C3D6", *quadratic = "C3D15";
  static constexpr std::array<std::array<int, 4>, 5> faces = {
      {{{0, 1, 2, -1}}, {{3, 4, 5, -1}}, {{0, 1, 4, 3}}, {{1, 2, 5, 4}}, {{2, 0, 3, 5}}}};
};
template <> struct Inp_cell<8> {
  static constexpr const char *type = "C3D8", *quadratic = "C3D20";
  static constexpr std::array<std::array<int, 4>, 6> faces = {
      {{{0, 1, 2, 3}}, {{4, 7, 6, 5}}, {{0, 4, 5, 1}}, {{1, 5, 6, 2}}, {{2, 6, 7, 3}}, {{3, 7, 4, 0}}}};
};

// The name of the orientation of fibres.
constexpr const char* inp_orientation = "fibres";

/* Writes a mesh as the part of an input deck that another one includes: nodes, elements in a set a region, and for each
 * patch a set of its nodes and a surface; with directions of fibres, an orientation. */
class Inp_writer {
public:
  Inp_writer(Output_file& file, const Mesh_nodes& nodes)
      : file_(file)
      , out_(file)
      , nodes_(nodes)
      , mesh_(nodes.mesh())
      , fibres_(nodes.cell_arrays()) {}

  void write() {
    if (mesh_.number_of_cells() == 0)
      fail("its format is for meshes with cells, and this one has none");
    check_names_differ();
    list_facets();
    out_ << "** Nodes, elements by region, node sets and surfaces by patch.\n*NODE\n";
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      out_ << i + 1;
      for (int k = 0; k < 3; ++k)
        out_ << ", " << short_number(nodes_.point(i)[k]);
      out_ << '\n';
    }
    std::size_t first = 0;
    const auto write = [&](const auto& block) {
      write_cells(block, first);
      first += block.size();
    };
    write(mesh_.tetrahedra);
    write(mesh_.pyramids);
    write(mesh_.prisms);
    write(mesh_.hexahedra);
    for (const Facet& f : facets_)
      if (f.element == 0)
        fail("a facet of its patch " + std::to_string(f.label) + " bounds no cell");
    write_patches();
    if (fibres_.are_there())
      write_orientation();
    out_.flush();
  }

private:
  typedef std::array<std::uint32_t, 4> Key; // sorted; a triangle's last one is none
  static constexpr std::uint32_t none = std::uint32_t(-1);

  struct Facet {
    Key key;
    int label;
    std::array<std::uint32_t, 4> corners;
    std::size_t element = 0; // of those that it bounds, in the highest region
    int face = 0, region = 0;
    bool operator<(const Facet& f) const { return key < f.key; }
  };

  [[noreturn]] void fail(const std::string& reason) const {
    throw Output_error("The file \"" + file_.name() + "\" cannot be written: " + reason +
                       "; write a .vtu file instead.");
  }

  // Exactly, if that takes no more than the twenty characters that a field of a deck may have; else to 13 digits or
  // more.
  static std::string short_number(double x) {
    char text[32];
    std::to_chars_result end = std::to_chars(text, text + sizeof text, x);
    for (int digits = 15; end.ptr - text > 20; --digits)
      end = std::to_chars(text, text + sizeof text, x, std::chars_format::scientific, digits);
    return std::string(text, end.ptr);
  }

  static std::string name_of(const Label_names& names, int label, const std::string& prefix,
                             const std::string& prefix_of_number) {
    const auto found = names.find(label);
    return as_abaqus_name(prefix + (found == names.end() ? prefix_of_number + std::to_string(label) : found->second));
  }
  // Element sets and surfaces of one name are mixed up by CalculiX, which loses the loads on them.
  std::string region_name(int label) const { return name_of(mesh_.region_names, label, "region_", ""); }
  std::string patch_name(int label) const { return name_of(mesh_.patch_names, label, "", "patch_"); }

  // Programs take upper and lower case for the same.
  void check_names_differ() const {
    std::map<std::string, std::string> seen;
    const auto add = [&](std::string name, const std::string& what) {
      for (char& c : name)
        c = char(std::toupper(static_cast<unsigned char>(c)));
      if (!seen.emplace(name, what).second)
        fail("the names of " + seen[name] + " and " + what + " are the same in its format, " + name);
    };
    std::set<int> regions, patches;
    for_each_block(mesh_, [&](const auto& block, const Element_kind& kind) {
      (kind.dimension == 3 ? regions : patches).insert(block.label.begin(), block.label.end());
    });
    for (int r : regions)
      add(region_name(r), "region " + std::to_string(r));
    for (int p : patches)
      add(patch_name(p), "patch " + std::to_string(p));
  }

  static Key key_of(Key corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  void list_facets() {
    on_facet_.assign(mesh_.points.size(), 0);
    const auto add = [&](const Key& corners, int label) {
      Facet f;
      f.key = key_of(corners);
      f.label = label;
      f.corners = corners;
      facets_.push_back(f);
      for (std::uint32_t v : corners)
        if (v != none)
          on_facet_[v] = 1;
    };
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const auto& t = mesh_.triangles.vertices[i];
      add({t[0], t[1], t[2], none}, mesh_.triangles.label[i]);
    }
    for (std::size_t i = 0; i < mesh_.quads.size(); ++i)
      add(mesh_.quads.vertices[i], mesh_.quads.label[i]);
    std::sort(facets_.begin(), facets_.end());
  }

  // first: how many cells of the mesh come before
  template <std::size_t N> void write_cells(const Element_block<N>& block, std::size_t first) {
    constexpr std::size_t kind = N == 8 ? 3 : N - 4;
    constexpr std::size_t most_on_a_line = 15; // nodes, of what may be 16 numbers
    std::map<int, std::vector<std::size_t>> by_region;
    for (std::size_t i = 0; i < block.size(); ++i)
      by_region[block.label[i]].push_back(i);
    for (const auto& region : by_region) {
      out_ << "*ELEMENT, TYPE=" << (nodes_.is_quadratic() ? Inp_cell<N>::quadratic : Inp_cell<N>::type)
           << ", ELSET=" << region_name(region.first) << '\n';
      for (std::size_t i : region.second) {
        const auto& cell = block.vertices[i];
        out_ << ++element_;
        if (fibres_.are_there())
          cells_.push_back(std::uint32_t(first + i));
        const Element_nodes nodes = nodes_.of(kind, cell.data(), i, abaqus_order);
        for (std::size_t k = 0; k < nodes.size; ++k)
          out_ << (k == most_on_a_line ? ",\n" : ", ") << nodes[k] + std::size_t(1);
        if (N == 5)
          for (int k = 0; k < 3; ++k)
            out_ << ", " << cell[4] + std::size_t(1);
        out_ << '\n';
        find_facets(cell, region.first);
      }
    }
  }

  template <std::size_t N> void find_facets(const std::array<std::uint32_t, N>& cell, int region) {
    for (std::size_t f = 0; f < Inp_cell<N>::faces.size(); ++f) {
      Facet face;
      bool may_be = true;
      for (std::size_t k = 0; k < 4; ++k) {
        const int c = Inp_cell<N>::faces[f][k];
        face.key[k] = c < 0 ? none : cell[std::size_t(c)];
        may_be = may_be && (c < 0 ? k == 3 : on_facet_[cell[std::size_t(c)]] != 0);
      }
      if (!may_be)
        continue;
      face.key = key_of(face.key);
      const auto range = std::equal_range(facets_.begin(), facets_.end(), face);
      for (auto it = range.first; it != range.second; ++it)
        if (it->element == 0 || it->region < region) {
          it->element = element_;
          it->face = int(f) + 1;
          it->region = region;
        }
    }
  }

  void write_patches() {
    std::map<int, std::vector<const Facet*>> by_patch;
    for (const Facet& f : facets_)
      by_patch[f.label].push_back(&f);
    for (auto& patch : by_patch) {
      auto& facets = patch.second;
      std::vector<std::uint32_t> nodes;
      for (const Facet* f : facets)
        for (std::uint32_t v : nodes_.of_face(f->corners, abaqus_order))
          nodes.push_back(v);
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      out_ << "*NSET, NSET=" << patch_name(patch.first) << '\n';
      for (std::size_t i = 0; i < nodes.size(); ++i)
        out_ << nodes[i] + std::size_t(1) << (i % 8 == 7 || i + 1 == nodes.size() ? "\n" : ", ");
      std::sort(facets.begin(), facets.end(), [](const Facet* a, const Facet* b) { return a->element < b->element; });
      out_ << "*SURFACE, NAME=" << patch_name(patch.first) << ", TYPE=ELEMENT\n";
      for (const Facet* f : facets)
        out_ << f->element << ", S" << f->face << '\n';
    }
  }

  /* A material's axes in each element of the wall: a section that names the orientation gets them. The table is Abaqus',
   * which wants it; CalculiX does without. */
  void write_orientation() {
    out_ << "*DISTRIBUTION TABLE, NAME=fibre_table\nCOORD3D, COORD3D\n"
            "*DISTRIBUTION, NAME=fibre_axes, LOCATION=ELEMENT, TABLE=fibre_table\n, 1., 0., 0., 0., 1., 0.\n";
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (!fibres_.has(cells_[i]))
        continue;
      out_ << i + 1;
      for (const double* direction : {fibres_.circumferential(cells_[i]), fibres_.longitudinal(cells_[i])})
        for (int k = 0; k < 3; ++k)
          out_ << ", " << short_number(direction[k]);
      out_ << '\n';
    }
    out_ << "*ORIENTATION, NAME=" << inp_orientation << ", DEFINITION=COORDINATES\nfibre_axes\n";
  }

  Output_file& file_;
  Number_writer out_;
  const Mesh_nodes nodes_;
  const Mixed_mesh& mesh_;
  const Fibre_directions fibres_;
  std::vector<std::uint32_t> cells_; // of each element, in the order of the file, if there are fibres
  std::vector<Facet> facets_;        // sorted
  std::vector<char> on_facet_;
  std::size_t element_ = 0; // the last one written; they count from 1
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_INP_H
