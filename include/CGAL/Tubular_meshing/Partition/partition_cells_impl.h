// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PARTITION_PARTITION_CELLS_IMPL_H
#define CGAL_TUBULAR_MESHING_PARTITION_PARTITION_CELLS_IMPL_H

#include <CGAL/Tubular_meshing/Partition/internal/Dual_graph.h>
#include <CGAL/Tubular_meshing/Partition/partition_cells.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#ifdef CGAL_TUBULAR_MESHING_WITH_METIS
#include <metis.h>
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

namespace internal {

typedef std::vector<std::uint32_t> Part_of_cells;

// The most cells that a part may have: 3 percent over its share, or the next whole number.
inline std::size_t largest_part(std::size_t cells, std::size_t parts) {
  return (std::max)((cells + parts - 1) / parts, std::size_t(1.03 * double(cells) / double(parts)));
}

inline std::vector<std::size_t> sizes_of(const Part_of_cells& part, std::size_t parts) {
  std::vector<std::size_t> cells(parts, 0);
  for (std::uint32_t p : part)
    ++cells[p];
  return cells;
}

inline bool is_balanced(const Part_of_cells& part, std::size_t parts) {
  const std::vector<std::size_t> cells = sizes_of(part, parts);
  const auto least_and_most = std::minmax_element(cells.begin(), cells.end());
  return *least_and_most.first > 0 && *least_and_most.second <= largest_part(part.size(), parts);
}

// Equal pieces of an order in which neighbours follow each other.
inline Part_of_cells in_equal_pieces(const Dual_graph& graph, std::size_t parts) {
  Part_of_cells part(graph.size());
  std::size_t i = 0;
  graph.traverse([](std::size_t, std::size_t) { return true; },
                 [&](std::size_t c, bool) { part[c] = std::uint32_t(i++ * parts / graph.size()); });
  return part;
}

#ifdef CGAL_TUBULAR_MESHING_WITH_METIS

static_assert(sizeof(idx_t) == sizeof(std::int32_t) || sizeof(idx_t) == sizeof(std::int64_t), "METIS counts in these");

// Twice the number of faces between parts.
inline std::size_t cut_of(const Dual_graph& graph, const Part_of_cells& part) {
  std::size_t cut = 0;
  for (std::size_t c = 0; c < graph.size(); ++c)
    for (std::int32_t k = graph.first[c]; k < graph.first[c + 1]; ++k)
      cut += part[c] != part[std::size_t(graph.neighbours[std::size_t(k)])];
  return cut;
}

// The pieces of the parts that are connected through faces, but for the largest of each part.
inline std::vector<std::vector<std::uint32_t>> fragments_of(const Dual_graph& graph, const Part_of_cells& part,
                                                            std::size_t parts) {
  constexpr std::size_t none = std::size_t(-1);
  std::vector<std::size_t> sizes, largest(parts, none);
  std::vector<std::uint32_t> piece(graph.size());
  const auto inside = [&](std::size_t a, std::size_t b) { return part[a] == part[b]; };
  graph.traverse(inside, [&](std::size_t c, bool is_first) {
    if (is_first)
      sizes.push_back(0);
    ++sizes.back();
    piece[c] = std::uint32_t(sizes.size() - 1);
  });
  for (std::size_t c = 0; c < graph.size(); ++c)
    if (largest[part[c]] == none || sizes[piece[c]] > sizes[largest[part[c]]])
      largest[part[c]] = piece[c];
  std::vector<std::vector<std::uint32_t>> fragments;
  if (sizes.size() == parts)
    return fragments;
  std::vector<std::size_t> fragment(sizes.size(), none);
  for (std::size_t c = 0; c < graph.size(); ++c) {
    if (piece[c] == largest[part[c]])
      continue;
    if (fragment[piece[c]] == none) {
      fragment[piece[c]] = fragments.size();
      fragments.emplace_back();
    }
    fragments[fragment[piece[c]]].push_back(std::uint32_t(c));
  }
  return fragments;
}

/* Gives pieces that lie apart from the rest of their part to the part that they share most faces with, where that keeps
 * the balance: they share none with their own, so that fewer faces are cut. */
inline void join_fragments(const Dual_graph& graph, std::size_t parts, Part_of_cells& part) {
  std::vector<std::size_t> sizes = sizes_of(part, parts);
  const std::size_t most = largest_part(graph.size(), parts);
  bool has_moved = true;
  for (int round = 0; round < 4 && has_moved; ++round) { // a piece may leave another one alone
    has_moved = false;
    for (const auto& cells : fragments_of(graph, part, parts)) {
      const std::uint32_t own = part[cells.front()];
      std::map<std::uint32_t, std::size_t> faces; // to cells of each part, those inside of the piece counted, too
      for (std::uint32_t c : cells)
        for (std::int32_t k = graph.first[c]; k < graph.first[c + std::size_t(1)]; ++k)
          ++faces[part[std::size_t(graph.neighbours[std::size_t(k)])]];
      std::uint32_t best = own;
      for (const auto& f : faces)
        if (f.first != own && sizes[f.first] + cells.size() <= most && (best == own || f.second > faces[best]))
          best = f.first;
      if (best == own)
        continue;
      for (std::uint32_t c : cells)
        part[c] = best;
      sizes[own] -= cells.size();
      sizes[best] += cells.size();
      has_moved = true;
    }
  }
}

// METIS takes numbers that it does not change by pointers through which it could.
template <class Index> Index* for_metis(const std::vector<std::int32_t>& numbers, std::vector<Index>& copy) {
  if constexpr (std::is_same<Index, std::int32_t>::value) {
    return const_cast<Index*>(numbers.data());
  } else {
    copy.assign(numbers.begin(), numbers.end());
    return copy.data();
  }
}

class Metis_partitioner {
public:
  explicit Metis_partitioner(const Dual_graph& graph)
      : size_(graph.size())
      , first_(for_metis(graph.first, copies_[0]))
      , neighbours_(for_metis(graph.neighbours, copies_[1])) {}
  Metis_partitioner(const Metis_partitioner&) = delete;

  struct Way {
    bool recursive; // by bisection, which keeps the balance best; else into all parts at once
    bool connected;
    idx_t excess; // in thousandths; METIS takes a little more
    idx_t seed;
  };

  Part_of_cells operator()(std::size_t parts, const Way& way) {
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_SEED] = way.seed;
    options[METIS_OPTION_UFACTOR] = way.excess;
    if (!way.recursive)
      options[METIS_OPTION_CONTIG] = way.connected ? 1 : 0;
    idx_t n = idx_t(size_), constraints = 1, number = idx_t(parts), cut = 0;
    std::vector<idx_t> part(size_);
    const auto partition = way.recursive ? METIS_PartGraphRecursive : METIS_PartGraphKway;
    const int result = partition(&n, &constraints, first_, neighbours_, nullptr, nullptr, nullptr, &number, nullptr,
                                 nullptr, options, &cut, part.data());
    if (result != METIS_OK)
      throw Input_error(std::string("The mesh cannot be partitioned: METIS ") +
                        (result == METIS_ERROR_MEMORY ? "has not enough memory" : "fails") + "; ask for fewer parts.");
    return Part_of_cells(part.begin(), part.end());
  }

private:
  std::size_t size_;
  std::vector<idx_t> copies_[2];
  idx_t *first_, *neighbours_;
};

// With fewer cells a part METIS leaves parts empty, and says so where it should not.
constexpr std::size_t fewest_cells_for_metis = 8;

/* What METIS makes without being asked for more than balance, the best of several trials: it begins at random, and its
 * cuts differ by a tenth and more. Connected parts are taken if they cut no more than a tenth more: METIS makes such ones
 * if it is asked to, but often at many times the cut where vessels branch. */
inline Part_of_cells partitioned(const Dual_graph& graph, std::size_t parts) {
  if (graph.size() / parts < fewest_cells_for_metis)
    return in_equal_pieces(graph, parts);
  const bool is_connected = graph.is_connected();
  Metis_partitioner metis(graph);
  Part_of_cells best;
  double least = 0;
  bool is_best_connected = false;
  const auto try_way = [&](const Metis_partitioner::Way& way) {
    Part_of_cells part = metis(parts, way);
    join_fragments(graph, parts, part);
    if (!is_balanced(part, parts))
      return;
    const bool all_connected = !is_connected || fragments_of(graph, part, parts).empty();
    const double cost = double(cut_of(graph, part)) * (all_connected ? 1 : 1.1);
    if (!best.empty() && cost >= least)
      return;
    best = std::move(part);
    least = cost;
    is_best_connected = all_connected;
  };
  const bool is_small = graph.size() < 100000;
  for (idx_t seed = 0; seed < (is_small ? 8 : 4); ++seed)
    try_way({false, false, 29, seed});
  if (!is_best_connected && is_connected) // else METIS stops there
    for (idx_t seed = 0; seed < (is_small ? 4 : 1); ++seed)
      try_way({false, true, 29, seed});
  if (best.empty())
    try_way({true, false, 1, 0});
  return best.empty() ? in_equal_pieces(graph, parts) : best;
}

#else

inline Part_of_cells partitioned(const Dual_graph& graph, std::size_t parts) {
  return in_equal_pieces(graph, parts); // not asked for
}

#endif

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE bool has_metis() {
#ifdef CGAL_TUBULAR_MESHING_WITH_METIS
  return true;
#else
  return false;
#endif
}

CGAL_TUBULAR_MESHING_INLINE Cell_partition partition_cells(const Mixed_mesh& mesh, std::size_t number_of_parts) {
  const std::size_t cells = mesh.number_of_cells();
  if (number_of_parts == 0)
    throw Parameter_error("A mesh cannot be divided into 0 parts; give a number from 1 on.");
  if (number_of_parts > 1 && !has_metis())
    throw Parameter_error("This program was built without METIS, which divides meshes into parts: build it where that "
                          "is installed (libmetis-dev), or write the mesh as a whole.");
  if (number_of_parts > (std::max)(cells, std::size_t(1)))
    throw Parameter_error("The mesh has " + std::to_string(cells) + " cells, which cannot be divided into " +
                          std::to_string(number_of_parts) + " parts; ask for fewer.");
  Cell_partition result;
  result.number_of_parts = number_of_parts;
  if (number_of_parts == 1)
    result.part.assign(cells, 0);
  else
    result.part = internal::partitioned(internal::Dual_graph(mesh), number_of_parts);
  return result;
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_PARTITION_PARTITION_CELLS_IMPL_H
