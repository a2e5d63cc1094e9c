// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_GROWING_NUMBERING_H
#define CGAL_TUBULAR_MESHING_BASE_GROWING_NUMBERING_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Gives equal keys equal numbers, counted from 0 in the order in which they come: as Numbering, where it is not known
 * beforehand how many different ones there are. */
template <class Key, class Hash> class Growing_numbering {
public:
  typedef std::uint32_t Index;

  Growing_numbering()
      : slots_(1024, none) {}

  std::size_t size() const { return keys_.size(); }
  const Key& operator[](Index number) const { return keys_[number]; }

  Index number_of(const Key& key) {
    std::size_t slot = hash_(key) & (slots_.size() - 1);
    for (; slots_[slot] != none; slot = (slot + 1) & (slots_.size() - 1))
      if (keys_[slots_[slot]] == key)
        return slots_[slot];
    const Index number = slots_[slot] = Index(keys_.size());
    keys_.push_back(key);
    if (2 * keys_.size() > slots_.size())
      grow();
    return number;
  }

private:
  static constexpr Index none = Index(-1);

  void grow() {
    slots_.assign(2 * slots_.size(), none);
    for (Index number = 0; number < keys_.size(); ++number) {
      std::size_t slot = hash_(keys_[number]) & (slots_.size() - 1);
      while (slots_[slot] != none)
        slot = (slot + 1) & (slots_.size() - 1);
      slots_[slot] = number;
    }
  }

  Hash hash_;
  std::vector<Index> slots_; // a power of two
  std::vector<Key> keys_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_GROWING_NUMBERING_H
