// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_INP_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_INP_H

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Cells_by_region.h>
#include <CGAL/Tubular_meshing/IO/internal/Facet_index.h>
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
#include <string_view>
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
      , fibres_(nodes.cell_arrays())
      , numbered_(mesh_)
      , order_(numbered_)
      , listed_(order_.listed())
      , index_(mesh_)
      , bounded_(mesh_.number_of_facets()) {}

  void write() {
    if (mesh_.number_of_cells() == 0)
      fail("its format is for meshes with cells, and this one has none");
    check_names_differ();
    out_ << "** Nodes, elements by region, node sets and surfaces by patch.\n*NODE\n";
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      out_ << i + 1;
      for (int k = 0; k < 3; ++k)
        out_ << ", " << Short_number(nodes_.point(i)[k]).text();
      out_ << '\n';
    }
    for (std::size_t kind = 0; kind < 4; ++kind)
      for (std::size_t b = 0; b < order_.blocks().size(); ++b)
        if (order_.blocks()[b].kind == kind)
          write_block(b);
    for (std::uint32_t f : index_.facets())
      if (bounded_[f].element == 0)
        fail("a facet of its patch " + std::to_string(label(f)) + " bounds no cell");
    write_patches();
    if (fibres_.are_there())
      write_orientation();
    out_.flush();
  }

private:
  // Of those elements that a facet bounds, that in the highest region.
  struct Bounded_element {
    std::uint32_t element = 0; // there is none
    int region = 0;
    std::uint8_t face = 0;
  };

  // Exactly, if that takes no more than the twenty characters that a field of a deck may have; else to 13 digits or
  // more.
  class Short_number {
  public:
    explicit Short_number(double x)
        : end_(std::to_chars(text_, text_ + sizeof text_, x).ptr) {
      for (int digits = 15; end_ - text_ > 20; --digits)
        end_ = std::to_chars(text_, text_ + sizeof text_, x, std::chars_format::scientific, digits).ptr;
    }
    std::string_view text() const { return {text_, std::size_t(end_ - text_)}; }

  private:
    char text_[32];
    char* end_;
  };

  [[noreturn]] void fail(const std::string& reason) const {
    throw Output_error("The file \"" + file_.name() + "\" cannot be written: " + reason +
                       "; write a .vtu file instead.");
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

  void write_block(std::size_t block) {
    switch (order_.blocks()[block].kind) {
    case 0:
      return write_cells(mesh_.tetrahedra, block);
    case 1:
      return write_cells(mesh_.pyramids, block);
    case 2:
      return write_cells(mesh_.prisms, block);
    default:
      return write_cells(mesh_.hexahedra, block);
    }
  }

  // cells: all of the kind of those of the block
  template <std::size_t N> void write_cells(const Element_block<N>& cells, std::size_t block) {
    constexpr std::size_t kind = N == 8 ? 3 : N - 4;
    constexpr std::size_t most_on_a_line = 15; // nodes, of what may be 16 numbers
    const int region = order_.blocks()[block].region;
    out_ << "*ELEMENT, TYPE=" << (nodes_.is_quadratic() ? Inp_cell<N>::quadratic : Inp_cell<N>::type)
         << ", ELSET=" << region_name(region) << '\n';
    for (std::size_t place = order_.first_place(block); place < order_.first_place(block + 1); ++place) {
      const std::size_t i = listed_[place] - numbered_.first_cell(kind);
      const auto& cell = cells.vertices[i];
      out_ << ++element_;
      if (fibres_.are_there())
        cells_.push_back(listed_[place]);
      const Element_nodes nodes = nodes_.of(kind, cell.data(), i, abaqus_order);
      for (std::size_t k = 0; k < nodes.size; ++k)
        out_ << (k == most_on_a_line ? ",\n" : ", ") << nodes[k] + std::size_t(1);
      if (N == 5)
        for (int k = 0; k < 3; ++k)
          out_ << ", " << cell[4] + std::size_t(1);
      out_ << '\n';
      find_facets(cell, region);
    }
  }

  template <std::size_t N> void find_facets(const std::array<std::uint32_t, N>& cell, int region) {
    if (!index_.may_have_facet(cell))
      return;
    for (std::size_t f = 0; f < Inp_cell<N>::faces.size(); ++f) {
      const std::array<int, 4>& corners = Inp_cell<N>::faces[f];
      if (corners[0] < 0)
        continue; // what has shrunk to a point
      Face face;
      for (std::size_t k = 0; k < 4; ++k)
        face[k] = corners[k] < 0 ? no_vertex : cell[std::size_t(corners[k])];
      if (!index_.may_be_facet(face))
        continue;
      const Facet_index::Facets found = index_.with_corners_of(face);
      for (auto it = found.first; it != found.second; ++it) {
        Bounded_element& e = bounded_[*it];
        if (e.element == 0 || e.region < region)
          e = {std::uint32_t(element_), region, std::uint8_t(f + 1)};
      }
    }
  }

  int label(std::size_t facet) const {
    const std::size_t triangles = mesh_.triangles.size();
    return facet < triangles ? mesh_.triangles.label[facet] : mesh_.quads.label[facet - triangles];
  }

  // The facets of each patch, by their sorted corners.
  std::map<int, std::vector<std::uint32_t>> facets_of_patches() const {
    std::map<int, std::size_t> sizes;
    for (std::uint32_t f : index_.facets())
      ++sizes[label(f)];
    std::map<int, std::vector<std::uint32_t>> patches;
    for (const auto& s : sizes)
      patches[s.first].reserve(s.second);
    for (std::uint32_t f : index_.facets())
      patches[label(f)].push_back(f);
    return patches;
  }

  void write_patches() {
    std::map<int, std::vector<std::uint32_t>> patches = facets_of_patches();
    for (auto& patch : patches) {
      std::vector<std::uint32_t>& facets = patch.second;
      write_nodes_of(facets, patch_name(patch.first));
      std::sort(facets.begin(), facets.end(),
                [&](std::uint32_t a, std::uint32_t b) { return bounded_[a].element < bounded_[b].element; });
      out_ << "*SURFACE, NAME=" << patch_name(patch.first) << ", TYPE=ELEMENT\n";
      for (std::uint32_t f : facets)
        out_ << bounded_[f].element << ", S" << int(bounded_[f].face) << '\n';
    }
  }

  void write_nodes_of(const std::vector<std::uint32_t>& facets, const std::string& name) {
    std::vector<std::uint32_t> nodes;
    nodes.reserve(nodes_.number(4) * facets.size());
    for (std::uint32_t f : facets)
      for (std::uint32_t v : nodes_.of_face(index_.corners_of(f), abaqus_order))
        nodes.push_back(v);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    out_ << "*NSET, NSET=" << name << '\n';
    for (std::size_t i = 0; i < nodes.size(); ++i)
      out_ << nodes[i] + std::size_t(1) << (i % 8 == 7 || i + 1 == nodes.size() ? "\n" : ", ");
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
          out_ << ", " << Short_number(direction[k]).text();
      out_ << '\n';
    }
    out_ << "*ORIENTATION, NAME=" << inp_orientation << ", DEFINITION=COORDINATES\nfibre_axes\n";
  }

  Output_file& file_;
  Number_writer out_;
  const Mesh_nodes nodes_;
  const Mixed_mesh& mesh_;
  const Fibre_directions fibres_;
  const Numbered_cells numbered_;
  const Cells_by_region order_;
  const Cells_by_region::Listed listed_;
  const Facet_index index_;
  std::vector<Bounded_element> bounded_;
  std::vector<std::uint32_t> cells_; // of each element, in the order of the file, if there are fibres
  std::size_t element_ = 0;          // the last one written; they count from 1
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_INP_H
