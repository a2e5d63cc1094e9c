// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_MSH_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_MSH_H

#include <CGAL/Tubular_meshing/IO/internal/Mesh_nodes.h>
#include <CGAL/Tubular_meshing/IO/internal/Number_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/element_kinds.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

// Writes a mesh for Gmsh, format 4.1 in binary or 2.2 in ASCII (older programs rarely read another form of it). Each
// label is an entity and a physical group of the same number; elements of label 0 are in no group. Nodes and elements
// are numbered in the mesh's order, so that it can be restored although 4.1 lists elements by entity.
class Msh_writer {
public:
  Msh_writer(Output_file& file, const Mesh_nodes& nodes)
      : file_(file)
      , out_(file)
      , nodes_(nodes)
      , mesh_(nodes.mesh()) {
    for_each_block(mesh_, [&](const auto& block, const Element_kind& kind) {
      for (int label : block.label)
        highest_label_[kind.dimension] = (std::max)(highest_label_[kind.dimension], checked(label));
      for (int label : block.label)
        labels_[kind.dimension][label] = true;
    });
  }

  void write_4_1() {
    write_header_4();
    write_names();
    write_entities();
    const int dimension = labels_[3].empty() ? 2 : 3;
    write_nodes_4(dimension, entity(dimension, labels_[dimension].begin()->first));
    write_elements_4([](std::size_t, int label) { return label; }, [&](int d, int label) { return entity(d, label); });
    write_arrays(true);
    out_.flush();
  }

  void write_2_2() {
    out_ << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    write_names();
    write_nodes_2();
    write_elements_2();
    write_arrays(false);
    out_.flush();
  }

protected:
  void write_header_4() {
    out_ << "$MeshFormat\n4.1 1 8\n";
    out_.bytes(std::int32_t(1)) << "\n$EndMeshFormat\n";
  }

  int checked(int label) const {
    if (label < 0)
      fail("its format has no negative labels, but the mesh has the label " + std::to_string(label));
    return label;
  }

  [[noreturn]] void fail(const std::string& reason) const {
    throw Output_error("The file \"" + file_.name() + "\" cannot be written: " + reason +
                       "; write a .vtu file instead.");
  }

  // Entities are numbered from 1.
  std::int32_t entity(int dimension, int label) const { return label > 0 ? label : highest_label_[dimension] + 1; }

  int type_of(const Element_kind& kind) const {
    const Quadratic_kind& q = quadratic_kinds[&kind - element_kinds];
    return nodes_.is_complete() ? q.complete_gmsh_type : nodes_.is_quadratic() ? q.gmsh_type : kind.gmsh_type;
  }
  template <class Block> Element_nodes nodes_of(const Block& block, const Element_kind& kind, std::size_t i) const {
    return nodes_.of(std::size_t(&kind - element_kinds), block.vertices[i].data(), i, gmsh_order);
  }

  void write_names() {
    if (mesh_.region_names.empty() && mesh_.patch_names.empty())
      return;
    out_ << "$PhysicalNames\n" << mesh_.patch_names.size() + mesh_.region_names.size() << '\n';
    for (const auto& n : mesh_.patch_names)
      out_ << "2 " << n.first << " \"" << n.second << "\"\n";
    for (const auto& n : mesh_.region_names)
      out_ << "3 " << n.first << " \"" << n.second << "\"\n";
    out_ << "$EndPhysicalNames\n";
  }

  // The box of the points; Gmsh needs one for each entity, but no tight one.
  std::array<double, 6> bounding_box() const {
    std::array<double, 6> box = {0, 0, 0, 0, 0, 0};
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const double x = nodes_.point(i)[k];
        box[k] = i == 0 ? x : (std::min)(box[k], x);
        box[k + 3] = i == 0 ? x : (std::max)(box[k + 3], x);
      }
    return box;
  }

  void write_entities() {
    // nodes need an entity, even without elements
    if (labels_[2].empty() && labels_[3].empty())
      labels_[3][0] = true;
    out_ << "$Entities\n";
    for (int d = 0; d < 4; ++d)
      out_.bytes(std::uint64_t(labels_[d].size()));
    const std::array<double, 6> box = bounding_box();
    for (int d = 2; d < 4; ++d)
      for (const auto& l : labels_[d]) {
        out_.bytes(entity(d, l.first));
        write_box_and_group(box, l.first);
      }
    out_ << "\n$EndEntities\n";
  }

  void write_box_and_group(const std::array<double, 6>& box, int label) {
    for (double x : box)
      out_.bytes(x);
    out_.bytes(std::uint64_t(label > 0 ? 1 : 0));
    if (label > 0)
      out_.bytes(std::int32_t(label));
    out_.bytes(std::uint64_t(0)); // bounding entities
  }

  // All nodes in one block, in order: classified on patches they would have to be listed patch by patch, and programs
  // that take nodes in the file's order would take other data for theirs.
  void write_nodes_4(int dimension, std::int32_t entity) {
    const std::uint64_t n = nodes_.size();
    out_ << "$Nodes\n";
    out_.bytes(std::uint64_t(1)).bytes(n).bytes(std::uint64_t(1)).bytes(n);
    out_.bytes(std::int32_t(dimension)).bytes(entity);
    out_.bytes(std::int32_t(0)).bytes(n);
    for (std::uint64_t i = 1; i <= n; ++i)
      out_.bytes(i);
    for (std::uint64_t i = 0; i < n; ++i)
      for (int k = 0; k < 3; ++k)
        out_.bytes(double(nodes_.point(i)[k]));
    out_ << "\n$EndNodes\n";
  }

  // Elements of a kind come by their key, key_of(element, label); entity_of(dimension, key) has them.
  template <class Key_of, class Entity_of> void write_elements_4(const Key_of& key_of, const Entity_of& entity_of) {
    typedef decltype(key_of(std::size_t(0), 0)) Key;
    std::vector<std::map<Key, std::vector<std::size_t>>> members; // of each kind and key, in order
    std::uint64_t blocks = 0, elements = 0;
    for_each_block(mesh_, [&](const auto& block, const Element_kind&) {
      members.emplace_back();
      for (std::size_t i = 0; i < block.size(); ++i)
        members.back()[key_of(elements + i, block.label[i])].push_back(i);
      blocks += members.back().size();
      elements += block.size();
    });
    out_ << "$Elements\n";
    out_.bytes(blocks).bytes(elements).bytes(std::uint64_t(1)).bytes(elements);
    std::uint64_t first = 1;
    for_each_block(mesh_, [&](const auto& block, const Element_kind& kind) {
      for (const auto& m : members[static_cast<std::size_t>(&kind - element_kinds)]) {
        out_.bytes(std::int32_t(kind.dimension)).bytes(entity_of(kind.dimension, m.first));
        out_.bytes(std::int32_t(type_of(kind))).bytes(std::uint64_t(m.second.size()));
        for (std::size_t i : m.second) {
          out_.bytes(std::uint64_t(first + i));
          for (std::uint32_t v : nodes_of(block, kind, i))
            out_.bytes(std::uint64_t(v) + 1);
        }
      }
      first += block.size();
    });
    out_ << "\n$EndElements\n";
  }

  void write_nodes_2() {
    out_ << "$Nodes\n" << nodes_.size() << '\n';
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      out_ << i + 1;
      for (int k = 0; k < 3; ++k)
        out_ << ' ' << nodes_.point(i)[k];
      out_ << '\n';
    }
    out_ << "$EndNodes\n";
  }

  void write_elements_2() {
    out_ << "$Elements\n" << mesh_.number_of_cells() + mesh_.number_of_facets() << '\n';
    std::size_t number = 1;
    for_each_block(mesh_, [&](const auto& block, const Element_kind& kind) {
      for (std::size_t i = 0; i < block.size(); ++i, ++number) {
        out_ << number << ' ' << type_of(kind) << " 2 " << block.label[i] << ' '
             << entity(kind.dimension, block.label[i]);
        for (std::uint32_t v : nodes_of(block, kind, i))
          out_ << ' ' << v + std::size_t(1);
        out_ << '\n';
      }
    });
    out_ << "$EndElements\n";
  }

  void write_arrays(bool binary) {
    for (const Point_array& a : mesh_.point_arrays)
      write_data("NodeData", a.name, a.components, nodes_.values(a), binary);
    for (const Cell_array& a : nodes_.cell_arrays())
      write_data("ElementData", a.name, a.components, a.values, binary);
  }

  // Of the first nodes, or elements. Gmsh knows scalars, vectors and tensors of nine components: a symmetric one is
  // written in full.
  void write_data(const std::string& section, const std::string& name, int components,
                  const std::vector<double>& values, bool binary) {
    const std::size_t stored = static_cast<std::size_t>(components), written = stored == 6 ? 9 : stored;
    if (written != 1 && written != 3 && written != 9)
      fail("its format has no arrays of " + std::to_string(stored) + " components, as '" + name + "' is");
    const std::size_t number = values.size() / stored;
    out_ << "$" << section << "\n1\n\"" << name << "\"\n1\n0\n3\n0\n" << written << '\n' << number << '\n';
    for (std::size_t i = 0; i < number; ++i) {
      if (binary)
        out_.bytes(static_cast<std::int32_t>(i + 1));
      else
        out_ << i + 1;
      for (std::size_t k = 0; k < written; ++k) {
        const double x = values[stored * i + (stored == 6 ? symmetric_component[k] : k)];
        if (binary)
          out_.bytes(x);
        else
          out_ << ' ' << x;
      }
      if (!binary)
        out_ << '\n';
    }
    out_ << (binary ? "\n" : "") << "$End" << section << "\n";
  }

  Output_file& file_;
  Number_writer out_;
  const Mesh_nodes nodes_;
  const Mixed_mesh& mesh_;
  std::array<std::map<int, bool>, 4> labels_; // that occur, by dimension
  std::array<int, 4> highest_label_ = {0, 0, 0, 0};
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_WRITE_MSH_H
