// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_BATCH_RUN_BATCH_H
#define TUBULAR_MESH_BATCH_RUN_BATCH_H

#include "../../command_line/exit_status.h"
#include "../Options.h"

#include <string>

/* Meshes all surfaces of a folder or a table, several at a time, each by a process of its own, which starts this program
 * again; and writes the index. Started again it goes on where it stopped. Returns some_failed where a surface has failed;
 * throws an Error where the batch as a whole cannot be done. */
command_line::Exit_status run_batch(const Options& options, const std::string& version, const std::string& program);

#endif // TUBULAR_MESH_BATCH_RUN_BATCH_H
