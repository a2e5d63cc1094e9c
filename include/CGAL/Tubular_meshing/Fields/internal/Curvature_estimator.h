// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_CURVATURE_ESTIMATOR_H
#define CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_CURVATURE_ESTIMATOR_H

#include <CGAL/Tubular_meshing/Fields/internal/Indexed_wall.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The second fundamental form in a tangent plane: uu, uv, vv for the plane's axes u and v. */
struct Shape_tensor {
  double uu = 0, uv = 0, vv = 0;
};
struct Tangent_frame {
  Vector_3d u, v, n;
};

inline Vector_3d any_perpendicular_to(const Vector_3d& n) {
  const Vector_3d a = std::abs(n.x) < 0.6 ? Vector_3d(1, 0, 0) : Vector_3d(0, 1, 0);
  return normalized(cross(n, a));
}
inline Tangent_frame frame_of_normal(const Vector_3d& n) {
  const Vector_3d u = any_perpendicular_to(n);
  return {u, cross(n, u), n};
}

/* The tensor in another tangent plane: the two are laid on each other by the smallest rotation. */
inline Shape_tensor transported(const Shape_tensor& k, const Tangent_frame& from, const Tangent_frame& to) {
  const double c = 1 + dot(from.n, to.n);
  // for normals that are nearly opposite there is no smallest rotation; such a neighbour is none
  const double s = c > 1e-6 ? 1 / c : 0;
  const Vector_3d sum = from.n + to.n;
  const Vector_3d u = from.u - (s * dot(from.u, to.n)) * sum, v = from.v - (s * dot(from.v, to.n)) * sum;
  const double uu = dot(u, to.u), uv = dot(u, to.v), vu = dot(v, to.u), vv = dot(v, to.v);
  return {k.uu * uu * uu + 2 * k.uv * uu * vu + k.vv * vu * vu,
          k.uu * uu * uv + k.uv * (uu * vv + uv * vu) + k.vv * vu * vv,
          k.uu * uv * uv + 2 * k.uv * uv * vv + k.vv * vv * vv};
}

/* Curvature tensors of a triangulated surface by Rusinkiewicz's method \cgalCite{rusinkiewicz2004}: in each face the
 * tensor that explains best how the vertices' normals differ along its edges; in each vertex the mean over its faces.
 * Then, against noise, the mean over a neighbourhood: what noise adds to the tensors cancels out in it, for they are
 * differences of one and the same normals. Positive where the surface is convex, seen from outside. */
class Curvature_estimator {
public:
  typedef Indexed_wall::Index Index;

  /* `radius[v]`: the radius of the neighbourhood of vertex v; an empty vector for no smoothing. */
  Curvature_estimator(const Indexed_wall& wall, const std::vector<double>& radius, int threads)
      : wall_(wall)
      , threads_(threads) {
    make_frames();
    collect_faces();
    smooth(radius.empty() ? std::vector<double>(wall.number_of_vertices(), 0.) : radius);
  }

  const std::vector<Tangent_frame>& frames() const { return frames_; }
  const std::vector<Shape_tensor>& tensors() const { return tensors_; }

private:
  // Normals by Max's weights, which are exact on spheres.
  void make_frames() {
    std::vector<Vector_3d> normals(wall_.number_of_vertices());
    for (const auto& t : wall_.triangles()) {
      const Vector_3d n = wall_.doubled_area(t);
      for (int i = 0; i < 3; ++i) {
        const Vector_3d a = wall_.point(t[(i + 1) % 3]) - wall_.point(t[i]);
        const Vector_3d b = wall_.point(t[(i + 2) % 3]) - wall_.point(t[i]);
        normals[t[i]] += (1 / (squared_norm(a) * squared_norm(b))) * n;
      }
    }
    frames_.reserve(normals.size());
    for (const Vector_3d& n : normals)
      frames_.push_back(frame_of_normal(squared_norm(n) > 0 ? normalized(n) : Vector_3d(0, 0, 1)));
  }

  // Least squares over the three edges: tensor · edge = difference of the normals, in the plane of the face.
  Shape_tensor tensor_of_face(const std::array<Index, 3>& t, const Tangent_frame& f) const {
    double s11 = 0, s12 = 0, s22 = 0, r1 = 0, r2 = 0, r3 = 0;
    for (int i = 0; i < 3; ++i) {
      const Index a = t[(i + 1) % 3], b = t[(i + 2) % 3];
      const Vector_3d e = wall_.point(b) - wall_.point(a), d = frames_[b].n - frames_[a].n;
      const double eu = dot(e, f.u), ev = dot(e, f.v), du = dot(d, f.u), dv = dot(d, f.v);
      s11 += eu * eu;
      s12 += eu * ev;
      s22 += ev * ev;
      r1 += du * eu;
      r2 += du * ev + dv * eu;
      r3 += dv * ev;
    }
    const double slivers = 1e-6 * (s11 + s22); // keeps the tensors of slivers, which weigh little, finite
    s11 += slivers;
    s22 += slivers;
    // the matrix is (s11 s12 0; s12 s11+s22 s12; 0 s12 s22)
    const double m = s11 + s22, det = s11 * s22 * m - s12 * s12 * m;
    return {(r1 * (m * s22 - s12 * s12) - r2 * s12 * s22 + r3 * s12 * s12) / det,
            (-r1 * s12 * s22 + r2 * s11 * s22 - r3 * s11 * s12) / det,
            (r1 * s12 * s12 - r2 * s11 * s12 + r3 * (s11 * m - s12 * s12)) / det};
  }

  // A face's share in the Voronoi region of each of its corners (Meyer et al.).
  std::array<double, 3> corner_areas(const std::array<Index, 3>& t) const {
    const double area = norm(wall_.doubled_area(t)) / 2;
    std::array<double, 3> l2, weight, result;
    for (int i = 0; i < 3; ++i)
      l2[i] = squared_norm(wall_.point(t[(i + 2) % 3]) - wall_.point(t[(i + 1) % 3]));
    for (int i = 0; i < 3; ++i)
      weight[i] = l2[i] * (l2[(i + 1) % 3] + l2[(i + 2) % 3] - l2[i]); // of the circumcenter
    for (int i = 0; i < 3; ++i)
      if (weight[i] <= 0) { // obtuse at i
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        result[j] = result[k] = area / 4;
        result[i] = area / 2;
        return result;
      }
    const double scale = area / (2 * (weight[0] + weight[1] + weight[2]));
    for (int i = 0; i < 3; ++i)
      result[i] = scale * (weight[(i + 1) % 3] + weight[(i + 2) % 3]);
    return result;
  }

  void collect_faces() {
    tensors_.assign(wall_.number_of_vertices(), Shape_tensor());
    confidence_.assign(wall_.number_of_vertices(), 0);
    for (const auto& t : wall_.triangles()) {
      const Tangent_frame f = frame_of_normal(normalized(wall_.doubled_area(t)));
      const Shape_tensor k = tensor_of_face(t, f);
      // a normal on the rim leans outward, being that of one side only: such faces count where there is nothing else
      const bool at_rim = wall_.is_on_rim(t[0]) || wall_.is_on_rim(t[1]) || wall_.is_on_rim(t[2]);
      const std::array<double, 3> area = corner_areas(t);
      for (int i = 0; i < 3; ++i) {
        const double w = (at_rim ? 1e-6 : 1) * area[i];
        add(tensors_[t[i]], w, transported(k, f, frames_[t[i]]));
        confidence_[t[i]] += w;
      }
    }
    for (std::size_t v = 0; v < tensors_.size(); ++v)
      if (confidence_[v] > 0)
        tensors_[v] = scaled(1 / confidence_[v], tensors_[v]);
  }

  // On the rim the neighbours' tensors are the better ones: the neighbourhood reaches them at least.
  void smooth(const std::vector<double>& radius) {
    std::vector<Shape_tensor> result(tensors_.size());
    for_each_range(tensors_.size(), threads_, [&](std::size_t first, std::size_t last) {
      Wall_neighborhood near(wall_);
      for (std::size_t v = first; v < last; ++v) {
        double total = 0;
        const double r = wall_.is_on_rim(Index(v)) ? (std::max)(radius[v], reach(Index(v))) : radius[v];
        near.for_each(Index(v), r, [&](Index w, double weight) {
          weight *= confidence_[w];
          add(result[v], weight, transported(tensors_[w], frames_[w], frames_[v]));
          total += weight;
        });
        result[v] = total > 0 ? scaled(1 / total, result[v]) : tensors_[v];
      }
    });
    tensors_.swap(result);
  }

  double reach(Index v) const {
    double longest2 = 0;
    for (const Index *n = wall_.neighbors_begin(v), *end = wall_.neighbors_end(v); n != end; ++n)
      longest2 = (std::max)(longest2, squared_norm(wall_.point(*n) - wall_.point(v)));
    return 1.5 * std::sqrt(longest2);
  }

  static void add(Shape_tensor& sum, double w, const Shape_tensor& k) {
    sum.uu += w * k.uu;
    sum.uv += w * k.uv;
    sum.vv += w * k.vv;
  }
  static Shape_tensor scaled(double s, const Shape_tensor& k) { return {s * k.uu, s * k.uv, s * k.vv}; }

  const Indexed_wall& wall_;
  int threads_;
  std::vector<Tangent_frame> frames_;
  std::vector<Shape_tensor> tensors_;
  std::vector<double> confidence_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_FIELDS_INTERNAL_CURVATURE_ESTIMATOR_H
