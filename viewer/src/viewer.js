// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

import { Vector3 } from "three";
import { Centerlines } from "./centerlines.js";
import { Coloring } from "./coloring.js";
import { cornersOf, Cut } from "./cut.js";
import { KINDS } from "./mesh.js";
import { button, checkbox, element, figures, legend, number, select } from "./panel.js";
import { Stage } from "./stage.js";
import { Surface } from "./surface.js";

const AXES = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

/** The mesh in 3D, and all that steers it. */
export class Viewer {
  constructor(root, mesh, report) {
    this.root = root;
    this.mesh = mesh;
    this.report = report;
    this.cut = new Cut(mesh);
    this.coloring = new Coloring(mesh);
    this.centerlines = new Centerlines(mesh.header);
    this.addParts();
    this.stage = new Stage(this.canvas, mesh);
    this.outside = new Surface(false);
    this.inside = new Surface(true);
    this.stage.scene.add(this.outside.object, this.inside.object);
    this.outside.setFaces(mesh.numberOfFacets, (f) => mesh.facet(f), mesh.points);
    this.lines = this.centerlines.object();
    this.lines.visible = false;
    this.stage.scene.add(this.lines);
    this.followTheme();
    this.addNames();
    this.addGestures();
    this.addButtonsOfTables();
    this.update();
    this.color();
    new ResizeObserver(() => this.stage.resize()).observe(this.canvas.parentElement);
    this.stage.resize();
    this.stage.look(mesh.header.from);
    this.stage.drawNow();
  }

  // --- the page ---

  addParts() {
    const { header } = this.mesh;
    this.canvas = element("canvas", {
      tabindex: 0,
      role: "application",
      "aria-label":
        "The mesh in 3D. Arrow keys turn it, with Shift they move it, + and - zoom, Enter tells about what is in the middle, Home shows all, Escape takes marks away.",
    });
    this.names = element("div", { class: "names", "aria-hidden": "true" });
    this.picked = element("div", { id: "picked", role: "status", "aria-live": "polite" });
    this.legend = element("div", { id: "legend" });
    this.slider = element("input", {
      id: "cut-at", type: "range", min: 0, max: 1000, value: 500, "aria-label": "Where it is cut",
      disabled: true, oninput: () => this.moveCut(),
    });
    const colors = ["patch", "region", "type", "quality", "size", "branch"].map((c) => [c, c]);
    const cuts = [["", "nothing"], ["x", "across x"], ["y", "across y"], ["z", "across z"], ["view", "as one looks"]];
    const bar = element(
      "div",
      { class: "bar", role: "toolbar", "aria-label": "View" },
      select("color-by", "Colour", colors, (by) => this.setColor(by)),
      select("cut-by", "Cut", cuts, (axis) => this.setCut(axis)),
      this.slider,
      checkbox("cut-turned", "other side", false, () => this.setCut(document.getElementById("cut-by").value)),
      select("wall", "Outside", [["1", "solid"], ["0.25", "see-through"], ["0", "hidden"]], (o) => this.setOpacity(Number(o))),
      checkbox("edges", "edges", true, (on) => this.setEdges(on)),
      checkbox("lines", "centerlines, radii", false, (on) => this.setLines(on)),
      checkbox("names", "names", false, (on) => this.setNames(on)),
      button("all", "Show all of it", () => this.stage.look(this.mesh.header.from)),
      ...Object.entries(AXES).map(([axis, from]) => button(axis, `Look along ${axis}`, () => this.stage.look(from))),
    );
    this.root.append(bar);
    if (header.regions.length > 1)
      this.root.append(this.switches("Regions", header.regions, this.cut.hiddenRegions));
    if (header.patches.length > 1)
      this.root.append(this.switches("Patches", header.patches, this.cut.hiddenPatches));
    this.root.append(element("div", { class: "canvas" }, this.canvas, this.names), this.legend, this.picked);
    if (header.cells < header.cells_of_mesh) this.root.append(this.leftOut());
  }

  switches(title, list, hidden) {
    const boxes = list.map(({ name }, i) =>
      checkbox(`${title}-${i}`, name, true, async (on) => {
        if (on) hidden.delete(i);
        else hidden.add(i);
        if (this.cut.isCutting) await this.needCells();
        this.update();
      }),
    );
    return element("details", { class: "switches" }, element("summary", {}, title), element("div", {}, ...boxes));
  }

  leftOut() {
    const { cells, cells_of_mesh: all, whole_branches: whole } = this.mesh.header;
    const text =
      cells === 0
        ? `The page has none of the ${all} cells, but the facets alone: they do not fit into its size (--report-budget).`
        : `The page has ${cells} of the ${all} cells, those of the branches before ${whole} and some of it; of the others it has the facets alone, and a cut shows them hollow (--report-budget).`;
    return element("p", { id: "left-out" }, text);
  }

  followTheme() {
    const dark = window.matchMedia("(prefers-color-scheme: dark)");
    const set = () => {
      const color = getComputedStyle(document.body).getPropertyValue("--canvas").trim();
      this.stage.setBackground(color || "#ffffff");
      const ink = dark.matches ? 0xf2f2f2 : 0x111111;
      this.lines.children.forEach((l) => l.material.color.set(ink));
    };
    dark.addEventListener("change", set);
    set();
  }

  // --- what is drawn ---

  async needCells() {
    if (this.mesh.numberOfCells > 0 || this.mesh.header.cells === 0) return;
    this.picked.textContent = "Reading the cells …";
    await this.mesh.readCells();
    this.picked.textContent = "";
  }

  async setCut(axis) {
    this.slider.disabled = axis === "";
    if (axis !== "") await this.needCells();
    const turned = document.getElementById("cut-turned").checked ? -1 : 1;
    const normal = axis === "" ? null : (AXES[axis] ?? this.stage.from()).map((x) => x * turned);
    this.range = this.cut.setNormal(normal);
    this.moveCut();
  }

  moveCut() {
    if (this.range) {
      const t = this.slider.value / 1000;
      this.cut.offset = (1 - t) * this.range[0] + t * this.range[1];
    }
    this.update();
  }

  /** Finds what is seen. */
  update() {
    const { facets, faces } = this.cut.seen();
    this.outside.show(facets);
    this.faces = faces;
    this.inside.setFaces(faces.length / 2, (i) => cornersOf(this.mesh, faces[2 * i], faces[2 * i + 1]), this.mesh.points);
    this.colorInside();
    this.seen = { facets: facets.length, faces: faces.length / 2 };
    this.stage.draw();
  }

  colorInside() {
    const { faces, mesh } = this;
    this.inside.setColors((i) => this.coloring.ofFace(faces[2 * i], cornersOf(mesh, faces[2 * i], faces[2 * i + 1])));
  }

  color() {
    this.outside.setColors((f) => this.coloring.ofFacet(f));
    this.colorInside();
    this.legend.replaceChildren(...legend(this.coloring.legend()));
    this.stage.draw();
  }

  setColor(by) {
    this.coloring.by = by;
    this.color();
  }

  setOpacity(opacity) {
    this.outside.setOpacity(opacity);
    this.stage.draw();
  }

  setEdges(on) {
    for (const surface of [this.outside, this.inside]) surface.material.uniforms.edges.value = on ? 1 : 0;
    this.stage.draw();
  }

  setLines(on) {
    this.lines.visible = on;
    this.stage.draw();
  }

  // --- names of openings ---

  addNames() {
    this.tags = this.report.openings.map((o) => {
      const tag = element("span", {}, o.name);
      return { tag, at: this.local(o.center) };
    });
    this.names.append(...this.tags.map((t) => t.tag));
    this.names.hidden = true;
    this.stage.afterDraw = () => this.placeNames();
  }

  setNames(on) {
    this.names.hidden = !on;
    this.stage.draw();
  }

  // Those of the larger openings first; one that would cover another waits until there is room.
  placeNames() {
    if (this.names.hidden) return;
    const taken = [];
    for (const { tag, at } of this.tags) {
      const place = this.stage.project(at);
      const hasRoom = place && taken.every(([x, y]) => Math.abs(x - place[0]) > 90 || Math.abs(y - place[1]) > 18);
      tag.hidden = !hasRoom;
      if (!hasRoom) continue;
      taken.push(place);
      tag.style.transform = `translate(${place[0]}px, ${place[1]}px) translate(-50%, -50%)`;
    }
  }

  // --- picking ---

  local([x, y, z]) {
    const [a, b, c] = this.mesh.origin;
    return new Vector3(x - a, y - b, z - c);
  }

  global(p) {
    const at = p.toArray ? p.toArray() : p;
    return at.map((x, k) => number(x + this.mesh.origin[k])).join(", ");
  }

  pick(x, y) {
    const ray = this.stage.ray(x, y);
    const outside = this.outside.pick(ray);
    const inside = this.inside.pick(ray);
    if (!outside && !inside) {
      this.clear();
      return;
    }
    if (outside && (!inside || outside.distance <= inside.distance * (1 + 1e-6))) this.tellFacet(outside.face, outside.point);
    else this.tellCell(this.faces[2 * inside.face], inside.point);
  }

  tellFacet(f, point) {
    const { mesh } = this;
    const { patches, regions } = mesh.header;
    const patch = patches[mesh.patch[f]];
    const opening = this.report.openings.find((o) => o.patch === patch.label);
    const corners = mesh.facet(f);
    const pairs = [["patch", `${patch.name} (${patch.label})`]];
    if (opening)
      pairs.push(
        ["opening's radius", number(opening.radius)], ["area", number(opening.area)],
        ["in the mesh", number(opening.mesh_area)], ["perimeter", number(opening.perimeter)],
        ["center", opening.center.map(number).join(", ")],
      );
    if (mesh.facetKind[f] < 4)
      pairs.push(["cell behind it", KINDS[mesh.facetKind[f]]], ["region", regions[mesh.facetRegion[f]]?.name]);
    pairs.push(["quality", number(mesh.facetQuality[f])], ["size", number(mesh.sizeOf(corners))]);
    this.addBranch(pairs, mesh.facetBranch[f], point);
    this.tell(corners.length === 4 ? "quad" : "triangle", pairs, mesh.centerOf(corners), point);
  }

  tellCell(c, point) {
    const { mesh } = this;
    const pairs = [
      ["region", mesh.header.regions[mesh.cellRegion[c]].name],
      ["quality", number(mesh.cellQuality[c])],
      ["size", number(mesh.sizeOf(mesh.cell(c)))],
    ];
    this.addBranch(pairs, mesh.cellBranch[c], point);
    this.tell(KINDS[mesh.cellKind[c]], pairs, mesh.centerOf(mesh.cell(c)), point);
  }

  addBranch(pairs, branch, point) {
    const b = this.report.branches[branch];
    if (!b) return;
    pairs.push(
      ["branch", branch], ["its length", number(b.length)],
      ["radius here", number(this.centerlines.radiusAt(branch, point))],
    );
  }

  tell(title, pairs, center, point) {
    this.picked.replaceChildren(...figures(title, [...pairs, ["place", this.global(center)]]));
    this.stage.mark(point);
  }

  clear() {
    this.picked.replaceChildren();
    this.stage.mark(null);
    this.unmarkBranch();
  }

  unmarkBranch() {
    if (this.marked) this.stage.scene.remove(this.marked);
    this.marked = null;
    this.stage.draw();
  }

  // --- "show me" ---

  addButtonsOfTables() {
    for (const b of document.querySelectorAll("button.show")) {
      b.hidden = false;
      b.addEventListener("click", () => {
        if (b.dataset.branch !== undefined) this.showBranch(Number(b.dataset.branch));
        else this.showPlace(b.dataset.place.split(",").map(Number), Number(b.dataset.radius), b.getAttribute("aria-label"));
        this.root.scrollIntoView({ block: "nearest" });
      });
    }
  }

  showPlace(place, radius, title) {
    const at = this.local(place);
    this.unmarkBranch();
    this.stage.focus(at, Math.max(radius * 4, this.stage.radius * 0.01));
    this.stage.mark(at);
    this.picked.replaceChildren(...figures(title.replace(/^Show me /, ""), [["place", this.global(at)]]));
  }

  showBranch(branch) {
    const { center, radius } = this.centerlines.extent(branch);
    this.clear();
    this.marked = this.centerlines.highlight(branch);
    this.stage.scene.add(this.marked);
    this.stage.focus(center, radius * 1.2);
    const b = this.report.branches[branch];
    this.picked.replaceChildren(
      ...figures(`branch ${branch}`, [
        ["length", number(b.length)], ["least radius", number(b.min_radius)], ["largest", number(b.max_radius)],
        ["points round it", number(b.points_per_circumference)],
      ]),
    );
  }

  // --- mouse, fingers and keys ---

  addGestures() {
    const { canvas } = this;
    let down = null;
    canvas.addEventListener("pointerdown", (e) => {
      down = [e.offsetX, e.offsetY];
      canvas.focus({ preventScroll: true });
    });
    canvas.addEventListener("pointerup", (e) => {
      if (down && Math.hypot(e.offsetX - down[0], e.offsetY - down[1]) < 4) this.pick(e.offsetX, e.offsetY);
      down = null;
    });
    canvas.addEventListener("keydown", (e) => {
      if (e.ctrlKey || e.metaKey || e.altKey) return;
      const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key];
      if (step && e.shiftKey) this.stage.move(-step[0] * 0.05, -step[1] * 0.05);
      else if (step) this.stage.turn(step[0] * 0.1, step[1] * 0.1);
      else if (e.key === "+" || e.key === "=") this.stage.zoom(0.85);
      else if (e.key === "-") this.stage.zoom(1 / 0.85);
      else if (e.key === "Home") this.stage.look(this.mesh.header.from);
      else if (e.key === "Enter") this.pick(canvas.clientWidth / 2, canvas.clientHeight / 2);
      else if (e.key === "Escape") this.clear();
      else return;
      e.preventDefault();
    });
  }
}
