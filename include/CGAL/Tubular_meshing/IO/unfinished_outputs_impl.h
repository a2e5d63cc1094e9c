// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_UNFINISHED_OUTPUTS_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_UNFINISHED_OUTPUTS_IMPL_H

#include <CGAL/Tubular_meshing/IO/unfinished_outputs.h>

#include <algorithm>
#include <system_error>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

struct Unfinished_outputs {
  std::recursive_mutex mutex;
  std::vector<std::filesystem::path> paths; // what was made first comes first
};

// Never destroyed: outputs of static lifetime may end later.
inline Unfinished_outputs& unfinished_outputs() {
  static Unfinished_outputs& all = *new Unfinished_outputs;
  return all;
}

CGAL_TUBULAR_MESHING_INLINE void add_unfinished(const std::filesystem::path& path) {
  std::error_code ignored; // the folder may be another one when it is removed
  unfinished_outputs().paths.push_back(std::filesystem::absolute(path, ignored));
}

CGAL_TUBULAR_MESHING_INLINE void forget_unfinished(const std::filesystem::path& path) noexcept {
  Unfinished_outputs& all = unfinished_outputs();
  const std::lock_guard<std::recursive_mutex> lock(all.mutex);
  std::error_code ignored;
  const auto found = std::find(all.paths.begin(), all.paths.end(), std::filesystem::absolute(path, ignored));
  if (found != all.paths.end())
    all.paths.erase(found);
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Commit_guard::Commit_guard()
    : lock_(internal::unfinished_outputs().mutex) {}

CGAL_TUBULAR_MESHING_INLINE void remove_unfinished_outputs() {
  internal::Unfinished_outputs& all = internal::unfinished_outputs();
  all.mutex.lock(); // for good
  std::error_code ignored;
  for (auto path = all.paths.rbegin(); path != all.paths.rend(); ++path)
    std::filesystem::is_directory(*path, ignored) && path->extension() == ".partial"
        ? std::filesystem::remove_all(*path, ignored)
        : std::uintmax_t(std::filesystem::remove(*path, ignored)); // of folders above, those that are empty
  all.paths.clear();
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_UNFINISHED_OUTPUTS_IMPL_H
