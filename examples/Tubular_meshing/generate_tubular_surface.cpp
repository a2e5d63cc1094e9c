// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Makes a test surface of a known shape, and its centerlines:
//   generate_tubular_surface arch -o arch.stl --centerlines arch_centerlines.vtk

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/Generators/bronchial_tree.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/write_centerlines.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>

#include <CLI/CLI.hpp>

#include <cstddef>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Surface;
namespace tubular = CGAL::Tubular_meshing;
typedef tubular::Tubular_skeleton Skeleton;

namespace {

struct Options {
  std::string shape, surface, centerlines, sag_shape = "saddle";
  std::size_t branches = 31;
  double points = 24, noise = 0, sag = 0;
  unsigned seed = 0;
  bool capped = false;
};

Skeleton skeleton_of(const Options& o) {
  if (o.shape == "tube")
    return tubular::straight_tube();
  if (o.shape == "curved")
    return tubular::curved_tube();
  if (o.shape == "y")
    return tubular::y_bifurcation();
  if (o.shape == "arch")
    return tubular::aortic_arch();
  if (o.shape == "willis")
    return tubular::willis_loop();
  return tubular::bronchial_tree(o.branches);
}

void generate(const Options& o) {
  const Skeleton skeleton = skeleton_of(o);
  Surface surface;
  tubular::generate_tubular_surface(
      skeleton, surface,
      tubular::parameters::points_per_circumference(o.points)
          .capped_ends(o.capped)
          .noise(o.noise)
          .noise_seed(o.seed)
          .sag(o.sag)
          .sag_shape(o.sag_shape == "tilt" ? tubular::Sag_shape::tilt : tubular::Sag_shape::saddle));

  // Both files get their names when both are whole.
  std::optional<tubular::IO::Output_file> centerlines_file;
  tubular::IO::Output_file surface_file(o.surface);
  tubular::IO::write_surface(surface_file, surface);
  if (!o.centerlines.empty()) {
    centerlines_file.emplace(o.centerlines);
    tubular::IO::write_centerlines(*centerlines_file, tubular::centerlines_of(skeleton));
    centerlines_file->commit();
  }
  surface_file.commit();
  std::printf("%s: %zu branches, %zu openings, %zu loops, %zu triangles\n", o.shape.c_str(),
              skeleton.number_of_branches(), skeleton.number_of_openings(), skeleton.number_of_loops(),
              std::size_t(surface.number_of_faces()));
}

} // namespace

int main(int argc, char** argv) {
  Options o;
  CLI::App app("Makes a test surface of a known shape, and its centerlines.");
  app.add_option("shape", o.shape, "tube, curved, y, arch, willis or tree")
      ->required()
      ->check(CLI::IsMember({"tube", "curved", "y", "arch", "willis", "tree"}));
  app.add_option("-o,--output", o.surface, "the surface: .stl, .off, .obj, .ply, .vtp, .vtk or .msh")->required();
  app.add_option("--centerlines", o.centerlines, "the centerlines with their radii: .vtk or .vtp");
  app.add_option("--branches", o.branches, "the tree's number of branches, odd")->capture_default_str();
  app.add_option("--resolution", o.points, "points round a circumference")->capture_default_str();
  auto* capped = app.add_flag("--capped", o.capped, "close the ends by flat caps");
  app.add_flag_callback(
         "--open", [&] { o.capped = false; }, "leave the ends open (the default)")
      ->excludes(capped);
  app.add_option("--noise", o.noise, "random roughness of the wall, as a fraction of the radius")
      ->capture_default_str();
  app.add_option("--seed", o.seed, "of the noise")->capture_default_str();
  app.add_option("--sag", o.sag, "how far rims leave their planes, as a fraction of the radius")->capture_default_str();
  app.add_option("--sag-shape", o.sag_shape, "saddle or tilt")
      ->capture_default_str()
      ->check(CLI::IsMember({"saddle", "tilt"}));
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  try {
    generate(o);
  } catch (const tubular::Parameter_error& e) {
    std::fprintf(stderr, "generate_tubular_surface: %s\n", e.what());
    return 2;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "generate_tubular_surface: %s\n", e.what());
    return 4;
  }
}
