// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The named parameters of the package, in the manner of CGAL's parameters_interface.h: included several times, with
// CGAL_TUBULAR_MESHING_PARAMETER defined by the includer. Hence no include guard.

// sizing
CGAL_TUBULAR_MESHING_PARAMETER(points_per_circumference)
CGAL_TUBULAR_MESHING_PARAMETER(min_size)
CGAL_TUBULAR_MESHING_PARAMETER(max_size)
CGAL_TUBULAR_MESHING_PARAMETER(gradation)

// centerlines
CGAL_TUBULAR_MESHING_PARAMETER(merge_tolerance)
CGAL_TUBULAR_MESHING_PARAMETER(loops)
CGAL_TUBULAR_MESHING_PARAMETER(seeds)

// openings
CGAL_TUBULAR_MESHING_PARAMETER(inlet)
CGAL_TUBULAR_MESHING_PARAMETER(centerline_graph)

// flow extensions
CGAL_TUBULAR_MESHING_PARAMETER(extension_length)
CGAL_TUBULAR_MESHING_PARAMETER(min_extension_length)
CGAL_TUBULAR_MESHING_PARAMETER(extended_openings)

// cutting
CGAL_TUBULAR_MESHING_PARAMETER(aspect_ratio)

// filling
CGAL_TUBULAR_MESHING_PARAMETER(facet_distance)
CGAL_TUBULAR_MESHING_PARAMETER(optimization_passes)
CGAL_TUBULAR_MESHING_PARAMETER(keep_boundary)
CGAL_TUBULAR_MESHING_PARAMETER(time_limit)

// files
CGAL_TUBULAR_MESHING_PARAMETER(format)
CGAL_TUBULAR_MESHING_PARAMETER(face_patch_map)

// running
CGAL_TUBULAR_MESHING_PARAMETER(number_of_threads)
CGAL_TUBULAR_MESHING_PARAMETER(observer)

// generators
CGAL_TUBULAR_MESHING_PARAMETER(capped_ends)
CGAL_TUBULAR_MESHING_PARAMETER(noise)
CGAL_TUBULAR_MESHING_PARAMETER(noise_seed)
CGAL_TUBULAR_MESHING_PARAMETER(sag)
CGAL_TUBULAR_MESHING_PARAMETER(sag_shape)

// surfaces
CGAL_TUBULAR_MESHING_PARAMETER(embedding)

// repair
CGAL_TUBULAR_MESHING_PARAMETER(repair_mode)
CGAL_TUBULAR_MESHING_PARAMETER(smooth)

// curvature
CGAL_TUBULAR_MESHING_PARAMETER(local_radius)
CGAL_TUBULAR_MESHING_PARAMETER(smoothing_radius)

// metrics
CGAL_TUBULAR_MESHING_PARAMETER(boundary_layer_thickness)
CGAL_TUBULAR_MESHING_PARAMETER(first_height)
CGAL_TUBULAR_MESHING_PARAMETER(growth)
CGAL_TUBULAR_MESHING_PARAMETER(smoothing_ratio)
CGAL_TUBULAR_MESHING_PARAMETER(curvature_points)
CGAL_TUBULAR_MESHING_PARAMETER(max_anisotropy)
