// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

import { Mesh } from "./mesh.js";
import { Viewer } from "./viewer.js";

async function start() {
  const root = document.getElementById("viewer");
  try {
    const mesh = await Mesh.read(document);
    const report = JSON.parse(document.getElementById("report").textContent);
    const viewer = new Viewer(root, mesh, report);
    document.body.classList.add("has-viewer");
    viewer.stage.resize();
    window.tubularMeshViewer = viewer; // for programs that steer the page
  } catch (error) {
    // The still pictures stay, and the tables are whole without it.
    root.replaceChildren();
    const note = document.createElement("p");
    note.textContent = `The mesh cannot be shown in 3D by this browser (${error.message ?? error}).`;
    root.append(note);
  }
}

start();
