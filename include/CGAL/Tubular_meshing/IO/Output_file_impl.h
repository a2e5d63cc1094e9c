// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_OUTPUT_FILE_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_OUTPUT_FILE_IMPL_H

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/IO/unfinished_outputs.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

// The file that a chain of symbolic links leads to, which need not exist.
inline std::filesystem::path without_links(std::filesystem::path file) {
  namespace fs = std::filesystem;
  std::error_code error;
  for (int i = 0; i < 40 && fs::is_symlink(fs::symlink_status(file, error)); ++i) {
    const fs::path next = fs::read_symlink(file, error);
    file = next.is_absolute() ? next : file.parent_path() / next;
  }
  return file;
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Output_file::Output_file(const std::string& file, const std::string& name)
    : name_(name) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (file.empty() || fs::is_directory(status))
    fail("it is not the name of a file");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    open(file, "wb");
    return;
  }
  target_ = internal::without_links(file).string();
  if (fs::exists(status))
    check_existing();
  open_temporary();
  if (fs::exists(status))
    fs::permissions(temporary_, status.permissions(), error);
}

CGAL_TUBULAR_MESHING_INLINE void Output_file::write(std::string_view bytes) {
  if (!bytes.empty() && std::fwrite(bytes.data(), 1, bytes.size(), stream_.get()) != bytes.size())
    fail_with_errno();
}

CGAL_TUBULAR_MESHING_INLINE Output_file& Output_file::companion(const std::string& file) {
  companions_.push_back(std::make_unique<Output_file>(file));
  return *companions_.back();
}

CGAL_TUBULAR_MESHING_INLINE std::string Output_file::name_for_library() {
  if (is_direct())
    fail("it is not a regular file, which its format needs");
  stream_.reset();
  return temporary_;
}

CGAL_TUBULAR_MESHING_INLINE void Output_file::finish() {
  if (stream_) {
    errno = 0;
    const bool flushed = std::fflush(stream_.get()) == 0;
    const int reason = errno;
    const bool closed = std::fclose(stream_.release()) == 0;
    if (!flushed)
      errno = reason;
    if (!flushed || !closed)
      fail_with_errno();
  }
  for (const auto& c : companions_)
    c->finish();
}

CGAL_TUBULAR_MESHING_INLINE void Output_file::commit() {
  finish();
  for (const auto& c : companions_)
    c->commit();
  if (temporary_.empty())
    return;
  const Commit_guard guard;
  std::error_code error;
  std::filesystem::rename(temporary_, target_, error);
  if (error)
    fail(error.message());
  internal::forget_unfinished(temporary_);
  temporary_.clear();
}

// Renaming would replace a file that is write-protected; opening it for writing tells, and changes nothing.
CGAL_TUBULAR_MESHING_INLINE void Output_file::check_existing() {
  errno = 0;
  const std::unique_ptr<std::FILE, Close> existing(std::fopen(target_.c_str(), "r+b"));
  if (!existing)
    fail_with_errno();
}

CGAL_TUBULAR_MESHING_INLINE void Output_file::open(const std::string& file, const char* mode) {
  errno = 0;
  stream_.reset(std::fopen(file.c_str(), mode));
  if (!stream_)
    fail_with_errno();
}

// The first free of a thousand names: what a killed process left behind is not in the way.
CGAL_TUBULAR_MESHING_INLINE void Output_file::open_temporary() {
  const Commit_guard guard;
  for (int i = 0; !stream_; ++i) {
    const std::filesystem::path file =
        std::filesystem::path(target_).parent_path() / (".tubular_meshing_" + std::to_string(i) + ".partial");
    errno = 0;
    stream_.reset(std::fopen(file.string().c_str(), "wbx"));
    if (stream_) {
      temporary_ = file.string();
      internal::add_unfinished(temporary_);
    } else if (errno != EEXIST || i == 1000)
      fail_with_errno();
  }
}

CGAL_TUBULAR_MESHING_INLINE void Output_file::discard() noexcept {
  stream_.reset();
  std::error_code ignored;
  if (!temporary_.empty()) {
    std::filesystem::remove(temporary_, ignored);
    internal::forget_unfinished(temporary_);
  }
  temporary_.clear();
}

[[noreturn]] CGAL_TUBULAR_MESHING_INLINE void Output_file::fail_with_errno() {
  fail(errno != 0 ? std::strerror(errno) : "unknown reason");
}

[[noreturn]] CGAL_TUBULAR_MESHING_INLINE void Output_file::fail(const std::string& reason) {
  discard();
  throw Output_error("The file \"" + name_ + "\" cannot be written (" + reason +
                     "); check its directory, its permissions and the free space.");
}

CGAL_TUBULAR_MESHING_INLINE void check_writable(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
    return;
  Output_file probe(file);
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_OUTPUT_FILE_IMPL_H
