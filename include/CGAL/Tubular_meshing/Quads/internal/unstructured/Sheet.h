// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_SHEET_H
#define CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_SHEET_H

#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Chart.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A place on a sheet: in the plane, and on the surface. */
struct Sheet_place {
  Eigen::Vector2d uv = Eigen::Vector2d::Zero();
  int triangle = -1; // of the sheet's own
  Vector_3d point, normal;
};

/* A surface that vertices move on. */
class Sheet {
public:
  virtual ~Sheet() = default;
  /* Along the surface as nearly as possible by a vector. False if that leads where there is none. */
  virtual bool move(const Sheet_place& from, const Vector_3d& step, Sheet_place& to) const = 0;
};

/* One over the plane. */
class Sheet_over_plane : public Sheet {
public:
  /* `hint` is a triangle close by, or −1. False outside; the nearest place is found then. */
  virtual bool place(const Eigen::Vector2d& uv, int hint, Sheet_place& result) const = 0;
};

/* A patch as the mesher of quads sees it, with a normal that is continuous. */
class Patch_sheet final : public Sheet_over_plane {
public:
  typedef Patch_parameterization Map;
  typedef Map::Point_2 Point_2;

  explicit Patch_sheet(const Map& map)
      : map_(map)
      , normals_(map.number_of_vertices()) {
    const int rounds = 2;
    const auto& patch = map.patch();
    std::vector<Vector_3d> areas;
    for (const auto& t : patch.triangles) {
      const Vector_3d a(patch.points[std::size_t(t[0])]);
      areas.push_back(
          cross(Vector_3d(patch.points[std::size_t(t[1])]) - a, Vector_3d(patch.points[std::size_t(t[2])]) - a));
    }
    std::vector<Vector_3d> of_triangles = areas;
    for (int round = 0; round < rounds; ++round) {
      std::vector<Vector_3d> sum(normals_.size());
      for (std::size_t t = 0; t < areas.size(); ++t)
        for (int v : patch.triangles[t])
          sum[std::size_t(v)] += of_triangles[t];
      for (std::size_t v = 0; v < sum.size(); ++v)
        normals_[v] = normalized(sum[v]);
      for (std::size_t t = 0; t < areas.size(); ++t) {
        const auto& c = patch.triangles[t];
        of_triangles[t] = norm(areas[t]) / 3 *
                          (normals_[std::size_t(c[0])] + normals_[std::size_t(c[1])] + normals_[std::size_t(c[2])]);
      }
    }
  }

  bool place(const Eigen::Vector2d& uv, int hint, Sheet_place& result) const override {
    const double outside = 1e-24; // of the unit circle
    const Patch_location at = map_.locate(Point_2(uv.x(), uv.y()), hint);
    result = place(at);
    result.uv = uv;
    return at.squared_distance <= outside;
  }
  Sheet_place place(const Patch_location& at) const {
    Sheet_place result;
    const Point_2 uv = map_.uv(at);
    result.uv = Eigen::Vector2d(uv.x(), uv.y());
    result.triangle = at.triangle;
    result.point = Vector_3d(map_.point(at));
    const auto& corners = map_.patch().triangles[std::size_t(at.triangle)];
    for (std::size_t i = 0; i < 3; ++i)
      result.normal += at.barycentric[i] * normals_[std::size_t(corners[i])];
    result.normal = normalized(result.normal);
    return result;
  }

  bool move(const Sheet_place& from, const Vector_3d& step, Sheet_place& to) const override {
    const auto x = map_.derivatives(from.triangle);
    const Eigen::Vector3d d(step.x, step.y, step.z);
    const Eigen::Vector2d by = (x.transpose() * x).inverse() * (x.transpose() * d);
    return std::isfinite(by.squaredNorm()) && place(from.uv + by, from.triangle, to);
  }

private:
  const Map& map_;
  std::vector<Vector_3d> normals_;
};

/* The same for a cap, which is planar. */
class Cap_sheet final : public Sheet_over_plane {
public:
  explicit Cap_sheet(const Cap_chart& chart)
      : origin_(chart.point(Plane_point(0, 0)))
      , first_(Vector_3d(chart.point(Plane_point(1, 0))) - origin_)
      , second_(Vector_3d(chart.point(Plane_point(0, 1))) - origin_) {}

  bool place(const Eigen::Vector2d& uv, int, Sheet_place& result) const override {
    result.uv = uv;
    result.triangle = 0;
    result.point = origin_ + uv.x() * first_ + uv.y() * second_;
    result.normal = cross(first_, second_);
    return true;
  }
  bool move(const Sheet_place& from, const Vector_3d& step, Sheet_place& to) const override {
    return place(from.uv + Eigen::Vector2d(dot(step, first_), dot(step, second_)), 0, to);
  }

private:
  Vector_3d origin_, first_, second_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUADS_INTERNAL_UNSTRUCTURED_SHEET_H
