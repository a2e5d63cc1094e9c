// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_SENTENCE_H
#define CGAL_TUBULAR_MESHING_BASE_SENTENCE_H

#include <array>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

typedef std::array<double, 3> Place; ///< coordinates in the unit of the surface

/*! \ingroup PkgTubularMeshingBase
 *
 * A message in which places stay coordinates until it is read: text, then a place and the text behind it, and so on.
 * The core works in a frame of the model's own; a sentence that comes from there is brought back by transform().
 */
class Sentence {
public:
  Sentence(const char* text)
      : text_(text) {}
  Sentence(std::string text)
      : text_(std::move(text)) {}
  explicit Sentence(const Place& place) { parts_.push_back({place, std::string()}); }

  /// The places that the sentence names, in their order.
  std::vector<Place> places() const {
    std::vector<Place> result;
    for (const Part& part : parts_)
      result.push_back(part.place);
    return result;
  }

  /// Replaces each place by `map(place)`.
  template <class Map> void transform(const Map& map) {
    for (Part& part : parts_)
      part.place = map(part.place);
  }

  std::string str() const {
    std::ostringstream s;
    s << text_;
    for (const Part& part : parts_)
      s << "(" << part.place[0] << ", " << part.place[1] << ", " << part.place[2] << ")" << part.text;
    return s.str();
  }

  Sentence& operator+=(const Sentence& next) {
    (parts_.empty() ? text_ : parts_.back().text) += next.text_;
    parts_.insert(parts_.end(), next.parts_.begin(), next.parts_.end());
    return *this;
  }
  friend Sentence operator+(Sentence a, const Sentence& b) { return a += b; }

private:
  struct Part {
    Place place;
    std::string text; ///< behind it
  };
  std::string text_; ///< before the first place
  std::vector<Part> parts_;
};

namespace internal {

// A place in a sentence: place_of(p), of a kernel's point or of three doubles.
template <class Point> auto place_of(const Point& p) -> decltype(p.x(), Sentence(Place())) {
  return Sentence(Place{{p.x(), p.y(), p.z()}});
}
template <class Vector> auto place_of(const Vector& v) -> decltype(v.x + 0., Sentence(Place())) {
  return Sentence(Place{{v.x, v.y, v.z}});
}

} // namespace internal
} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_BASE_SENTENCE_H
