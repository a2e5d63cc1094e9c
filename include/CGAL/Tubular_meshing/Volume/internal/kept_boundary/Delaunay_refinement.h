// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_DELAUNAY_REFINEMENT_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_DELAUNAY_REFINEMENT_H

#include <CGAL/Tubular_meshing/Volume/internal/Speculation.h>
#include <CGAL/Tubular_meshing/Volume/internal/Tetrahedron_store.h>
#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Size_criterion.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/interruption.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_set>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Looks for a point that splits one tetrahedron that is larger than a size allows: its circumcenter or, where the
 * boundary is in the way and coarser than the inside, its middle. The tetrahedra whose circumscribed spheres contain
 * that point, and which are reached from the first without crossing a labelled facet, make room for those between it and
 * the facets of the cavity. Predicates are exact, so that none is inverted. */
class Delaunay_insertion {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  Delaunay_insertion(const Store& store, const Size_criterion& size)
      : store_(store)
      , size_(size) {}

  // Whether t is too large, and a point was found.
  bool find(Index t) {
    seen_.clear();
    const auto excess = size_.excess(t);
    if (!excess)
      return false;
    const double h = excess->size;
    if (!try_at(excess->circumcenter, t, 0, h) && !try_at(excess->middle, t, least_spacing * h, h))
      return false;
    size_at_point_ = size_.size_at(point_);
    store_.match_star(facets_, links_);
    return true;
  }

  // Whether all that the last find() has seen is as it was, by the times at which tetrahedra came or were to go.
  template <class Time> bool is_fresh(const std::vector<Time>& changed, Time since) const {
    return std::all_of(seen_.begin(), seen_.end(), [&](Index t) { return changed[t] <= since; });
  }

  /* Room for what will change, and the change itself, several of which may be made at the same time. False if it has to
   * be made alone. */
  bool reserve(Store& store, Size_criterion& size) {
    if (facets_.size() < cavity_.size())
      return false;
    vertex_ = store.reserve_star(cavity_, facets_.size(), point_, come_);
    size.set_size(vertex_, size_at_point_);
    return true;
  }
  void fill(Store& store) const { store.fill_star(facets_, links_, vertex_, come_); }

  void commit(Store& store, Size_criterion& size) {
    store.replace_by_star(cavity_, facets_, links_, point_, come_);
    size.set_size(store[come_.front()].v[0], size_at_point_);
  }

  // After one of them.
  const std::vector<Index>& gone() const { return cavity_; }
  const Store::Index_list& come() const { return come_; }

private:
  // of a new point from vertices and labelled facets, over the size
  static constexpr double least_spacing = 0.7;
  static constexpr double least_height = 0.5;
  static constexpr std::size_t few = 64; // tetrahedra, up to which looking through a list is the quickest

  static Point_3 to_point(const Vector_3d& p) { return Point_3(p.x, p.y, p.z); }
  Point_3 point(Index v) const { return to_point(store_.point(v)); }

  // A point that is in the circumscribed sphere of t, and no nearer than `spacing` to other vertices.
  bool try_at(const Vector_3d& x, Index t, double spacing, double h) {
    point_ = x;
    const Point_3 p = to_point(x);
    collect_cavity(p, t);
    return make_visible(p, t) && !is_crowded(x, spacing) && !encroaches(x, least_height * h);
  }

  void collect_cavity(const Point_3& p, Index t) {
    cavity_.assign(1, t);
    known_.clear();
    seen_.push_back(t);
    for (std::size_t k = 0; k < cavity_.size(); ++k)
      for (int i = 0; i < 4; ++i) {
        const Index n = beyond(Store::facet(cavity_[k], i));
        if (n == Store::none || is_in_cavity(n))
          continue;
        seen_.push_back(n);
        if (!conflicts(p, n))
          continue;
        cavity_.push_back(n);
        if (cavity_.size() == few + 1)
          known_.insert(cavity_.begin(), cavity_.end());
        else if (cavity_.size() > few)
          known_.insert(n);
      }
  }

  // The tetrahedron behind a facet that may be crossed.
  Index beyond(Index facet) const {
    const Index other = store_.other_side(facet);
    return other == Store::none || store_.label(facet) != 0 ? Store::none : Store::tetrahedron_of(other);
  }
  bool is_in_cavity(Index t) const {
    return cavity_.size() <= few ? std::find(cavity_.begin(), cavity_.end(), t) != cavity_.end() : known_.count(t) > 0;
  }

  bool conflicts(const Point_3& p, Index t) const {
    const auto& v = store_[t].v;
    return Kernel().side_of_oriented_sphere_3_object()(point(v[0]), point(v[1]), point(v[2]), point(v[3]), p) ==
           ON_POSITIVE_SIDE;
  }

  /* Takes tetrahedra out of the cavity until p sees the inside of all of its facets: without the Delaunay property,
   * next to the boundary, it need not. A facet that p does not see from inside stays one whatever else goes, so that the
   * order makes no difference. False if the first one would have to go. */
  bool make_visible(const Point_3& p, Index t) {
    for (;;) {
      facets_.clear();
      hidden_.clear();
      for (Index c : cavity_)
        for (int i = 0; i < 4; ++i) {
          const Index f = Store::facet(c, i), n = beyond(f);
          if (n != Store::none && is_in_cavity(n))
            continue;
          facets_.push_back(f);
          const auto w = store_.vertices(f);
          if (orientation(p, point(w[0]), point(w[1]), point(w[2])) != POSITIVE) {
            hidden_.push_back(c);
            break;
          }
        }
      if (hidden_.empty())
        return true;
      if (std::find(hidden_.begin(), hidden_.end(), t) != hidden_.end())
        return false;
      leave_out_hidden();
    }
  }

  // They are in the cavity's order.
  void leave_out_hidden() {
    auto hidden = hidden_.begin();
    const auto end = std::remove_if(cavity_.begin(), cavity_.end(), [&](Index c) {
      const bool is_hidden = hidden != hidden_.end() && *hidden == c;
      hidden += is_hidden;
      return is_hidden;
    });
    cavity_.erase(end, cavity_.end());
    if (cavity_.size() > few)
      for (Index c : hidden_)
        known_.erase(c);
  }

  bool is_crowded(const Vector_3d& x, double spacing) const {
    for (Index f : facets_)
      for (Index v : store_.vertices(f))
        if (squared_norm(store_.point(v) - x) < spacing * spacing)
          return true;
    return false;
  }

  // Whether x is too near to a labelled facet of the cavity for a good tetrahedron: in the smallest sphere through its
  // vertices and, as the facet may be larger than what is wanted inside, below a height.
  bool encroaches(const Vector_3d& x, double height) const {
    for (Index f : facets_) {
      if (store_.label(f) == 0)
        continue;
      const auto w = store_.vertices(f);
      const Vector_3d& p = store_.point(w[0]);
      const Vector_3d a = store_.point(w[1]) - p, b = store_.point(w[2]) - p, n = cross(a, b);
      const Vector_3d to_center =
          (0.5 / squared_norm(n)) * (squared_norm(a) * cross(b, n) + squared_norm(b) * cross(n, a));
      if (squared_norm(x - p - to_center) < squared_norm(to_center) && std::abs(dot(x - p, n)) < height * norm(n))
        return true;
    }
    return false;
  }

  const Store& store_;
  const Size_criterion& size_;

  // what was found last
  Vector_3d point_;
  double size_at_point_ = 0;
  std::vector<Index> cavity_;
  std::vector<Index> facets_; // each with its tetrahedron inside
  Store::Star_links links_;
  Index vertex_ = 0;                // the new one
  Store::Index_list come_;          // tetrahedra
  std::vector<Index> seen_;         // tetrahedra, some more than once
  std::vector<Index> hidden_;       // tetrahedra that are to go
  std::unordered_set<Index> known_; // those of a cavity of more than a few
};

/* Adds points inside a mesh until no tetrahedron is larger than `size`, a length, allows, but for those that
 * only a point too near to the boundary could split: facets with a label, and all their vertices, stay [Shewchuk 1998].
 * About linear in the number of tetrahedra made. The result does not depend on the number of threads. */
class Delaunay_refinement {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  // `radius_bound`: the largest circumscribed radius, over the size there.
  Delaunay_refinement(Store& store, Length_function size, double radius_bound, int threads)
      : store_(store)
      , threads_(threads)
      , size_(store, size, radius_bound, threads)
      , insertions_(threads, batch, store, size_) {}

  // Returns the number of points added, which is `most` if there was no room for more.
  std::size_t operator()(std::size_t most) {
    std::size_t added = 0;
    std::vector<Index> todo = store_.tetrahedra();
    Lists next;
    changed_.assign(store_.number_of_slots(), now_);
    for (; !todo.empty() && added < most; todo = next.in_order(todo.size())) {
      keep_too_large(todo);
      next.clear();
      const std::vector<Index> order = interleaved(todo.size());
      const auto note = [&](const Delaunay_insertion& i, std::size_t k) {
        check_interruption();
        ++added;
        set_changed(i.gone(), i.come());
        next.push_back(order[k], i.come());
      };
      insertions_.run([&] { return added < most ? todo.size() : 0; }, [&] { return now_; },
                      [&](Delaunay_insertion& i, std::size_t k) { return i.find(todo[order[k]]); },
                      [&](const Delaunay_insertion& i, std::size_t, Time since) { return i.is_fresh(changed_, since); },
                      [&](Delaunay_insertion& i, std::size_t k) {
                        if (added == most || !i.reserve(store_, size_))
                          return false;
                        note(i, k);
                        return true;
                      },
                      [&](const Delaunay_insertion& i, std::size_t) { i.fill(store_); },
                      [&](Delaunay_insertion& i, std::size_t k) {
                        if (added == most)
                          return;
                        i.commit(store_, size_);
                        note(i, k);
                      });
    }
    return added;
  }

private:
  typedef std::uint32_t Time;
  static constexpr std::size_t batch = 128;

  // Lists, each with a number, which come in any order.
  class Lists {
  public:
    void clear() {
      parts_.clear();
      values_.clear();
    }
    void push_back(Index number, const Store::Index_list& list) {
      parts_.push_back({number, values_.size(), list.size()});
      values_.insert(values_.end(), list.begin(), list.end());
    }
    // All of them, one after the other, by their numbers, which are below n and all different.
    std::vector<Index> in_order(std::size_t n) const {
      std::vector<Index> part(n, Store::none), result;
      for (std::size_t p = 0; p < parts_.size(); ++p)
        part[parts_[p].number] = Index(p);
      result.reserve(values_.size());
      for (Index p : part)
        if (p != Store::none) {
          const auto first = values_.begin() + std::ptrdiff_t(parts_[p].first);
          result.insert(result.end(), first, first + std::ptrdiff_t(parts_[p].size));
        }
      return result;
    }

  private:
    struct Part {
      Index number;
      std::size_t first, size;
    };
    std::vector<Part> parts_;
    std::vector<Index> values_;
  };

  // Of thirty tetrahedra that come with a point hardly one is.
  void keep_too_large(std::vector<Index>& list) const {
    std::vector<char> is_small(list.size());
    for_each_range(list.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k)
        is_small[k] = !size_.excess(list[k]);
    });
    std::size_t kept = 0;
    for (std::size_t k = 0; k < list.size(); ++k)
      if (!is_small[k])
        list[kept++] = list[k];
    list.resize(kept);
  }

  /* Neighbors in a list are neighbors in space, and would be in each other's way: those of a batch come from as many
   * parts of the list, and those of the next batch are next to them, where memory is still at hand. */
  static std::vector<Index> interleaved(std::size_t n) {
    const std::size_t length = (n + batch - 1) / batch;
    std::vector<Index> result;
    result.reserve(n);
    for (std::size_t i = 0; i < length; ++i)
      for (std::size_t k = i; k < n; k += length)
        result.push_back(Index(k));
    return result;
  }

  void set_changed(const std::vector<Index>& gone, const Store::Index_list& come) {
    ++now_;
    changed_.resize(store_.number_of_slots(), 0);
    for (Index t : gone)
      changed_[t] = now_;
    for (Index t : come)
      changed_[t] = now_;
  }

  Store& store_;
  int threads_;
  Size_criterion size_;
  Speculation<Delaunay_insertion> insertions_;
  Time now_ = 0;
  std::vector<Time> changed_; // when each tetrahedron came, or was to go
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_DELAUNAY_REFINEMENT_H
