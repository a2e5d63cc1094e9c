// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_CORNER_OCTREE_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_CORNER_OCTREE_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Growing_numbering.h>
#include <CGAL/Tubular_meshing/base/Triangle_soup.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* An octree over a domain, as fine as asked for, whose leaves share their corners: a function known at the corners is
 * interpolated anywhere, for the cost of a descent. The values are the user's, one a corner. Built in O(n log n) in the
 * number n of leaves. */
class Corner_octree {
public:
  typedef std::array<double, 3> Position;
  typedef std::array<std::uint32_t, 3> Lattice_point; // position in units of the smallest leaf
  typedef std::pair<std::uint32_t, double> Leaf;      // its number and its edge

  /* What there is to know at a node's center: how far away the domain is (0 inside), and how wide a leaf may be there; not
   * the latter where the domain is out of the node's reach, the distance from its center to its corners. */
  struct Need {
    double distance_to_domain, leaf_width;
  };
  // Where a point is: in which leaf, at which coordinates from 0 to 1.
  struct Place {
    const std::uint32_t* corners; // eight, x fastest
    std::array<double, 3> t;

    /* The weight of corner c in trilinear interpolation. */
    double weight(int c) const {
      return (c & 1 ? t[0] : 1 - t[0]) * (c & 2 ? t[1] : 1 - t[1]) * (c & 4 ? t[2] : 1 - t[2]);
    }
  };

  Corner_octree() = default;

  /* `need`, safe to call from several threads, is asked at the center of each node: one that touches the domain is
   * split until it is no wider than a leaf may be. */
  Corner_octree(const Bbox_3& box, Function_view<Need(const Position&, double reach)> need, int threads) {
    const double dx = box.xmax() - box.xmin(), dy = box.ymax() - box.ymin(), dz = box.zmax() - box.zmin();
    edge_ = (std::max)({dx, dy, dz}) * 1.0625;
    origin_ = {(box.xmin() + box.xmax() - edge_) / 2, (box.ymin() + box.ymax() - edge_) / 2,
               (box.zmin() + box.zmax() - edge_) / 2};
    refine(need, threads);
    number_corners();
  }

  std::size_t number_of_leaves() const { return leaf_corners_.size() / 8; }
  std::size_t number_of_corners() const { return corners_.size(); }
  /* Eight a leaf, x fastest. */
  const std::vector<std::uint32_t>& leaf_corners() const { return leaf_corners_; }
  const std::vector<Lattice_point>& corners() const { return corners_; }

  /* The leaves whose centers lie in the domain. */
  const std::vector<Leaf>& leaves_in_domain() const { return leaves_in_domain_; }
  /* Calls visit(i, position) for each corner, on several threads. */
  void for_each_corner(Function_view<void(std::size_t, const Position&)> visit, int threads) const {
    for_each_range(corners_.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        visit(i, position_of_corner(i));
    });
  }
  /* The same for those of leaves that touch the domain: no others are asked for there. */
  void for_each_corner_at_domain(Function_view<void(std::size_t, const Position&)> visit, int threads) const {
    for_each_range(corners_.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        if (is_at_domain_[i])
          visit(i, position_of_corner(i));
    });
  }

  bool is_at_domain(std::size_t corner) const { return is_at_domain_[corner] != 0; }

  /* The length of a step of the lattice. */
  double unit() const { return edge_ / side; }

  /* The leaf of a point; one outside of the tree counts as the nearest point inside. */
  Place locate(double x, double y, double z) const {
    const double scale = side / edge_;
    return locate_on_lattice({(x - origin_[0]) * scale, (y - origin_[1]) * scale, (z - origin_[2]) * scale});
  }

  /* Gives corners in the middle of a larger leaf's face or edge the value that is interpolated there: the interpolant
   * is continuous then. `assign(corner, place)` is called for each, in an order in which the place's own corners are
   * done; it must set the corner's value to the interpolated one. O(n log n). */
  void for_each_hanging_corner(Function_view<void(std::uint32_t, const Place&)> assign) const {
    struct Hanging {
      std::uint32_t width, corner;
      Place place;
    };
    std::vector<Hanging> hanging;
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
      Hanging h{0, i, Place()};
      for (int c = 0; c < 8; ++c)
        look_around(c, h.corner, h.width, h.place);
      const auto at_end = [](double t) { return t == 0 || t == 1; };
      if (!(at_end(h.place.t[0]) && at_end(h.place.t[1]) && at_end(h.place.t[2])))
        hanging.push_back(h);
    }
    std::stable_sort(hanging.begin(), hanging.end(),
                     [](const Hanging& a, const Hanging& b) { return a.width > b.width; });
    for (const Hanging& h : hanging)
      assign(h.corner, h.place);
  }

  /* Forgets corners(), which only building needs. */
  void release_corners() {
    corners_ = std::vector<Lattice_point>();
    is_at_domain_ = std::vector<char>();
  }

private:
  static constexpr int max_depth = 20; // corners have 21-bit coordinates: three fit into a 64-bit key
  static constexpr double side = double(1u << max_depth);

  struct Node {
    std::uint32_t first; // first of eight children; for a leaf, its number
    std::uint8_t depth;
    bool is_leaf;
  };

  Position position(const std::array<double, 3>& lattice) const {
    const double s = unit();
    return {origin_[0] + s * lattice[0], origin_[1] + s * lattice[1], origin_[2] + s * lattice[2]};
  }

  Position position_of_corner(std::size_t i) const {
    return position({double(corners_[i][0]), double(corners_[i][1]), double(corners_[i][2])});
  }

  // p by value: it becomes the position within the leaf. A coordinate that is not a number becomes 0.
  Place locate_on_lattice(std::array<double, 3> p, std::uint32_t* width = nullptr) const {
    std::array<std::uint32_t, 3> i;
    for (int k = 0; k < 3; ++k) {
      p[k] = p[k] > 0 ? (std::min)(p[k], side - 0.5) : 0;
      i[k] = std::uint32_t(p[k]);
    }
    std::uint32_t n = 0;
    int bit = max_depth;
    while (!nodes_[n].is_leaf) {
      --bit;
      n = nodes_[n].first + (((i[0] >> bit) & 1u) | (((i[1] >> bit) & 1u) << 1) | (((i[2] >> bit) & 1u) << 2));
    }
    const std::uint32_t mask = ~((1u << bit) - 1u);
    const double scale = 1 / double(1u << bit);
    if (width != nullptr)
      *width = 1u << bit;
    return {&leaf_corners_[8 * std::size_t(nodes_[n].first)],
            {scale * (p[0] - double(i[0] & mask)), scale * (p[1] - double(i[1] & mask)),
             scale * (p[2] - double(i[2] & mask))}};
  }

  // Whether the leaf in the direction of octant c from a corner is larger than the largest one so far.
  void look_around(int c, std::uint32_t corner, std::uint32_t& width, Place& place) const {
    const Lattice_point& l = corners_[corner];
    std::array<double, 3> p;
    for (int k = 0; k < 3; ++k) {
      p[k] = double(l[k]) + ((c >> k) & 1 ? 0.5 : -0.5);
      if (p[k] < 0 || p[k] > side)
        return;
    }
    std::uint32_t w;
    Place found = locate_on_lattice(p, &w);
    if (w <= width)
      return;
    for (int k = 0; k < 3; ++k) // from the probe back to the corner
      found.t[k] += (double(l[k]) - p[k]) / w;
    width = w;
    place = found;
  }

  // Level by level, so that the samples of a level can be taken in parallel.
  void refine(Function_view<Need(const Position&, double)> need, int threads) {
    std::vector<Lattice_point> lower = {{0, 0, 0}}; // corner of each node
    std::vector<Need> needs;
    nodes_.push_back({0, 0, true});
    for (std::size_t begin = 0, depth = 0; begin < nodes_.size(); ++depth) {
      const std::size_t end = nodes_.size();
      const std::uint32_t width = 1u << (max_depth - depth);
      const double edge = edge_ / double(1u << depth), half = width / 2.;
      const double reach = 0.87 * edge; // half the diagonal
      needs.resize(end - begin);
      for_each_range(end - begin, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
          const Lattice_point& l = lower[begin + k];
          needs[k] = need(position({l[0] + half, l[1] + half, l[2] + half}), reach);
        }
      });
      for (std::size_t n = begin; n < end; ++n) {
        const Need& s = needs[n - begin];
        const bool may_touch_domain = s.distance_to_domain <= reach;
        if (depth + 1 < max_depth && may_touch_domain && edge > s.leaf_width)
          split(n, width / 2, lower);
        else {
          nodes_[n].first = std::uint32_t(leaf_lower_.size());
          if (s.distance_to_domain == 0)
            leaves_in_domain_.emplace_back(nodes_[n].first, edge);
          leaf_lower_.push_back({lower[n], width, may_touch_domain});
        }
      }
      begin = end;
    }
  }

  void split(std::size_t n, std::uint32_t width, std::vector<Lattice_point>& lower) {
    nodes_[n].is_leaf = false;
    nodes_[n].first = std::uint32_t(nodes_.size());
    const std::uint8_t depth = std::uint8_t(nodes_[n].depth + 1);
    const Lattice_point l = lower[n];
    for (std::uint32_t c = 0; c < 8; ++c) {
      nodes_.push_back({0, depth, true});
      lower.push_back(corner(l, width, c));
    }
  }

  static Lattice_point corner(const Lattice_point& l, std::uint32_t width, std::uint32_t c) {
    return {l[0] + (c & 1u) * width, l[1] + ((c >> 1) & 1u) * width, l[2] + ((c >> 2) & 1u) * width};
  }

  struct Hash_of_key {
    std::size_t operator()(std::uint64_t key) const { return std::size_t(mixed_bits(key)); }
  };

  void number_corners() {
    Growing_numbering<std::uint64_t, Hash_of_key> numbers;
    leaf_corners_.reserve(8 * leaf_lower_.size());
    for (const New_leaf& leaf : leaf_lower_)
      for (std::uint32_t c = 0; c < 8; ++c) {
        const Lattice_point p = corner(leaf.lower, leaf.width, c);
        const std::uint64_t key = (std::uint64_t(p[0]) << 42) | (std::uint64_t(p[1]) << 21) | p[2];
        const std::uint32_t number = numbers.number_of(key);
        if (number == corners_.size()) {
          corners_.push_back(p);
          is_at_domain_.push_back(0);
        }
        is_at_domain_[number] |= char(leaf.may_touch_domain);
        leaf_corners_.push_back(number);
      }
    leaf_lower_ = std::vector<New_leaf>();
  }

  Position origin_ = {0, 0, 0};
  double edge_ = 1;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> leaf_corners_;
  std::vector<Leaf> leaves_in_domain_;

  // of use while building only
  struct New_leaf {
    Lattice_point lower;
    std::uint32_t width;
    bool may_touch_domain;
  };
  std::vector<New_leaf> leaf_lower_;
  std::vector<Lattice_point> corners_;
  std::vector<char> is_at_domain_; // of each corner: whether it is one of a leaf that may touch the domain
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_CORNER_OCTREE_H
