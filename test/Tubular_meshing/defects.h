// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The defects that surfaces come with, made at three severities from clean ones.

#ifndef CGAL_TUBULAR_MESHING_TEST_DEFECTS_H
#define CGAL_TUBULAR_MESHING_TEST_DEFECTS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace defects {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef std::array<std::size_t, 3> Triangle;
namespace tubular = CGAL::Tubular_meshing;

struct Soup {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
};

inline Soup soup_of(const Mesh& mesh) {
  Soup soup;
  soup.points.assign(mesh.points().begin(), mesh.points().end());
  for (auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    soup.triangles.push_back(
        {std::size_t(mesh.source(h)), std::size_t(mesh.target(h)), std::size_t(mesh.target(mesh.next(h)))});
  }
  return soup;
}

/* A clean surface, and what the makers of defects need to know of it. */
struct Clean_surface {
  std::string name;
  double points; ///< per circumference
  Mesh mesh;
  Soup soup;
  std::vector<bool> near_rim; ///< by vertex: within a few edges of an opening
  std::vector<double> edge;   ///< by vertex: the mean length of its edges
  std::vector<Vector> normal; ///< by vertex: outward
  std::size_t openings = 0;
  long handles = 0;
  unsigned draw = 0; ///< vertex() gives others for another one

  Clean_surface(const std::string& name, const tubular::Tubular_skeleton& skeleton, double points = 16)
      : name(name)
      , points(points)
      , openings(skeleton.number_of_openings())
      , handles(long(skeleton.number_of_loops())) {
    tubular::generate_tubular_surface(skeleton, mesh, tubular::parameters::points_per_circumference(points));
    mesh.collect_garbage();
    soup = soup_of(mesh);
    measure();
  }

  /* The radius of the vessel at a vertex: the length of the edges there tells. */
  double radius(std::size_t v) const { return edge[v] * points / (2 * CGAL_PI); }

  /* A vertex of the wall, far from the rims, that only depends on the number. */
  std::size_t vertex(unsigned number) const {
    std::mt19937 random(number + 1 + 1000 * draw);
    for (;;) {
      const std::size_t v = random() % soup.points.size();
      if (!near_rim[v])
        return v;
    }
  }

  std::vector<std::size_t> triangles_at(std::size_t v) const {
    std::vector<std::size_t> around;
    for (auto f : CGAL::faces_around_target(mesh.halfedge(Mesh::Vertex_index(unsigned(v))), mesh))
      around.push_back(std::size_t(f));
    return around;
  }

  std::set<std::size_t> triangles_around(std::size_t v, int rings) const {
    std::set<std::size_t> all;
    for (std::size_t f : triangles_at(v))
      all.insert(f);
    for (int i = 1; i < rings; ++i) {
      std::set<std::size_t> more = all;
      for (std::size_t f : all)
        for (std::size_t w : soup.triangles[f])
          for (std::size_t g : triangles_at_or_rim(w))
            more.insert(g);
      all.swap(more);
    }
    return all;
  }

private:
  std::vector<std::size_t> triangles_at_or_rim(std::size_t v) const {
    std::vector<std::size_t> around;
    for (auto f : CGAL::faces_around_target(mesh.halfedge(Mesh::Vertex_index(unsigned(v))), mesh))
      if (f != Mesh::null_face())
        around.push_back(std::size_t(f));
    return around;
  }

  void measure() {
    near_rim.assign(soup.points.size(), false);
    edge.assign(soup.points.size(), 0);
    normal.assign(soup.points.size(), Vector(0, 0, 0));
    for (auto v : mesh.vertices()) {
      for (auto w : CGAL::vertices_around_target(mesh.halfedge(v), mesh))
        edge[v] += std::sqrt(CGAL::squared_distance(mesh.point(v), mesh.point(w))) / double(mesh.degree(v));
      near_rim[v] = mesh.is_border(v);
    }
    for (int ring = 0; ring < 6; ++ring) {
      std::vector<bool> wider = near_rim;
      for (auto e : mesh.edges()) {
        const auto v = mesh.vertex(e, 0), w = mesh.vertex(e, 1);
        if (near_rim[v] || near_rim[w])
          wider[v] = wider[w] = true;
      }
      near_rim.swap(wider);
    }
    for (const Triangle& t : soup.triangles) {
      const Vector n =
          CGAL::cross_product(soup.points[t[1]] - soup.points[t[0]], soup.points[t[2]] - soup.points[t[0]]);
      for (std::size_t v : t)
        normal[v] = normal[v] + n;
    }
    for (Vector& n : normal)
      n = n / std::sqrt(n.squared_length());
  }
};

inline const std::vector<Clean_surface>& clean_surfaces() {
  static const std::vector<Clean_surface> all = {
      Clean_surface("tube", tubular::straight_tube(10, 1)), Clean_surface("y", tubular::y_bifurcation()),
      Clean_surface("arch", tubular::aortic_arch()), Clean_surface("loop", tubular::willis_loop())};
  return all;
}

// --- what the makers share ---

inline void remove_triangles(Soup& soup, const std::set<std::size_t>& gone) {
  std::vector<Triangle> kept;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    if (!gone.count(f))
      kept.push_back(soup.triangles[f]);
  soup.triangles.swap(kept);
}

inline void append_ball(Soup& soup, const Point& center, double radius, int parallels, int meridians) {
  std::vector<std::vector<std::size_t>> rings;
  const std::size_t south = soup.points.size(), north = south + 1;
  soup.points.push_back(center - radius * Vector(0, 0, 1));
  soup.points.push_back(center + radius * Vector(0, 0, 1));
  for (int k = 1; k < parallels; ++k) {
    rings.emplace_back();
    for (int i = 0; i < meridians; ++i) {
      const double u = 2 * CGAL_PI * i / meridians, v = CGAL_PI * k / parallels;
      rings.back().push_back(soup.points.size());
      soup.points.push_back(center +
                            radius * Vector(std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), -std::cos(v)));
    }
  }
  for (int i = 0; i < meridians; ++i) {
    const int j = (i + 1) % meridians;
    soup.triangles.push_back({south, rings[0][j], rings[0][i]});
    soup.triangles.push_back({north, rings.back()[i], rings.back()[j]});
    for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
      soup.triangles.push_back({rings[k][i], rings[k][j], rings[k + 1][j]});
      soup.triangles.push_back({rings[k][i], rings[k + 1][j], rings[k + 1][i]});
    }
  }
}

// Gives the triangles on one side of a plane through a vertex, within a reach, points of their own, and returns for
// each new point the old one.
inline std::map<std::size_t, std::size_t> cut_along_plane(Soup& soup, const Point& origin, const Vector& normal,
                                                          double reach) {
  std::map<std::size_t, bool> above, below; // the points used on each side
  std::vector<std::size_t> upper;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const Triangle& t = soup.triangles[f];
    const Point c = CGAL::centroid(soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
    const bool is_above = (c - origin) * normal > 0 && CGAL::squared_distance(c, origin) < reach * reach;
    for (std::size_t v : t)
      (is_above ? above : below)[v] = true;
    if (is_above)
      upper.push_back(f);
  }
  std::map<std::size_t, std::size_t> twin, old;
  for (const auto& v : above)
    if (below.count(v.first)) {
      twin[v.first] = soup.points.size();
      old[soup.points.size()] = v.first;
      soup.points.push_back(soup.points[v.first]);
    }
  for (std::size_t f : upper)
    for (std::size_t& v : soup.triangles[f])
      if (twin.count(v))
        v = twin.at(v);
  return old;
}

// --- the defects; severity is 0, 1 or 2 ---

typedef Soup (*Maker)(const Clean_surface&, int severity);

// The corners of few, many, or all triangles become points of their own.
inline Soup duplicate_points(const Clean_surface& s, int severity) {
  Soup soup = s.soup;
  const std::size_t step = severity == 0 ? 50 : severity == 1 ? 3 : 1;
  for (std::size_t f = 0; f < soup.triangles.size(); f += step)
    for (std::size_t& v : soup.triangles[f]) {
      soup.points.push_back(soup.points[v]);
      v = soup.points.size() - 1;
    }
  return soup;
}

inline Soup duplicate_triangles(const Clean_surface& s, int severity) {
  Soup soup = s.soup;
  const std::size_t n = soup.triangles.size(), step = severity == 0 ? n - 1 : severity == 1 ? 7 : 1;
  for (std::size_t f = 0; f < n; f += step) {
    Triangle t = soup.triangles[f];
    if (f % 2 == 0)
      std::swap(t[0], t[1]);
    soup.triangles.push_back(t);
  }
  return soup;
}

inline Soup turned_triangles(const Clean_surface& s, int severity) {
  Soup soup = s.soup;
  std::mt19937 random(5);
  const unsigned percent = severity == 0 ? 1 : severity == 1 ? 20 : 50;
  for (Triangle& t : soup.triangles)
    if (random() % 100 < percent)
      std::swap(t[0], t[1]);
  std::shuffle(soup.triangles.begin(), soup.triangles.end(), random);
  return soup;
}

// All triangles, all of them and some turned back, all of them and half of them turned back.
inline Soup inside_out(const Clean_surface& s, int severity) {
  Soup soup = s.soup;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    if (severity == 0 || f % (severity == 1 ? 50 : 2) != 1)
      std::swap(soup.triangles[f][0], soup.triangles[f][1]);
  return soup;
}

// A fin of one triangle; twenty fins inside and outside; and a membrane across the vessel.
inline Soup nonmanifold_edges(const Clean_surface& s, int severity) {
  Soup soup = s.soup;
  for (unsigned i = 0; i < (severity == 0 ? 1u : 20u); ++i) {
    const std::size_t v = s.vertex(i);
    const Triangle t = s.soup.triangles[s.triangles_at(v)[0]];
    soup.points.push_back(CGAL::midpoint(soup.points[t[0]], soup.points[t[1]]) +
                          (i % 2 == 0 ? 0.5 : -0.5) * s.edge[v] * s.normal[v]);
    soup.triangles.push_back({t[0], t[1], soup.points.size() - 1});
  }
  if (severity < 2)
    return soup;
  // the disk over a closed curve of edges round the vessel: the border of the faces on one side of a plane there
  const auto h = *std::find_if(s.mesh.halfedges().begin(), s.mesh.halfedges().end(),
                               [&](Mesh::Halfedge_index h) { return s.mesh.is_border(h); });
  std::set<Mesh::Face_index> ring;
  std::vector<Mesh::Halfedge_index> front;
  for (auto b : CGAL::halfedges_around_face(h, s.mesh))
    for (auto f : CGAL::faces_around_target(b, s.mesh))
      if (f != Mesh::null_face())
        ring.insert(f);
  for (int i = 0; i < 8; ++i) {
    const std::set<Mesh::Face_index> inner = ring;
    for (auto f : inner)
      for (auto v : CGAL::vertices_around_face(s.mesh.halfedge(f), s.mesh))
        for (auto g : CGAL::faces_around_target(s.mesh.halfedge(v), s.mesh))
          if (g != Mesh::null_face())
            ring.insert(g);
  }
  for (auto f : ring)
    for (auto side : CGAL::halfedges_around_face(s.mesh.halfedge(f), s.mesh))
      if (!s.mesh.is_border(s.mesh.opposite(side)) && !ring.count(s.mesh.face(s.mesh.opposite(side))))
        front.push_back(side);
  Vector sum(0, 0, 0);
  for (auto side : front)
    sum = sum + (s.mesh.point(s.mesh.target(side)) - CGAL::ORIGIN);
  soup.points.push_back(CGAL::ORIGIN + sum / double(front.size()));
  for (auto side : front)
    soup.triangles.push_back(
        {std::size_t(s.mesh.source(side)), std::size_t(s.mesh.target(side)), soup.points.size() - 1});
  return soup;
}

// Tetrahedra that touch the wall in a point: one, ten; and holes that touch in a point.
inline Soup nonmanifold_points(const Clean_surface& s, int severity) {
  Soup soup = s.soup;
  for (unsigned i = 0; i < (severity == 0 ? 1u : 10u); ++i) {
    const std::size_t v = s.vertex(i), n = soup.points.size();
    const Point& p = s.soup.points[v];
    const double d = 0.4 * s.edge[v];
    const Vector up = s.normal[v];
    const Vector side = CGAL::cross_product(up, std::abs(up.x()) < 0.5 ? Vector(1, 0, 0) : Vector(0, 1, 0));
    soup.points.push_back(p + d * up + d * side);
    soup.points.push_back(p + d * up - d * side);
    soup.points.push_back(p + d * up + d * CGAL::cross_product(up, side));
    for (const Triangle& t :
         {Triangle{v, n, n + 1}, Triangle{v, n + 1, n + 2}, Triangle{v, n + 2, n}, Triangle{n, n + 2, n + 1}})
      soup.triangles.push_back(t);
  }
  if (severity == 2)
    for (unsigned i = 20; i < 23; ++i) {
      const auto around = s.triangles_at(s.vertex(i));
      soup.triangles[around[0]] = soup.triangles[around[around.size() / 2]] = {0, 0, 0};
    }
  return soup;
}

// Triangles without area where an edge has a vertex too many; corners drawn onto the opposite edge; many of both.
inline Soup needle_triangles(const Clean_surface& s, int severity) {
  Soup soup = s.soup;
  for (unsigned i = 0; i < (severity == 0 ? 1u : severity == 1 ? 5u : 20u); ++i) {
    const std::size_t v = s.vertex(i);
    const std::size_t f = s.triangles_at(v)[0];
    const Triangle t = soup.triangles[f];
    if (t != s.soup.triangles[f])
      continue;
    // a point very near a corner, or on an edge, splits the triangle into three
    const Vector a = soup.points[t[1]] - soup.points[t[0]], b = soup.points[t[2]] - soup.points[t[0]];
    const std::size_t n = soup.points.size();
    soup.points.push_back(soup.points[t[0]] + (i % 2 == 0 ? 1e-6 * (a + b) : 0.5 * a + 1e-7 * b));
    soup.triangles[f] = {t[0], t[1], n};
    soup.triangles.push_back({t[1], t[2], n});
    soup.triangles.push_back({t[2], t[0], n});
  }
  return soup;
}

// A speck inside, several inside and outside, and another vessel beside.
inline Soup islands(const Clean_surface& s, int severity) {
  Soup soup = s.soup;
  for (unsigned i = 0; i < (severity == 0 ? 1u : 9u); ++i) {
    const std::size_t v = s.vertex(i);
    append_ball(soup, s.soup.points[v] + (i % 2 == 0 ? -0.5 : 0.6) * s.radius(v) * s.normal[v], 0.15 * s.radius(v), 5,
                7);
  }
  if (severity == 2) {
    const std::size_t n = soup.points.size();
    const double beside = 100 * s.radius(s.vertex(0));
    for (const Point& p : s.soup.points)
      soup.points.push_back(Point(0.5 * p.x() + beside, 0.5 * p.y(), 0.5 * p.z()));
    for (const Triangle& t : s.soup.triangles)
      soup.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
  return soup;
}

// A triangle missing; several vertices missing; a hole of about half the vessel's width.
inline Soup pinholes(const Clean_surface& s, int severity) {
  Soup soup = s.soup;
  std::set<std::size_t> gone;
  for (unsigned i = 0; i < (severity == 1 ? 5u : 1u); ++i) {
    const std::size_t v = s.vertex(i);
    if (severity == 0)
      gone.insert(s.triangles_at(v)[0]);
    else
      for (std::size_t f : s.triangles_around(v, severity))
        gone.insert(f);
  }
  remove_triangles(soup, gone);
  return soup;
}

// A cut across the vessel of which the sides are apart by a thousandth, a twentieth, a sixth of an edge; the last one
// with other points on one side.
inline Soup seam_gaps(const Clean_surface& s, int severity) {
  Soup soup = s.soup;
  const std::size_t v = s.vertex(3);
  const Vector across = CGAL::cross_product(s.normal[v], Vector(0.6, 0.5, 0.63));
  const auto old = cut_along_plane(soup, s.soup.points[v], across, 1.3 * s.radius(v));
  std::mt19937 random(9);
  std::uniform_real_distribution<double> noise(-1, 1);
  const double width = severity == 0 ? 1e-3 : severity == 1 ? 0.05 : 0.1;
  for (const auto& twin : old) {
    const Vector offset(noise(random), noise(random), noise(random));
    soup.points[twin.first] = soup.points[twin.first] + width * s.edge[twin.second] * offset;
  }
  if (severity == 2) { // split every other edge of one side
    std::size_t number = 0;
    const std::size_t n = soup.triangles.size();
    for (std::size_t f = 0; f < n; ++f)
      for (int k = 0; k < 3; ++k) {
        const Triangle t = soup.triangles[f];
        if (!old.count(t[k]) || !old.count(t[(k + 1) % 3]) || old.count(t[(k + 2) % 3]) || number++ % 2 == 0)
          continue;
        const std::size_t middle = soup.points.size();
        soup.points.push_back(soup.points[t[k]] + 0.4 * (soup.points[t[(k + 1) % 3]] - soup.points[t[k]]));
        soup.triangles[f] = {t[k], middle, t[(k + 2) % 3]};
        soup.triangles.push_back({middle, t[(k + 1) % 3], t[(k + 2) % 3]});
        break;
      }
  }
  return soup;
}

// One vertex pushed through its neighbours; ten; a spike through the opposite wall.
inline Soup self_intersections(const Clean_surface& s, int severity) {
  Soup soup = s.soup;
  for (unsigned i = 0; i < (severity == 1 ? 10u : 1u); ++i) {
    const std::size_t v = s.vertex(i);
    const Triangle t = s.soup.triangles[s.triangles_at(v)[0]];
    const std::size_t w = t[0] == v ? t[1] : t[0];
    soup.points[v] =
        severity < 2 ? s.soup.points[v] + 2.6 * (s.soup.points[w] - s.soup.points[v]) - 0.1 * s.edge[v] * s.normal[v]
                     : s.soup.points[v] - 2.7 * s.radius(v) * s.normal[v];
  }
  return soup;
}

// A vertex laid over the neighbouring triangle, just above it; ten; a whole ring of triangles pushed over the next.
inline Soup folds(const Clean_surface& s, int severity) {
  Soup soup = s.soup;
  for (unsigned i = 0; i < (severity == 1 ? 10u : 1u); ++i) {
    const std::size_t v = s.vertex(i);
    const Triangle t = s.soup.triangles[s.triangles_at(v)[0]];
    const std::size_t a = t[0] == v ? t[1] : t[0], b = t[2] == v ? t[1] : t[2];
    const Vector over = CGAL::midpoint(s.soup.points[a], s.soup.points[b]) - s.soup.points[v];
    if (severity < 2)
      soup.points[v] = s.soup.points[v] + 1.4 * over + 0.08 * s.edge[v] * s.normal[v];
    else
      for (std::size_t f : s.triangles_at(v))
        for (std::size_t w : s.soup.triangles[f])
          soup.points[w] = s.soup.points[w] + 2.2 * over + 0.15 * s.edge[v] * s.normal[v];
  }
  if (severity == 2) // each vertex once
    for (std::size_t v = 0; v < soup.points.size(); ++v) {
      const Vector d = soup.points[v] - s.soup.points[v];
      const double l = std::sqrt(d.squared_length()), most = 2 * s.edge[v];
      if (l > most)
        soup.points[v] = s.soup.points[v] + most / l * d;
    }
  return soup;
}

// Bulges of the wall: a blister into the lumen up to the opposite wall, nearly touching it; touching it; through it.
inline Soup touching_vessels(const Clean_surface& s, int severity) {
  Soup soup = s.soup;
  const std::size_t v = s.vertex(1);
  const double depth = (severity == 0 ? 1.8 : severity == 1 ? 2.0 : 2.2) * s.radius(v);
  for (std::size_t w = 0; w < soup.points.size(); ++w) {
    const double d2 = CGAL::squared_distance(s.soup.points[v], s.soup.points[w]) / CGAL::square(s.radius(v));
    if (s.normal[w] * s.normal[v] > 0.3 && d2 < 4)
      soup.points[w] = soup.points[w] - depth * std::exp(-4 * d2) * s.normal[v];
  }
  return soup;
}

// Three-sided tunnels through the lumen, from a triangle of the wall to one opposite: as where two vessels touch and
// have been made one. One, two and three of them.
inline Soup fused_vessels(const Clean_surface& s, int severity) {
  Soup soup = s.soup;
  std::set<std::size_t> taken; // vertices
  for (unsigned number = 40, made = 0; made <= unsigned(severity); ++number) {
    const std::size_t v = s.vertex(number), f = s.triangles_at(v)[0];
    const Triangle a = s.soup.triangles[f];
    const Point aim = s.soup.points[v] - 2 * s.radius(v) * s.normal[v];
    std::size_t w = 0;
    for (std::size_t i = 0; i < s.soup.points.size(); ++i)
      if (CGAL::squared_distance(s.soup.points[i], aim) < CGAL::squared_distance(s.soup.points[w], aim))
        w = i;
    if (s.near_rim[w] || s.normal[w] * s.normal[v] > -0.95 ||
        CGAL::squared_distance(s.soup.points[w], aim) > CGAL::square(0.3 * s.radius(v)))
      continue;
    const std::size_t g = s.triangles_at(w)[0];
    Triangle b = s.soup.triangles[g];
    if (std::any_of(a.begin(), a.end(), [&](std::size_t i) { return taken.count(i) > 0; }) ||
        std::any_of(b.begin(), b.end(), [&](std::size_t i) { return taken.count(i) > 0; }))
      continue;
    for (std::size_t h : s.triangles_around(v, 3))
      taken.insert(s.soup.triangles[h].begin(), s.soup.triangles[h].end());
    for (std::size_t h : s.triangles_around(w, 3))
      taken.insert(s.soup.triangles[h].begin(), s.soup.triangles[h].end());
    std::swap(b[1], b[2]); // seen from the other side; turned until it fits
    const auto twist = [&](int k) {
      double sum = 0;
      for (int i = 0; i < 3; ++i)
        sum += CGAL::squared_distance(s.soup.points[a[i]], s.soup.points[b[(i + k) % 3]]);
      return sum;
    };
    int best = 0;
    for (int k = 1; k < 3; ++k)
      best = twist(k) < twist(best) ? k : best;
    std::rotate(b.begin(), b.begin() + best, b.end());
    soup.triangles[f] = soup.triangles[g] = {0, 0, 0};
    for (int i = 0; i < 3; ++i) {
      soup.triangles.push_back({a[i], a[(i + 1) % 3], b[(i + 1) % 3]});
      soup.triangles.push_back({a[i], b[(i + 1) % 3], b[i]});
    }
    ++made;
  }
  return soup;
}

inline Soup noise(const Clean_surface& s, int severity) {
  Soup soup = s.soup;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> amplitude(-1, 1);
  const double most = severity == 0 ? 0.05 : severity == 1 ? 0.2 : 0.35;
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    soup.points[v] = soup.points[v] + most * amplitude(random) * s.edge[v] * s.normal[v];
  return soup;
}

struct Defect {
  std::string name;
  Maker make;
};

inline const std::vector<Defect>& all_defects() {
  static const std::vector<Defect> all = {{"duplicate points", duplicate_points},
                                          {"duplicate triangles", duplicate_triangles},
                                          {"turned triangles", turned_triangles},
                                          {"inside out", inside_out},
                                          {"nonmanifold edges", nonmanifold_edges},
                                          {"nonmanifold points", nonmanifold_points},
                                          {"needle triangles", needle_triangles},
                                          {"islands", islands},
                                          {"pinholes", pinholes},
                                          {"seam gaps", seam_gaps},
                                          {"self-intersections", self_intersections},
                                          {"folds", folds},
                                          {"touching walls", touching_vessels},
                                          {"fused vessels", fused_vessels},
                                          {"noise", noise}};
  return all;
}

/* Three different defects at once, at other places each, of severities up to 1. In this order each one finds the
 * triangles that it looks for: first those that move points, then those that add and split triangles, those that remove
 * some, and at last those that concern all. */
inline Soup three_defects(Clean_surface s, unsigned seed, std::string& names) {
  const std::vector<Defect> in_order = {{"noise", noise},
                                        {"self-intersections", self_intersections},
                                        {"folds", folds},
                                        {"seam gaps", seam_gaps},
                                        {"needle triangles", needle_triangles},
                                        {"nonmanifold edges", nonmanifold_edges},
                                        {"nonmanifold points", nonmanifold_points},
                                        {"islands", islands},
                                        {"pinholes", pinholes},
                                        {"duplicate points", duplicate_points},
                                        {"duplicate triangles", duplicate_triangles},
                                        {"turned triangles", turned_triangles},
                                        {"inside out", inside_out}};
  std::mt19937 random(seed);
  std::set<std::size_t> chosen;
  while (chosen.size() < 3)
    chosen.insert(random() % in_order.size());
  for (std::size_t i : chosen) {
    const int severity = int(random() % 2);
    s.draw = random() % 100000;
    s.soup = in_order[i].make(s, severity);
    names += (names.empty() ? "" : ", ") + in_order[i].name + " " + std::to_string(severity);
  }
  return s.soup;
}

} // namespace defects

#endif // CGAL_TUBULAR_MESHING_TEST_DEFECTS_H
