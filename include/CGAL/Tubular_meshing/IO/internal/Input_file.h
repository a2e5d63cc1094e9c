// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_INPUT_FILE_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_INPUT_FILE_H

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

namespace CGAL::Tubular_meshing::IO::internal {

// Lower-case letters behind the last dot of the file's name, without the dot.
inline std::string extension_of(const std::string& file) {
  std::string ext = std::filesystem::path(file).extension().string();
  if (!ext.empty())
    ext.erase(0, 1);
  for (char& c : ext)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ext;
}

inline std::string quoted(const std::string& file) {
  return '"' + file + '"';
}

// A whole file in memory: what a reader allocates is bounded by what is really there, not by what a header says.
struct Input_file {
  std::string name;
  std::string bytes;

  explicit Input_file(const std::string& file)
      : name(file) {
    errno = 0;
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> in(std::fopen(file.c_str(), "rb"), &std::fclose);
    if (!in)
      fail("cannot be opened (" + std::string(std::strerror(errno)) + "); check its name and permissions");
    reserve_for(file);
    char chunk[1 << 16];
    std::size_t n;
    while ((n = std::fread(chunk, 1, sizeof chunk, in.get())) > 0)
      bytes.append(chunk, n);
    if (std::ferror(in.get()))
      fail("cannot be read (" + std::string(std::strerror(errno)) + ")");
    if (bytes.empty())
      fail("is empty; export it again");
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw Input_error("The file " + quoted(name) + " " + what + ".");
  }

private:
  void reserve_for(const std::string& file) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored))
      bytes.reserve(std::filesystem::file_size(file, ignored));
  }
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_INPUT_FILE_H
