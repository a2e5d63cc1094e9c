// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What writing a mesh costs in each format: the time beside that of .vtu, and the peak of memory beyond the mesh beside
// what the mesh takes.
//
//     benchmark_writers FOLDER MESH...            meshes of .vtu, .msh or .mesh files
//     benchmark_writers FOLDER --tetrahedra N     N tetrahedra, or so, of a cylinder
//     benchmark_writers FOLDER --hexahedra N      the same of hexahedra
//     --keep leaves the files in the folder, --only FORMAT writes one format
//
// Each format is written by a process of its own, three times (once, of more than three million cells); the shortest time
// counts, of the processor's: other work on the machine matters less. A format that cannot hold the mesh says why.

#include <CGAL/Tubular_meshing/IO/Mesh_format.h>
#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;
namespace fs = std::filesystem;

namespace {

using tubular::Mixed_mesh;
using tubular::IO::Mesh_format;

// A cylinder of n x n x m bricks, which a square of n x n that has become a disk is drawn along; each brick is one
// hexahedron or six tetrahedra.
class Cylinder {
public:
  static Mixed_mesh make(std::size_t cells, bool hexahedra) {
    const double bricks = double(cells) / (hexahedra ? 1 : 6);
    const std::size_t n = std::max(std::size_t(2), std::size_t(std::cbrt(bricks / 4)));
    Cylinder cylinder{n, std::max(std::size_t(1), std::size_t(bricks / double(n * n))), {}};
    cylinder.add_points();
    cylinder.add_cells(hexahedra);
    cylinder.add_facets(hexahedra);
    cylinder.mesh.region_names = {{1, "lumen"}};
    cylinder.mesh.patch_names = {{1, "wall"}, {2, "inlet"}, {3, "outlet_1"}};
    return std::move(cylinder.mesh);
  }

  std::size_t n, m;
  Mixed_mesh mesh;

private:
  std::uint32_t at(std::size_t i, std::size_t j, std::size_t k) const {
    return std::uint32_t(i + (n + 1) * (j + (n + 1) * k));
  }

  void add_points() {
    mesh.points.reserve((n + 1) * (n + 1) * (m + 1));
    for (std::size_t k = 0; k <= m; ++k)
      for (std::size_t j = 0; j <= n; ++j)
        for (std::size_t i = 0; i <= n; ++i) {
          const double u = 2 * double(i) / double(n) - 1, v = 2 * double(j) / double(n) - 1;
          mesh.points.emplace_back(u * std::sqrt(1 - v * v / 2), v * std::sqrt(1 - u * u / 2),
                                   2 * double(k) / double(n));
        }
  }

  void add_cells(bool hexahedra) {
    const std::size_t bricks = n * n * m;
    hexahedra ? mesh.hexahedra.reserve(bricks) : mesh.tetrahedra.reserve(6 * bricks);
    for (std::size_t k = 0; k < m; ++k)
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
          const std::array<std::uint32_t, 8> v = {
              at(i, j, k),     at(i + 1, j, k),     at(i + 1, j + 1, k),     at(i, j + 1, k),
              at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)};
          if (hexahedra) {
            mesh.hexahedra.push_back(v, tubular::labels::lumen);
            continue;
          }
          for (const auto& p : {std::array<std::size_t, 2>{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}})
            mesh.tetrahedra.push_back({v[0], v[p[0]], v[p[1]], v[6]}, tubular::labels::lumen);
        }
  }

  // Corners outward; of triangles the diagonal from the first corner is that of the tetrahedra.
  void add_facet(bool hexahedra, const std::array<std::uint32_t, 4>& q, int patch) {
    if (hexahedra) {
      mesh.quads.push_back(q, patch);
      return;
    }
    mesh.triangles.push_back({q[0], q[1], q[2]}, patch);
    mesh.triangles.push_back({q[0], q[2], q[3]}, patch);
  }

  void add_facets(bool hexahedra) {
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i) {
        add_facet(hexahedra, {at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0)}, 2);
        add_facet(hexahedra, {at(i, j, m), at(i + 1, j, m), at(i + 1, j + 1, m), at(i, j + 1, m)}, 3);
      }
    for (std::size_t k = 0; k < m; ++k)
      for (std::size_t i = 0; i < n; ++i) {
        add_facet(hexahedra, {at(i, 0, k), at(i + 1, 0, k), at(i + 1, 0, k + 1), at(i, 0, k + 1)}, 1);
        add_facet(hexahedra, {at(i, n, k), at(i, n, k + 1), at(i + 1, n, k + 1), at(i + 1, n, k)}, 1);
        add_facet(hexahedra, {at(0, i, k), at(0, i, k + 1), at(0, i + 1, k + 1), at(0, i + 1, k)}, 1);
        add_facet(hexahedra, {at(n, i, k), at(n, i + 1, k), at(n, i + 1, k + 1), at(n, i, k + 1)}, 1);
      }
  }
};

double bytes_of(const Mixed_mesh& m) {
  double bytes = double(m.points.size() * sizeof m.points[0]);
  const auto add = [&](const auto& block) {
    bytes += double(block.size() * (sizeof block.vertices[0] + sizeof block.label[0]));
  };
  add(m.tetrahedra);
  add(m.pyramids);
  add(m.prisms);
  add(m.hexahedra);
  add(m.triangles);
  add(m.quads);
  return bytes;
}

// Of this process, in bytes: "VmRSS:" now, "VmHWM:" at its peak.
double memory(const std::string& which) {
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0;
  while (status >> word)
    if (word == which)
      status >> kilobytes;
  return 1024 * kilobytes;
}

double size_of_files(const fs::path& path) {
  if (fs::is_regular_file(path))
    return double(fs::file_size(path));
  double size = 0;
  for (const auto& entry : fs::recursive_directory_iterator(path))
    size += entry.is_regular_file() ? double(entry.file_size()) : 0;
  return size;
}

struct Outcome {
  bool written = false;
  double seconds = 0, memory = 0, size = 0;
  std::array<char, 400> why_not = {}; // of a fixed size: it goes through a pipe
};

struct Written_format {
  std::string name, file;
};

std::vector<Written_format> formats() {
  std::vector<Written_format> result;
  for (const std::string& name : tubular::IO::mesh_format_names()) {
    const Mesh_format format = tubular::IO::mesh_format_named(name);
    if (format == Mesh_format::pvtu || !tubular::IO::why_not_built_in(format).empty())
      continue;
    result.push_back({name, tubular::IO::is_openfoam(format)        ? name
                            : format == Mesh_format::svmultiphysics ? "mesh-complete"
                            : format == Mesh_format::gmsh           ? "mesh.msh"
                            : format == Mesh_format::medit          ? "mesh.mesh"
                            : format == Mesh_format::abaqus         ? "mesh.inp"
                            : format == Mesh_format::febio          ? "mesh.feb"
                            : format == Mesh_format::fluent         ? "mesh.cas"
                            : format == Mesh_format::exodus         ? "mesh.exo"
                                                                    : "mesh." + name});
  }
  return result;
}

Outcome write_here(const Mixed_mesh& mesh, const Written_format& f, const fs::path& folder, int times) {
  Outcome outcome;
  const auto np = tubular::parameters::format(tubular::IO::mesh_format_named(f.name));
  std::ofstream("/proc/self/clear_refs") << "5"; // the peak is what it is now
  const double before = memory("VmRSS:");
  try {
    for (int i = 0; i < times; ++i) {
      const std::clock_t begin = std::clock();
      tubular::IO::write_mesh((folder / f.file).string(), mesh, np);
      const double seconds = double(std::clock() - begin) / CLOCKS_PER_SEC;
      outcome.seconds = i == 0 ? seconds : std::min(outcome.seconds, seconds);
    }
    outcome.written = true;
  } catch (const std::exception& e) {
    std::string(e.what()).copy(outcome.why_not.data(), outcome.why_not.size() - 1);
  }
  outcome.memory = memory("VmHWM:") - before;
  return outcome;
}

// In a process of its own, which has the mesh already.
Outcome write_in_child(const Mixed_mesh& mesh, const Written_format& f, const fs::path& folder, int times) {
  Outcome outcome;
  int ends[2];
  if (pipe(ends) != 0)
    return outcome;
  const pid_t child = fork();
  if (child == 0) {
    const Outcome mine = write_here(mesh, f, folder, times);
    const bool told = write(ends[1], &mine, sizeof mine) == ssize_t(sizeof mine);
    _exit(told ? 0 : 1);
  }
  int status = 0;
  close(ends[1]);
  const bool heard = read(ends[0], &outcome, sizeof outcome) == ssize_t(sizeof outcome);
  close(ends[0]);
  waitpid(child, &status, 0);
  if (!heard || status != 0) {
    outcome = Outcome();
    std::string("the process ended with status " + std::to_string(status))
        .copy(outcome.why_not.data(), outcome.why_not.size() - 1);
  }
  return outcome;
}

void measure(const std::string& name, const Mixed_mesh& mesh, const fs::path& folder, const std::string& only,
             bool keep) {
  malloc_trim(0); // what was freed before would hide what a writer takes
  const int times = mesh.number_of_cells() > 3000000 ? 1 : 3;
  const double bytes = bytes_of(mesh);
  std::printf("\n%s: %zu points, %zu cells, %zu facets, %.1f MB\n\n", name.c_str(), mesh.points.size(),
              mesh.number_of_cells(), mesh.number_of_facets(), 1e-6 * bytes);
  std::printf("| format | s | of .vtu's | memory, of the mesh's | MB |\n|---|---|---|---|---|\n");
  double of_vtu = 0;
  for (const Written_format& f : formats()) {
    if (!only.empty() && f.name != only)
      continue;
    Outcome outcome = write_in_child(mesh, f, folder, times);
    if (!outcome.written) {
      std::printf("| %s | %s | | | |\n", f.name.c_str(), outcome.why_not.data());
      continue;
    }
    if (f.name == "vtu")
      of_vtu = outcome.seconds;
    outcome.size = size_of_files(folder / f.file);
    if (f.name == "xdmf")
      outcome.size += size_of_files(folder / "mesh.h5");
    std::printf("| %s | %.2f | %.2f | %.2f | %.1f |\n", f.name.c_str(), outcome.seconds,
                of_vtu > 0 ? outcome.seconds / of_vtu : 0, outcome.memory / bytes, 1e-6 * outcome.size);
    std::fflush(stdout);
    if (!keep) {
      std::error_code ignored;
      fs::remove_all(folder / f.file, ignored);
      fs::remove(folder / "mesh.h5", ignored);
    }
  }
}

} // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() < 2) {
    std::fprintf(stderr,
                 "benchmark_writers FOLDER (MESH | --tetrahedra N | --hexahedra N)... [--only FORMAT] [--keep]\n");
    return 2;
  }
  try {
    const fs::path folder = arguments[0];
    fs::create_directories(folder);
    std::string only;
    bool keep = false;
    for (std::size_t i = 1; i < arguments.size(); ++i) {
      keep = keep || arguments[i] == "--keep";
      if (arguments[i] == "--only" && i + 1 < arguments.size())
        only = arguments[i + 1];
    }
    for (std::size_t i = 1; i < arguments.size(); ++i) {
      const std::string& a = arguments[i];
      if (a == "--keep")
        continue;
      if (a == "--only") {
        ++i;
      } else if ((a == "--tetrahedra" || a == "--hexahedra") && i + 1 < arguments.size()) {
        ++i;
        measure("cylinder", Cylinder::make(std::stoul(arguments[i]), a == "--hexahedra"), folder, only, keep);
      } else {
        Mixed_mesh mesh;
        tubular::IO::read_mesh(a, mesh);
        measure(fs::path(a).filename().string(), mesh, folder, only, keep);
      }
    }
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  return 0;
}
