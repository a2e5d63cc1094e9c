// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_OUTPUT_FOLDER_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_OUTPUT_FOLDER_IMPL_H

#include <CGAL/Tubular_meshing/IO/Output_file_impl.h>
#include <CGAL/Tubular_meshing/IO/Output_folder.h>
#include <CGAL/Tubular_meshing/IO/unfinished_outputs.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>

namespace CGAL::Tubular_meshing::IO {

CGAL_TUBULAR_MESHING_INLINE Output_folder::Output_folder(const std::string& folder, Belongs belongs)
    : name_(folder)
    , belongs_(belongs) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::path path = fs::path(folder).lexically_normal();
  if (path.filename().empty()) // behind a slash
    path = path.parent_path();
  if (path.filename().empty() || path.filename() == "." || path.filename() == "..")
    fail("it is not the name of a folder that can be replaced");
  target_ = internal::without_links(path);
  if (fs::exists(target_, error))
    check_existing();
  try {
    make_parents();
    make_temporary();
  } catch (...) {
    discard(); // a constructor that throws has no destructor
    throw;
  }
}

// All that is there has to be of the kind that is written, so that nothing of the user's goes.
CGAL_TUBULAR_MESHING_INLINE void Output_folder::check_existing() {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::is_directory(target_, error))
    fail("its format needs a folder, and there is a file of that name");
  for (fs::recursive_directory_iterator it(target_, error), end; !error && it != end; it.increment(error)) {
    const fs::path inside = it->path().lexically_relative(target_);
    const bool is_folder = it->symlink_status(error).type() == fs::file_type::directory; // a link to one is none
    if (!is_folder && !belongs_(inside))
      fail("there is a folder of that name with other files, as \"" + inside.string() +
           "\", which would be lost; give another name or move them");
  }
  if (error)
    fail(error.message());
}

CGAL_TUBULAR_MESHING_INLINE void Output_folder::make_parents() {
  namespace fs = std::filesystem;
  std::error_code error;
  std::vector<fs::path> missing;
  for (fs::path p = target_.parent_path(); !p.empty() && !fs::exists(p, error); p = p.parent_path())
    missing.push_back(p);
  for (auto p = missing.rbegin(); p != missing.rend(); ++p) {
    const Commit_guard guard;
    const bool is_new = fs::create_directory(*p, error);
    if (error)
      fail(error.message());
    if (is_new) {
      parents_.push_back(*p);
      internal::add_unfinished(*p);
    }
  }
}

CGAL_TUBULAR_MESHING_INLINE std::filesystem::path Output_folder::sibling(int i) const {
  return target_.parent_path() / (".tubular_meshing_" + std::to_string(i) + ".partial");
}

// The first free of a thousand names: what a killed process left behind is not in the way.
CGAL_TUBULAR_MESHING_INLINE void Output_folder::make_temporary() {
  const Commit_guard guard;
  std::error_code error;
  for (int i = 0; i < 1000 && temporary_.empty(); ++i) {
    if (std::filesystem::create_directory(sibling(i), error)) {
      temporary_ = sibling(i);
      internal::add_unfinished(temporary_);
    } else if (error && error != std::errc::file_exists)
      fail(error.message());
  }
  if (temporary_.empty())
    fail("too many temporary folders are beside it");
}

CGAL_TUBULAR_MESHING_INLINE std::filesystem::path Output_folder::unused_sibling() const {
  namespace fs = std::filesystem;
  std::error_code error;
  int i = 0;
  while (i < 1000 && fs::exists(fs::symlink_status(sibling(i), error)))
    ++i;
  return sibling(i);
}

CGAL_TUBULAR_MESHING_INLINE Output_file& Output_folder::file(const std::string& path) {
  close();
  const std::filesystem::path file = temporary_ / path;
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  if (error)
    fail(error.message());
  file_ = std::make_unique<Output_file>(file.string(), (std::filesystem::path(name_) / path).string());
  return *file_;
}

CGAL_TUBULAR_MESHING_INLINE void Output_folder::close() {
  if (file_)
    file_->commit();
  file_.reset();
}

CGAL_TUBULAR_MESHING_INLINE void Output_folder::finish() {
  close();
}

CGAL_TUBULAR_MESHING_INLINE void Output_folder::commit() {
  namespace fs = std::filesystem;
  finish();
  if (temporary_.empty())
    return;
  const Commit_guard guard;
  std::error_code error;
  fs::path old;
  if (fs::exists(target_, error)) {
    check_existing(); // it may have come meanwhile
    old = unused_sibling();
    fs::rename(target_, old, error);
    if (error)
      fail(error.message());
  }
  fs::rename(temporary_, target_, error);
  if (error) {
    const std::string reason = error.message();
    if (!old.empty())
      fs::rename(old, target_, error);
    fail(reason);
  }
  forget();
  if (!old.empty())
    fs::remove_all(old, error);
}

CGAL_TUBULAR_MESHING_INLINE void Output_folder::discard() noexcept {
  std::error_code ignored;
  file_.reset();
  if (!temporary_.empty())
    std::filesystem::remove_all(temporary_, ignored);
  for (auto p = parents_.rbegin(); p != parents_.rend(); ++p)
    std::filesystem::remove(*p, ignored); // where it is empty
  forget();
}

// There is nothing to be removed any more.
CGAL_TUBULAR_MESHING_INLINE void Output_folder::forget() noexcept {
  if (!temporary_.empty())
    internal::forget_unfinished(temporary_);
  for (const std::filesystem::path& p : parents_)
    internal::forget_unfinished(p);
  temporary_.clear();
  parents_.clear();
}

[[noreturn]] CGAL_TUBULAR_MESHING_INLINE void Output_folder::fail(const std::string& reason) {
  discard();
  throw Output_error("The folder \"" + name_ + "\" cannot be written (" + reason +
                     "); check its name, its permissions and the free space.");
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_OUTPUT_FOLDER_IMPL_H
