// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_PIECE_MESHER_IMPL_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_PIECE_MESHER_IMPL_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Patches/pieces/crossing_faces.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Piece_mesher.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* See mesh_by_pieces(). */
class Surface_remesher {
public:
  explicit Surface_remesher(Piece_mesher& mesher)
      : mesher_(mesher) {}

  Remeshed_surface run() {
    const int most_rounds = 6, rounds_for_shape = 2, rounds_before_smoothing = 2;
    mesher_.mesh_all();
    for (int round = 0;; ++round) {
      std::vector<size_type> failed = pieces_that_do_not_fit();
      crossings_.clear();
      if (failed.empty()) {
        build();
        const std::vector<size_type> folded = mesher_.improve(result_, piece_of_face_);
        failed = crossing_pieces();
        if (!failed.empty() && round >= rounds_before_smoothing && mesher_.may_smooth() && smooth_crossings())
          failed.clear();
        if (failed.empty() && round < rounds_for_shape) // quads that are turned over, but meet nothing, may stay
          failed = folded;
      }
      if (failed.empty())
        break;
      if (round == most_rounds)
        throw Meshing_error("The new faces of " + mesher_.name_of(failed.front()) +
                            " meet each other or their neighbours" + place_of_failure() +
                            ", however fine they are: the surface may intersect itself there; see repair_surface().");
      mesher_.mesh_finer(failed);
    }
    result_.report = mesher_.report();
    result_.report.smoothed_places = smoothed_places_;
    return std::move(result_);
  }

private:
  std::vector<size_type> pieces_that_do_not_fit() const {
    std::vector<char> failed;
    for (const auto& piece : mesher_.pieces())
      failed.push_back(piece.empty());
    mark_pieces_that_share_an_edge(failed);
    return marked(failed);
  }

  // A point on a curve, by the curve's number and its own on it.
  typedef std::pair<size_type, size_type> Curve_point_number;
  // An edge inside of a piece, between two points on curves.
  struct Chord {
    Curve_point_number a, b; // a < b
    size_type piece;
    bool operator<(const Chord& c) const { return std::tie(a, b, piece) < std::tie(c.a, c.b, c.piece); }
    bool joins_the_same(const Chord& c) const { return a == c.a && b == c.b; }
  };

  // Two pieces on the same curves may both have an edge between two of their points that are no neighbours on a curve;
  // a piece on both sides of a curve, between a point and itself or its neighbour on the other side.
  void mark_pieces_that_share_an_edge(std::vector<char>& failed) const {
    std::vector<Chord> chords;
    for (size_type k = 0; k < mesher_.pieces().size(); ++k)
      if (!collect_chords(k, chords))
        failed[k] = 1;
    std::sort(chords.begin(), chords.end());
    for (size_type i = 1; i < chords.size(); ++i)
      if (chords[i].joins_the_same(chords[i - 1]))
        failed[chords[i].piece] = failed[chords[i - 1].piece] = 1;
  }

  // False if an edge between two sides of the piece is none, or one of a curve.
  bool collect_chords(size_type k, std::vector<Chord>& chords) const {
    const auto& piece = mesher_.pieces()[k];
    bool fits = true;
    std::vector<Curve_point_number> numbers;
    std::vector<size_type> sides;
    for (size_type s = 0; s < piece.sides.size(); ++s) {
      const auto& side = piece.sides[s];
      const size_type n = mesher_.curve_points()[side.curve].size();
      for (size_type i = 0; i < n; ++i)
        numbers.emplace_back(side.curve, side.forward ? i : n - 1 - i);
      sides.resize(numbers.size(), s);
    }
    const auto collect = [&](const auto& face) {
      for (size_type e = 0; e < face.size(); ++e) {
        const size_type a = face[e], b = face[(e + 1) % face.size()];
        if (a >= b || b >= numbers.size()) // once, of the two sides of an edge
          continue;
        const bool is_on_curve = numbers[a] == numbers[b] || are_neighbours(numbers[a], numbers[b]);
        if (!is_on_curve)
          chords.push_back({(std::min)(numbers[a], numbers[b]), (std::max)(numbers[a], numbers[b]), k});
        else if (sides[a] != sides[b])
          fits = false;
      }
    };
    std::for_each(piece.triangles.begin(), piece.triangles.end(), collect);
    std::for_each(piece.quads.begin(), piece.quads.end(), collect);
    return fits;
  }

  bool are_neighbours(const Curve_point_number& a, const Curve_point_number& b) const {
    const size_type n = mesher_.curve_points()[a.first].size();
    const size_type apart = (std::max)(a.second, b.second) - (std::min)(a.second, b.second);
    return a.first == b.first && (apart == 1 || apart == n - 1);
  }

  void build() {
    Surface& surface = result_.surface;
    size_type points = 0, faces = 0;
    for (const auto& curve : mesher_.curve_points())
      points += curve.size();
    for (const auto& piece : mesher_.pieces()) {
      points += piece.inner_points.size();
      faces += piece.triangles.size() + piece.quads.size();
    }
    surface.clear_without_removing_property_maps();
    surface.reserve(Surface::size_type(points), Surface::size_type(points + faces), Surface::size_type(faces));
    result_.curves.assign(mesher_.curve_points().size(), {});
    for (size_type c = 0; c < result_.curves.size(); ++c)
      for (const auto& p : mesher_.curve_points()[c])
        result_.curves[c].push_back(surface.add_vertex(p.point));
    piece_of_face_.clear();
    for (size_type k = 0; k < mesher_.pieces().size(); ++k)
      add_piece(k);
  }

  void add_piece(size_type k) {
    const auto& piece = mesher_.pieces()[k];
    std::vector<Vertex> vertices;
    for (const auto& side : piece.sides) {
      const std::vector<Vertex>& curve = result_.curves[side.curve];
      side.forward ? vertices.insert(vertices.end(), curve.begin(), curve.end())
                   : vertices.insert(vertices.end(), curve.rbegin(), curve.rend());
    }
    for (const Point_3& p : piece.inner_points)
      vertices.push_back(result_.surface.add_vertex(p));
    for (const auto& t : piece.triangles)
      register_face(k, result_.surface.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]));
    for (const auto& q : piece.quads)
      register_face(k, result_.surface.add_face(vertices[q[0]], vertices[q[1]], vertices[q[2]], vertices[q[3]]));
  }

  void register_face(size_type k, Face f) {
    if (f == Surface::null_face())
      throw Meshing_error("The faces of " + mesher_.name_of(k) + " do not fit together with their neighbours.");
    const int opening = mesher_.opening(k);
    result_.patch[f] = opening == 0 ? labels::wall : opening;
    result_.patch_of_face[f] = opening == 0 ? int(k) : -1;
    piece_of_face_.push_back(k);
  }

  std::vector<size_type> crossing_pieces() {
    std::vector<char> failed(mesher_.pieces().size(), 0);
    crossings_ = crossing_faces(result_.surface);
    std::sort(crossings_.begin(), crossings_.end()); // the same order on any number of threads
    for (const auto& c : crossings_)
      failed[piece_of_face_[size_type(c.first)]] = failed[piece_of_face_[size_type(c.second)]] = 1;
    return marked(failed);
  }

  /* Where a surface is rougher than the mesh size, as a decimated one is, a few of the many new faces cross each other
   * at any size. Those few are smoothed, with ever more faces around, but for rims and caps. Whether none is left. */
  bool smooth_crossings() {
    const int most_rounds = 4, sweeps = 10;
    Surface& surface = result_.surface;
    std::vector<char> moved(surface.number_of_vertices(), 0);
    for (int rings = 1; rings <= most_rounds && !crossings_.empty(); ++rings) {
      const std::vector<Vertex> around = vertices_around_crossings(rings);
      for (Vertex v : around)
        moved[size_type(v)] = 1;
      for (int i = 0; i < sweeps; ++i)
        for (Vertex v : around)
          surface.point(v) = mean_of_neighbours(v);
      crossing_pieces();
    }
    smoothed_places_ = number_of_connected(moved);
    return crossings_.empty();
  }

  std::vector<Vertex> vertices_around_crossings(int rings) const {
    const Surface& surface = result_.surface;
    std::vector<Vertex> all;
    std::vector<char> is_in(surface.number_of_vertices(), 0);
    const auto add = [&](Vertex v) {
      if (!is_in[size_type(v)]++)
        all.push_back(v);
    };
    for (const auto& c : crossings_)
      for (Face f : {c.first, c.second})
        for (Vertex v : surface.vertices_around_face(surface.halfedge(f)))
          add(v);
    for (int i = 0; i < rings; ++i)
      for (size_type j = 0, n = all.size(); j < n; ++j)
        for (Vertex w : surface.vertices_around_target(surface.halfedge(all[j])))
          add(w);
    const auto is_on_cap = [&](Vertex v) {
      for (Face f : surface.faces_around_target(surface.halfedge(v)))
        if (result_.patch_of_face[f] < 0)
          return true;
      return false;
    };
    all.erase(std::remove_if(all.begin(), all.end(), is_on_cap), all.end());
    std::sort(all.begin(), all.end());
    return all;
  }

  Point_3 mean_of_neighbours(Vertex v) const {
    const Surface& surface = result_.surface;
    Vector_3 sum(0, 0, 0);
    double n = 0;
    for (Vertex w : surface.vertices_around_target(surface.halfedge(v))) {
      sum = sum + (surface.point(w) - CGAL::ORIGIN);
      ++n;
    }
    return CGAL::ORIGIN + sum / n;
  }

  // The number of sets that marked vertices make.
  size_type number_of_connected(std::vector<char>& marked) const {
    size_type number = 0;
    for (size_type i = 0; i < marked.size(); ++i) {
      if (!marked[i])
        continue;
      ++number;
      marked[i] = 0;
      std::vector<Vertex> front = {Vertex(Surface::size_type(i))};
      while (!front.empty()) {
        const Vertex v = front.back();
        front.pop_back();
        for (Vertex w : result_.surface.vertices_around_target(result_.surface.halfedge(v)))
          if (marked[size_type(w)]) {
            marked[size_type(w)] = 0;
            front.push_back(w);
          }
      }
    }
    return number;
  }

  // Nothing, if the pieces that failed do not even fit together.
  Sentence place_of_failure() const {
    if (crossings_.empty())
      return "";
    const Surface& surface = result_.surface;
    return " near " + place_of(surface.point(surface.target(surface.halfedge(crossings_.front().first))));
  }

  Piece_mesher& mesher_;
  Remeshed_surface result_;
  std::vector<size_type> piece_of_face_;
  Face_pairs crossings_; // of the surface as it is, in order
  size_type smoothed_places_ = 0;
};

CGAL_TUBULAR_MESHING_INLINE Remeshed_surface mesh_by_pieces(Piece_mesher& mesher) {
  return Surface_remesher(mesher).run();
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_PIECE_MESHER_IMPL_H
