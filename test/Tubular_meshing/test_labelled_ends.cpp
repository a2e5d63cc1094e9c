// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Ends of vessels by the labels of faces, and by creases: which are found, what they are called, how they are closed.

#include "labelled_surfaces.h"

#include <CGAL/Tubular_meshing/Openings/close_openings.h>
#include <CGAL/Tubular_meshing/Openings/internal/label_roles.h>
#include <CGAL/Tubular_meshing/Openings/labelled_ends.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Repair/carry_labels.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/Rims/crease_ends.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace {

using namespace CGAL::Tubular_meshing;
using namespace test_surfaces;
namespace params = CGAL::Tubular_meshing::parameters;
namespace PMP = CGAL::Polygon_mesh_processing;

// --- names ---

TEST(Label_roles, Names_say_what_is_what) {
  using internal::Label_role;
  using internal::role_of_name;
  for (const char* name : {"wall", "Wall", "vessel_wall", "WALL_AORTA", "aortaWall", "lumen", "lumen2", "vessels"})
    EXPECT_EQ(role_of_name(name), Label_role::wall) << name;
  for (const char* name : {"inlet", "inlet_aorta", "aorta-inlet", "vesselInlet", "INLET2", "inflow", "lumen inlet 3"})
    EXPECT_EQ(role_of_name(name), Label_role::inlet) << name;
  for (const char* name : {"outlet", "outlet_left", "Outlet2", "outflow", "cap_3", "caps", "vessel_cap", "openings"})
    EXPECT_EQ(role_of_name(name), Label_role::opening) << name;
  for (const char* name : {"", "aorta", "face_3", "ascii", "capillary", "3", "left_renal", "Cube.001"})
    EXPECT_EQ(role_of_name(name), Label_role::unknown) << name;
}

TEST(Labels, Names_do_not_clash) {
  EXPECT_EQ(unused_name("a", {}), "a");
  EXPECT_EQ(unused_name("a", {"a", "a_2"}), "a_3");
  Label_names names = {{1, "outer_wall"}, {2, "aorta"}, {3, "outlet_1"}, {4, "inlet"}};
  add_wall_patch_names(names, false);
  EXPECT_EQ(names.at(100), "outer_wall_2");
  EXPECT_EQ(names.at(102), "aorta_ring");
  EXPECT_EQ(names.at(103), "outlet_ring_1");
  EXPECT_EQ(names.at(104), "inlet_ring");
}

// --- ends ---

// Each end is one of the labels' and has its name; the cap is plane, and as large as the rim.
void expect_ends(const Tubular_model& model, const std::vector<Point>& centers, const std::vector<std::string>& names) {
  ASSERT_EQ(model.openings.size(), centers.size());
  EXPECT_TRUE(CGAL::is_closed(model.surface));
  std::set<std::string> seen;
  for (const Opening& o : model.openings) {
    std::size_t nearest = 0;
    for (std::size_t i = 1; i < centers.size(); ++i)
      if (CGAL::squared_distance(centers[i], o.center) < CGAL::squared_distance(centers[nearest], o.center))
        nearest = i;
    EXPECT_LT(CGAL::squared_distance(centers[nearest], o.center), 0.04 * o.radius * o.radius);
    EXPECT_EQ(o.name, names[nearest]);
    EXPECT_EQ(model.patch_names.at(o.patch), names[nearest]);
    seen.insert(o.name);
    for (auto f : model.surface.faces())
      if (model.patch[f] == o.patch) {
        for (auto v : model.surface.vertices_around_face(model.surface.halfedge(f)))
          EXPECT_LT(std::abs((model.surface.point(v) - o.center) * o.normal), 1e-6 * o.radius);
      }
  }
  EXPECT_EQ(seen.size(), centers.size());
}

TEST(Labelled_ends, Domes_of_any_height_in_any_place_and_unit) {
  const Mesh open = open_bifurcation();
  for (const auto& heights : dome_heights())
    for (const Transformation& t : placements()) {
      Labelled_mesh m = with_domes(transformed(open, t), heights, 1, 2);
      const Tubular_model model = make_tubular_model(m.mesh, params::face_label_map(labels_of(m)));
      expect_ends(model, m.centers, {"face_2", "face_3", "face_4"});
      EXPECT_EQ(model.patch_names.at(labels::wall), "wall");
      ASSERT_EQ(model.labels.labels.size(), 4u);
      for (const Understood_label& l : model.labels.labels) {
        EXPECT_TRUE(l.is_understood()) << l.label << " " << l.reason;
        EXPECT_EQ(l.count, l.label == 1 ? 0u : 1u);
      }
      EXPECT_EQ(model.patch_ids.id.at(labels::wall), 1);
      for (const Opening& o : model.openings)
        EXPECT_EQ("face_" + std::to_string(model.patch_ids.id.at(o.patch)), o.name);
    }
}

TEST(Labelled_ends, Whatever_the_numbers_are_the_largest_is_the_wall) {
  const Mesh open = open_bifurcation();
  for (int wall : {-1, 0, 7, 100}) {
    Labelled_mesh m = with_domes(open, {0.5}, wall, 3);
    const Tubular_model model = make_tubular_model(m.mesh, params::face_label_map(labels_of(m)));
    expect_ends(model, m.centers, {"face_3", "face_4", "face_5"});
    EXPECT_EQ(model.labels.wall, wall);
  }
}

TEST(Labelled_ends, Names_go_through_and_say_which_is_the_inlet) {
  const Label_names names = {{1, "vessel_wall"}, {2, "outlet_big"}, {3, "inlet_small"}, {4, "outlet \"x\""}};
  Labelled_mesh m = with_domes(open_bifurcation(), {0.8, 0, 0.3}, 1, 2);
  const auto np = params::face_label_map(labels_of(m)).label_names(names);
  const Tubular_model model = make_tubular_model(m.mesh, np);
  expect_ends(model, m.centers, {"outlet_big", "inlet_small", "outlet _x_"});
  EXPECT_EQ(model.openings[0].name, "inlet_small");
  EXPECT_EQ(model.patch_names.at(labels::wall), "vessel_wall");

  EXPECT_EQ(make_tubular_model(m.mesh, np.inlet_name("outlet_big")).openings[0].name, "outlet_big");
  EXPECT_EQ(make_tubular_model(m.mesh, np.inlet_name("4")).openings[0].name, "outlet _x_");
  EXPECT_EQ(make_tubular_model(m.mesh, np.inlet(m.centers[0])).openings[0].name, "outlet_big");
  EXPECT_THROW(make_tubular_model(m.mesh, np.inlet_name("aorta")), Parameter_error);
}

TEST(Labelled_ends, Meshes_have_the_names) {
  const Label_names names = {{1, "vessel_wall"}, {2, "inlet_aorta"}, {3, "left"}, {4, "right"}};
  Labelled_mesh m = with_domes(open_bifurcation(12), {0.8}, 1, 2);
  const auto np = params::face_label_map(labels_of(m)).label_names(names).points_per_circumference(8);
  Mesher mesher(m.mesh, np);
  for (const Mixed_mesh& mesh : {mesher.isotropic(), mesher.anisotropic()}) {
    std::set<std::string> found;
    for (const auto& n : mesh.patch_names)
      found.insert(n.second);
    EXPECT_EQ(found, (std::set<std::string>{"vessel_wall", "inlet_aorta", "left", "right"}));
    EXPECT_EQ(mesh.patch_names.at(labels::inlet), "inlet_aorta");
  }
}

TEST(Labelled_ends, One_label_may_have_several_ends) {
  Labelled_mesh m = with_domes(open_bifurcation(), {0.5}, 0, 1);
  for (int& l : m.label)
    l = l == 0 ? 0 : 1;
  const Tubular_model model =
      make_tubular_model(m.mesh, params::face_label_map(labels_of(m)).label_names(Label_names{{1, "ends"}}));
  ASSERT_EQ(model.openings.size(), 3u);
  std::set<std::string> found;
  for (const Opening& o : model.openings)
    found.insert(o.name);
  EXPECT_EQ(found, (std::set<std::string>{"ends_1", "ends_2", "ends_3"}));
}

TEST(Labelled_ends, One_label_for_all_is_none) {
  Labelled_mesh m = with_domes(open_bifurcation(), {0}, 1, 2);
  std::fill(m.label.begin(), m.label.end(), 5);
  const Tubular_model model = make_tubular_model(m.mesh, params::face_label_map(labels_of(m)));
  EXPECT_TRUE(model.labels.empty());
  EXPECT_TRUE(model.patch_names.empty());
  EXPECT_EQ(model.openings.size(), 3u); // which are flat
}

// A disk in the wall, by the distance from a point of it.
void label_disk(Labelled_mesh& m, const Point& center, double radius, int label) {
  std::size_t i = 0;
  for (auto f : m.mesh.faces()) {
    if (CGAL::squared_distance(m.mesh.point(m.mesh.target(m.mesh.halfedge(f))), center) < radius * radius &&
        m.label[i] == 1)
      m.label[i] = label;
    ++i;
  }
}

const Understood_label& label_in(const Tubular_model& model, int label) {
  return *std::find_if(model.labels.labels.begin(), model.labels.labels.end(),
                       [&](const Understood_label& l) { return l.label == label; });
}

TEST(Labelled_ends, A_disk_of_the_wall_is_an_end_only_if_it_is_called_so) {
  Tube tube;
  tube.sides = 40;
  tube.rings = 80;
  tube.rx = tube.ry = 1;
  Labelled_mesh m = with_domes(make_tube(tube), {0.5}, 1, 2);
  label_disk(m, Point(1, 0, 4), 0.5, 9);
  const auto label = labels_of(m);
  const Tubular_model model = make_tubular_model(m.mesh, params::face_label_map(label));
  EXPECT_EQ(model.openings.size(), 2u);
  EXPECT_FALSE(label_in(model, 9).is_understood());
  EXPECT_EQ(label_in(model, 9).count, 0u);
  const Tubular_model called =
      make_tubular_model(m.mesh, params::face_label_map(label).label_names(Label_names{{9, "outlet_side"}}));
  EXPECT_EQ(called.openings.size(), 3u);
  EXPECT_TRUE(label_in(called, 9).is_understood());
}

TEST(Labelled_ends, A_sac_or_a_blind_vessel_with_a_label_stays) {
  Tube tube;
  tube.sides = 24;
  tube.rings = 40;
  for (double width : {1., 2.2}) {
    Labelled_mesh m = with_domes(make_tube(tube), {0.5}, 1, 2);
    for (auto v : m.mesh.vertices()) { // the upper end is drawn out, or blown up to a ball on a neck
      const Point p = m.mesh.point(v);
      if (p.z() > 7)
        m.mesh.point(v) = width == 1 ? Point(p.x(), p.y(), 7 + 4 * (p.z() - 7))
                                     : Point(p.x() * (1 + (width - 1) * std::sin((std::min)(p.z() - 7, 1.))),
                                             p.y() * (1 + (width - 1) * std::sin((std::min)(p.z() - 7, 1.))), p.z());
    }
    std::size_t i = 0;
    for (auto f : m.mesh.faces()) {
      bool above = true;
      for (auto v : m.mesh.vertices_around_face(m.mesh.halfedge(f)))
        above = above && m.mesh.point(v).z() > 6.9;
      m.label[i] = above ? 9 : m.label[i];
      ++i;
    }
    Surface surface = m.mesh;
    Face_patch_map label = surface.add_property_map<Surface::Face_index, int>("f:l", 0).first;
    auto l = m.label.begin();
    for (auto f : surface.faces())
      label[f] = *l++;
    const Labelled_ends ends = open_labelled_ends(surface, label);
    EXPECT_EQ(ends.ends.size(), 1u) << width;
    const auto nine = std::find_if(ends.labels.begin(), ends.labels.end(), [](const auto& x) { return x.label == 9; });
    ASSERT_NE(nine, ends.labels.end());
    EXPECT_NE(nine->reason.find(width == 1 ? "blind vessel" : "sac"), std::string::npos) << nine->reason;
  }
}

TEST(Labelled_ends, What_is_no_disk_is_wall) {
  Labelled_mesh m = with_domes(open_bifurcation(), {0.5}, 1, 2);
  std::size_t i = 0;
  for (auto f : m.mesh.faces()) { // a ring of the trunk
    const double z = m.mesh.point(m.mesh.target(m.mesh.halfedge(f))).z();
    if (m.label[i] == 1 && z > 2 && z < 4)
      m.label[i] = 8;
    ++i;
  }
  const Tubular_model model = make_tubular_model(m.mesh, params::face_label_map(labels_of(m)));
  expect_ends(model, m.centers, {"face_2", "face_3", "face_4"});
  EXPECT_NE(label_in(model, 8).reason.find("no disk"), std::string::npos);
  EXPECT_FALSE(model.labels.wall); // there are two of them
}

TEST(Labelled_ends, An_end_in_two_halves_is_found_by_its_shape) {
  Labelled_mesh m = with_domes(open_bifurcation(), {0, 0.6, 0.6}, 1, 2);
  std::size_t i = 0;
  for (auto f : m.mesh.faces()) {
    const auto h = m.mesh.halfedge(f);
    const Point c = CGAL::centroid(m.mesh.point(m.mesh.source(h)), m.mesh.point(m.mesh.target(h)),
                                   m.mesh.point(m.mesh.target(m.mesh.next(h))));
    if (m.label[i] == 2 && c.x() > m.centers[0].x())
      m.label[i] = 6;
    ++i;
  }
  const Tubular_model model = make_tubular_model(m.mesh, params::face_label_map(labels_of(m)));
  EXPECT_EQ(model.openings.size(), 3u);
  EXPECT_FALSE(label_in(model, 2).is_understood());
  EXPECT_FALSE(label_in(model, 6).is_understood());
}

TEST(Labelled_ends, Names_of_rims_of_open_surfaces) {
  Labelled_mesh m{open_bifurcation(), {}, {}};
  for (const Opening& o : find_openings(m.mesh))
    m.centers.push_back(o.center);
  for (auto f : m.mesh.faces()) {
    int label = 1;
    for (std::size_t i = 0; i < m.centers.size(); ++i)
      if (CGAL::squared_distance(m.mesh.point(m.mesh.target(m.mesh.halfedge(f))), m.centers[i]) < 1.6)
        label = 2 + int(i);
    m.label.push_back(label);
  }
  const Label_names names = {{2, "outlet_a"}, {3, "inlet_b"}, {4, "band"}};
  const std::size_t faces = m.mesh.number_of_faces();
  const Tubular_model model = make_tubular_model(m.mesh, params::face_label_map(labels_of(m)).label_names(names));
  ASSERT_EQ(model.openings.size(), 3u);
  EXPECT_EQ(model.openings[0].name, "inlet_b");
  EXPECT_EQ(std::count_if(model.openings.begin(), model.openings.end(), [](const auto& o) { return o.name.empty(); }),
            1);
  EXPECT_GE(model.surface.number_of_faces(), faces - 100); // bands stay
  EXPECT_FALSE(label_in(model, 4).is_understood());
  std::set<std::string> different;
  for (const auto& n : model.patch_names)
    EXPECT_TRUE(different.insert(n.second).second) << n.second;
}

TEST(Labelled_ends, A_number_is_not_believed_where_that_label_is_a_cap) {
  Labelled_mesh m = with_domes(open_bifurcation(), {0.7}, 4, 1);
  const Tubular_model model = make_tubular_model(m.mesh, params::face_label_map(labels_of(m)).wall_label(1));
  expect_ends(model, m.centers, {"face_1", "face_2", "face_3"});
}

// --- labels and repair ---

TEST(Carried_labels, Survive_what_the_repair_does) {
  Labelled_mesh m = with_domes(open_bifurcation(), {0.7}, 1, 2);
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  for (auto f : m.mesh.faces()) { // apart, as an STL file has them
    triangles.push_back({points.size(), points.size() + 1, points.size() + 2});
    for (auto v : m.mesh.vertices_around_face(m.mesh.halfedge(f)))
      points.push_back(m.mesh.point(v));
  }
  std::vector<int> labels = m.label;
  for (std::size_t i = 0; i < 20; ++i) { // repeated and turned triangles
    const auto t = triangles[50 * i];
    triangles.push_back({t[1], t[0], t[2]});
    labels.push_back(labels[50 * i]);
  }
  triangles.erase(triangles.begin() + 777); // a pinhole
  labels.erase(labels.begin() + 777);
  for (bool smooth : {false, true}) {
    Surface surface;
    repair_surface(points, triangles, surface, params::smooth(smooth));
    Face_patch_map label = surface.add_property_map<Surface::Face_index, int>("f:label", -7).first;
    carry_labels(points, triangles, labels, surface, label);
    ASSERT_TRUE(CGAL::is_closed(surface));
    std::vector<std::size_t> count(5, 0), before(5, 0);
    for (auto f : surface.faces()) {
      ASSERT_GE(label[f], 1);
      ASSERT_LE(label[f], 4);
      ++count[std::size_t(label[f])];
    }
    for (int l : m.label)
      ++before[std::size_t(l)];
    for (std::size_t l = 1; l < 5; ++l)
      EXPECT_NEAR(double(count[l]), double(before[l]), smooth ? 0.1 * double(before[l]) : 3) << l;
  }
}

// --- creases ---

std::size_t number_of_openings(const Mesh& mesh) {
  return internal::find_any_openings(mesh, Find_openings_options()).size();
}

TEST(Crease_ends, Domes_and_dishes_with_a_crease_are_ends) {
  const Mesh open = open_bifurcation();
  for (double height : {0.15, 0.3, 0.5, -0.3, -0.7})
    for (const Transformation& t : placements()) {
      const Labelled_mesh m = with_domes(transformed(open, t), {height}, 1, 2, 8, true);
      std::vector<Opening> openings = find_openings(m.mesh);
      ASSERT_EQ(openings.size(), 3u) << height;
      Mesh mesh = m.mesh;
      auto patch = mesh.add_property_map<Mesh::Face_index, int>("f:patch", 0).first;
      close_openings(mesh, openings, patch);
      EXPECT_TRUE(CGAL::is_closed(mesh));
      std::vector<double> area(3, 0.);
      for (auto f : mesh.faces())
        if (patch[f] >= labels::inlet) {
          const Opening& o = openings[std::size_t(patch[f] - labels::inlet)];
          area[std::size_t(patch[f] - labels::inlet)] += PMP::face_area(f, mesh);
          for (auto v : mesh.vertices_around_face(mesh.halfedge(f)))
            EXPECT_LT(std::abs((mesh.point(v) - o.center) * o.normal), 1e-6 * o.radius);
        }
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(area[i], openings[i].area, 1e-6 * area[i]); // the dome is gone
    }
}

TEST(Crease_ends, Inside_out_as_well) {
  Mesh mesh = with_domes(open_bifurcation(), {0.4}, 1, 2, 8, true).mesh;
  PMP::reverse_face_orientations(mesh);
  EXPECT_EQ(number_of_openings(mesh), 3u);
}

TEST(Crease_ends, Round_ends_and_sacs_are_none) {
  // half balls go over into the wall without a crease
  Tube tube;
  tube.sides = 40;
  tube.rings = 60;
  EXPECT_EQ(number_of_openings(with_domes(make_tube(tube), {1}, 1, 2, 24).mesh), 0u);
  EXPECT_EQ(number_of_openings(make_sphere(30, 40)), 0u);
  // a bump with a sharp base on the side of a tube, which is open at its ends
  Mesh bumpy = make_tube(tube);
  for (auto v : bumpy.vertices()) {
    const Point p = bumpy.point(v);
    const double d = std::sqrt(CGAL::squared_distance(p, Point(1, 0, 4)));
    if (d < 0.6)
      bumpy.point(v) = p + (0.6 - d) * 1.5 * Vector(p.x(), p.y(), 0);
  }
  EXPECT_EQ(number_of_openings(bumpy), 2u);
}

TEST(Crease_ends, Sides_of_prisms_and_boxes_are_none) {
  Tube tube;
  tube.sides = 6;
  tube.rings = 6;
  EXPECT_EQ(number_of_openings(make_tube(tube)), 2u);
  tube.sides = 12;
  tube.rings = 1;
  EXPECT_EQ(number_of_openings(make_tube(tube)), 2u);
}

} // namespace
