// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_WATCHED_SIZE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_WATCHED_SIZE_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/interruption.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL::Tubular_meshing::internal {

/* A size field that knows how often it is asked. Mesh_3 is proved to come to an end on smooth surfaces; where one
 * crosses itself, or has sharp folds inside of a patch, it may put points closer and closer without end. A mesh of sizes
 * h has a number of points near V/h³ + A/h², with the means of h³ and h² over the points, and near that of the surface
 * where h is large: when the field has been asked as often as it takes for many times as many, it throws, which ends
 * Mesh_3. */
class Watched_size {
public:
  // `facet_distance`: see fill_with_mesh_3()
  Watched_size(Length_function size, const Surface& surface, double facet_distance)
      : size_(size)
      , points_of_surface_(double(surface.number_of_vertices())) {
    const Vector_3d origin(surface.number_of_vertices() > 0 ? surface.point(*surface.vertices().begin()) : Point_3());
    for (auto f : surface.faces()) {
      const auto h = surface.halfedge(f);
      const Vector_3d p = Vector_3d(surface.point(surface.source(h))) - origin,
                      q = Vector_3d(surface.point(surface.target(h))) - origin,
                      r = Vector_3d(surface.point(surface.target(surface.next(h)))) - origin;
      volume_ += dot(p, cross(q, r)) / 6;
      area_ += norm(cross(q - p, r - p)) / 2;
    }
    // facets across an edge of the surface are as far from it as they are large
    const double finer = (std::max)(1., usual_distance / facet_distance);
    area_ *= finer * finer;
  }
  Watched_size(const Watched_size&) = delete;
  Watched_size& operator=(const Watched_size&) = delete;

  // Throws a Meshing_error when it has been asked too often. Here Mesh_3 can be stopped as well.
  double operator()(const Point_3& p) const {
    const double h = size_(p);
    if (requests_++ % sample_of == 0)
      sample(h);
    return h;
  }

  // Counts the cuts of the domain; throws as well.
  void note_intersection() const {
    if (double(++intersections_) > most_points * intersections_a_point * expected_points_)
      throw_endless();
  }

private:
  static constexpr std::uint64_t sample_of = 64;
  static constexpr double usual_distance = 0.07;
  static constexpr double requests_a_point = 24;      // 5 to 33 were measured
  static constexpr double intersections_a_point = 60; // 12 to 92
  static constexpr double most_points = 20;           // times what is expected

  void sample(double h) const {
    check_interruption();
    ++samples_;
    square_ += h * h;
    cube_ += h * h * h;
    expected_points_ = samples_ * (std::abs(volume_) / cube_ + area_ / square_) + points_of_surface_;
    if (double(requests_) > most_points * requests_a_point * expected_points_)
      throw_endless();
  }

  [[noreturn]] static void throw_endless() {
    throw Meshing_error("Mesh_3 comes to no end on this surface: it was stopped at many times the points that the mesh "
                        "size asks for. Check that the surface does not intersect itself, and has no sharp folds.");
  }

  Length_function size_;
  double points_of_surface_, volume_ = 0, area_ = 0;
  mutable std::uint64_t requests_ = 0, intersections_ = 0;
  mutable double samples_ = 0, square_ = 0, cube_ = 0;
  mutable double expected_points_ = (std::numeric_limits<double>::max)(); // none yet
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_MESH_3_WATCHED_SIZE_H
