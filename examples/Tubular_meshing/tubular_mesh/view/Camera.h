// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_VIEW_CAMERA_H
#define TUBULAR_MESH_VIEW_CAMERA_H

#include "Clip_plane.h"
#include "Shown_mesh.h"

#include <array>
#include <string>
#include <vector>

/* A parallel projection: the picture's axes, and where the middle and the scale are. */
class Camera {
public:
  typedef Shown_mesh::Vector Vector;

  // Looks from a direction at these points, which fill a picture of this width and height.
  Camera(const std::vector<Vector>& points, const Vector& from, int width, int height);

  // To the right, down, and towards the reader; in pixels.
  Vector project(const Vector& p) const;
  double pixels(double length) const { return scale_ * length; }
  const Vector& from() const { return from_; }
  const Vector& up() const { return up_; }

  // From where most is seen of a mesh: along the axis in which it extends least.
  static Vector best_direction(const Shown_mesh& mesh);

private:
  Vector from_, right_, up_, middle_;
  double scale_ = 1, width_, height_;
};

// Of a whole mesh; of what is seen of it, or of all where that is nothing.
std::vector<Camera::Vector> points_of(const Shown_mesh& mesh);
std::vector<Camera::Vector> points_of(const Shown_mesh& mesh, const Seen_faces& seen);

// Of the box around its points.
Camera::Vector center_of_extent(const Shown_mesh& mesh);

#endif // TUBULAR_MESH_VIEW_CAMERA_H
