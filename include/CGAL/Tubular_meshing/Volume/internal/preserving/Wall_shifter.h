// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_WALL_SHIFTER_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_WALL_SHIFTER_H

#include <CGAL/Tubular_meshing/Volume/internal/preserving/Input_surface.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Where the vertices of a surface mesh have to be for its volume to be that of the input, round each of them: see
 * preserve_volume(), of which this is the work. */
class Wall_shifter {
public:
  typedef std::uint32_t Index;

  Wall_shifter(const Surface& mesh, Face_patch_map patch, const Input_surface& input, int threads)
      : input_(input)
      , threads_(threads) {
    points_.reserve(mesh.number_of_vertices());
    for (auto v : mesh.vertices())
      points_.emplace_back(mesh.point(v));
    opening_.assign(points_.size(), 0);
    is_on_wall_.assign(points_.size(), 0);
    for (auto f : mesh.faces())
      if (patch[f] == labels::wall)
        add_facet(mesh, f);
      else
        add_rim_edges(mesh, patch, f);
    around_.resize(facets_.size());
  }

  /* The vertices' new places, by their numbers. */
  std::vector<Vector_3d> run() {
    const Part whole = whole_wall();
    move_rims();
    move_wall(whole, Quadrature::coarse);
    move_rims(); // these see what normals that differ have left of the first, and a coarse quadrature
    move_wall(whole, Quadrature::fine);
    match_areas();
    move_wall(wall_at_rims(), Quadrature::fine);
    return points_;
  }

private:
  static constexpr Index none = Index(-1);

  struct Facet {
    std::array<Index, 4> corner; // the last is none, of a triangle
  };
  struct Rim_edge {
    Index from, to; // the opening on the left, seen from outside
    int opening;
  };

  void add_facet(const Surface& mesh, Surface::Face_index f) {
    Facet facet = {{{none, none, none, none}}};
    std::size_t k = 0;
    for (auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      if (k < 4)
        facet.corner[k++] = Index(v);
    for (std::size_t i = 0; i < k; ++i)
      is_on_wall_[facet.corner[i]] = 1;
    facets_.push_back(facet);
  }

  void add_rim_edges(const Surface& mesh, Face_patch_map patch, Surface::Face_index f) {
    for (auto h : mesh.halfedges_around_face(mesh.halfedge(f))) {
      const auto beyond = mesh.face(mesh.opposite(h));
      if (beyond == Surface::null_face() || patch[beyond] != labels::wall)
        continue;
      edges_.push_back({Index(mesh.source(h)), Index(mesh.target(h)), patch[f]});
      for (Index v : {edges_.back().from, edges_.back().to})
        opening_[v] = opening_[v] == 0 || opening_[v] == patch[f] ? patch[f] : between_openings;
    }
  }
  static constexpr int between_openings = -1; // such a vertex has nowhere to go

  // --- rims ---

  Vector_3d outward(const Rim_edge& e, const Input_surface::Opening& o) const {
    return normalized(cross(points_[e.to] - points_[e.from], o.normal));
  }

  /* What a vertex misses, against how much it would have to move for it. */
  struct Balance {
    double missing = 0, response = 0;
  };

  // Of all rim edges, `visit(edge, opening, outward)`.
  template <class Visit> void for_each_rim_edge(const Visit& visit) const {
    for (const Rim_edge& e : edges_) {
      const Input_surface::Opening* o = input_.opening(e.opening);
      if (o != nullptr)
        visit(e, *o, outward(e, *o));
    }
  }

  std::vector<Vector_3d> rim_directions() const {
    std::vector<Vector_3d> result(points_.size());
    for_each_rim_edge([&](const Rim_edge& e, const Input_surface::Opening&, const Vector_3d& n) {
      const double length = norm(points_[e.to] - points_[e.from]);
      result[e.from] += length * n;
      result[e.to] += length * n;
    });
    for (Vector_3d& n : result)
      n = normalized(n);
    return result;
  }

  bool is_on_one_rim(Index v) const { return opening_[v] > 0; }

  void move_rims() {
    static const std::array<double, 3> at = {0.112701665379258, 0.5, 0.887298334620742};
    static const std::array<double, 3> weight = {5. / 18, 8. / 18, 5. / 18}; // Gauss, exact to the fifth degree
    const std::vector<Vector_3d> direction = rim_directions();
    std::vector<Balance> balance(points_.size());
    for_each_rim_edge([&](const Rim_edge& e, const Input_surface::Opening& o, const Vector_3d& n) {
      const Vector_3d along = points_[e.to] - points_[e.from];
      const double length = norm(along);
      for (std::size_t q = 0; q < at.size(); ++q) {
        const double d = Input_surface::distance_to_rim(o, points_[e.from] + at[q] * along, n, length / 2);
        balance[e.from].missing += weight[q] * length * (1 - at[q]) * d;
        balance[e.to].missing += weight[q] * length * at[q] * d;
      }
      balance[e.from].response += length / 2 * dot(direction[e.from], n);
      balance[e.to].response += length / 2 * dot(direction[e.to], n);
    });
    for (Index v = 0; v < points_.size(); ++v)
      if (is_on_one_rim(v) && balance[v].response > 0)
        points_[v] += balance[v].missing / balance[v].response * direction[v];
  }

  // All of a rim by the same length, for the rest.
  void match_areas() {
    std::map<int, double> area, response;
    const std::vector<Vector_3d> direction = rim_directions();
    std::map<int, Vector_3d> origin;
    for_each_rim_edge([&](const Rim_edge& e, const Input_surface::Opening& o, const Vector_3d& n) {
      const Vector_3d& from = origin.emplace(e.opening, points_[e.from]).first->second;
      area[e.opening] += dot(cross(points_[e.from] - from, points_[e.to] - from), o.normal) / 2;
      const double length = norm(points_[e.to] - points_[e.from]);
      for (Index v : {e.from, e.to})
        if (is_on_one_rim(v))
          response[e.opening] += length / 2 * dot(direction[v], n);
    });
    std::map<int, double> shift;
    for (const auto& a : area) {
      const double missing = input_.opening(a.first)->area - a.second;
      // a percent is more than curves leave; a rim that has another shape is not to be moved by this
      if (response[a.first] > 0 && std::abs(missing) < 0.01 * a.second)
        shift[a.first] = missing / response[a.first];
    }
    for (Index v = 0; v < points_.size(); ++v)
      if (is_on_one_rim(v) && shift.count(opening_[v]) != 0)
        points_[v] += shift[opening_[v]] * direction[v];
  }

  // --- the wall ---

  bool moves_with_wall(Index v) const { return is_on_wall_[v] && opening_[v] == 0; }

  /* Vertices that are moved, and all facets that have to do with them. */
  struct Part {
    std::vector<char> moves; // of each vertex
    std::vector<Index> facets;
  };

  Part whole_wall() const {
    Part result{std::vector<char>(points_.size(), 0), std::vector<Index>(facets_.size())};
    for (Index v = 0; v < points_.size(); ++v)
      result.moves[v] = moves_with_wall(v);
    std::iota(result.facets.begin(), result.facets.end(), Index(0));
    return result;
  }

  // The vertices that share facets with those of rims.
  Part wall_at_rims() const {
    Part result{std::vector<char>(points_.size(), 0), {}};
    const auto has = [](const Facet& f, const auto& condition) {
      return std::any_of(f.corner.begin(), f.corner.end(), [&](Index v) { return v != none && condition(v); });
    };
    const auto is_at_rim = [&](const Facet& f) { return has(f, [&](Index v) { return !moves_with_wall(v); }); };
    for (const Facet& f : facets_)
      if (is_at_rim(f))
        for (Index v : f.corner)
          if (v != none && moves_with_wall(v))
            result.moves[v] = 1;
    for (Index i = 0; i < facets_.size(); ++i)
      if (is_at_rim(facets_[i]) || has(facets_[i], [&](Index v) { return result.moves[v] != 0; }))
        result.facets.push_back(i);
    return result;
  }

  /* Calls visit(corners, points) for the triangles of a facet; of a quad, the four around its middle, for which the
   * last number is none. */
  template <class Visit> void for_each_triangle(const Facet& f, const Visit& visit) const {
    const auto& c = f.corner;
    if (c[3] == none)
      return visit(std::array<Index, 3>{{c[0], c[1], c[2]}},
                   std::array<Vector_3d, 3>{{points_[c[0]], points_[c[1]], points_[c[2]]}});
    const Vector_3d middle = 0.25 * (points_[c[0]] + points_[c[1]] + points_[c[2]] + points_[c[3]]);
    for (std::size_t k = 0; k < 4; ++k)
      visit(std::array<Index, 3>{{c[k], c[(k + 1) % 4], none}},
            std::array<Vector_3d, 3>{{points_[c[k]], points_[c[(k + 1) % 4]], middle}});
  }

  std::vector<Vector_3d> wall_normals() const {
    std::vector<Vector_3d> result(points_.size());
    for (const Facet& f : facets_)
      for_each_triangle(f, [&](const std::array<Index, 3>& corner, const std::array<Vector_3d, 3>& p) {
        const Vector_3d n = cross(p[1] - p[0], p[2] - p[0]);
        for (Index v : corner)
          if (v != none)
            result[v] += n;
      });
    for (Vector_3d& n : result)
      n = normalized(n);
    return result;
  }

  /* Of one facet: what is missing at each of its corners, and how much comes for moving it. */
  typedef std::array<Balance, 4> Facet_balance;

  // Points of a triangle by their barycentric coordinates, and their weights.
  enum class Quadrature { coarse, fine };
  struct Rule {
    const std::array<double, 4>* points;
    std::size_t number;
  };
  static Rule rule(Quadrature quadrature, bool is_quad) {
    // six points, exact to the fourth degree (D. A. Dunavant, 1985)
    static const double a = 0.445948490915965, wa = 0.223381589678011, b = 0.091576213509771, wb = 0.109951743655322;
    static const std::array<double, 4> six[6] = {{1 - 2 * a, a, a, wa}, {a, 1 - 2 * a, a, wa}, {a, a, 1 - 2 * a, wa},
                                                 {1 - 2 * b, b, b, wb}, {b, 1 - 2 * b, b, wb}, {b, b, 1 - 2 * b, wb}};
    // three, exact to the second degree
    static const std::array<double, 4> three[3] = {
        {2. / 3, 1. / 6, 1. / 6, 1. / 3}, {1. / 6, 2. / 3, 1. / 6, 1. / 3}, {1. / 6, 1. / 6, 2. / 3, 1. / 3}};
    return quadrature == Quadrature::coarse || is_quad ? Rule{three, 3} : Rule{six, 6}; // a quad has four triangles
  }

  // `wall`: at the facet.
  Facet_balance balance_of(const Facet& f, const std::vector<Vector_3d>& normal, const Input_surface::Wall_nearby& wall,
                           Quadrature quadrature) const {
    const Rule points = rule(quadrature, f.corner[3] != none);
    Facet_balance result;
    const auto add = [&](Index v, double missing, double area, const Vector_3d& n) {
      for (std::size_t k = 0; k < 4; ++k)
        if (f.corner[k] != none && (v == none || f.corner[k] == v)) { // a quad's middle is a quarter of each corner's
          const double part = v == none ? 0.25 : 1;
          result[k].missing += part * missing;
          result[k].response += part * area * dot(normal[f.corner[k]], n);
        }
    };
    for_each_triangle(f, [&](const std::array<Index, 3>& corner, const std::array<Vector_3d, 3>& p) {
      const Vector_3d doubled = cross(p[1] - p[0], p[2] - p[0]), n = normalized(doubled);
      const double area = norm(doubled) / 2;
      const double bound = bound_of(p);
      std::array<double, 3> missing = {0, 0, 0};
      for (std::size_t i = 0; i < points.number; ++i) {
        const std::array<double, 4>& q = points.points[i];
        const double d = wall.distance(q[0] * p[0] + q[1] * p[1] + q[2] * p[2], n, bound, input_);
        for (std::size_t k = 0; k < 3; ++k)
          missing[k] += q[3] * area * q[k] * d;
      }
      for (std::size_t k = 0; k < 3; ++k)
        add(corner[k], missing[k], area / 3, n);
    });
    return result;
  }

  // How far the wall is looked for.
  static double bound_of(const std::array<Vector_3d, 3>& triangle) {
    return std::sqrt((std::max)(squared_norm(triangle[1] - triangle[0]), squared_norm(triangle[2] - triangle[0]))) / 2;
  }

  // The ball that a facet is in but for its corners: the points that count are not there.
  Input_surface::Surroundings surroundings(const Facet& f) const {
    const double part = f.corner[3] == none ? 0.73 : 0.84; // of the way from the middle to a corner
    Input_surface::Surroundings result = {Vector_3d(), 0, 0};
    double corners = 0;
    for (Index v : f.corner)
      if (v != none) {
        result.center += points_[v];
        ++corners;
      }
    result.center = (1 / corners) * result.center;
    for (Index v : f.corner)
      if (v != none)
        result.radius = (std::max)(result.radius, part * norm(points_[v] - result.center));
    for_each_triangle(f, [&](const std::array<Index, 3>&, const std::array<Vector_3d, 3>& p) {
      result.bound = (std::max)(result.bound, bound_of(p));
    });
    return result;
  }

  void move_wall(const Part& part, Quadrature quadrature) {
    const std::vector<Vector_3d> normal = wall_normals();
    std::vector<Facet_balance> of_facet(part.facets.size());
    for_each_range(part.facets.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const Index f = part.facets[i];
        around_[f].move_to(surroundings(facets_[f]), input_);
        of_facet[i] = balance_of(facets_[f], normal, around_[f], quadrature);
      }
    });
    std::vector<Balance> balance(points_.size());
    for (std::size_t i = 0; i < part.facets.size(); ++i) {
      const Facet& f = facets_[part.facets[i]];
      for (std::size_t k = 0; k < 4 && f.corner[k] != none; ++k) {
        balance[f.corner[k]].missing += of_facet[i][k].missing;
        balance[f.corner[k]].response += of_facet[i][k].response;
      }
    }
    hand_on_from_rims(balance);
    for (Index v = 0; v < points_.size(); ++v)
      if (part.moves[v] && balance[v].response > 0)
        points_[v] += balance[v].missing / balance[v].response * normal[v];
  }

  // What facets miss at a vertex of a rim, which has its place already, is shared by their other corners.
  void hand_on_from_rims(std::vector<Balance>& balance) const {
    std::vector<std::pair<Index, Index>> pairs; // of a rim's vertex and one that takes over
    for (const Facet& f : facets_)
      for (Index r : f.corner)
        for (Index v : f.corner)
          if (r != none && v != none && !moves_with_wall(r) && moves_with_wall(v))
            pairs.emplace_back(r, v);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    for (std::size_t i = 0, j = 0; i < pairs.size(); i = j) {
      while (j < pairs.size() && pairs[j].first == pairs[i].first)
        ++j;
      for (std::size_t k = i; k < j; ++k)
        balance[pairs[k].second].missing += balance[pairs[i].first].missing / double(j - i);
    }
  }

  const Input_surface& input_;
  int threads_;
  std::vector<Vector_3d> points_;
  std::vector<int> opening_; // of each vertex: the label of the opening that it is on the rim of, or 0
  std::vector<char> is_on_wall_;
  std::vector<Facet> facets_;                      // of the wall
  std::vector<Input_surface::Wall_nearby> around_; // of each facet
  std::vector<Rim_edge> edges_;                    // where it meets openings
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PRESERVING_WALL_SHIFTER_H
