# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Run as a script by the tests fuzz/*: a fixed number of inputs, the same each time. Nothing is written but failures.

file(GLOB seeds ${SEEDS}/*)
if(NOT seeds)
  message(FATAL_ERROR "There are no seeds in ${SEEDS}")
endif()
list(SORT seeds)
list(JOIN seeds "," seeds)
set(ENV{ASAN_OPTIONS} quarantine_size_mb=16)
set(ENV{UBSAN_OPTIONS} print_stacktrace=1)
execute_process(
  COMMAND ${FUZZER} --reader=${READER} -seed_inputs=${seeds} -dict=${WORDS} -seed=1 -runs=${RUNS} -max_len=4096
          -rss_limit_mb=1024 -malloc_limit_mb=64 -timeout=10 -verbosity=0 -artifact_prefix=${FAILURES}/
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${output}\nThe reader failed (${result}); the input is in ${FAILURES}")
endif()
