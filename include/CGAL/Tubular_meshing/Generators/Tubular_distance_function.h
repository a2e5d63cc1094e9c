// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_DISTANCE_FUNCTION_H
#define CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_DISTANCE_FUNCTION_H

#include <CGAL/Tubular_meshing/Generators/Tubular_skeleton.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingGenerators
 *
 * The implicit function of the tubular surface around a skeleton: negative inside, zero on the surface, and positive
 * outside, in the unit of the skeleton.
 *
 * Along one branch it is d - r: the distance from the nearest point of the branch minus the radius there. Branches are
 * united by a polynomial smooth minimum \cgalCite{quilez2013}, whose blending width is half the smaller
 * radius times 1 - cos(a), where a is the angle between the branches' gradients: creases become fillets, and where
 * branches continue each other smoothly, or only one is near, the function is *exactly* d - r. Ends are half balls.
 *
 * Built in O(n log n) for n skeleton segments; an evaluation is O(log n) and allocates nothing. Thread-safe.
 */
class Tubular_distance_function {
  typedef internal::Vector_3d Vec;

public:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  struct Value {
    double value = 0;
    std::array<double, 3> gradient = {{0, 0, 0}}; ///< about 1 long; zero on the centerline
    double radius = 0;                            ///< local radius, blended as the function is
    std::size_t branch = none;                    ///< the one that is smallest here
    double distance = 0;                          ///< from the nearest point of this branch
    double abscissa = 0;                          ///< of that point, along the branch from its source
    bool blended = false;                         ///< whether another branch has a part in it
  };

  explicit Tubular_distance_function(const Tubular_skeleton& skeleton);

  double operator()(const Point_3& p) const { return evaluate(p).value; }

  Value evaluate(const Point_3& p) const { return evaluate(Vec(p)); }

  /// Not for users.
  Value evaluate(const Vec& p) const;

  /// Whether within `reach` of p there may be a surface of a tube whose radius is less than `radius`.
  bool has_surface_near(const Vec& p, double reach, double radius) const;

  /// Lower and upper corner of a box around the surface.
  std::array<Vec, 2> bounding_box() const;

private:
  static constexpr double blend_width = 0.5; // of the radius

  struct Segment {
    Vec from, along;
    double length, radius, radius_change, abscissa;
    std::size_t branch;
  };
  struct Box_node { // count 0: two children; else `count` segments from `first`
    Vec lower, upper;
    double min_radius, max_radius;
    std::uint32_t first, second, count;
  };
  struct Foot {
    double t, squared_distance, radius;
  };
  struct Hit {
    std::uint32_t segment;
    Foot foot;
  };
  // The nearest point of each branch around; more than a few branches meet nowhere, the least important are dropped.
  struct Hits {
    std::array<Hit, 16> hit;
    std::size_t size = 0;
  };

  std::uint32_t build(std::size_t begin, std::size_t end);

  Box_node bounds(std::size_t begin, std::size_t end) const;

  static double distance_to_box(const Vec& p, const Box_node& n);

  static Foot nearest_on(const Segment& s, const Vec& p);

  // Descends nearer child first; a node is left out if it can neither hold the smallest branch nor blend with it. The
  // margin beyond the blending width makes sure of the true nearest point of a branch of changing radius.
  void find_hits(const Vec& p, Hits& hits) const;

  void add_hit(std::uint32_t segment, const Foot& foot, Hits& hits) const;

  static double value(const Foot& foot) { return std::sqrt(foot.squared_distance) - foot.radius; }

  // Folds the branches' values, smallest first, so that the result is continuous where their order changes.
  Value blend(const Vec& p, Hits& hits) const;

  std::vector<Segment> segments_;
  std::vector<Box_node> nodes_;
};

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Generators/Tubular_distance_function_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_GENERATORS_TUBULAR_DISTANCE_FUNCTION_H
