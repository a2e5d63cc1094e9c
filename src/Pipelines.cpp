// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Pipelines/Mesher_impl.h>
#include <CGAL/Tubular_meshing/Pipelines/Sampled_estimator_impl.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model_impl.h>
#include <CGAL/Tubular_meshing/Pipelines/join_parts_impl.h>
