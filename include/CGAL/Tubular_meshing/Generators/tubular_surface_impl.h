// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SURFACE_IMPL_H
#define CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SURFACE_IMPL_H

#include <CGAL/Tubular_meshing/Generators/Tubular_distance_function.h>
#include <CGAL/Tubular_meshing/Generators/Tubular_skeleton.h>
#include <CGAL/Tubular_meshing/Generators/internal/Tubular_octree.h>
#include <CGAL/Tubular_meshing/Generators/internal/Tubular_remesher.h>
#include <CGAL/Tubular_meshing/Generators/internal/march_tetrahedra.h>
#include <CGAL/Tubular_meshing/Generators/internal/tubular_caps.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Rims/trim_by_plane.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Makes the surface around a skeleton, and changes it as asked for. */
class Tubular_surface_generator {
public:
  typedef Tubular_skeleton::End End;

  explicit Tubular_surface_generator(const Tubular_skeleton& skeleton)
      : function_(skeleton)
      , ends_(skeleton.ends()) {
    for (const auto& b : skeleton.branches)
      half_length_.push_back(half_length(b));
    ends_of_branch_.resize(skeleton.branches.size());
    for (std::size_t i = 0; i < ends_.size(); ++i)
      ends_of_branch_[ends_[i].branch].push_back(i);
  }

  Surface& mesh() { return mesh_; }

  void make_surface(double points_per_circumference, bool round_ends) {
    // Cells smaller than the radius leave no tube and no gap between tubes unseen; the remeshing does the rest.
    Tetrahedra_marcher(function_, Tubular_octree(function_, 0.9), mesh_);
    Tubular_remesher remesher(function_, ends_, points_per_circumference, mesh_);
    remesher.clean_up_slivers();
    mesh_.collect_garbage();
    if (!round_ends)
      trim_ends(remesher);
    for (int pass = 0; pass < 6; ++pass) {
      mesh_.collect_garbage();
      remesher.pass();
    }
    mesh_.collect_garbage();
    find_rims();
  }

  // Along the normal; rims stay in their planes.
  void add_noise(double amplitude, unsigned seed) {
    std::mt19937 random(seed);
    for (Vertex v : mesh_.vertices()) {
      const double in_0_1 = random() / 4294967296.; // the same on all platforms, unlike std's distributions
      const auto value = function_.evaluate(mesh_.point(v));
      Vector_3d n(value.gradient[0], value.gradient[1], value.gradient[2]);
      if (mesh_.is_border(v)) {
        const Vector_3d axis(ends_[nearest_end(value.branch, Vector_3d(mesh_.point(v)))].normal);
        n = n - dot(n, axis) * axis;
      }
      move(v, amplitude * value.radius * (2 * in_0_1 - 1) * normalized(n));
    }
  }

  void cap_ends() {
    for (std::size_t i = 0; i < ends_.size(); ++i)
      Cap_filler(ends_[i], mesh_).fill(rims_[i]);
  }

  // Rim, and cap, move along the axis, and the wall with them, ever less, over two radii.
  void sag_ends(double amplitude, Sag_shape shape) {
    for (Vertex v : mesh_.vertices()) {
      const Vector_3d p(mesh_.point(v));
      const auto value = function_.evaluate(p);
      if (ends_of_branch_[value.branch].empty())
        continue;
      const End& end = ends_[nearest_end(value.branch, p)];
      const End_frame frame(end);
      const double range = (std::min)(2 * end.radius, half_length_[end.branch]);
      const double t = 1 + frame.height(p) / range, rho = frame.distance_from_axis(p) / end.radius;
      if (!(t > 0) || rho > 2)
        continue;
      const double weight = t >= 1 ? 1 : t * t * (3 - 2 * t), a = frame.angle(p);
      const double wave = shape == Sag_shape::saddle ? rho * rho * std::cos(2 * a) : rho * std::cos(a);
      move(v, amplitude * end.radius * weight * wave * frame.normal);
    }
  }

private:
  static double half_length(const Tubular_skeleton::Branch& b) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < b.points.size(); ++i)
      length += norm(Vector_3d(b.points[i + 1]) - Vector_3d(b.points[i]));
    return length / 2;
  }

  void move(Vertex v, const Vector_3d& d) { mesh_.point(v) = as<Point_3>(Vector_3d(mesh_.point(v)) + d); }

  std::size_t nearest_end(std::size_t branch, const Vector_3d& p) const {
    const std::vector<std::size_t>& ends = ends_of_branch_[branch];
    return *std::min_element(ends.begin(), ends.end(), [&](std::size_t a, std::size_t b) {
      return squared_norm(Vector_3d(ends_[a].center) - p) < squared_norm(Vector_3d(ends_[b].center) - p);
    });
  }

  // The ends are half balls until now: their tips are where the trimming starts.
  void trim_ends(Tubular_remesher& remesher) {
    const std::vector<Vertex> tips = find_tips();
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const End& end = ends_[i];
      const std::vector<Vertex> seeds(tips[i] == Surface::null_vertex() ? 0 : 1, tips[i]);
      const Halfedge rim = trim_by_plane(mesh_, end.center, end.normal, seeds, 3 * end.radius);
      if (rim == Surface::null_halfedge())
        throw Meshing_error("the end of the tube at node " + std::to_string(end.node) + ", branch " +
                            std::to_string(end.branch) +
                            " of the skeleton, cannot be opened: another branch is too near, or its own is too short; "
                            "move it, or make it longer than its radius.");
      remesher.attach_border(rim, i);
    }
  }

  std::vector<Vertex> find_tips() const {
    std::vector<Vertex> tips(ends_.size(), Surface::null_vertex());
    std::vector<double> highest(ends_.size(), 0.5);
    for (Vertex v : mesh_.vertices()) {
      const std::size_t branch = function_.evaluate(mesh_.point(v)).branch;
      for (std::size_t i : ends_of_branch_[branch]) {
        const Vector_3d d = Vector_3d(mesh_.point(v)) - Vector_3d(ends_[i].center);
        const double height = dot(d, Vector_3d(ends_[i].normal)) / ends_[i].radius;
        if (height > highest[i] && norm(d) < 1.3 * ends_[i].radius) {
          highest[i] = height;
          tips[i] = v;
        }
      }
    }
    return tips;
  }

  void find_rims() {
    rims_.assign(ends_.size(), Surface::null_halfedge());
    for (Halfedge h : mesh_.halfedges())
      if (mesh_.is_border(h)) {
        const Point_3& p = mesh_.point(mesh_.target(h));
        rims_[nearest_end(function_.evaluate(p).branch, Vector_3d(p))] = h;
      }
  }

  Tubular_distance_function function_;
  std::vector<End> ends_;
  std::vector<std::vector<std::size_t>> ends_of_branch_;
  std::vector<double> half_length_; // of the branches
  std::vector<Halfedge> rims_;
  Surface mesh_;
};

inline void check_range(double value, double from, double to, const std::string& what) {
  if (!(value >= from && value <= to))
    throw Parameter_error(what + " must be between " + std::to_string(from) + " and " + std::to_string(to) + ", not " +
                          std::to_string(value) + ".");
}

CGAL_TUBULAR_MESHING_INLINE Surface generate_tubular_surface(const Tubular_skeleton& skeleton,
                                                             const Generate_tubular_surface_options& options) {
  check_range(options.points_per_circumference, 8, 1000, "the number of points round the circumference");
  check_range(options.noise, 0, 1, "the noise, a fraction of the radius,");
  check_range(options.sag, 0, 0.5, "the sag, a fraction of the radius,");

  Tubular_surface_generator generator(skeleton);
  generator.make_surface(options.points_per_circumference, options.round_ends);
  if (options.noise > 0)
    generator.add_noise(options.noise, options.noise_seed);
  if (options.capped_ends && !options.round_ends)
    generator.cap_ends();
  if (options.sag > 0 && !options.round_ends)
    generator.sag_ends(options.sag, options.sag_shape);
  Surface surface; // without what the generator has removed
  copy_face_graph(generator.mesh(), surface);
  return surface;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_SURFACE_IMPL_H
