// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_CORNER_TREE_H
#define CGAL_TUBULAR_MESHING_BASE_CORNER_TREE_H

#include <CGAL/Tubular_meshing/base/Growing_numbering.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/Triangle_soup.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The nearest of many segments or triangles (`Shape`, of Double_kernel), by a tree of their corners.
 *
 * Let the nearest point p of a shape be at a distance d from q. It is seen across the shape, or across the side that it
 * is on, so that the squared distance of corners there is d² + |corner - p|²; and one of them is no further from p than
 * the radius of the smallest ball round the shape, its reach. So only shapes at corners whose squared distance is no more
 * than d² + reach² are looked at. Where q is far away for their size, as in the middle of a vessel, these are far fewer
 * than those with boxes closer than d, which an AABB tree looks at. Corners that shapes share are one.
 *
 * Of shapes that are equally near, but for rounding, the one with the lowest number is found: the answer depends neither on
 * the tree, nor on where the search began, nor on the unit, position and direction of it all. Built once in O(n log n),
 * on all threads where corners are numbered; a query is O(log n) for shapes such as surfaces and centerlines, allocates
 * nothing, and is safe from several threads. */
template <class Shape> class Corner_tree {
public:
  typedef Double_kernel::Point_3 Point;
  typedef typename Nearest_tree<Shape>::Result Result;
  typedef std::uint32_t Index;
  static constexpr std::size_t N = std::is_same<Shape, Double_kernel::Segment_3>::value ? 2 : 3; // corners of a shape
  typedef std::array<Index, N> Numbers;

  Corner_tree() = default;
  explicit Corner_tree(const std::vector<Shape>& shapes) {
    Growing_numbering<Coordinates, Hash_of_coordinates> places;
    shapes_.resize(shapes.size());
    for (std::size_t s = 0; s < shapes.size(); ++s)
      for (std::size_t k = 0; k < N; ++k)
        shapes_[s][k] = places.number_of(place(shapes[s].vertex(int(k))));
    build([&](Index c) { return places[c]; }, places.size(), 1);
  }
  /* Of shapes by the numbers of their corners, which are in different places. */
  Corner_tree(const std::vector<Point>& points, std::vector<Numbers> shapes, int threads)
      : shapes_(std::move(shapes)) {
    build([&](Index c) { return place(points[c]); }, points.size(), threads);
  }

  bool empty() const { return shapes_.empty(); }
  std::size_t size() const { return shapes_.size(); }
  Shape shape(std::size_t i) const { return at_corners(shapes_[i]); }
  /* The numbers of a shape's corners, in its order; those in the same place are one. */
  const Numbers& corners(std::size_t i) const { return shapes_[i]; }
  std::size_t number_of_corners() const { return corners_.size(); }

  CGAL::Bbox_3 bbox() const {
    if (empty())
      return CGAL::Bbox_3();
    const Place &l = nodes_.front().low, &h = nodes_.front().high;
    return CGAL::Bbox_3(l[0], l[1], l[2], h[0], h[1], h[2]);
  }

  /* The nearest shape closer than the given bound; `index` is size() if there is none. */
  Result nearest(const Point& q, double squared_bound = (std::numeric_limits<double>::infinity)()) const {
    return nearest_from(size(), q, squared_bound);
  }
  /* The same, faster where `hint` is a shape that is likely to be as near. */
  Result nearest_from(std::size_t hint, const Point& q, double squared_bound) const {
    Result best{size(), q, squared_bound};
    double as_near = squared_bound; // no further than this is as near
    if (hint < size())
      look_at(Index(hint), from_nearest(shapes_[hint], place(q)), q, best, as_near);
    search(place(q), as_near, [&](Index shape, const Numbers& corners) { look_at(shape, corners, q, best, as_near); });
    return best;
  }

  /* Calls visit(i, shape, squared distance) for all shapes that are no further from q than this bound, which visit() may
   * lower; the nearer ones first, on the whole, and each once, if its corners differ. */
  template <class Visit> void for_each_near(const Point& q, const double& squared_bound, const Visit& visit) const {
    search(place(q), squared_bound, [&](Index i, const Numbers& corners) {
      const Shape s = at_corners(corners);
      const double d2 = CGAL::squared_distance(projection(s, q), q);
      if (d2 <= squared_bound)
        visit(std::size_t(i), s, d2);
    });
  }

private:
  typedef Coordinates Place;
  static constexpr Index leaf_size = 12;
  static constexpr double tie = 1e-10; // of squared distances: shapes are as near

  struct Corner {
    Place at;
    double reach; // the largest of its shapes, squared
  };
  struct Numbered_corner : Corner {
    Index number;
  };
  // A shape at one of its corners.
  struct Ray {
    Index shape;
    std::array<Index, N - 1> others; // its other corners, in order
  };
  // The corners of a leaf are those from first to last. Else last is 0, and the children are `first` and the next one.
  struct Node {
    Place low, high;
    double reach; // the largest of its corners
    Index first, last;
  };

  // --- building ---

  static Place place(const Point& p) { return {p.x(), p.y(), p.z()}; }

  // Corners have the numbers that they are given by for the time being.
  template <class Place_of> void build(const Place_of& place_of, std::size_t points, int threads) {
    if (shapes_.empty())
      return;
    std::vector<Numbered_corner> order = corners_of_shapes(place_of, points, threads);
    nodes_.resize(1 + descendants(Index(order.size())).first);
    build(0, 1, order, 0, Index(order.size()), threads);
    place_corners(order, points);
    collect_stars();
  }

  /* The square of the radius of the smallest ball round a shape: no point of it is further from all corners; nor is one
   * of a side from both of the side's ends. */
  static double reach_of(const std::array<Place, N>& corner) {
    std::array<double, 3> side = {0, 0, 0}; // squared
    for (std::size_t k = 0; k < (N == 2 ? 1 : 3); ++k)
      side[k] = squared_distance(corner[k], corner[(k + 1) % N]);
    std::sort(side.begin(), side.end());
    const double a = side[2], b = side[1], c = side[0], d = b + c - a;
    const double reach = d > 0 ? (std::min)(a * b * c / (4 * b * c - d * d), a / 3) : a / 4;
    return (1 + 1e-9) * reach;
  }

  // Without points that no shape has.
  template <class Place_of>
  std::vector<Numbered_corner> corners_of_shapes(const Place_of& place_of, std::size_t points, int threads) const {
    std::vector<double> of_shape(shapes_.size());
    for_each_range(shapes_.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t s = first; s < last; ++s) {
        std::array<Place, N> corner;
        for (std::size_t k = 0; k < N; ++k)
          corner[k] = place_of(shapes_[s][k]);
        of_shape[s] = reach_of(corner);
      }
    });
    std::vector<double> reach(points, -1);
    for (std::size_t s = 0; s < shapes_.size(); ++s)
      for (Index c : shapes_[s])
        reach[c] = (std::max)((std::max)(reach[c], 0.), of_shape[s]);
    std::vector<Numbered_corner> result;
    result.reserve(points);
    for (Index c = 0; c < points; ++c)
      if (reach[c] >= 0) {
        result.emplace_back();
        result.back().at = place_of(c);
        result.back().reach = reach[c];
        result.back().number = c;
      }
    return result;
  }

  // Of nodes of n and of n + 1 corners: how many nodes are below them.
  static std::pair<std::size_t, std::size_t> descendants(Index n) {
    if (n < leaf_size)
      return {0, 0};
    const auto [low, high] = descendants(n / 2); // a node is halved
    const bool is_even = n % 2 == 0;
    return {n == leaf_size ? 0 : 2 + low + (is_even ? low : high), 2 + high + (is_even ? low : high)};
  }

  // The node n, and those below it, from `below` on.
  void build(std::size_t n, std::size_t below, std::vector<Numbered_corner>& order, Index first, Index last,
             int threads) {
    Node& node = nodes_[n];
    node.low.fill((std::numeric_limits<double>::infinity)());
    node.high.fill(-(std::numeric_limits<double>::infinity)());
    node.reach = 0;
    for (Index i = first; i < last; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        node.low[k] = (std::min)(node.low[k], order[i].at[k]);
        node.high[k] = (std::max)(node.high[k], order[i].at[k]);
      }
      node.reach = (std::max)(node.reach, order[i].reach);
    }
    node.first = first;
    node.last = last;
    if (last - first <= leaf_size)
      return;
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (node.high[k] - node.low[k] > node.high[axis] - node.low[axis])
        axis = k;
    const Index middle = first + (last - first) / 2;
    std::nth_element(order.begin() + first, order.begin() + middle, order.begin() + last,
                     [axis](const Numbered_corner& a, const Numbered_corner& b) {
                       return a.at[axis] < b.at[axis] || (a.at[axis] == b.at[axis] && a.number < b.number);
                     });
    node.first = Index(below);
    node.last = 0;
    const std::size_t below_second = below + 2 + descendants(middle - first).first;
    const Index worth_a_task = 4096;
    for_each_task(2, last - first > worth_a_task ? threads : 1, [&](std::size_t k) {
      if (k == 0)
        build(below, below + 2, order, first, middle, threads);
      else
        build(below + 1, below_second, order, middle, last, threads);
    });
  }

  // Corners are numbered in the order of the tree from here on.
  void place_corners(const std::vector<Numbered_corner>& order, std::size_t points) {
    std::vector<Index> place_of(points);
    corners_.reserve(order.size());
    for (const Numbered_corner& c : order) {
      place_of[c.number] = Index(corners_.size());
      corners_.push_back(c);
    }
    for (Numbers& of_shape : shapes_)
      for (Index& c : of_shape)
        c = place_of[c];
  }

  void collect_stars() {
    first_ray_.assign(corners_.size() + 1, 0);
    for (const Numbers& of_shape : shapes_)
      for (Index c : of_shape)
        ++first_ray_[c + 1];
    std::partial_sum(first_ray_.begin(), first_ray_.end(), first_ray_.begin());
    std::vector<Index> next(first_ray_.begin(), first_ray_.end());
    rays_.resize(N * shapes_.size());
    for (Index s = 0; s < shapes_.size(); ++s)
      for (std::size_t k = 0; k < N; ++k) {
        Ray& ray = rays_[next[shapes_[s][k]]++];
        ray.shape = s;
        for (std::size_t i = 1; i < N; ++i)
          ray.others[i - 1] = shapes_[s][(k + i) % N];
      }
  }

  // --- searching ---

  static double squared_distance(const Place& a, const Place& q) {
    const double x = a[0] - q[0], y = a[1] - q[1], z = a[2] - q[2];
    return x * x + y * y + z * z;
  }

  // A shape at a corner of a node is no nearer than this, squared; less what rounding may have added.
  static double least(double squared_distance, double reach) { return (1 - 1e-14) * squared_distance - reach; }
  static double least(const Node& n, const Place& q) {
    double d2 = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double below = n.low[k] - q[k], above = q[k] - n.high[k];
      double d = below > above ? below : above;
      d = d > 0 ? d : 0;
      d2 += d * d;
    }
    return least(d2, n.reach);
  }

  // Calls look(number, corners) for all shapes that may be within the bound, which it may lower; the nearer ones first.
  template <class Look> void search(const Place& q, const double& squared_bound, const Look& look) const {
    struct Waiting {
      double least;
      Index node;
    };
    Waiting waiting[64]; // one a level of the tree at most
    int size = 0;
    if (empty())
      return;
    for (Waiting at{least(nodes_.front(), q), 0};; at = waiting[--size]) {
      while (at.least <= squared_bound && nodes_[at.node].last == 0) {
        const Index child = nodes_[at.node].first;
        Waiting far{least(nodes_[child + 1], q), child + 1};
        at = {least(nodes_[child], q), child};
        if (far.least < at.least)
          std::swap(at, far);
        waiting[size++] = far;
      }
      if (at.least <= squared_bound)
        look_at_corners(nodes_[at.node], q, squared_bound, look);
      if (size == 0)
        return;
    }
  }

  template <class Look>
  void look_at_corners(const Node& leaf, const Place& q, const double& squared_bound, const Look& look) const {
    for (Index c = leaf.first; c < leaf.last; ++c) {
      const double d2 = squared_distance(corners_[c].at, q);
      if (!(least(d2, corners_[c].reach) <= squared_bound))
        continue;
      for (Index i = first_ray_[c]; i < first_ray_[c + 1]; ++i)
        if (is_from_nearest(c, d2, rays_[i], q))
          look(rays_[i].shape, from(c, rays_[i]));
    }
  }

  // A shape is looked at from the nearest of its corners only; of those equally near, from that with the lowest number.
  bool is_from_nearest(Index corner, double d2, const Ray& ray, const Place& q) const {
    bool result = true;
    for (Index other : ray.others) {
      const double d = squared_distance(corners_[other].at, q);
      result = result && (d2 < d || (d2 == d && corner <= other));
    }
    return result;
  }

  Numbers from_nearest(Numbers corners, const Place& q) const {
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < N; ++k) {
      const double d = squared_distance(corners_[corners[k]].at, q);
      const double least = squared_distance(corners_[corners[nearest]].at, q);
      if (d < least || (d == least && corners[k] < corners[nearest]))
        nearest = k;
    }
    std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(nearest), corners.end());
    return corners;
  }

  static Numbers from(Index corner, const Ray& ray) {
    Numbers result;
    result[0] = corner;
    std::copy(ray.others.begin(), ray.others.end(), result.begin() + 1);
    return result;
  }

  Point corner(Index c) const { return Point(corners_[c].at[0], corners_[c].at[1], corners_[c].at[2]); }
  Shape at_corners(const Numbers& c) const {
    if constexpr (N == 2)
      return Shape(corner(c[0]), corner(c[1]));
    else
      return Shape(corner(c[0]), corner(c[1]), corner(c[2]));
  }

  // `as_near`: the bound up to where a shape is as near as the best.
  void look_at(Index shape, const Numbers& corners, const Point& q, Result& best, double& as_near) const {
    const Point p = projection(at_corners(corners), q);
    const double d2 = CGAL::squared_distance(p, q);
    const bool is_first = best.index == size();
    if (is_first ? !(d2 < as_near) : !(d2 <= as_near))
      return;
    if (is_first || (1 + tie) * d2 < best.squared_distance)
      best = Result{shape, p, d2};
    else if (shape < best.index)
      best = Result{shape, p, (std::min)(d2, best.squared_distance)};
    else
      best.squared_distance = (std::min)(d2, best.squared_distance);
    as_near = (1 + tie) * best.squared_distance;
  }

  std::vector<Node> nodes_;
  std::vector<Corner> corners_;  // in the order of the tree
  std::vector<Index> first_ray_; // where those of each corner begin in rays_
  std::vector<Ray> rays_;
  std::vector<Numbers> shapes_; // the corners of each
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_CORNER_TREE_H
