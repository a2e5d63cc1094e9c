// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pack_scene.h"

#include "../view/Camera.h"
#include "../view/Color.h"
#include "../view/deflate.h"
#include "Packed_stream.h"
#include "Quantization.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace tubular = CGAL::Tubular_meshing;
typedef nlohmann::ordered_json Json;

namespace {

constexpr std::size_t cells_of_chunk = 32768;

// Qualities from -1 to 1 in twelve bits.
std::uint32_t packed_quality(float q) {
  return std::uint32_t(std::lround((std::isfinite(q) ? std::clamp(double(q), -1., 1.) + 1 : 0) / 2 * 4095));
}

// The numbers that vertices get: those on facets, and the others, each in the order in which they are first used.
class Vertex_numbers {
public:
  explicit Vertex_numbers(std::size_t points)
      : number_(points, Shown_mesh::none)
      , is_inner_(points, 0) {}

  // Its number; new ones are appended to the list.
  std::uint32_t of(std::uint32_t v, bool is_inner) {
    if (number_[v] == Shown_mesh::none) {
      std::vector<std::uint32_t>& list = is_inner ? inner_ : outer_;
      is_inner_[v] = is_inner;
      number_[v] = std::uint32_t(list.size());
      list.push_back(v);
    }
    return number_[v];
  }
  bool is_inner(std::uint32_t v) const { return is_inner_[v]; }
  const std::vector<std::uint32_t>& outer() const { return outer_; }
  const std::vector<std::uint32_t>& inner() const { return inner_; }

private:
  std::vector<std::uint32_t> number_, outer_, inner_;
  std::vector<char> is_inner_;
};

// A corner as its number and whether it is inside; numbers as differences from the last one of the same kind.
class Corner_writer {
public:
  explicit Corner_writer(Packed_stream& out)
      : out_(out) {}
  typedef std::pair<bool, std::uint32_t> Corner;

  void write(const std::vector<Corner>& corners) {
    std::int64_t last[2] = {first_[0], first_[1]};
    bool is_first[2] = {true, true};
    for (const Corner& c : corners) {
      out_.signed_number(std::int64_t(c.second) - last[c.first]);
      last[c.first] = c.second;
      if (is_first[c.first])
        first_[c.first] = c.second; // with which the next element's first corner is compared
      is_first[c.first] = false;
    }
  }

private:
  Packed_stream& out_;
  std::int64_t first_[2] = {0, 0};
};

class Scene_packer {
public:
  explicit Scene_packer(const Shown_mesh& mesh)
      : mesh_(mesh)
      , quantization_(mesh)
      , vertices_(mesh.mesh().points.size())
      , number_of_cell_(mesh.cells().size(), Shown_mesh::none) {
    order_facets();
    order_cells();
    number_labels();
  }

  Packed_scene pack(std::size_t most_bytes) {
    Packed_scene scene;
    std::vector<std::string> chunks;
    std::vector<Json> headers;
    std::size_t bytes = pack_facets().first.size(), packed = 0;
    const std::size_t without_cells = bytes;
    while (packed < cells_.size()) {
      const std::size_t end = (std::min)(packed + cells_of_chunk, cells_.size());
      auto chunk = pack_chunk(packed, end);
      // Facets refer to the cells that are there, which takes bytes as well: about as many as they have, and two.
      if (bytes + chunk.first.size() > most_bytes)
        break;
      bytes += chunk.first.size();
      number_cells(packed, end);
      chunks.push_back(std::move(chunk.first));
      headers.push_back(std::move(chunk.second));
      packed = end;
    }
    auto facets = pack_facets();
    while (!chunks.empty() && bytes - without_cells + facets.first.size() > most_bytes) {
      bytes -= chunks.back().size();
      packed = (chunks.size() - 1) * cells_of_chunk;
      for (std::size_t i = packed; i < cells_.size(); ++i)
        number_of_cell_[cells_[i]] = Shown_mesh::none;
      chunks.pop_back();
      headers.pop_back();
      facets = pack_facets();
    }
    scene.cells = packed;
    scene.whole_branches = mesh_.centerlines().branches().size();
    for (std::size_t i = packed; i < (std::min)(packed + cells_of_chunk, cells_.size()); ++i)
      scene.whole_branches = (std::min)(scene.whole_branches, std::size_t(mesh_.place_of_cell(cells_[i]).branch));
    scene.parts.push_back(std::move(facets.first));
    for (std::string& chunk : chunks)
      scene.parts.push_back(std::move(chunk));
    Json description = header(facets.second, headers, packed);
    description["whole_branches"] = scene.whole_branches;
    scene.header = description.dump(-1, ' ', false, Json::error_handler_t::replace);
    return scene;
  }

private:
  typedef std::pair<std::string, Json> Packed; // base64, and what it holds

  void order_facets() {
    facets_.resize(mesh_.number_of_facets());
    std::iota(facets_.begin(), facets_.end(), 0u);
    std::sort(facets_.begin(), facets_.end(), [&](std::uint32_t a, std::uint32_t b) {
      const auto key = [&](std::uint32_t f) {
        const Shown_mesh::Place& p = mesh_.place_of_facet(f);
        return std::make_tuple(!mesh_.is_triangle(f), p.branch, p.abscissa, f);
      };
      return key(a) < key(b);
    });
    for (std::uint32_t f : facets_)
      for (std::uint32_t v : mesh_.facet(f))
        if (v != tubular::internal::cells::no_vertex)
          vertices_.of(v, false);
  }

  // Along the branches, in each chunk by their kind.
  void order_cells() {
    cells_.resize(mesh_.cells().size());
    std::iota(cells_.begin(), cells_.end(), 0u);
    std::sort(cells_.begin(), cells_.end(), [&](std::uint32_t a, std::uint32_t b) {
      const auto &p = mesh_.place_of_cell(a), &q = mesh_.place_of_cell(b);
      return std::tie(p.branch, p.abscissa, a) < std::tie(q.branch, q.abscissa, b);
    });
    for (std::size_t begin = 0; begin < cells_.size(); begin += cells_of_chunk)
      std::stable_sort(cells_.begin() + std::ptrdiff_t(begin),
                       cells_.begin() + std::ptrdiff_t((std::min)(begin + cells_of_chunk, cells_.size())),
                       [&](std::uint32_t a, std::uint32_t b) { return mesh_.cells().kind(a) < mesh_.cells().kind(b); });
  }

  void number_labels() {
    std::set<int> patches, regions;
    for (std::uint32_t f : facets_)
      patches.insert(mesh_.patch(f));
    for (std::uint32_t c : cells_)
      regions.insert(mesh_.cells().region(c));
    for (int p : patches)
      patch_number_.emplace(p, patch_number_.size());
    for (int r : regions)
      region_number_.emplace(r, region_number_.size());
  }

  void number_cells(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      number_of_cell_[cells_[i]] = std::uint32_t(i);
  }

  void write_points(Packed_stream& out, const std::vector<std::uint32_t>& points, std::size_t first) const {
    out.begin("points");
    std::vector<std::uint32_t> differences[3];
    std::array<std::uint32_t, 3> last = {0, 0, 0};
    for (std::size_t i = first; i < points.size(); ++i) {
      const auto p = quantization_(mesh_.point(points[i]));
      for (std::size_t k = 0; k < 3; ++k)
        differences[k].push_back(std::uint32_t(Packed_stream::folded(std::int64_t(p[k]) - std::int64_t(last[k]))));
      last = p;
    }
    for (const auto& d : differences)
      out.planes(d, 4);
  }

  // What viewers need of a stream to read it.
  static Packed packed(const Packed_stream& out, Json header) {
    Json sections = Json::array();
    for (const auto& s : out.sections())
      sections.push_back({s.first, s.second});
    header["bytes"] = out.bytes().size();
    header["sections"] = sections;
    return {base64(deflated(out.bytes())), header};
  }

  Packed pack_facets() {
    Packed_stream out;
    write_points(out, vertices_.outer(), 0);
    out.begin("corners");
    Corner_writer corners(out);
    for (std::uint32_t f : facets_) {
      std::vector<Corner_writer::Corner> of_facet;
      for (std::uint32_t v : mesh_.facet(f))
        if (v != tubular::internal::cells::no_vertex)
          of_facet.emplace_back(false, vertices_.of(v, false));
      if (of_facet.size() == 3) // which corner is the first does not matter
        std::rotate(of_facet.begin(), std::min_element(of_facet.begin(), of_facet.end()), of_facet.end());
      corners.write(of_facet);
    }
    write_facets(out, "patch", [&](std::uint32_t f) { return patch_number_.at(mesh_.patch(f)); });
    write_facets(out, "branch", [&](std::uint32_t f) { return mesh_.place_of_facet(f).branch; });
    // of the cell behind it, which may not be there
    write_facets(out, "kind", [&](std::uint32_t f) {
      const std::uint32_t cell = mesh_.sides(f)[0];
      return cell == Shown_mesh::none ? (mesh_.is_triangle(f) ? 4 : 5) : mesh_.cells().kind(cell);
    });
    write_facets(out, "region", [&](std::uint32_t f) {
      const std::uint32_t cell = mesh_.sides(f)[0];
      return cell == Shown_mesh::none ? 0 : region_number_.at(mesh_.cells().region(cell));
    });
    // The region on its other side, 0 for none: as colours and cuts need it where cells are left out.
    write_facets(out, "beyond", [&](std::uint32_t f) {
      const std::uint32_t cell = mesh_.sides(f)[1];
      return cell == Shown_mesh::none ? 0 : 1 + region_number_.at(mesh_.cells().region(cell));
    });
    out.begin("quality");
    std::vector<std::uint32_t> quality;
    for (std::uint32_t f : facets_) {
      const std::uint32_t cell = mesh_.sides(f)[0];
      quality.push_back(
          packed_quality(cell == Shown_mesh::none ? mesh_.quality_of_facet(f) : mesh_.quality_of_cell(cell)));
    }
    out.planes(quality, 2);
    for (std::size_t side = 0; side < 2; ++side)
      write_facets(out, side == 0 ? "cell" : "other_cell", [&](std::uint32_t f) {
        const std::uint32_t cell = mesh_.sides(f)[side];
        return cell == Shown_mesh::none || number_of_cell_[cell] == Shown_mesh::none ? std::uint32_t(0)
                                                                                     : number_of_cell_[cell] + 1;
      });
    return packed(out, {{"points", vertices_.outer().size()},
                        {"triangles", mesh_.mesh().triangles.size()},
                        {"quads", mesh_.mesh().quads.size()}});
  }

  template <class F> void write_facets(Packed_stream& out, const char* section, const F& value) const {
    std::vector<std::int64_t> values;
    values.reserve(facets_.size());
    for (std::uint32_t f : facets_)
      values.push_back(std::int64_t(value(f)));
    out.begin(section);
    out.differences(values);
  }

  Packed pack_chunk(std::size_t begin, std::size_t end) {
    const auto& cells = mesh_.cells();
    const std::size_t first_point = vertices_.inner().size();
    Packed_stream out;
    std::vector<std::vector<Corner_writer::Corner>> corners;
    std::array<std::size_t, 4> number = {0, 0, 0, 0};
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t cell = cells_[i];
      std::vector<Corner_writer::Corner> of_cell;
      for (std::uint32_t v : cells.corners(cell)) {
        const std::uint32_t n = vertices_.of(v, true);
        of_cell.emplace_back(vertices_.is_inner(v), n);
      }
      if (of_cell.size() == 4) // nothing is read from the order of a tetrahedron's corners
        std::sort(of_cell.begin(), of_cell.end());
      corners.push_back(std::move(of_cell));
      ++number[cells.kind(cell)];
    }
    out.begin("inside"); // which corners are: a bit each
    for (const auto& of_cell : corners) {
      int bits = 0;
      for (std::size_t k = 0; k < of_cell.size(); ++k)
        bits |= int(of_cell[k].first) << k;
      out.byte(bits);
    }
    out.begin("corners");
    Corner_writer writer(out);
    for (const auto& of_cell : corners)
      writer.write(of_cell);
    write_cells(out, "region", begin, end, [&](std::uint32_t c) { return region_number_.at(cells.region(c)); });
    write_cells(out, "branch", begin, end, [&](std::uint32_t c) { return mesh_.place_of_cell(c).branch; });
    out.begin("quality");
    std::vector<std::uint32_t> quality;
    for (std::size_t i = begin; i < end; ++i)
      quality.push_back(packed_quality(mesh_.quality_of_cell(cells_[i])));
    out.planes(quality, 2);
    write_points(out, vertices_.inner(), first_point);
    return packed(out, {{"points", vertices_.inner().size() - first_point}, {"cells", number}});
  }

  template <class F>
  void write_cells(Packed_stream& out, const char* section, std::size_t begin, std::size_t end, const F& value) const {
    std::vector<std::int64_t> values;
    for (std::size_t i = begin; i < end; ++i)
      values.push_back(std::int64_t(value(cells_[i])));
    out.begin(section);
    out.differences(values);
  }

  Json header(const Json& facets, const std::vector<Json>& chunks, std::size_t cells) const {
    const auto labels = [](const std::map<int, std::size_t>& numbers, const tubular::Label_names& names, auto color) {
      Json list = Json::array();
      for (const auto& n : numbers) {
        const auto name = names.find(n.first);
        list.push_back({{"label", n.first},
                        {"name", name == names.end() ? std::to_string(n.first) : name->second},
                        {"color", color(n.first).text()}});
      }
      return list;
    };
    const auto& o = quantization_.origin();
    Json header = {{"origin", {o.x, o.y, o.z}},
                   {"step", quantization_.step()},
                   {"facets", facets},
                   {"chunks", chunks},
                   {"cells", cells},
                   {"cells_of_mesh", mesh_.cells().size()},
                   {"patches", labels(patch_number_, mesh_.mesh().patch_names, color_of_patch)},
                   {"regions", labels(region_number_, mesh_.mesh().region_names, color_of_region)}};
    const auto from = Camera::best_direction(mesh_);
    header["from"] = {from.x, from.y, from.z};
    for (const Color& c : palette())
      header["palette"].push_back(c.text());
    for (const Color& c : color_scale())
      header["scale"].push_back(c.text());
    header["branches"] = branches();
    return header;
  }

  // Their lines: x, y, z, r of each point, in steps from the origin.
  Json branches() const {
    const auto& graph = mesh_.centerlines();
    const auto steps = [&](double x) { return std::lround(x / quantization_.step()); };
    Json list = Json::array();
    for (const auto& branch : graph.branches()) {
      Json numbers = Json::array();
      for (std::size_t i : branch.points) {
        const auto d = Shown_mesh::Vector(graph.points()[i]) - quantization_.origin();
        for (double x : {d.x, d.y, d.z, graph.radii()[i]})
          numbers.push_back(steps(x));
      }
      list.push_back(std::move(numbers));
    }
    return list;
  }

  const Shown_mesh& mesh_;
  Quantization quantization_;
  Vertex_numbers vertices_;
  std::vector<std::uint32_t> facets_, cells_; // in their order
  std::vector<std::uint32_t> number_of_cell_; // in that order, if it is packed
  std::map<int, std::size_t> patch_number_, region_number_;
};

} // namespace

Packed_scene pack_scene(const Shown_mesh& mesh, std::size_t most_bytes) {
  return Scene_packer(mesh).pack(most_bytes);
}
