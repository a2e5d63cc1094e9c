// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_CASE_PATCHES_H
#define TUBULAR_MESH_CASE_PATCHES_H

#include "Run.h"

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <array>
#include <string>
#include <vector>

/* An inlet: how the velocity falls off to its rim. */
class Inlet_profile {
public:
  typedef CGAL::Tubular_meshing::Point_3 Point_3;
  typedef CGAL::Tubular_meshing::internal::Vector_3d Vector;

  /* Of the facets of a patch. Throws a Meshing_error if they have no rim round their center. */
  Inlet_profile(const CGAL::Tubular_meshing::Mixed_mesh& mesh, int patch);
  /* The same for quadratic elements, whose rim is curved. */
  Inlet_profile(const CGAL::Tubular_meshing::Quadratic_mesh& mesh, int patch);

  /* 1 - (r / R)², R being the distance from the center to the rim in the direction of p; 0 at the rim. */
  double operator()(const Point_3& p) const;

  const Vector& center() const { return center_; }
  const Vector& inward() const { return inward_; } // into the lumen, of unit length
  const std::array<Vector, 2>& axes() const { return axes_; }
  double area() const { return area_; }

  /* R for angles from axis 0 to axis 1, evenly spaced over the whole circle. */
  const std::vector<double>& rim() const { return rim_; }

private:
  static constexpr int angles = 256;

  Inlet_profile(const CGAL::Tubular_meshing::Mixed_mesh& mesh, const CGAL::Tubular_meshing::Quadratic_mesh* nodes,
                int patch);
  void find_rim(const std::vector<std::array<Vector, 2>>& edges);

  Vector center_, inward_;
  std::array<Vector, 2> axes_;
  double area_ = 0;
  std::vector<double> rim_;
};

/* The patches of a mesh of a lumen, as a solver sees them. */
struct Case_patch {
  enum Kind { wall, inlet, outlet };
  int label;
  std::string name; // in the solver's files
  Kind kind;
  double pressure = 0; // at an outlet, Pa
};

/* In the order of their labels, with the names that they have in the format of the options. Throws a Parameter_error if a
 * pressure is given at an outlet that is not there. */
std::vector<Case_patch> case_patches(const Run& run, const CGAL::Tubular_meshing::Mixed_mesh& mesh);

#endif // TUBULAR_MESH_CASE_PATCHES_H
