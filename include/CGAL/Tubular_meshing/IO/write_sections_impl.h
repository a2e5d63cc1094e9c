// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_WRITE_SECTIONS_IMPL_H
#define CGAL_TUBULAR_MESHING_IO_WRITE_SECTIONS_IMPL_H

#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Number_writer.h>
#include <CGAL/Tubular_meshing/IO/internal/Vtk_xml_writer.h>
#include <CGAL/Tubular_meshing/IO/write_sections.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/utf_8.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

namespace internal {

typedef std::function<double(const Cross_section&)> Section_measure;

// The values beside places and directions, in the order of the columns.
inline const std::vector<std::pair<std::string, Section_measure>>& section_measures() {
  static const std::vector<std::pair<std::string, Section_measure>> measures = {
      {"area", [](const Cross_section& s) { return s.area; }},
      {"perimeter", [](const Cross_section& s) { return s.perimeter; }},
      {"hydraulic_diameter", [](const Cross_section& s) { return s.hydraulic_diameter(); }},
      {"inscribed_radius", [](const Cross_section& s) { return s.inscribed_radius; }},
      {"eccentricity", [](const Cross_section& s) { return s.eccentricity; }},
      {"curvature", [](const Cross_section& s) { return s.curvature; }},
      {"torsion", [](const Cross_section& s) { return s.torsion; }}};
  return measures;
}

inline void write_sections_csv(Output_file& file, const std::vector<Cross_section>& sections) {
  Number_writer out(file);
  out << "branch,abscissa,x,y,z,normal_x,normal_y,normal_z,center_x,center_y,center_z";
  for (const auto& m : section_measures())
    out << ',' << m.first;
  out << '\n';
  for (const Cross_section& s : sections) {
    out << s.branch << ',' << s.abscissa;
    for (int k = 0; k < 3; ++k)
      out << ',' << s.point[k];
    for (int k = 0; k < 3; ++k)
      out << ',' << s.normal[k];
    for (int k = 0; k < 3; ++k)
      out << ',' << s.center[k];
    for (const auto& m : section_measures())
      out << ',' << m.second(s);
    out << '\n';
  }
  out.flush();
}

// The vertices and polylines of branches, as VTK lists cells.
struct Section_cells {
  std::vector<std::int64_t> corners, ends;
  std::vector<std::int32_t> branch;

  void add(std::size_t first, std::size_t last, std::size_t b) {
    for (std::size_t i = first; i < last; ++i)
      corners.push_back(std::int64_t(i));
    ends.push_back(std::int64_t(corners.size()));
    branch.push_back(std::int32_t(b));
  }
};

inline void write_cells(const std::string& name, const Section_cells& cells, Vtk_xml_writer& out) {
  out.begin(name);
  out.array("connectivity", 1, cells.corners);
  out.array("offsets", 1, cells.ends);
  out.end(name);
}

inline void write_sections_vtp(Output_file& file, const std::vector<Cross_section>& sections) {
  Section_cells vertices, lines;
  for (std::size_t first = 0, last; first < sections.size(); first = last) {
    for (last = first + 1; last < sections.size() && sections[last].branch == sections[first].branch;)
      ++last;
    (last - first == 1 ? vertices : lines).add(first, last, sections[first].branch);
  }
  const auto values = [&](const Section_measure& measure) {
    std::vector<double> result;
    for (const Cross_section& s : sections)
      result.push_back(measure(s));
    return result;
  };
  const auto triples = [&](const auto& vector) {
    std::vector<double> result;
    for (const Cross_section& s : sections)
      for (int k = 0; k < 3; ++k)
        result.push_back(vector(s)[k]);
    return result;
  };
  Vtk_xml_writer out("PolyData");
  out.begin("Piece NumberOfPoints=\"" + std::to_string(sections.size()) + "\" NumberOfVerts=\"" +
            std::to_string(vertices.ends.size()) + "\" NumberOfLines=\"" + std::to_string(lines.ends.size()) +
            "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\"");
  out.begin("PointData");
  std::vector<std::int32_t> branch;
  for (const Cross_section& s : sections)
    branch.push_back(std::int32_t(s.branch));
  out.array("branch", 1, branch);
  out.array("abscissa", 1, values([](const Cross_section& s) { return s.abscissa; }));
  out.array("normal", 3, triples([](const Cross_section& s) { return s.normal; }));
  out.array("center", 3, triples([](const Cross_section& s) { return s.center; }));
  for (const auto& m : section_measures())
    out.array(m.first, 1, values(m.second));
  out.end("PointData");
  out.begin("CellData");
  std::vector<std::int32_t> of_cells = vertices.branch;
  of_cells.insert(of_cells.end(), lines.branch.begin(), lines.branch.end());
  out.array("branch", 1, of_cells);
  out.end("CellData");
  out.begin("Points");
  out.array("Points", 3, triples([](const Cross_section& s) { return s.point; }));
  out.end("Points");
  write_cells("Verts", vertices, out);
  write_cells("Lines", lines, out);
  out.end("Piece");
  out.write(file);
}

inline std::string json_string(const std::string& text) {
  static const char* const digits = "0123456789abcdef";
  std::string out = "\"";
  for (char c : Tubular_meshing::internal::as_utf_8(text))
    if (c == '"' || c == '\\')
      (out += '\\') += c;
    else if (static_cast<unsigned char>(c) < 0x20)
      ((out += "\\u00") += digits[c >> 4]) += digits[c & 15];
    else
      out += c;
  return out + "\"";
}

class Zero_d_writer {
public:
  Zero_d_writer(Output_file& file, const Zero_d_model& model)
      : out_(file)
      , model_(model) {}

  void write() {
    out_ << "{\n  \"description\": {\n    \"units\": \"cm, g, s\",\n    \"made by\": \"Tubular_meshing\"\n  },\n"
         << "  \"simulation_parameters\": {\n    \"density\": " << model_.density
         << ",\n    \"viscosity\": " << model_.viscosity
         << ",\n    \"number_of_cardiac_cycles\": 10,\n    \"number_of_time_pts_per_cardiac_cycle\": 101,\n"
         << "    \"absolute_tolerance\": 1e-8\n  },\n";
    list("boundary_conditions", model_.boundary_conditions, [&](const auto& c) { write_condition(c); });
    out_ << ",\n";
    list("junctions", model_.junctions, [&](const Zero_d_junction& j) { write_junction(j); });
    out_ << ",\n";
    list("vessels", model_.vessels, [&](const Zero_d_vessel& v) { write_vessel(v); });
    out_ << "\n}\n";
    out_.flush();
  }

private:
  template <class List, class Write> void list(const char* name, const List& elements, const Write& write) {
    out_ << "  \"" << name << "\": [";
    for (std::size_t i = 0; i < elements.size(); ++i) {
      out_ << (i == 0 ? "\n    {" : ",\n    {");
      write(elements[i]);
      out_ << "}";
    }
    out_ << (elements.empty() ? "]" : "\n  ]");
  }

  void write_condition(const Zero_d_boundary_condition& c) {
    out_ << "\"bc_name\": " << json_string(c.name);
    if (c.type == Zero_d_boundary_condition::resistance) {
      out_ << ", \"bc_type\": \"RESISTANCE\", \"bc_values\": {\"Pd\": 0.0, \"R\": " << c.value << "}";
      return;
    }
    const bool is_flow = c.type == Zero_d_boundary_condition::flow;
    out_ << ", \"bc_type\": \"" << (is_flow ? "FLOW" : "PRESSURE") << "\", \"bc_values\": {\"" << (is_flow ? "Q" : "P")
         << "\": [" << c.value << ", " << c.value << "], \"t\": [0.0, 1.0]}";
  }

  void write_junction(const Zero_d_junction& j) {
    out_ << "\"junction_name\": \"J" << number_of_junctions_++
         << "\", \"junction_type\": \"NORMAL_JUNCTION\", \"inlet_vessels\": ";
    numbers(j.inlets);
    out_ << ", \"outlet_vessels\": ";
    numbers(j.outlets);
  }

  void numbers(const std::vector<std::size_t>& list) {
    out_ << "[";
    for (std::size_t i = 0; i < list.size(); ++i)
      out_ << (i == 0 ? "" : ", ") << list[i];
    out_ << "]";
  }

  void write_vessel(const Zero_d_vessel& v) {
    out_ << "\"vessel_id\": " << v.branch << ", \"vessel_name\": \"branch" << v.branch
         << "_seg0\", \"vessel_length\": " << v.length << ",\n     \"zero_d_element_type\": \"BloodVessel\", "
         << "\"zero_d_element_values\": {\"R_poiseuille\": " << v.resistance << ", \"C\": " << v.capacitance
         << ", \"L\": " << v.inductance << ", \"stenosis_coefficient\": 0.0}";
    if (v.inlet.empty() && v.outlet.empty())
      return;
    out_ << ",\n     \"boundary_conditions\": {";
    if (!v.inlet.empty())
      out_ << "\"inlet\": " << json_string(v.inlet) << (v.outlet.empty() ? "" : ", ");
    if (!v.outlet.empty())
      out_ << "\"outlet\": " << json_string(v.outlet);
    out_ << "}";
  }

  Number_writer out_;
  const Zero_d_model& model_;
  std::size_t number_of_junctions_ = 0;
};

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE bool is_supported_sections_format(const std::string& file) {
  const std::string ext = internal::extension_of(file);
  return ext == "csv" || ext == "vtp";
}

CGAL_TUBULAR_MESHING_INLINE void write_sections(Output_file& file, const std::vector<Cross_section>& sections) {
  const std::string ext = internal::extension_of(file.name());
  if (ext == "csv")
    internal::write_sections_csv(file, sections);
  else if (ext == "vtp")
    internal::write_sections_vtp(file, sections);
  else
    throw Output_error("The file " + internal::quoted(file.name()) +
                       " cannot be written: sections are written as .csv or .vtp; give it one of these extensions.");
}

CGAL_TUBULAR_MESHING_INLINE void write_zero_d_model(Output_file& file, const Zero_d_model& model) {
  internal::Zero_d_writer(file, model).write();
}

} // namespace CGAL::Tubular_meshing::IO

#endif // CGAL_TUBULAR_MESHING_IO_WRITE_SECTIONS_IMPL_H
