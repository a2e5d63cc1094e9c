// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_BATCH_DIGEST_H
#define TUBULAR_MESH_BATCH_DIGEST_H

#include <cstdint>
#include <cstdio>
#include <string>

/* 16 hexadecimal digits that tell one text from others: FNV-1a, of 64 bits (Fowler, Noll, Vo). Against chance, not against
 * malice. */
inline std::string digest(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (char c : text)
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

#endif // TUBULAR_MESH_BATCH_DIGEST_H
