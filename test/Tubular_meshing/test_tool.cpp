// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line tool, as its user meets it: exit status, what it says, what it writes, and what it leaves alone.

#include "test_tool_helpers.h"
#include "test_tool_refusals.h"

#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>

#include <CGAL/boost/graph/helpers.h>

#include <cmath>
#include <ostream>

using namespace tool_test;

namespace {

const Arguments reproducibly = {"--threads", "1"};

Arguments run_to(const Tool& t, const std::string& output_file) {
  const Sample s = tube();
  return {t.make("tube.off", s.surface), "-c", t.make("lines.vtk", s.lines), "-o", output_file};
}

Arguments tube_run(const Tool& t) {
  return run_to(t, t.out("mesh.vtu"));
}

// --- what cannot be done ---

// It begins with a capital, or an option, and has one full stop, at the end.
bool is_a_sentence(const std::string& s) {
  return std::regex_match(s, std::regex("([A-Z]|--).*\\.")) && !std::regex_search(s, std::regex("\\. [A-Z]"));
}

// The tool's own sentences begin with its name; the option parser's, with the option's.
void expect_one_sentence(const Outcome& outcome, const Arguments& mentioned) {
  const std::vector<std::string> said = complaints(outcome);
  ASSERT_EQ(said.size(), 1u) << outcome.err;
  const std::string prefix = "tubular_mesh: ";
  if (said[0].compare(0, prefix.size(), prefix) == 0) {
    EXPECT_TRUE(is_a_sentence(said[0].substr(prefix.size()))) << said[0];
  }
  EXPECT_LT(said[0].size(), 500u) << said[0];
  for (const std::string& word : mentioned)
    EXPECT_NE(said[0].find(word), std::string::npos) << "no mention of \"" << word << "\" in: " << said[0];
}

class Refused : public Tool, public ::testing::WithParamInterface<Refusal> {
protected:
  void SetUp() override {
    Tool::SetUp();
    const Sample good = tube();
    make("tube.off", good.surface);
    make("lines.vtk", good.lines);
    make_bad_surfaces(*this, good);
    make_bad_centerlines(*this, good);
    fs::create_directory(out("folder.vtu"));
    std::ofstream(out("file")) << "a file";
  }
};

TEST_P(Refused, With_a_sentence_and_without_a_trace) {
  const Refusal& refusal = GetParam();
  const std::set<std::string> before = listing(output_directory());
  const std::string good_surface = bytes_of(in("tube.off"));
  Limits limits;
  limits.seconds = 20;
  const Outcome outcome = run(arguments_of(refusal, *this), limits);
  EXPECT_EQ(outcome.status, refusal.status) << outcome.killed_by << "\n" << outcome.err;
  EXPECT_EQ(outcome.out, "");
  expect_one_sentence(outcome, refusal.mentioned);
  EXPECT_EQ(listing(output_directory()), before);
  EXPECT_EQ(bytes_of(in("tube.off")), good_surface);
  if (refusal.status == usage) {
    EXPECT_EQ(stages_of(outcome), Arguments()) << "it was known before any work";
  }
}

std::string name_of(const ::testing::TestParamInfo<Refusal>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Usage, Refused, ::testing::ValuesIn(usage_errors()), name_of);
INSTANTIATE_TEST_SUITE_P(File, Refused, ::testing::ValuesIn(file_errors()), name_of);
INSTANTIATE_TEST_SUITE_P(Geometry, Refused, ::testing::ValuesIn(geometry_errors()), name_of);

// --- what fails on the way ---

class Full_disk : public Tool {
protected:
  // The output directory holds an older mesh, which must survive.
  void expect_nothing_written(const Arguments& arguments, const Limits& limits, const std::string& culprit) {
    std::ofstream(out("mesh.vtu")) << "the mesh of yesterday";
    const std::set<std::string> before = listing(output_directory());
    const Outcome outcome = run(arguments, limits);
    EXPECT_EQ(outcome.status, meshing) << outcome.killed_by << outcome.err;
    EXPECT_EQ(outcome.out, "");
    expect_one_sentence(outcome, {culprit, "cannot be written"});
    EXPECT_EQ(listing(output_directory()), before);
    EXPECT_EQ(bytes_of(out("mesh.vtu")), "the mesh of yesterday");
  }
  bool link_to_full_device(const std::string& name) const {
    if (!fs::exists("/dev/full"))
      return false;
    fs::create_symlink("/dev/full", out(name));
    return true;
  }
};

TEST_F(Full_disk, While_the_mesh_is_written) {
  Limits limits;
  limits.file_size = 20000;
  for (const char* format : {".vtu", ".msh", ".mesh"})
    expect_nothing_written(run_to(*this, out(std::string("mesh") + format)), limits, std::string("mesh") + format);
}

TEST_F(Full_disk, While_what_comes_after_the_mesh_is_written) {
  if (!link_to_full_device("full.json") || !link_to_full_device("full.vtp") || !link_to_full_device("full.vtu"))
    GTEST_SKIP() << "needs /dev/full";
  expect_nothing_written(tube_run(*this) + Arguments{"--report", out("full.json")}, Limits(), "full.json");
  expect_nothing_written(tube_run(*this) + Arguments{"--write-surface", out("full.vtp")}, Limits(), "full.vtp");
  expect_nothing_written(tube_run(*this) + Arguments{"--write-centerlines", out("full.vtp")}, Limits(), "full.vtp");
  expect_nothing_written(run_to(*this, out("full.vtu")) + Arguments{"--report", out("r.json")}, Limits(), "full.vtu");
}

TEST_F(Tool, Refuses_a_directory_that_is_write_protected) {
  if (geteuid() == 0)
    GTEST_SKIP() << "needs a user who is not root";
  fs::permissions(output_directory(), fs::perms::owner_read | fs::perms::owner_exec);
  const Outcome outcome = run(tube_run(*this));
  fs::permissions(output_directory(), fs::perms::owner_all);
  EXPECT_EQ(outcome.status, usage);
  expect_one_sentence(outcome, {"mesh.vtu"});
}

// --- what goes well ---

TEST_F(Tool, Tells_its_version_and_its_options) {
  const Outcome version = succeed({"--version"}), help = succeed({"--help"});
  EXPECT_TRUE(std::regex_match(version.out, std::regex("tubular_mesh [0-9]+\\.[0-9.]+\n"))) << version.out;
  for (const char* option : {"--centerlines",
                             "--output",
                             "--type",
                             "--points-per-circumference",
                             "--min-size",
                             "--max-size",
                             "--gradation",
                             "--inlet",
                             "--outlet",
                             "--seeds",
                             "--loops",
                             "--repair",
                             "--smooth",
                             "--flow-extensions",
                             "--report",
                             "--write-surface",
                             "--write-centerlines",
                             "--threads",
                             "--verbose",
                             "--quiet",
                             "--version",
                             "Exit status",
                             ".vtu"})
    EXPECT_NE(help.out.find(option), std::string::npos) << option;
}

void expect_statistics(const Json& told, const tubular::Measure_statistics& measured) {
  EXPECT_EQ(told["count"], measured.count());
  EXPECT_NEAR(told["min"].get<double>(), measured.min(), 1e-9);
  EXPECT_NEAR(told["mean"].get<double>(), measured.mean(), 1e-9);
  EXPECT_NEAR(told["p1"].get<double>(), measured.percentile(1), 1e-9);
  EXPECT_EQ(told["histogram"], Json(measured.histogram()));
}

double diagonal_of(const Mesh& mesh) {
  CGAL::Bbox_3 b;
  for (const Point& p : mesh.points)
    b += p.bbox();
  return std::hypot(b.xmax() - b.xmin(), b.ymax() - b.ymin(), b.zmax() - b.zmin());
}

// The cap of an opening in the mesh, and what the report says of it.
void expect_opening(const Json& told, const Mesh& mesh) {
  const int patch = told["patch"];
  EXPECT_EQ(told["name"], mesh.patch_names.at(patch));
  const auto vector = [&](const char* key) {
    return Kernel::Vector_3(told[key][0].get<double>(), told[key][1].get<double>(), told[key][2].get<double>());
  };
  const Kernel::Vector_3 center = vector("center"), normal = vector("normal");
  Kernel::Vector_3 area = CGAL::NULL_VECTOR;
  std::size_t triangles = 0;
  double off_plane = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.triangles.label[i] == patch) {
      const auto& v = mesh.triangles.vertices[i];
      const Point &p = mesh.points[v[0]], &q = mesh.points[v[1]], &r = mesh.points[v[2]];
      area = area + CGAL::cross_product(q - p, r - p) / 2;
      off_plane = (std::max)(off_plane, std::abs((p - CGAL::ORIGIN - center) * normal));
      ++triangles;
    }
  EXPECT_EQ(told["triangles"], triangles);
  EXPECT_GE(triangles, 8u);
  EXPECT_LE(off_plane, 1e-9 * diagonal_of(mesh));
  // The caps' rims are polygons of at least ten sides.
  EXPECT_NEAR(area * normal, told["area"].get<double>(), 0.08 * told["area"].get<double>()) << told["name"];
}

void expect_report_of(const Json& report, const Mesh& mesh) {
  const tubular::Validity_report validity = tubular::validity_report(mesh);
  EXPECT_TRUE(validity.is_valid()) << validity.defects();
  EXPECT_EQ(report["valid"], true);
  EXPECT_EQ(report["boundary_euler"], validity.boundary_euler);
  EXPECT_EQ(report["points"], mesh.points.size());
  EXPECT_EQ(report["cells"]["tetrahedra"], mesh.number_of_cells());
  EXPECT_EQ(report["facets"]["triangles"], mesh.number_of_facets());
  const tubular::Quality_report quality = tubular::quality_report(mesh);
  expect_statistics(report["quality"]["gamma_tau"], quality.gamma_tau);
  expect_statistics(report["quality"]["gamma_T"], quality.gamma_T);
  EXPECT_EQ(report["openings"].size() + 1, mesh.patch_names.size()); // and the wall
  EXPECT_EQ(report["openings"][0]["name"], "inlet");
  for (const Json& opening : report["openings"])
    expect_opening(opening, mesh);
  EXPECT_EQ(std::set<int>(mesh.tetrahedra.label.begin(), mesh.tetrahedra.label.end()), std::set<int>{1});
}

TEST_F(Tool, Reports_the_mesh_that_it_writes) {
  const Sample s = bifurcation();
  const std::string surface = make("y.vtp", s.surface), lines = make("lines.vtp", s.lines);
  const Outcome outcome = succeed({surface, "-c", lines, "-o", out("mesh.vtu"), "--report", out("r.json")});
  EXPECT_EQ(listing(output_directory()).size(), 2u);
  const Json report = json_in(out("r.json"));
  const Mesh mesh = mesh_in(out("mesh.vtu"));
  expect_report_of(report, mesh);
  EXPECT_EQ(report["program"].get<std::string>() + "\n", run({"--version"}).out);
  EXPECT_EQ(report["input"], surface);
  EXPECT_EQ(report["centerlines"], lines);
  EXPECT_EQ(report["output"], out("mesh.vtu"));
  EXPECT_EQ(report["boundary_euler"], 2);
  EXPECT_EQ(report["openings"].size(), 3u);
  EXPECT_EQ(report["branches"].size(), 3u);

  // What it prints is the same.
  for (const char* number : {"points", "cells", "facets"}) {
    const Json& n = report[number];
    EXPECT_NE(outcome.out.find((n.is_object() ? n.front() : n).dump()), std::string::npos) << number;
  }
  double sum = 0;
  const std::vector<std::string> stages = stages_of(outcome);
  for (const auto& time : report["times"].items()) {
    EXPECT_GT(std::count(stages.begin(), stages.end(), time.key()), 0) << time.key();
    EXPECT_NE(outcome.out.find(time.key()), std::string::npos) << time.key();
    sum += time.value().get<double>();
  }
  EXPECT_LE(sum, report["total_time"].get<double>() + 0.01);
  EXPECT_GE(sum, 0.9 * report["total_time"].get<double>() - 0.01);
  EXPECT_GT(report["peak_memory_bytes"].get<double>(), 1e6);
}

TEST_F(Tool, Says_as_much_as_it_is_told_to) {
  const Arguments arguments = tube_run(*this);
  const Outcome quiet = succeed(arguments + Arguments{"-q"}), plain = succeed(arguments);
  const Outcome verbose = succeed(arguments + Arguments{"-v"});
  EXPECT_EQ(quiet.out + quiet.err, "");
  EXPECT_GT(lines_of(verbose.out).size(), lines_of(plain.out).size() + 20); // the histograms
  EXPECT_EQ(plain.out.find("\033"), std::string::npos);
  EXPECT_EQ(plain.err.find('\r'), std::string::npos);

  const Outcome failed = run({"absent.stl", "-c", "absent.vtk", "-o", out("m.vtu"), "-q"});
  EXPECT_EQ(failed.status, input);
  expect_one_sentence(failed, {"absent.stl"}); // errors are not kept quiet
}

TEST_F(Tool, Makes_the_same_files_from_the_same_input) {
  const Sample s = bifurcation();
  const Arguments arguments = {make("y.off", s.surface), "-c", make("lines.vtk", s.lines), "--threads", "1"};
  for (const char* run : {"a", "b"})
    succeed(arguments + Arguments{"-o", out(run + std::string(".vtu")), "--write-surface",
                                  out(run + std::string(".vtp")), "--write-centerlines",
                                  out(run + std::string(".vtk"))});
  for (const char* format : {".vtu", ".vtp", ".vtk"}) {
    EXPECT_EQ(bytes_of(out(std::string("a") + format)), bytes_of(out(std::string("b") + format))) << format;
    EXPECT_GT(bytes_of(out(std::string("a") + format)).size(), 1000u);
  }
}

TEST_F(Tool, Writes_the_same_mesh_in_each_format) {
  std::vector<Mesh> meshes;
  for (const char* format : {".vtu", ".msh", ".mesh"}) {
    succeed(run_to(*this, out(std::string("m") + format)) + reproducibly);
    meshes.push_back(mesh_in(out(std::string("m") + format)));
  }
  for (const Mesh& m : meshes) {
    EXPECT_EQ(m.points, meshes[0].points);
    EXPECT_EQ(m.tetrahedra.vertices, meshes[0].tetrahedra.vertices);
    EXPECT_EQ(m.tetrahedra.label, meshes[0].tetrahedra.label);
    EXPECT_EQ(m.triangles.vertices, meshes[0].triangles.vertices);
    EXPECT_EQ(m.triangles.label, meshes[0].triangles.label);
    EXPECT_EQ(m.patch_names, meshes[0].patch_names);
  }
}

TEST_F(Tool, Takes_the_opening_at_the_point_for_the_inlet) {
  const Sample s = bifurcation();
  const Arguments arguments = {make("y.off", s.surface),
                               "-c",
                               make("lines.vtk", s.lines),
                               "-n",
                               "10",
                               "-o",
                               out("mesh.vtu"),
                               "--report",
                               out("r.json")};
  const auto inlet_z = [&](const Arguments& inlet) {
    succeed(arguments + inlet);
    const Json report = json_in(out("r.json"));
    expect_report_of(report, mesh_in(out("mesh.vtu")));
    EXPECT_EQ(report["openings"][0]["patch"], 2);
    EXPECT_TRUE(report["branches"][report["openings"][0]["branch"].get<std::size_t>()]["parents"].empty());
    return report["openings"][0]["center"][2].get<double>();
  };
  EXPECT_NEAR(inlet_z({}), 0, 0.01); // where the lines begin
  EXPECT_NEAR(inlet_z({"--inlet", "3.2,0,12"}), 12, 0.2);
  EXPECT_NEAR(inlet_z({"--inlet", "-30,0,110"}), 11, 0.2);
  EXPECT_NEAR(inlet_z({"--inlet=-1,-1,-1"}), 0, 0.01);
}

// --- without centerlines ---

// The largest difference between branches' lengths, in the order of their lengths, of the longest.
double difference_of_lengths(const Json& a, const Json& b) {
  std::vector<double> lengths[2];
  for (const Json& branch : a["branches"])
    lengths[0].push_back(branch["length"]);
  for (const Json& branch : b["branches"])
    lengths[1].push_back(branch["length"]);
  if (lengths[0].size() != lengths[1].size())
    return 1;
  double difference = 0;
  for (auto& l : lengths)
    std::sort(l.begin(), l.end());
  for (std::size_t i = 0; i < lengths[0].size(); ++i)
    difference = (std::max)(difference, std::abs(lengths[0][i] - lengths[1][i]));
  return difference / lengths[0].back();
}

TEST_F(Tool, Needs_no_centerlines) {
  const Sample s = bifurcation();
  const Arguments common =
      Arguments{make("y.off", s.surface), "-n", "12", "-o", out("mesh.vtu"), "--report", out("r.json")} + reproducibly;
  succeed(common + Arguments{"-c", make("lines.vtk", s.lines)});
  const Json given = json_in(out("r.json"));
  succeed(common);
  const Json computed = json_in(out("r.json"));
  expect_report_of(computed, mesh_in(out("mesh.vtu")));
  EXPECT_TRUE(computed["centerlines"].is_null());
  EXPECT_LT(difference_of_lengths(computed, given), 0.05); // where lines part is a matter of definition
  EXPECT_NEAR(computed["points"].get<double>(), given["points"].get<double>(), 0.05 * given["points"].get<double>());
  for (const Json& opening : computed["openings"])
    EXPECT_FALSE(opening["branch"].is_null());
  EXPECT_TRUE(computed["branches"][computed["openings"][0]["branch"].get<std::size_t>()]["parents"].empty());

  const Json first_outlet = computed["openings"][1];
  std::ostringstream point;
  point << first_outlet["center"][0] << "," << first_outlet["center"][1] << "," << first_outlet["center"][2];
  succeed(common + Arguments{"--inlet", point.str()});
  const Json turned = json_in(out("r.json"));
  EXPECT_EQ(turned["openings"][0]["center"], first_outlet["center"]);
  EXPECT_TRUE(turned["branches"][turned["openings"][0]["branch"].get<std::size_t>()]["parents"].empty());
}

std::string cigar() { // closed, and round at its ends
  Surface surface;
  std::istringstream in(sphere_off());
  CGAL::IO::read_OFF(in, surface);
  for (auto v : surface.vertices())
    surface.point(v) = Point(surface.point(v).x(), surface.point(v).y(), 4 * surface.point(v).z());
  std::ostringstream out;
  CGAL::IO::write_OFF(out, surface);
  return out.str();
}

TEST_F(Tool, Takes_points_for_the_ends_of_a_surface_without_any) {
  const Arguments common =
      Arguments{make("cigar.off", cigar()), "-o", out("mesh.vtu"), "--report", out("r.json")} + reproducibly;
  std::string meshes[2];
  int i = 0;
  for (const Arguments& ends : {Arguments{"--inlet", "0,0,-4", "--outlet", "0,0,4"},
                                Arguments{"--seeds", make("seeds.txt", "# from, to\n0,0,-4\n\n 0 0 4\n")}}) {
    succeed(common + ends);
    const Json report = json_in(out("r.json"));
    EXPECT_TRUE(report["openings"].empty());
    EXPECT_EQ(report["branches"].size(), 1u);
    EXPECT_EQ(report["boundary_euler"], 2);
    EXPECT_GE(report["quality"]["gamma_tau"]["min"].get<double>(), 0.2);
    EXPECT_NEAR(report["branches"][0]["max_radius"].get<double>(), 1, 0.02);
    meshes[i++] = bytes_of(out("mesh.vtu"));
  }
  EXPECT_EQ(meshes[0], meshes[1]);
}

TEST_F(Tool, Keeps_all_branches_of_a_loop_where_asked_to) {
  const Sample s = sample_of(tubular::willis_loop());
  const Arguments common = {make("loop.off", s.surface), "-n", "10", "-o", out("mesh.vtu"), "--report", out("r.json")};
  succeed(common + Arguments{"-c", make("lines.vtk", s.lines)});
  const Json given = json_in(out("r.json"));
  succeed(common + Arguments{"--loops"});
  const Json computed = json_in(out("r.json"));
  EXPECT_EQ(computed["branches"].size(), given["branches"].size());
  EXPECT_EQ(computed["boundary_euler"], given["boundary_euler"]);
  EXPECT_LT(computed["boundary_euler"], 2);
  succeed(common);
  EXPECT_LT(json_in(out("r.json"))["branches"].size(), given["branches"].size());
}

// --- repair ---

TEST_F(Tool, Leaves_a_clean_surface_alone) {
  const Arguments arguments = tube_run(*this) + Arguments{"--report", out("r.json")} + reproducibly;
  const Outcome outcome = succeed(arguments);
  EXPECT_TRUE(json_in(out("r.json"))["repairs"].empty());
  EXPECT_EQ(outcome.out.find("repair:"), std::string::npos);
  const std::string mesh = bytes_of(out("mesh.vtu"));
  succeed(arguments + Arguments{"--repair", "off"});
  EXPECT_EQ(bytes_of(out("mesh.vtu")), mesh);
}

TEST_F(Tool, Mends_a_surface_and_says_so) {
  Surface surface = tube().surface;
  std::size_t removed = 0;
  for (auto f : surface.faces()) // a pinhole
    if (removed < 1 && std::abs(surface.point(surface.target(surface.halfedge(f))).z() - 3) < 0.3) {
      CGAL::Euler::remove_face(surface.halfedge(f), surface);
      ++removed;
    }
  surface.collect_garbage();
  std::string soup =
      "OFF\n" + std::to_string(surface.number_of_vertices()) + " " + std::to_string(surface.number_of_faces()) + " 0\n";
  for (auto v : surface.vertices()) {
    std::ostringstream line;
    line.precision(17);
    line << surface.point(v) << "\n";
    soup += line.str();
  }
  for (auto f : surface.faces()) { // every fifth triangle is turned
    std::vector<std::string> corners;
    for (auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
      corners.push_back(std::to_string(v.idx()));
    if (f.idx() % 5 == 1)
      std::swap(corners[0], corners[1]);
    soup += "3 " + corners[0] + " " + corners[1] + " " + corners[2] + "\n";
  }
  const Outcome outcome = succeed({make("torn.off", soup), "-o", out("mesh.vtu"), "--report", out("r.json")});
  const Json report = json_in(out("r.json"));
  expect_report_of(report, mesh_in(out("mesh.vtu")));
  EXPECT_EQ(report["openings"].size(), 2u);
  std::set<std::string> defects;
  for (const Json& repair : report["repairs"]) {
    defects.insert(repair["defect"].get<std::string>());
    EXPECT_GT(repair["count"].get<int>(), 0);
    EXPECT_NE(outcome.out.find(repair["sentence"].get<std::string>()), std::string::npos);
  }
  EXPECT_EQ(defects, (std::set<std::string>{"turned_triangles", "pinholes"}));
}

TEST_F(Tool, Wraps_and_smooths_when_told_to) {
  const Sample s = bifurcation();
  const Arguments common = {make("y.off", s.surface), "-n", "10", "-o", out("mesh.vtu"), "--report", out("r.json")};
  for (const Arguments& options : {Arguments{"--repair", "wrap"}, Arguments{"--smooth"}}) {
    succeed(common + options);
    const Json report = json_in(out("r.json"));
    expect_report_of(report, mesh_in(out("mesh.vtu")));
    EXPECT_EQ(report["repairs"].size(), 1u);
    EXPECT_EQ(report["openings"].size(), 3u);
    EXPECT_EQ(report["branches"].size(), 3u);
  }
}

TEST_F(Tool, Extends_the_openings) {
  const Sample s = bifurcation();
  const Arguments common = {make("y.off", s.surface),
                            "-n",
                            "10",
                            "-o",
                            out("mesh.vtu"),
                            "--report",
                            out("r.json"),
                            "--inlet",
                            "3.2,0,12"}; // a twig's end
  succeed(common);
  const Json plain = json_in(out("r.json"));
  EXPECT_TRUE(plain["flow_extensions"].empty());
  succeed(common + Arguments{"--flow-extensions", "4"});
  const Json extended = json_in(out("r.json"));
  expect_report_of(extended, mesh_in(out("mesh.vtu")));
  ASSERT_EQ(extended["openings"].size(), 3u);
  ASSERT_EQ(extended["flow_extensions"].size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) { // in the same order
    const double radius = plain["openings"][i]["radius"], length = extended["flow_extensions"][i];
    EXPECT_NEAR(length, 4 * radius, 0.05 * radius);
    double along = 0;
    for (int k = 0; k < 3; ++k)
      along += (extended["openings"][i]["center"][k].get<double>() - plain["openings"][i]["center"][k].get<double>()) *
               plain["openings"][i]["normal"][k].get<double>();
    EXPECT_NEAR(along, length, 0.1 * length);
    EXPECT_NEAR(extended["openings"][i]["radius"].get<double>(), radius, 0.05 * radius);
  }
}

TEST_F(Tool, Reads_what_it_has_written) {
  const Sample s = bifurcation();
  Json reports[3];
  succeed({make("y.off", s.surface), "-c", make("lines.vtk", s.lines), "-o", out("a.vtu"), "--threads", "1", "--report",
           out("r.json"), "--write-surface", out("a.vtp"), "--write-centerlines", out("c.vtp")});
  reports[0] = json_in(out("r.json"));
  Surface closed;
  tubular::IO::read_surface(out("a.vtp"), closed);
  EXPECT_TRUE(CGAL::is_closed(closed));
  Centerlines branches;
  tubular::IO::read_centerlines(out("c.vtp"), branches);
  EXPECT_EQ(branches.lines.size(), 3u);
  EXPECT_EQ(branches.radius.size(), branches.points.size());

  const Arguments again = {"-o", out("b.vtu"), "--threads", "1", "--report", out("r.json")};
  succeed(again + Arguments{in("y.off"), "-c", out("c.vtp")});
  reports[1] = json_in(out("r.json"));
  succeed(again + Arguments{out("a.vtp"), "-c", out("c.vtp")});
  reports[2] = json_in(out("r.json"));
  expect_report_of(reports[2], mesh_in(out("b.vtu")));
  for (const Json& r : reports) {
    EXPECT_EQ(r["openings"].size(), 3u);
    EXPECT_EQ(r["branches"].size(), 3u);
    EXPECT_NEAR(r["points"].get<double>(), reports[0]["points"].get<double>(), 0.02 * r["points"].get<double>());
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(r["openings"][i]["area"].get<double>(), reports[0]["openings"][i]["area"].get<double>(), 0.02);
  }
}

TEST_F(Tool, Obeys_the_limits_of_the_mesh_size) {
  const Arguments arguments = tube_run(*this) + Arguments{"--report", out("r.json")} + reproducibly;
  const auto cells = [&](const Arguments& options) {
    succeed(arguments + options);
    return json_in(out("r.json"))["cells"]["tetrahedra"].get<double>();
  };
  const double n_20 = cells({}), n_12 = cells({"-n", "12"}), size_at_20 = 2 * CGAL_PI / 20;
  const std::string size = std::to_string(size_at_20);
  EXPECT_GT(n_20 / n_12, 3); // 4.6, but for the surface's share
  EXPECT_LT(n_20 / n_12, 5);
  EXPECT_NEAR(cells({"-n", "12", "--max-size", size}), n_20, 0.06 * n_20); // the polygonal tube's radius is less than 1
  EXPECT_NEAR(cells({"-n", "40", "--min-size", size}), n_20, 0.06 * n_20);
}

TEST_F(Tool, Meshes_the_sample_that_is_shipped) {
  const std::string sample = std::string(TUBULAR_MESHING_DATA) + "/aortic_arch";
  succeed({sample + ".stl", "-c", sample + "_centerlines.vtk", "-o", out("mesh.msh"), "--report", out("r.json")});
  const Json report = json_in(out("r.json"));
  expect_report_of(report, mesh_in(out("mesh.msh")));
  EXPECT_EQ(report["openings"].size(), 5u);
  EXPECT_EQ(report["branches"].size(), 7u);
  EXPECT_EQ(report["boundary_euler"], 2);
  EXPECT_GE(report["quality"]["gamma_tau"]["min"].get<double>(), 0.21);
}

// --- the same model elsewhere, in other units ---

class Invariance : public Tool {
protected:
  Json report_of(const Sample& s) {
    succeed({make("s.off", s.surface), "-c", make("c.vtk", s.lines), "-o", out("m.vtu"), "--report", out("r.json"),
             "--threads", "1"});
    expect_report_of(json_in(out("r.json")), mesh_in(out("m.vtu")));
    return json_in(out("r.json"));
  }

  // Of a small model, rims make up much of the surface, and they count a few points more or less.
  double triangles_share = 0.03;

  void expect_the_same(const Json& report, const Json& original, double scale) {
    const auto near = [](const Json& a, const Json& b, double share) {
      EXPECT_NEAR(a.get<double>(), b.get<double>(), share * b.get<double>());
    };
    near(report["points"], original["points"], 0.02);
    near(report["cells"]["tetrahedra"], original["cells"]["tetrahedra"], 0.02);
    near(report["facets"]["triangles"], original["facets"]["triangles"], triangles_share);
    near(report["quality"]["gamma_tau"]["mean"], original["quality"]["gamma_tau"]["mean"], 0.01);
    near(report["quality"]["gamma_T"]["mean"], original["quality"]["gamma_T"]["mean"], 0.01);
    EXPECT_EQ(report["boundary_euler"], original["boundary_euler"]);
    ASSERT_EQ(report["openings"].size(), original["openings"].size());
    for (std::size_t i = 0; i < report["openings"].size(); ++i) // in the same order
      EXPECT_NEAR(report["openings"][i]["radius"].get<double>(),
                  scale * original["openings"][i]["radius"].get<double>(),
                  1e-4 * report["openings"][i]["radius"].get<double>());
    ASSERT_EQ(report["branches"].size(), original["branches"].size());
  }

  void expect_invariance(const Sample& s) {
    const Json original = report_of(s);
    for (double scale : {1000., 1e6, 1e-3}) {
      SCOPED_TRACE("scaled by " + std::to_string(scale));
      expect_the_same(
          report_of(transformed(s, [&](const Point& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN); })),
          original, scale);
    }
    CGAL::Bbox_3 box;
    for (auto v : s.surface.vertices())
      box += s.surface.point(v).bbox();
    const Kernel::Vector_3 across(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
    {
      SCOPED_TRACE("moved by a hundred diagonals");
      expect_the_same(report_of(transformed(s, [&](const Point& p) { return p + 100 * across; })), original, 1);
    }
    for (const double angle : {0.4, 2.}) {
      SCOPED_TRACE("rotated by " + std::to_string(angle));
      const double c = std::cos(angle), i = std::sin(angle);
      expect_the_same(report_of(transformed(s,
                                            [&](const Point& p) { // about x, then about z
                                              const double y = c * p.y() - i * p.z(), z = i * p.y() + c * p.z();
                                              return Point(c * p.x() - i * y, i * p.x() + c * y, z);
                                            })),
                      original, 1);
    }
  }
};

TEST_F(Invariance, Of_a_bifurcation) {
  expect_invariance(bifurcation());
}

// --- the paper's own geometries ---

#ifdef TUBULAR_MESHING_SHARED_DATA
const char* const shared_data = TUBULAR_MESHING_SHARED_DATA;
#else
const char* const shared_data = "shared/data, which is not here";
#endif

struct Real_model {
  const char *name, *surface, *centerlines;
  double points;
  std::size_t openings, branches;
  int euler;
  double least_gamma_tau, mean_gamma_tau, mean_gamma_T, distance;
};

std::ostream& operator<<(std::ostream& out, const Real_model& m) {
  return out << m.name;
}

std::string file_of(const char* name) {
  return (fs::path(shared_data) / "paper" / name).string();
}

bool is_absent(const Real_model& m) {
  return !fs::exists(file_of(m.surface)) || !fs::exists(file_of(m.centerlines));
}

class Real : public Tool, public ::testing::WithParamInterface<Real_model> {};

// How far the input's vertices are from the mesh, at most, over the diagonal: caps may cut off a little at the ends.
double distance_to_mesh(const std::string& surface_file, const Mesh& mesh) {
  Surface surface, boundary;
  tubular::IO::read_surface(surface_file, surface);
  for (const Point& p : mesh.points)
    boundary.add_vertex(p);
  typedef Surface::Vertex_index Vertex;
  for (const auto& t : mesh.triangles.vertices)
    boundary.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  const tubular::Wall_distance distance(boundary);
  double largest = 0;
  for (auto v : surface.vertices())
    largest = (std::max)(largest, distance(surface.point(v)));
  return largest / diagonal_of(mesh);
}

TEST_P(Real, Is_meshed_well) {
  const Real_model& model = GetParam();
  if (is_absent(model))
    GTEST_SKIP() << "needs " << file_of(model.surface);
  std::ostringstream n;
  n << model.points;
  // one thread: what passes once passes always
  succeed({file_of(model.surface), "-c", file_of(model.centerlines), "-n", n.str(), "-o", out("mesh.vtu"), "--report",
           out("r.json"), "--threads", "1"});
  const Json report = json_in(out("r.json"));
  const Mesh mesh = mesh_in(out("mesh.vtu"));
  expect_report_of(report, mesh);
  EXPECT_EQ(report["boundary_euler"], model.euler);
  EXPECT_EQ(report["openings"].size(), model.openings);

  EXPECT_EQ(report["branches"].size(), model.branches);
  EXPECT_GE(report["quality"]["gamma_tau"]["min"].get<double>(), model.least_gamma_tau);
  EXPECT_GE(report["quality"]["gamma_tau"]["mean"].get<double>(), model.mean_gamma_tau);
  EXPECT_GE(report["quality"]["gamma_T"]["mean"].get<double>(), model.mean_gamma_T);
  EXPECT_LE(distance_to_mesh(file_of(model.surface), mesh), model.distance);
  for (const Json& branch : report["branches"])
    if (branch["points_per_circumference"] > 0) {
      EXPECT_GE(branch["points_per_circumference"].get<double>(), 0.9 * model.points);
      EXPECT_LE(branch["points_per_circumference"].get<double>(), model.points + 6);
    }
}

const Real_model real_models[] = {
    {"aorta", "aorta.stl", "centerlinesAORTA.vtk", 20, 5, 7, 2, 0.21, 0.72, 0.90, 0.004},
    {"carotid", "carotid.stl", "centerlinesCAROTID.vtk", 20, 3, 3, 2, 0.18, 0.72, 0.90, 0.004},
    {"carotid_16", "carotid.stl", "centerlinesCAROTID.vtk", 16, 3, 3, 2, 0.18, 0.72, 0.90, 0.004},
    {"bypass", "bypass.stl", "centerlinesBYPASS.msh", 20, 2, 4, 0, 0.18, 0.72, 0.90, 0.004},
    {"bypass_25", "bypass.stl", "centerlinesBYPASS.msh", 25, 2, 4, 0, 0.18, 0.72, 0.90, 0.004},
    {"cerebral_10", "cerebral.stl", "centerlinesCEREBRAL.vtk", 10, 9, 15, 2, 0.15, 0.66, 0.85,
     0.008}, // chords of ten a round
};
INSTANTIATE_TEST_SUITE_P(Paper, Real, ::testing::ValuesIn(real_models),
                         [](const ::testing::TestParamInfo<Real_model>& info) { return std::string(info.param.name); });

// --- a surface alone ---

struct Real_surface {
  const char *name, *file;
  double points;
  std::size_t openings;
  int euler;
};

std::ostream& operator<<(std::ostream& out, const Real_surface& s) {
  return out << s.name;
}

class Real_alone : public Tool, public ::testing::WithParamInterface<Real_surface> {};

TEST_P(Real_alone, Is_meshed) {
  const std::string file = (fs::path(shared_data) / GetParam().file).string();
  if (!fs::exists(file))
    GTEST_SKIP() << "needs " << file;
  std::ostringstream n;
  n << GetParam().points;
  succeed({file, "-n", n.str(), "-o", out("mesh.vtu"), "--report", out("r.json"), "--threads", "1"});
  const Json report = json_in(out("r.json"));
  expect_report_of(report, mesh_in(out("mesh.vtu")));
  EXPECT_EQ(report["boundary_euler"], GetParam().euler);
  EXPECT_EQ(report["openings"].size(), GetParam().openings);
  for (const Json& opening : report["openings"])
    EXPECT_FALSE(opening["branch"].is_null()) << opening["name"];
  EXPECT_GE(report["quality"]["gamma_tau"]["min"].get<double>(), 0.15);
}

const Real_surface real_surfaces[] = {{"aorta", "paper/aorta.stl", 20, 5, 2},
                                      {"carotid", "paper/carotid.stl", 16, 3, 2},
                                      {"bypass", "paper/bypass.stl", 12, 2, 0},
                                      {"cerebral", "paper/cerebral.stl", 10, 9, 2},
                                      {"cylemi", "paper/cylemi.stl", 20, 2, 2},
                                      {"coronaries", "trees/sofa_LCA.stl", 12, 7, 2},
                                      {"noisy_carotids", "trees/sofa_carotids.stl", 16, 3, 2},
                                      {"network", "trees/sofa_phantom_network.obj", 12, 8, 0}};
INSTANTIATE_TEST_SUITE_P(Shared, Real_alone, ::testing::ValuesIn(real_surfaces),
                         [](const ::testing::TestParamInfo<Real_surface>& info) {
                           return std::string(info.param.name);
                         });

TEST_F(Invariance, Of_the_aorta) {
  if (is_absent(real_models[0]))
    GTEST_SKIP() << "needs " << file_of(real_models[0].surface);
  Sample s;
  tubular::IO::read_surface(file_of(real_models[0].surface), s.surface);
  tubular::IO::read_centerlines(file_of(real_models[0].centerlines), s.lines);
  triangles_share = 0.02;
  expect_invariance(s);
}

} // namespace
