// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_TEST_TOOL_REFUSALS_H
#define TUBULAR_MESHING_TEST_TOOL_REFUSALS_H

// What the command-line tool has to refuse: command lines that nobody can obey, on files that nobody can mesh.

#include "test_tool_bad_files.h"

#include <ostream>
#include <string>
#include <vector>

namespace tool_test {

/* A run that has to be refused: with what status, what its sentence has to mention, and how the tool is called, see
 * arguments_of(). */
struct Refusal {
  const char* name;
  Exit_status status;
  Arguments mentioned;
  std::string command_line;
};

inline std::ostream& operator<<(std::ostream& out, const Refusal& r) {
  return out << r.name; // ctest's name of the test
}

inline std::string with(const std::string& options) {
  return "IN/tube.off -c IN/lines.vtk -o OUT/mesh.vtu " + options;
}
inline std::string alone(const std::string& surface, const std::string& options = "") {
  return "IN/" + surface + " -o OUT/mesh.vtu " + options;
}
inline std::string on(const std::string& surface) {
  return "IN/" + surface + " -c IN/lines.vtk -o OUT/mesh.vtu";
}
inline std::string along(const std::string& centerlines) {
  return "IN/tube.off -c IN/" + centerlines + " -o OUT/mesh.vtu";
}
inline std::string both(const std::string& name) {
  return "IN/" + name + ".off -c IN/" + name + ".vtk -o OUT/mesh.vtu";
}
inline std::string to(const std::string& mesh) {
  return "IN/tube.off -c IN/lines.vtk -o " + mesh;
}

inline std::vector<Refusal> usage_errors() {
  return {
      {"No_arguments", usage, {"Surface"}, ""},
      {"No_output", usage, {"--output"}, "IN/tube.off -c IN/lines.vtk"},
      {"Unknown_option", usage, {"--colour"}, with("--colour")},
      {"Two_surfaces", usage, {"b.stl"}, with("b.stl")},
      {"No_points", usage, {"-points"}, with("-n 0")},
      {"Negative_points", usage, {"-points"}, with("-n -20")},
      {"Points_in_letters", usage, {"-points", "abc"}, with("-n abc")},
      {"Points_and_letters", usage, {"-points", "20mm"}, with("-n 20mm")},
      {"Points_not_a_number", usage, {"points"}, with("-n nan")},
      {"Number_missing", usage, {"-points"}, with("-n")},
      {"Integer_missing", usage, {"--threads", "value"}, with("--threads")},
      {"Points_twice", usage, {"-points", "more than once"}, with("-n 20 -n 30")},
      {"Negative_size", usage, {"--min-size"}, with("--min-size -1")},
      {"Size_zero", usage, {"--max-size"}, with("--max-size 0")},
      {"Size_not_a_number", usage, {"size"}, with("--max-size nan")},
      {"Sizes_reversed", usage, {"--min-size", "--max-size"}, with("--min-size 0.5 --max-size 0.4")},
      {"Gradation_below_one", usage, {"--gradation"}, with("--gradation 0.9")},
      {"Inlet_of_two_numbers", usage, {"--inlet"}, with("--inlet 1,2")},
      {"Inlet_not_a_number", usage, {"inlet"}, with("--inlet nan,0,0")},
      {"Inlet_and_more", usage, {"--inlet"}, with("--inlet 1,2,3,4")},
      {"Outlet_without_inlet", usage, {"--outlet", "--inlet"}, alone("tube.off", "--outlet 1,2,3")},
      {"Outlet_in_letters", usage, {"--outlet", "a,b,c"}, alone("tube.off", "--inlet 0,0,0 --outlet a,b,c")},
      {"Outlet_beside_centerlines", usage, {"--outlet", "--centerlines"}, with("--inlet 0,0,0 --outlet 0,0,6")},
      {"Seeds_beside_centerlines", usage, {"--seeds", "--centerlines"}, with("--seeds IN/seeds.txt")},
      {"Seeds_beside_inlet", usage, {"--seeds", "--inlet"}, alone("tube.off", "--inlet 0,0,0 --seeds IN/seeds.txt")},
      {"Loops_of_given_centerlines", usage, {"--loops", "--centerlines"}, with("--loops")},
      {"No_loops_of_given_centerlines", usage, {"--no-loops", "--centerlines"}, with("--no-loops")},
      {"Loops_and_none", usage, {"--loops", "--no-loops"}, alone("tube.off", "--loops --no-loops")},
      {"Repair_unknown", usage, {"--repair", "please"}, with("--repair please")},
      {"Extensions_negative", usage, {"--flow-extensions"}, alone("tube.off", "--flow-extensions -3")},
      {"Extensions_beside_centerlines", usage, {"--flow-extensions"}, with("--flow-extensions 3")},
      {"Extensions_beside_seeds",
       usage,
       {"--flow-extensions"},
       alone("tube.off", "--seeds IN/seeds.txt --flow-extensions 3")},
      {"Output_over_the_seeds", usage, {"seeds.txt"}, alone("tube.off", "--seeds IN/seeds.txt --report IN/seeds.txt")},
      {"Negative_threads", usage, {"--threads"}, with("--threads -1")},
      {"Quiet_and_verbose", usage, {"--quiet"}, with("-q -v")},
      {"Mixed_by_Mesh_3", usage, {"Mesh_3", "quads"}, with("-t mixed --volume-mesher mesh_3")},
      {"Order_zero", usage, {"order 1 or 2", "not 0"}, with("--order 0")},
      {"Order_three", usage, {"order 1 or 2", "not 3"}, with("--order 3")},
      {"Order_in_letters", usage, {"--order", "two"}, with("--order two")},
      {"Complete_elements_of_first_order", usage, {"--order-2-complete", "--order 2"}, with("--order-2-complete")},
      {"Surface_of_second_order", usage, {"--order 2", "cells"}, "IN/tube.off -o OUT/s.stl -t surface --order 2"},
      {"Second_order_for_SU2", usage, {"SU2", "--order 2"}, to("OUT/mesh.su2 --order 2")},
      {"Second_order_for_OpenFOAM", usage, {"OpenFOAM", "--order 2"}, to("OUT/case --format openfoam --order 2")},
      {"Second_order_in_a_mesh_file", usage, {".mesh", "--order 2"}, to("OUT/mesh.mesh --order 2")},
      {"Quadratic_pyramids_for_CalculiX", usage, {"pyramids", "--type"}, to("OUT/mesh.inp --order 2 -t mixed")},
      {"Complete_pyramids_for_VTK",
       usage,
       {"pyramids", "--order-2-complete"},
       with("--order 2 --order-2-complete -t mixed")},
      {"Complete_hexahedra_for_CalculiX",
       usage,
       {"27 nodes", "--order-2-complete"},
       to("OUT/mesh.inp --order 2 --order-2-complete -t hexahedral")},
      {"Quadratic_prisms_for_svMultiPhysics",
       usage,
       {"prisms", "--wall-elements"},
       to("OUT/tube-mesh-complete --order 2 --wall 0.2")},
      {"Wall_of_no_thickness", usage, {"--wall"}, with("--wall 0")},
      {"Wall_without_layers", usage, {"--wall-layers"}, with("--wall 0.2 --wall-layers 0")},
      {"Wall_layers_without_a_wall", usage, {"--wall-layers", "--wall"}, with("--wall-layers 3")},
      {"Wall_growth_negative", usage, {"--wall-growth"}, with("--wall 0.2 --wall-growth -1")},
      {"Wall_elements_unknown", usage, {"--wall-elements", "cubes"}, with("--wall 0.2 --wall-elements cubes")},
      {"Second_wall_alone", usage, {"--second-wall", "--wall"}, with("--second-wall 0.1")},
      {"Second_walls_layers_alone", usage, {"--second-wall-layers"}, with("--wall 0.2 --second-wall-layers 2")},
      {"Wall_in_two_measures", usage, {"--wall-thickness"}, with("--wall 0.2 --wall-thickness 0.3")},
      {"Wall_by_array_and_table",
       usage,
       {"--wall-thickness-array"},
       with("--wall-thickness-array a --wall-thickness-table IN/t.csv")},
      {"Wall_of_negative_length", usage, {"--wall-thickness"}, with("--wall-thickness -0.1")},
      {"Materials_without_a_wall", usage, {"--material-array", "--wall"}, with("--material-array m")},
      {"Fibres_without_a_wall", usage, {"--fibres", "--wall"}, with("--fibres")},
      {"Fibres_for_SU2", usage, {"fibres", ".vtu"}, to("OUT/m.su2 --wall 0.2 --fibres")},
      {"Sections_of_unknown_format", usage, {"s.txt", ".csv"}, with("--write-sections OUT/s.txt")},
      {"Zero_d_model_of_unknown_format", usage, {"z.xml", ".json"}, with("--write-0d OUT/z.xml --length-unit mm")},
      {"Unit_without_a_model", usage, {"--length-unit", "--write-0d"}, with("--length-unit mm")},
      {"Unit_unknown", usage, {"--length-unit", "inch"}, with("--write-0d OUT/z.json --length-unit inch")},
      {"Density_of_nothing", usage, {"--density"}, with("--write-0d OUT/z.json --length-unit mm --density 0")},
      {"Pressure_without_Murray",
       usage,
       {"--mean-pressure", "--murray"},
       with("--write-0d OUT/z.json --length-unit mm --mean-pressure 1e4")},
      {"Section_spacing_of_nothing", usage, {"--section-spacing", "--write-sections"}, with("--section-spacing 1")},
      {"Page_of_a_dry_run", usage, {"page", ".json"}, with("--dry-run --report OUT/r.htm")},
      {"Section_spacing_too_small", usage, {"--section-spacing"}, with("--section-spacing 0.001")},
      {"Mixed_wall_of_tetrahedra",
       usage,
       {"hexahedra", "isotropic"},
       with("-t mixed --wall 0.2 --wall-elements tetrahedra")},
      {"Hexahedral_wall_of_tetrahedra",
       usage,
       {"hexahedra", "isotropic"},
       with("-t hexahedral --wall 0.2 --wall-elements tetrahedra")},
      {"Hex_method_unknown", usage, {"--hex-method", "magic"}, with("-t hexahedral --hex-method magic")},
      {"Hex_fallback_unknown", usage, {"--hex-fallback", "magic"}, with("-t hexahedral --hex-fallback magic")},
      {"Hex_fallback_of_pyramids_for_a_solver",
       usage,
       {"pyramids", "--hex-fallback mixed"},
       to("mesh-complete") + " -t hexahedral --hex-fallback mixed"},
      {"Blocks_of_tetrahedra", usage, {"--write-blocks", "hexahedral"}, with("--write-blocks blocks.vtu")},
      {"Blocks_of_subdivision",
       usage,
       {"--write-blocks", "blocks"},
       with("-t hexahedral --hex-method subdivision --write-blocks blocks.vtu")},
      {"Blocks_in_a_text", usage, {"blocks.txt", ".vtu"}, with("-t hexahedral --write-blocks blocks.txt")},
      {"Blocks_of_a_solver", usage, {"polyMesh", ".vtu"}, with("-t hexahedral --write-blocks polyMesh")},
      {"Hex_method_of_tetrahedra", usage, {"--hex-method", "hexahedral"}, with("--hex-method subdivision")},
      {"Hexahedral_layers_on_Mesh_3",
       usage,
       {"parametric"},
       with("-t hexahedral --surface-mesher mesh_3 --boundary-layer-prisms 3")},
      {"Surface_elements_unknown", usage, {"--surface-elements"}, with("--surface-elements hexagons")},
      {"Surface_elements_of_a_volume", usage, {"--surface-elements", "mixed"}, with("--surface-elements quads")},
      {"No_layers_inside", usage, {"--boundary-layer-prisms"}, with("--boundary-layer-prisms 0")},
      {"Anisotropic_with_prisms", usage, {"--boundary-layer-prisms"}, with("-t anisotropic --boundary-layer-prisms 3")},
      {"Prisms_on_Mesh_3", usage, {"parametric"}, with("--surface-mesher mesh_3 --boundary-layer-prisms 3")},
      {"Layer_of_no_thickness", usage, {"--boundary-layer"}, with("-t anisotropic --boundary-layer 0")},
      {"First_height_negative", usage, {"--first-height"}, with("-t anisotropic --first-height -1")},
      {"Growth_below_one", usage, {"--growth"}, with("-t anisotropic --growth 0.5")},
      {"Smoothing_ratio_below_one", usage, {"--smoothing-ratio"}, with("-t anisotropic --smoothing-ratio 0.5")},
      {"Too_few_curvature_points", usage, {"--curvature-points"}, with("-t anisotropic --curvature-points 2")},
      {"Anisotropic_by_Mesh_3", usage, {"parametric"}, with("-t anisotropic --surface-mesher mesh_3")},
      {"Type_unknown", usage, {"cubic", "isotropic"}, with("-t cubic")},
      {"Surface_mesher_unknown", usage, {"--surface-mesher", "magic"}, with("--surface-mesher magic")},
      {"Volume_mesher_unknown", usage, {"--volume-mesher", "magic"}, with("--volume-mesher magic")},
      {"Tetgen_without_a_surface_to_keep",
       usage,
       {"tetgen", "--surface-mesher"},
       with("--surface-mesher mesh_3 --volume-mesher tetgen")},
      {"Prisms_filled_by_Mesh_3",
       usage,
       {"Mesh_3", "tetgen"},
       with("--volume-mesher mesh_3 --boundary-layer-prisms 3")},
      {"Surface_by_Mesh_3", usage, {"Mesh_3", "parametric"}, with("-t surface --surface-mesher mesh_3")},
      {"Surface_with_a_volume_mesher",
       usage,
       {"--volume-mesher", "surface"},
       with("-t surface --volume-mesher mesh_3")},
      {"Surface_with_a_wall", usage, {"--wall", "surface"}, to("OUT/s.vtp") + " -t surface --wall 0.2"},
      {"Surface_as_a_mesh", usage, {"mesh.vtu", ".vtp"}, with("-t surface")},
      {"Output_of_unknown_format", usage, {"mesh.stl", ".vtu"}, to("OUT/mesh.stl")},
      {"Output_without_format", usage, {"out/mesh", ".vtu"}, to("OUT/mesh")},
      {"Output_without_name", usage, {".vtu"}, to("''")},
      {"Output_in_missing_directory", usage, {"nowhere/mesh.vtu"}, to("OUT/nowhere/mesh.vtu")},
      {"Output_is_a_directory", usage, {"folder.vtu"}, to("OUT/folder.vtu")},
      {"Output_below_a_file", usage, {"file/mesh.vtu"}, to("OUT/file/mesh.vtu")},
      {"Report_in_missing_directory", usage, {"nowhere/r.json"}, with("--report OUT/nowhere/r.json")},
      {"Surface_in_missing_directory", usage, {"nowhere/s.vtp"}, with("--write-surface OUT/nowhere/s.vtp")},
      {"Surface_of_unknown_format", usage, {"s.xyz", ".vtp"}, with("--write-surface OUT/s.xyz")},
      {"Centerlines_of_unknown_format", usage, {"c.stl", ".vtp"}, with("--write-centerlines OUT/c.stl")},
      {"Output_named_twice", usage, {"a.vtp"}, with("--write-surface OUT/a.vtp --write-centerlines OUT/a.vtp")},
      {"Output_spelled_twice", usage, {"a.vtp"}, with("--write-surface OUT/a.vtp --write-centerlines OUT/./a.vtp")},
      {"Output_over_the_surface", usage, {"tube.off"}, with("--write-surface IN/tube.off")},
      {"Output_over_the_surface_respelled", usage, {"tube.off"}, with("--write-surface IN/./tube.off")},
  };
}

inline std::vector<Refusal> file_errors() {
  return {
      {"Missing_surface", input, {"absent.stl"}, on("absent.stl")},
      {"Empty_surface", input, {"empty.stl", "empty"}, on("empty.stl")},
      {"Directory_as_surface", input, {"folder.stl"}, on("folder.stl")},
      {"Text_as_surface", input, {"letter.stl"}, on("letter.stl")},
      {"Surface_of_unknown_format", input, {"surface.docx", ".stl"}, on("surface.docx")},
      {"Binary_STL_cut_off", input, {"cut.stl"}, on("cut.stl")},
      {"Binary_STL_without_triangles", input, {"no_triangles.stl"}, on("no_triangles.stl")},
      {"Binary_STL_cut_off_in_its_header", input, {"half_a_header.stl"}, on("half_a_header.stl")},
      {"Binary_STL_of_four_billion_triangles", input, {"four_billion.stl"}, on("four_billion.stl")},
      {"NaN_in_binary_STL", input, {"nan_in_binary.stl", "not a finite number"}, on("nan_in_binary.stl")},
      {"ASCII_STL_cut_off", input, {"cut_ascii.stl"}, on("cut_ascii.stl")},
      {"NaN_in_STL", input, {"nan.stl", "vertex 1", "not a finite number"}, on("nan.stl")},
      {"Infinity_in_STL", input, {"infinity.stl", "vertex 1", "not a finite number"}, on("infinity.stl")},
      {"OFF_cut_off", input, {"cut.off"}, on("cut.off")},
      {"OFF_with_wrong_index", input, {"wrong_index.off"}, on("wrong_index.off")},
      {"VTP_cut_off", input, {"cut.vtp"}, on("cut.vtp")},
      {"Surface_of_one_triangle", input, {"1 triangle", "too few"}, on("one_triangle.stl")},
      {"Surface_of_one_point", input, {"three different corners"}, on("one_point.off")},
      {"Centerlines_as_surface", input, {"lines.vtp"}, on("lines.vtp")},
      {"Missing_centerlines", input, {"absent.vtk"}, along("absent.vtk")},
      {"Empty_centerlines", input, {"empty.vtp", "empty"}, along("empty.vtp")},
      {"Directory_as_centerlines", input, {"folder.stl"}, along("folder.stl")},
      {"Text_as_centerlines", input, {"letter.vtk"}, along("letter.vtk")},
      {"Centerlines_cut_off", input, {"cut.vtk"}, along("cut.vtk")},
      {"Surface_as_centerlines", input, {"good.vtp", "line"}, along("good.vtp")},
      {"STL_as_centerlines", input, {"good.stl"}, along("good.stl")},
      {"Missing_seeds", input, {"absent.txt"}, alone("sphere.off", "--seeds IN/absent.txt")},
      {"Seeds_that_are_no_points", input, {"Line 1", "letter.vtk"}, alone("sphere.off", "--seeds IN/letter.vtk")},
      {"One_seed", input, {"one_seed.txt", "target"}, alone("sphere.off", "--seeds IN/one_seed.txt")},
      {"Empty_surface_alone", input, {"empty.stl", "empty"}, alone("empty.stl")},
      {"NaN_in_centerlines", input, {"nan.vtk", "not a finite number"}, along("nan.vtk")},
  };
}

inline std::vector<Refusal> geometry_errors() {
  return {
      {"Surface_without_openings", input, {"closed", "flat"}, on("sphere.off")},
      {"Surface_without_openings_alone", input, {"closed", "flat", "seeds"}, alone("sphere.off")},
      {"Surface_with_one_end", input, {"one end", "seeds"}, alone("bag.off")},
      {"Number_of_openings_that_are_not_there", input, {"3 openings, not 2"}, alone("window.off", "--openings 2")},
      {"Hole_to_fill_that_is_not_there", input, {"border", "fill"}, alone("window.off", "--fill 50,0,0")},
      {"Surface_that_passes_through_itself", input, {"surface", "intersect"}, on("spiked.off") + " --repair off"},
      {"Surfaces_that_overlap", input, {"surface"}, both("overlapping") + " --repair off"},
      {"Surface_in_two_pieces", input, {"pieces"}, both("two") + " --repair off"},
      {"Centerlines_far_away", input, {"centerlines", "surface"}, along("far_away.vtk")},
      {"Centerlines_beside_the_surface", input, {"centerlines", "surface"}, along("beside.vtk")},
      {"Centerlines_in_larger_units", input, {"centerlines", "unit"}, along("larger.vtk")},
      {"Centerlines_in_smaller_units", input, {"centerlines", "unit"}, along("smaller.vtk")},
      {"Centerlines_without_length", input, {"centerlines"}, along("one_place.vtk")},
  };
}

} // namespace tool_test

#endif // TUBULAR_MESHING_TEST_TOOL_REFUSALS_H
