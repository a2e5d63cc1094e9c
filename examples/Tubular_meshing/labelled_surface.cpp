// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A surface whose file says which face is which end, by face ids, solids or groups: the openings of the mesh are there,
// and have their names.

#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/Repair/carry_labels.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/tubular_meshing.h>

#include <cstdlib>
#include <iostream>

namespace TM = CGAL::Tubular_meshing;

int main(int argc, char* argv[]) {
  if (argc != 3) {
    std::cerr << "usage: " << argv[0] << " SURFACE OUTPUT.vtu|.msh|.mesh\n";
    return EXIT_FAILURE;
  }
  try {
    const TM::IO::Surface_data data = TM::IO::read_surface_data(argv[1]);
    if (data.labels.empty()) {
      std::cerr << "The faces of this surface have no labels.\n";
      return EXIT_FAILURE;
    }
    TM::Surface surface;
    std::cout << TM::repair_surface(data.points, data.triangles, surface).text();
    TM::Face_patch_map label = surface.add_property_map<TM::Surface::Face_index, int>("f:label", 0).first;
    TM::carry_labels(data.points, data.triangles, data.labels.label, surface, label);

    const TM::Mesher_options options(TM::parameters::points_per_circumference(16));
    TM::Mesher mesher(
        TM::make_tubular_model(surface, TM::parameters::face_label_map(label).label_names(data.labels.names)), options);
    for (const TM::Understood_label& l : mesher.model().labels.labels)
      std::cout << "label " << l.text() << ": "
                << (l.count > 0         ? "an end"
                    : l.is_understood() ? "the wall"
                                        : "taken for wall, since it " + l.reason)
                << "\n";
    for (const TM::Opening& o : mesher.model().openings)
      std::cout << "patch " << o.patch << " is " << TM::patch_names(mesher.model()).at(o.patch) << "\n";
    TM::IO::write_mesh(argv[2], mesher.isotropic());
  } catch (const TM::Error& e) {
    std::cerr << e.what() << "\n";
    return EXIT_FAILURE;
  }
}
