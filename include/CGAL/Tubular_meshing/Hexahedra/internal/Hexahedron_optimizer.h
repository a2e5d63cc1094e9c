// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_HEXAHEDRON_OPTIMIZER_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_HEXAHEDRON_OPTIMIZER_H

#include <CGAL/Tubular_meshing/Hexahedra/internal/Hexahedron_stars.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Sliding_surface.h>
#include <CGAL/Tubular_meshing/Hexahedra/internal/Star_energy.h>
#include <CGAL/Tubular_meshing/Hexahedra/Optimize_hexahedra_options.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/interruption.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Moves the vertices of hexahedra down the sum of what their corners count, see optimize_hexahedra(). Vertices are
 * visited color by color; one that has come to rest is visited again when one of its hexahedra has changed. */
class Hexahedron_optimizer {
public:
  typedef Hexahedron_stars::Index Index;

  Hexahedron_optimizer(Mixed_mesh& mesh, const Surface& surface, Face_patch_map patch,
                       const Optimize_hexahedra_options& options)
      : mesh_(mesh)
      , surface_(surface)
      , patch_(patch)
      , options_(options)
      , quality_(mesh.hexahedra.size()) {
    points_.reserve(mesh.points.size());
    for (const Point_3& p : mesh.points)
      points_.emplace_back(p);
  }

  /* The same with a surface that is ready. `slack`: how far off their patch vertices may be that lie on one alone;
   * those that are farther off when it begins come no nearer than they do by themselves. */
  Hexahedron_optimizer(Mixed_mesh& mesh, const Surface& surface, Face_patch_map patch,
                       const Optimize_hexahedra_options& options, const Sliding_surface& sliding, double slack)
      : Hexahedron_optimizer(mesh, surface, patch, options) {
    sliding_ = &sliding;
    slack_ = slack;
  }

  Optimize_hexahedra_report run() {
    const Summary before = measure_all();
    Summary after = before;
    if (before.below_wanted > 0) {
      after = attempt(before);
      if (is_spoilt_ && turned_over_ > 0)
        hold_and_try_again(before, after);
      if (is_worse(after, before))
        keep_all(before, after);
      else
        for (std::size_t v = 0; v < points_.size(); ++v)
          mesh_.points[v] = as<Point_3>(points_[v]);
    }
    report_.min_scaled_jacobian_before = before.least;
    report_.min_scaled_jacobian = after.least;
    report_.mean_scaled_jacobian_before = before.mean;
    report_.mean_scaled_jacobian = after.mean;
    report_.inverted_before = before.inverted;
    report_.inverted = after.inverted;
    report_.below_wanted_before = before.below_wanted;
    report_.below_wanted = after.below_wanted;
    return report_;
  }

private:
  static constexpr std::size_t chunk = 2048; // of hexahedra: sums are taken chunk by chunk, in order

  struct Summary {
    double least = 0, mean = 0;
    std::size_t inverted = 0, below_wanted = 0;
  };

  void keep_all(const Summary& before, Summary& after) {
    after = before;
    report_.held_vertices = 0;
  }

  // From where the vertices are; given up where vertices that have come onto the surface keep hexahedra inverted.
  Summary attempt(const Summary& before) {
    prepare();
    untangle();
    for (int power : {1, 2, 4, 8}) {
      improve(power);
      is_spoilt_ = power == 1 && !holds_ && turned_over_ > 0 && before.inverted == 0;
      if (is_spoilt_) {
        const Summary now = measure_all();
        if (now.inverted > 0)
          return now;
      }
    }
    is_spoilt_ = before.inverted == 0 && options_.target_lengths == nullptr && send_back(before.least);
    const Summary after = measure_all();
    is_spoilt_ = is_spoilt_ || is_worse(after, before);
    return after;
  }
  /* Vertices off the surface whose arrival there turns hexahedra over may spoil what is around them for good: then they
   * stay where they are. */
  void hold_and_try_again(const Summary& before, Summary& after) {
    std::vector<Vector_3d> first(points_.size());
    first.swap(points_);
    for (std::size_t v = 0; v < first.size(); ++v)
      points_[v] = Vector_3d(mesh_.points[v]);
    holds_ = true;
    measure_all();
    const Summary again = attempt(before);
    if (again.inverted < after.inverted || (again.inverted == after.inverted && again.least > after.least)) {
      after = again;
      report_.held_vertices = number_held_;
    } else
      points_.swap(first);
  }

  // Where the caller has lengths in mind these may be worth some quality.
  bool is_worse(const Summary& after, const Summary& before) const {
    return after.inverted > before.inverted ||
           (after.inverted == before.inverted && after.least < before.least && options_.target_lengths == nullptr);
  }
  /* Vertices of hexahedra that have become worse than the worst one was go back to where they came from, and then those
   * of hexahedra that this makes worse: so one place that gets no better does not take from all others what they have
   * won. Ends, as no hexahedron is worse whose vertices are all back. True if there were any. */
  bool send_back(double least) {
    bool were_any = false;
    for (bool is_done = false; !is_done;) {
      is_done = true;
      measure_all();
      for (std::size_t h = 0; h < number_of_hexahedra(); ++h)
        if (double(quality_[h]) < least)
          for (Index v : mesh_.hexahedra.vertices[h]) {
            const Vector_3d from(mesh_.points[v]);
            is_done = is_done && squared_norm(points_[v] - from) == 0;
            points_[v] = from;
          }
      were_any = were_any || !is_done;
    }
    return were_any;
  }
  struct Worst {
    double determinant, energy;
  };

  // --- hexahedra ---

  std::size_t number_of_hexahedra() const { return mesh_.hexahedra.size(); }

  Hexahedron_points corners(std::size_t h) const {
    Hexahedron_points p;
    for (std::size_t c = 0; c < 8; ++c)
      p[c] = points_[mesh_.hexahedra.vertices[h][c]];
    return p;
  }

  // Sets all qualities.
  Summary measure_all() {
    const std::size_t n = number_of_hexahedra();
    for_each_range(n, options_.number_of_threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t h = first; h < last; ++h)
        quality_[h] = float(least_scaled_jacobian(corners(h)));
    });
    Summary summary;
    summary.least = n == 0 ? 0 : quality_[0];
    for (float q : quality_) {
      summary.least = (std::min)(summary.least, double(q));
      summary.mean += q;
      summary.inverted += !(q > 0);
      summary.below_wanted += q < options_.quality_wanted;
    }
    summary.mean /= n == 0 ? 1. : double(n);
    return summary;
  }

  void set_lengths(std::size_t h) {
    Axis_lengths l = options_.target_lengths != nullptr ? (*options_.target_lengths)[h] : tempered_lengths(corners(h));
    for (double& x : l)
      x = 1 / x;
    inverse_lengths_[h] = l;
  }
  /* Cubes are the targets of tangled hexahedra, whose edges tell nothing of their proportions; in each tangle of one
   * size, that of its largest: ε begins high then, so that what has collapsed opens again. */
  void make_cubes(const std::vector<Index>& tangled) {
    std::vector<bool> is_to_do(number_of_hexahedra(), false);
    for (Index h : tangled)
      is_to_do[h] = true;
    std::vector<Index> tangle;
    for (Index first : tangled) {
      if (!is_to_do[first])
        continue;
      tangle.assign(1, first);
      is_to_do[first] = false;
      double size = 0;
      for (std::size_t k = 0; k < tangle.size(); ++k) {
        const Axis_lengths l = mean_edge_lengths(corners(tangle[k]));
        size = (std::max)(size, (l[0] + l[1] + l[2]) / 3);
        for (Index v : mesh_.hexahedra.vertices[tangle[k]])
          for (const auto& e : stars_(v))
            if (is_to_do[e.hexahedron()]) {
              is_to_do[e.hexahedron()] = false;
              tangle.push_back(Index(e.hexahedron()));
            }
      }
      for (Index h : tangle)
        inverse_lengths_[h].fill(size > 0 ? 1 / size : 1);
    }
  }
  Axis_lengths tempered_lengths(const Hexahedron_points& p) const {
    constexpr double thinnest = 1e-3; // of the longest: a hexahedron may be flat when it comes
    Axis_lengths l = mean_edge_lengths(p);
    const double longest = *std::max_element(l.begin(), l.end());
    if (!(longest > 0))
      return {1, 1, 1};
    for (double& x : l)
      x = (std::max)(x, thinnest * longest);
    const double g = std::cbrt(l[0] * l[1] * l[2]);
    for (double& x : l)
      x = g * std::pow(x / g, 1 - options_.tempering);
    return l;
  }

  // --- what may move ---

  void prepare() {
    stars_ = Hexahedron_stars(mesh_.hexahedra, mesh_.points.size());
    inverse_lengths_.resize(number_of_hexahedra());
    for_each_range(number_of_hexahedra(), options_.number_of_threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t h = first; h < last; ++h)
        set_lengths(h);
    });
    if (sliding_ == nullptr) {
      own_sliding_.reset(new Sliding_surface(surface_, patch_));
      sliding_ = own_sliding_.get();
    }
    locate();
    active_.clear();
    is_active_.assign(points_.size(), 0);
    epsilon_ = 1;
    must_visit_ = std::vector<std::atomic<std::uint8_t>>(points_.size());
  }

  void locate() {
    struct Patches {
      int label[2] = {0, 0};
      std::uint8_t number = 0;
      void add(int l) {
        if (number == 3 || (number > 0 && label[0] == l) || (number > 1 && label[1] == l))
          return;
        if (number < 2)
          label[number] = l;
        ++number;
      }
    };
    std::vector<Patches> patches(points_.size());
    const auto add = [&](const auto& facets) {
      for (std::size_t f = 0; f < facets.size(); ++f)
        for (Index v : facets.vertices[f])
          patches[v].add(facets.label[f]);
    };
    add(mesh_.triangles);
    add(mesh_.quads);
    slide_.assign(points_.size(), Slide());
    for (std::size_t v = 0; v < points_.size(); ++v) {
      const Patches& p = patches[v];
      if (p.number == 1)
        slide_[v] = sliding_->on_patch(p.label[0]);
      else if (p.number == 2 && !sliding_->is_rim_corner_at(points_[v]))
        slide_[v] = sliding_->on_rim(p.label[0], p.label[1]);
      else if (p.number > 1)
        slide_[v].dimension = 0;
      if (options_.fixed_vertices != nullptr && (*options_.fixed_vertices)[v])
        slide_[v].dimension = 0;
    }
    const auto fix = [&](const auto& cells) {
      for (const auto& c : cells.vertices)
        for (Index v : c)
          slide_[v].dimension = 0;
    };
    fix(mesh_.tetrahedra);
    fix(mesh_.pyramids);
    fix(mesh_.prisms);
  }

  /* Takes the vertices of hexahedra worse than a bound, and of the rings around them. False if there are none that may
   * move. */
  bool activate(double bound, int rings) {
    std::vector<Index> front;
    std::vector<std::uint8_t> reached(points_.size(), 0);
    const auto reach = [&](std::size_t h) {
      for (Index v : mesh_.hexahedra.vertices[h])
        if (!reached[v]) {
          reached[v] = 1;
          front.push_back(v);
        }
    };
    for (std::size_t h = 0; h < number_of_hexahedra(); ++h)
      if (quality_[h] < bound)
        reach(h);
    std::size_t done = 0;
    for (int ring = 0; ring < rings; ++ring)
      for (const std::size_t end = front.size(); done < end; ++done)
        for (const auto& e : stars_(front[done]))
          reach(e.hexahedron());
    active_.clear();
    std::vector<Index> arrived; // on the surface
    for (std::size_t v = 0; v < points_.size(); ++v) {
      if (!reached[v] || slide_[v].dimension == 0)
        continue;
      active_.push_back(Index(v));
      must_visit_[v].store(1, std::memory_order_relaxed);
      if (!is_active_[v] && slide_[v].dimension < 3)
        arrived.push_back(Index(v));
      is_active_[v] = 1;
    }
    bring_to_surface(arrived);
    colors_ = Vertex_colors(mesh_.hexahedra, stars_, active_);
    collect_hexahedra();
    report_.movable_vertices = (std::max)(report_.movable_vertices, active_.size());
    return !active_.empty();
  }

  void bring_to_surface(const std::vector<Index>& vertices) {
    if (slack_ > 0)
      return;
    std::vector<Vector_3d> target(vertices.size());
    for_each_range(vertices.size(), options_.number_of_threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k)
        target[k] = sliding_->nearest(slide_[vertices[k]], points_[vertices[k]]).point;
    });
    for (std::size_t k = 0; k < vertices.size(); ++k) {
      const Index v = vertices[k];
      const bool was_valid = is_valid_around(v);
      const Vector_3d from = std::exchange(points_[v], target[k]);
      if (!was_valid || is_valid_around(v))
        continue;
      ++turned_over_;
      if (holds_) {
        points_[v] = from;
        slide_[v].dimension = 0;
        ++number_held_;
      }
    }
    active_.erase(std::remove_if(active_.begin(), active_.end(), [&](Index v) { return slide_[v].dimension == 0; }),
                  active_.end());
  }

  bool is_valid_around(Index v) const {
    return std::all_of(stars_(v).begin(), stars_(v).end(),
                       [&](const auto& e) { return least_scaled_jacobian(corners(e.hexahedron())) > 0; });
  }

  // Those of active vertices.
  void collect_hexahedra() {
    active_hexahedra_.clear();
    std::vector<bool> is_taken(number_of_hexahedra(), false);
    for (Index v : active_)
      for (const auto& e : stars_(v))
        is_taken[e.hexahedron()] = true;
    for (std::size_t h = 0; h < number_of_hexahedra(); ++h)
      if (is_taken[h])
        active_hexahedra_.push_back(Index(h));
  }

  // --- moving ---

  void sweep(const Corner_penalty& penalty) {
    check_interruption();
    ++report_.sweeps;
    std::atomic<std::size_t> moved(0);
    colors_.for_each_range_of_color(options_.number_of_threads, [&](const Index* first, const Index* last) {
      Star_energy energy;
      std::size_t n = 0;
      for (; first != last; ++first)
        if (must_visit_[*first].exchange(0, std::memory_order_relaxed))
          n += relocate(*first, penalty, energy);
      moved.fetch_add(n, std::memory_order_relaxed);
    });
    moved_ = moved;
  }

  bool relocate(Index v, Corner_penalty penalty, Star_energy& energy) {
    energy.clear();
    for (const auto& e : stars_(v))
      energy.add_hexahedron(corners(e.hexahedron()), e.corner(), inverse_lengths_[e.hexahedron()]);
    if (energy.least_determinant() > barrier)
      penalty.epsilon = untangling_ ? penalty.epsilon : 0;
    const Vector_3d d = displacement(v, penalty, energy);
    if (!(squared_norm(d) > 0))
      return false;
    points_[v] += d;
    if (squared_norm(d) < rest * rest * energy.squared_shortest_edge())
      return false;
    for (const auto& e : stars_(v))
      for (Index w : mesh_.hexahedra.vertices[e.hexahedron()])
        must_visit_[w].store(1, std::memory_order_relaxed);
    return true;
  }

  // Down the energy, to a place where v may be.
  Vector_3d displacement(Index v, const Corner_penalty& penalty, const Star_energy& energy) const {
    const Slide& slide = slide_[v];
    const Vector_3d& x = points_[v];
    const Star_energy::Derivatives at = energy.derivatives(Vector_3d(), penalty);
    if (!(at.value < (std::numeric_limits<double>::infinity)()))
      return Vector_3d();
    Vector_3d step;
    const bool has_slack = slack_ > 0 && slide.dimension == 2;
    if (slide.dimension == 3 || has_slack)
      step = newton_step(at.hessian, at.gradient);
    else {
      const Vector_3d direction = sliding_->nearest(slide, x, energy.squared_longest_edge()).direction;
      step = slide.dimension == 2 ? tangential_step(at.hessian, at.gradient, direction)
                                  : step_along(at.hessian, at.gradient, direction);
    }
    const double longest2 = energy.squared_longest_edge(), length2 = squared_norm(step);
    if (length2 > longest2)
      step = std::sqrt(longest2 / length2) * step;
    double most = 0; // how far off its patch
    if (has_slack)
      most = (std::max)(slack_, norm(sliding_->nearest(slide, x).point - x));
    Vector_3d taken;
    backtrack(step, [&](const Vector_3d& s) {
      Vector_3d d = s;
      if (has_slack) {
        const Vector_3d place = sliding_->nearest(slide, x + s).point, off = x + s - place;
        const double distance = norm(off);
        if (distance > most)
          d = place + (most / distance) * off - x;
      } else if (slide.dimension < 3) {
        // a place further away than the step is long is on another part of the surface
        const Sliding_surface::Place place = sliding_->nearest(slide, x + s, squared_norm(s));
        if (!(squared_norm(place.direction) > 0))
          return false;
        d = place.point - x;
      }
      if (!(energy.value(d, penalty) < at.value))
        return false;
      taken = d;
      return true;
    });
    return taken;
  }

  // --- the stages ---

  Worst worst(const Corner_penalty& penalty) const {
    const std::size_t n = active_hexahedra_.size(), chunks = (n + chunk - 1) / chunk;
    std::vector<Worst> parts(chunks);
    for_each_task(chunks, options_.number_of_threads, [&](std::size_t c) {
      Worst part = {(std::numeric_limits<double>::infinity)(), 0};
      for (std::size_t k = c * chunk; k < (std::min)(n, (c + 1) * chunk); ++k) {
        const std::size_t h = active_hexahedra_[k];
        const Hexahedron_energy e = hexahedron_energy(corners(h), inverse_lengths_[h], penalty);
        part.determinant = (std::min)(part.determinant, e.least_determinant);
        part.energy += e.value;
      }
      parts[c] = part;
    });
    Worst all = {(std::numeric_limits<double>::infinity)(), 0};
    for (const Worst& p : parts) {
      all.determinant = (std::min)(all.determinant, p.determinant);
      all.energy += p.energy;
    }
    return all;
  }

  /* Where hexahedra are inverted: until none is, in a neighborhood that grows. */
  void untangle() {
    std::vector<Index> tangled;
    for (std::size_t h = 0; h < number_of_hexahedra(); ++h)
      if (!(quality_[h] > 0))
        tangled.push_back(Index(h));
    if (tangled.empty())
      return;
    if (options_.target_lengths == nullptr)
      make_cubes(tangled);
    constexpr int attempts = 3;
    constexpr double worst_quality = 0.02;
    bool done = false;
    for (int k = 0; k < attempts && !done; ++k) {
      const std::size_t last = active_.size();
      activate(worst_quality, (options_.number_of_rings + 1) << k);
      done = active_.size() == last || lower_epsilon();
      measure_all();
    }
    for (Index h : tangled)
      set_lengths(h);
  }

  /* Sweeps, in which ε is lowered whenever the energy has settled, by the rule of the paper: D is the worst determinant,
   * σ how far the energy has come down, a tenth at least, and μ = (1 − σ) χ(D) is what χ(D) becomes. Whether no corner
   * is inverted any more. */
  bool lower_epsilon() {
    constexpr double settled = 0.03, least_part = 0.1;
    constexpr int patience = 40; // sweeps without the worst corner getting better
    Corner_penalty penalty;
    penalty.epsilon = 1;
    untangling_ = true;
    Worst now = worst(penalty);
    double at_epsilon = now.energy, best = now.determinant;
    for (int k = 0, last = 0; k < options_.untangling_sweeps && k < last + patience && !(now.determinant > barrier);
         ++k) {
      visit_all();
      sweep(penalty);
      const Worst next = worst(penalty);
      const bool is_settled = next.energy > (1 - settled) * now.energy;
      now = next;
      if (now.determinant > best) {
        best = now.determinant;
        last = k;
      }
      if (!is_settled)
        continue;
      const double part = (std::max)(least_part, 1 - now.energy / at_epsilon);
      const double aim = (1 - part) * penalty.chi(now.determinant);
      penalty.epsilon = now.determinant < aim ? 2 * std::sqrt(aim * (aim - now.determinant)) : penalty.epsilon / 2;
      now = worst(penalty);
      at_epsilon = now.energy;
    }
    untangling_ = false;
    epsilon_ = penalty.epsilon;
    return now.determinant > barrier;
  }

  void visit_all() {
    for (Index v : active_)
      must_visit_[v].store(1, std::memory_order_relaxed);
  }

  // Sweeps until nearly all vertices have come to rest, or for long enough.
  void improve(int power) {
    measure_all();
    if (!activate(options_.quality_wanted, options_.number_of_rings))
      return;
    Corner_penalty penalty;
    penalty.power = power;
    penalty.epsilon = epsilon_;
    moved_ = active_.size();
    for (int k = 0; k < options_.number_of_sweeps && moved_ > active_.size() / 200; ++k)
      sweep(penalty);
  }

  static constexpr double barrier = 1e-12; // what D must be for a corner to count as not inverted
  static constexpr double rest = 1e-2;     // a vertex has come to rest whose step is this part of its shortest edge

  Mixed_mesh& mesh_;
  const Surface& surface_;
  Face_patch_map patch_;
  const Optimize_hexahedra_options& options_;
  Optimize_hexahedra_report report_;

  Hexahedron_stars stars_;
  std::vector<Vector_3d> points_;
  std::vector<float> quality_; // of each hexahedron, its least scaled Jacobian
  std::vector<Axis_lengths> inverse_lengths_;
  std::unique_ptr<Sliding_surface> own_sliding_;
  const Sliding_surface* sliding_ = nullptr;
  double slack_ = 0;         // how far vertices may be off their patch
  std::vector<Slide> slide_; // of each vertex

  std::vector<Index> active_, active_hexahedra_;
  std::vector<std::uint8_t> is_active_;
  std::vector<std::atomic<std::uint8_t>> must_visit_;
  Vertex_colors colors_;
  std::size_t moved_ = 0;
  double epsilon_ = 1;     // of corners that are still inverted
  bool is_spoilt_ = false; // by vertices that got worse
  bool holds_ = false;     // vertices off the surface
  std::size_t number_held_ = 0;
  std::size_t turned_over_ = 0; // vertices that turned hexahedra over on arrival
  bool untangling_ = false;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INTERNAL_HEXAHEDRON_OPTIMIZER_H
