// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the targets for readers share: the bytes of libFuzzer as a file of the format that `--format=EXT` names.

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

inline std::string& format() {
  static std::string extension;
  return extension;
}

inline const Scratch_file& scratch_file() {
  static const Scratch_file file(format());
  return file;
}

} // namespace fuzz

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  const std::string option = "--format=";
  for (int i = 1; i < *argc; ++i)
    if (std::string((*argv)[i]).compare(0, option.size(), option) == 0)
      fuzz::format() = (*argv)[i] + option.size();
  if (fuzz::format().empty()) {
    std::fprintf(stderr, "give %sEXTENSION, the format that the bytes are read as\n", option.c_str());
    std::exit(2);
  }
  return 0;
}

#endif // CGAL_TUBULAR_MESHING_FUZZED_FILE_H
