// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The bytes of libFuzzer as a file, since readers read files.

#ifndef CGAL_TUBULAR_MESHING_FUZZED_FILE_H
#define CGAL_TUBULAR_MESHING_FUZZED_FILE_H

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <unistd.h>

namespace fuzz {

/* A file in memory where the system has a place for such, with an extension, as readers go by it. Gone at the end of
 * the process, but for one that crashes. */
class Scratch_file {
public:
  explicit Scratch_file(const std::string& extension) {
    namespace fs = std::filesystem;
    const fs::path memory = "/dev/shm";
    std::string pattern = ((fs::exists(memory) ? memory : fs::temp_directory_path()) / "tubular_fuzz_XXXXXX").string();
    if (!mkdtemp(pattern.data())) {
      std::perror("no scratch directory");
      std::exit(2);
    }
    directory_ = pattern;
    name_ = directory_ + "/input." + extension;
  }
  ~Scratch_file() {
    std::error_code ignored;
    std::filesystem::remove_all(directory_, ignored);
  }

  const std::string& name() const { return name_; }
  void write(const std::uint8_t* data, std::size_t size) const { write(name_, data, size); }
  // A file of the same name with another extension.
  void write_companion(const char* extension, const std::uint8_t* data, std::size_t size) const {
    write(directory_ + "/input." + extension, data, size);
  }
  void remove_companion(const char* extension) const {
    std::error_code ignored;
    std::filesystem::remove(directory_ + "/input." + extension, ignored);
  }

private:
  static void write(const std::string& name, const std::uint8_t* data, std::size_t size) {
    std::FILE* out = std::fopen(name.c_str(), "wb");
    if (!out || std::fwrite(data, 1, size, out) != size || std::fclose(out) != 0) {
      std::perror(name.c_str());
      std::exit(2);
    }
  }

  std::string directory_, name_;
};

} // namespace fuzz

#endif // CGAL_TUBULAR_MESHING_FUZZED_FILE_H
