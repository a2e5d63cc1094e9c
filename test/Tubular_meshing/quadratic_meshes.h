// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_TEST_QUADRATIC_MESHES_H
#define TUBULAR_MESHING_TEST_QUADRATIC_MESHES_H

// Quadratic elements by the textbooks' shape functions, which the package does not use; vessels of known volume.

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Fields/Local_radius.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher.h>
#include <CGAL/Tubular_meshing/Quadratic/Quadratic_mesh.h>
#include <CGAL/Tubular_meshing/Quadratic/make_quadratic_mesh.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace quadratic_meshes {

namespace tubular = CGAL::Tubular_meshing;
using tubular::Element_type;
using tubular::Mixed_mesh;
using tubular::Point_3;
using tubular::Quadratic_mesh;
typedef tubular::internal::Vector_3d Vector;

/* Where a point of the reference element is, by the nodes in the order of Quadratic_mesh. Coordinates of tetrahedra and
 * prisms are from 0 to 1, of hexahedra from -1 to 1, of pyramids those of a base from -1 to 1 and of a height of 1. */
class Textbook_element {
public:
  Textbook_element(Element_type type, bool complete, std::vector<Vector> nodes)
      : type_(type)
      , complete_(complete)
      , p_(std::move(nodes)) {}

  Vector operator()(double x, double y, double z) const {
    std::vector<double> n;
    switch (type_) {
    case Element_type::tetrahedron:
      n = tetrahedron(x, y, z);
      break;
    case Element_type::pyramid:
      n = pyramid(x, y, z);
      break;
    case Element_type::prism:
      n = complete_ ? prism_18(x, y, z) : prism_15(x, y, z);
      break;
    default:
      n = complete_ ? hexahedron_27(x, y, z) : hexahedron_20(x, y, z);
    }
    Vector sum;
    for (std::size_t i = 0; i < n.size(); ++i)
      sum += n[i] * p_[i];
    return sum;
  }

  // The derivatives along the axes, by differences of fourth order.
  std::array<Vector, 3> frame(double x, double y, double z) const {
    const double h = 1e-3;
    const auto slope = [&](double dx, double dy, double dz) {
      const auto at = [&](double s) { return (*this)(x + s * h * dx, y + s * h * dy, z + s * h * dz); };
      return (1 / (12 * h)) * (8. * (at(1) - at(-1)) - (at(2) - at(-2)));
    };
    return {slope(1, 0, 0), slope(0, 1, 0), slope(0, 0, 1)};
  }

  double determinant(double x, double y, double z) const {
    const auto f = frame(x, y, z);
    return dot(cross(f[0], f[1]), f[2]);
  }

  // By a product of Gauss' rules, of collapsed coordinates where the element is no cube.
  double volume() const {
    // exact to the fifth degree in each coordinate, which is that of all determinants with what collapsing adds
    static const std::array<double, 3> at = {0.112701665379258, 0.5, 0.887298334620742};
    static const std::array<double, 3> weight = {5. / 18, 8. / 18, 5. / 18};
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k) {
          const double u = at[i], v = at[j], w = at[k], all = weight[i] * weight[j] * weight[k];
          switch (type_) {
          case Element_type::tetrahedron:
            sum += all * (1 - w) * (1 - w) * (1 - v) * determinant(u * (1 - v) * (1 - w), v * (1 - w), w);
            break;
          case Element_type::pyramid:
            sum += 4 * all * (1 - w) * (1 - w) * determinant((2 * u - 1) * (1 - w), (2 * v - 1) * (1 - w), w);
            break;
          case Element_type::prism:
            sum += all * (1 - v) * determinant(u * (1 - v), v, w);
            break;
          default:
            sum += 8 * all * determinant(2 * u - 1, 2 * v - 1, 2 * w - 1);
          }
        }
    return sum;
  }

private:
  static std::vector<double> tetrahedron(double x, double y, double z) {
    const double t = 1 - x - y - z;
    return {t * (2 * t - 1), x * (2 * x - 1), y * (2 * y - 1), z * (2 * z - 1), 4 * t * x,
            4 * x * y,       4 * y * t,       4 * z * t,       4 * z * x,       4 * z * y};
  }

  // Of 13 nodes, by Bedrosian; a fourteenth in the middle of the base takes from the others what they have there.
  std::vector<double> pyramid(double x, double y, double z) const {
    const double d = 1 - z, q = x * y * z / d;
    std::vector<double> n = {(-x - y - 1) * ((1 - x) * (1 - y) - z + q) / 4,
                             (x - y - 1) * ((1 + x) * (1 - y) - z - q) / 4,
                             (x + y - 1) * ((1 + x) * (1 + y) - z + q) / 4,
                             (-x + y - 1) * ((1 - x) * (1 + y) - z - q) / 4,
                             z * (2 * z - 1),
                             (1 + x - z) * (1 - x - z) * (1 - y - z) / (2 * d),
                             (1 + y - z) * (1 - y - z) * (1 + x - z) / (2 * d),
                             (1 + x - z) * (1 - x - z) * (1 + y - z) / (2 * d),
                             (1 + y - z) * (1 - y - z) * (1 - x - z) / (2 * d),
                             z * (1 - x - z) * (1 - y - z) / d,
                             z * (1 + x - z) * (1 - y - z) / d,
                             z * (1 + x - z) * (1 + y - z) / d,
                             z * (1 - x - z) * (1 + y - z) / d};
    if (complete_) {
      const double bubble = (1 + x - z) * (1 - x - z) * (1 + y - z) * (1 - y - z) / (d * d);
      for (std::size_t k = 0; k < 4; ++k) {
        n[k] += bubble / 4;
        n[5 + k] -= bubble / 2;
      }
      n.push_back(bubble);
    }
    return n;
  }

  static std::vector<double> prism_15(double x, double y, double z) {
    const double l[3] = {1 - x - y, x, y}, t = 2 * z - 1;
    std::vector<double> n;
    for (double s : {-1., 1.})
      for (double a : l)
        n.push_back(a * ((2 * a - 1) * (1 + s * t) - (1 - t * t)) / 2);
    for (double s : {-1., 1.})
      for (std::size_t k = 0; k < 3; ++k)
        n.push_back(2 * l[k] * l[(k + 1) % 3] * (1 + s * t));
    for (double a : l)
      n.push_back(a * (1 - t * t));
    return n;
  }

  static std::vector<double> prism_18(double x, double y, double z) {
    const double l[3] = {1 - x - y, x, y}, line[3] = {(2 * z - 1) * (z - 1), z * (2 * z - 1), 4 * z * (1 - z)};
    std::vector<double> n;
    for (std::size_t s = 0; s < 2; ++s)
      for (double a : l)
        n.push_back(a * (2 * a - 1) * line[s]);
    for (std::size_t s = 0; s < 2; ++s)
      for (std::size_t k = 0; k < 3; ++k)
        n.push_back(4 * l[k] * l[(k + 1) % 3] * line[s]);
    for (double a : l)
      n.push_back(a * (2 * a - 1) * line[2]);
    for (std::size_t k = 0; k < 3; ++k)
      n.push_back(4 * l[k] * l[(k + 1) % 3] * line[2]);
    return n;
  }

  static std::vector<std::array<double, 3>> places_in_cube() {
    const std::array<std::array<double, 3>, 8> c = {{{{-1, -1, -1}},
                                                     {{1, -1, -1}},
                                                     {{1, 1, -1}},
                                                     {{-1, 1, -1}},
                                                     {{-1, -1, 1}},
                                                     {{1, -1, 1}},
                                                     {{1, 1, 1}},
                                                     {{-1, 1, 1}}}};
    std::vector<std::array<double, 3>> result(c.begin(), c.end());
    const std::vector<std::array<double, 3>> others = {{0, -1, -1}, {1, 0, -1}, {0, 1, -1}, {-1, 0, -1}, {0, -1, 1},
                                                       {1, 0, 1},   {0, 1, 1},  {-1, 0, 1}, {-1, -1, 0}, {1, -1, 0},
                                                       {1, 1, 0},   {-1, 1, 0}, {0, 0, -1}, {0, 0, 1},   {0, -1, 0},
                                                       {1, 0, 0},   {0, 1, 0},  {-1, 0, 0}, {0, 0, 0}};
    result.insert(result.end(), others.begin(), others.end());
    return result;
  }

  static std::vector<double> hexahedron_20(double x, double y, double z) {
    const auto places = places_in_cube();
    std::vector<double> n;
    for (std::size_t i = 0; i < 8; ++i) {
      const double a = places[i][0] * x, b = places[i][1] * y, c = places[i][2] * z;
      n.push_back((1 + a) * (1 + b) * (1 + c) * (a + b + c - 2) / 8);
    }
    for (std::size_t i = 8; i < 20; ++i) {
      const double at[3] = {x, y, z};
      double value = 0.25;
      for (std::size_t k = 0; k < 3; ++k)
        value *= places[i][k] == 0 ? 1 - at[k] * at[k] : 1 + places[i][k] * at[k];
      n.push_back(value);
    }
    return n;
  }

  static std::vector<double> hexahedron_27(double x, double y, double z) {
    std::vector<double> n;
    const double at[3] = {x, y, z};
    for (const auto& place : places_in_cube()) {
      double value = 1;
      for (std::size_t k = 0; k < 3; ++k)
        value *= place[k] == 0 ? 1 - at[k] * at[k] : at[k] * (at[k] + place[k]) / 2;
      n.push_back(value);
    }
    return n;
  }

  Element_type type_;
  bool complete_;
  std::vector<Vector> p_;
};

inline Textbook_element element(const Quadratic_mesh& mesh, Element_type type, const std::uint32_t* corners,
                                std::size_t number) {
  std::vector<Vector> points;
  for (std::uint32_t n : mesh.nodes(type, corners, number))
    points.push_back(Vector(mesh.node(n)));
  return Textbook_element(type, mesh.is_complete, points);
}

// The volume of each region, cell by cell.
inline std::map<int, double> volumes(const Quadratic_mesh& mesh) {
  std::map<int, double> result;
  tubular::internal::for_each_block_of_cells(mesh.linear, [&](Element_type type, const auto& block) {
    for (std::size_t i = 0; i < block.size(); ++i)
      result[block.label[i]] += element(mesh, type, block.vertices[i].data(), i).volume();
  });
  return result;
}

/* A vessel, of which a mesh is made, and one of quadratic elements from it. */
struct Vessel {
  tubular::Tubular_model model;
  double volume;                // of the smooth vessel
  std::vector<double> openings; // the radii
};

template <class NamedParameters>
Mixed_mesh linear_mesh(const Vessel& vessel, const std::string& type, const NamedParameters& np) {
  tubular::Mesher mesher(vessel.model, np);
  return type == "isotropic"     ? mesher.isotropic()
         : type == "anisotropic" ? mesher.anisotropic()
         : type == "mixed"       ? mesher.mixed()
                                 : mesher.hexahedral();
}

inline tubular::Local_radius local_radius(const Vessel& vessel) {
  return tubular::Local_radius(tubular::Centerline_field(vessel.model.centerlines),
                               tubular::Wall_distance(vessel.model.surface, vessel.model.patch, tubular::labels::wall));
}

inline tubular::Quadratic_report curve(const Vessel& vessel, const Mixed_mesh& linear, bool complete,
                                       Quadratic_mesh& mesh, int threads = 0) {
  return tubular::make_quadratic_mesh(linear, vessel.model.surface, vessel.model.patch, local_radius(vessel), mesh,
                                      tubular::parameters::complete_elements(complete).number_of_threads(threads));
}

inline Vessel vessel_around(const tubular::Tubular_skeleton& skeleton, double volume, double points = 24) {
  tubular::Surface surface;
  tubular::generate_tubular_surface(skeleton, surface, tubular::parameters::points_per_circumference(points));
  Vessel v;
  v.model = tubular::make_tubular_model(surface, tubular::centerlines_of(skeleton));
  v.volume = volume;
  v.openings = {1, 1};
  return v;
}
inline Vessel tube(double points = 24) {
  return vessel_around(tubular::straight_tube(6, 1), 6 * CGAL_PI, points);
}
inline Vessel bend(double points = 24) {
  return vessel_around(tubular::curved_tube(4, CGAL_PI / 2, 1), 4 * CGAL_PI / 2 * CGAL_PI, points);
}

} // namespace quadratic_meshes

#endif // TUBULAR_MESHING_TEST_QUADRATIC_MESHES_H
