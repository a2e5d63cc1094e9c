// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The page that tubular_mesh --report writes, in a browser. Run by ctest; environment variables say where things are:
// TOOL, CHROMIUM, SURFACE, CENTERLINES, FOLDER.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, rmSync, statSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";

const { TOOL, CHROMIUM, SURFACE, CENTERLINES, FOLDER } = process.env;
const HOSTILE = "a'b </script><script>alert(1)</script> <!-- ünïcode & \u2028 €";

rmSync(FOLDER, { recursive: true, force: true });
mkdirSync(FOLDER, { recursive: true });

function pageOf(name, ...options) {
  const page = join(FOLDER, `${name}.html`);
  const args = [SURFACE, "-c", CENTERLINES, "-o", join(FOLDER, `${name}.vtu`), "--report", page, "-q", ...options];
  execFileSync(TOOL, args, { stdio: ["ignore", "ignore", "inherit"] });
  return page;
}

const url = (page) => pathToFileURL(page).href;
const viewer = "window.tubularMeshViewer";
const choose = (id, value) =>
  `(() => { const e = document.getElementById(${JSON.stringify(id)}); e.value = ${JSON.stringify(value)};
    e.dispatchEvent(new Event("change")); })()`;
const set = (id, value) =>
  `(() => { const e = document.getElementById(${JSON.stringify(id)}); e.value = ${JSON.stringify(value)};
    e.dispatchEvent(new Event("input")); })()`;
const press = (selector) => `document.querySelector(${JSON.stringify(selector)}).click()`;

// What the canvas shows: how many pixels are not background, their mean, and how many colours there are.
const picture = `(() => {
  ${viewer}.stage.drawNow();
  const source = ${viewer}.canvas, copy = document.createElement("canvas");
  copy.width = source.width; copy.height = source.height;
  const context = copy.getContext("2d");
  context.drawImage(source, 0, 0);
  const { data } = context.getImageData(0, 0, copy.width, copy.height);
  let drawn = 0, sum = [0, 0, 0]; const colors = new Set();
  for (let i = 0; i < data.length; i += 4) {
    if (data[i] === data[0] && data[i + 1] === data[1] && data[i + 2] === data[2]) continue;
    ++drawn; for (let k = 0; k < 3; ++k) sum[k] += data[i + k];
    colors.add(data[i] << 16 | data[i + 1] << 8 | data[i + 2]);
  }
  return { drawn, share: drawn / (data.length / 4), mean: sum.map((s) => Math.round(s / Math.max(drawn, 1))), colors: colors.size };
})()`;

let browser, tab, mixed, plain;

before(async () => {
  plain = pageOf("plain", "-n", "10");
  mixed = pageOf("mixed", "-n", "8", "-t", "mixed", "--wall", "0.2", "--wall-layers", "2", "--rename", `inlet=${HOSTILE}`);
  browser = new Browser(CHROMIUM);
  tab = await browser.open();
  await tab.visit(url(mixed));
});

after(async () => browser?.close());

test("draws the mesh, without a complaint", async () => {
  const seen = await tab.evaluate(picture);
  assert.ok(seen.share > 0.03, JSON.stringify(seen));
  assert.ok(seen.colors > 20, JSON.stringify(seen));
  await tab.screenshot(join(FOLDER, "mesh.png"));
  assert.deepEqual(tab.errors, []);
});

test("has the mesh that was made: its numbers and its volume", async () => {
  await tab.evaluate(`${viewer}.mesh.readCells()`);
  const found = await tab.evaluate(`(() => {
    const { mesh } = ${viewer}, p = mesh.points, kinds = [0, 0, 0, 0];
    for (let c = 0; c < mesh.numberOfCells; ++c) ++kinds[mesh.cellKind[c]];
    const at = (v) => [p[3 * v], p[3 * v + 1], p[3 * v + 2]];
    const six = (x, y, z) => { // six times the volume between a triangle and the origin
      return x[0] * (y[1] * z[2] - y[2] * z[1]) - x[1] * (y[0] * z[2] - y[2] * z[0]) + x[2] * (y[0] * z[1] - y[1] * z[0]); };
    const lumen = mesh.header.regions.findIndex((r) => r.name === "lumen");
    let volume = 0;
    for (let f = 0; f < mesh.numberOfFacets; ++f) {
      const isOfLumen = mesh.facetRegion[f] === lumen || mesh.beyond[f] - 1 === lumen;
      if (!isOfLumen) continue;
      const q = [...mesh.facet(f)].map(at), n = q.length; // round the mean of the corners, as quads need not be plane
      const middle = [0, 1, 2].map((k) => q.reduce((sum, x) => sum + x[k], 0) / n);
      for (let i = 0; i < n; ++i) volume += six(middle, q[i], q[(i + 1) % n]) / 6;
    }
    return { kinds, volume, facets: mesh.numberOfFacets };
  })()`);
  const report = JSON.parse(await tab.evaluate(`document.getElementById("report").textContent`));
  const { tetrahedra, pyramids, prisms, hexahedra } = report.cells;
  assert.deepEqual(found.kinds, [tetrahedra, pyramids, prisms, hexahedra]);
  assert.equal(found.facets, report.facets.triangles + report.facets.quads);
  assert.ok(Math.abs(found.volume / report.volume.mesh - 1) < 1e-3, `${found.volume} is not ${report.volume.mesh}`);
});

test("colours by each of its measures", async () => {
  const means = new Set();
  for (const by of ["patch", "region", "type", "quality", "size", "branch"]) {
    await tab.evaluate(choose("color-by", by));
    means.add(JSON.stringify((await tab.evaluate(picture)).mean));
    assert.ok(await tab.evaluate(`document.getElementById("legend").textContent.length > 2`), by);
  }
  assert.ok(means.size >= 5, [...means].join(" "));
  await tab.evaluate(choose("color-by", "type"));
  const legend = await tab.evaluate(`document.getElementById("legend").textContent`);
  for (const kind of ["tetrahedron", "pyramid", "hexahedron"]) assert.ok(legend.includes(kind), legend);
});

test("cuts by whole cells, and tells of the cells that it lays bare", async () => {
  await tab.evaluate(choose("cut-by", "z"));
  await tab.waitFor(`${viewer}.seen.faces > 0`);
  await tab.evaluate(set("cut-at", "400"));
  const cut = await tab.evaluate(`(() => {
    const { cut, mesh, faces, seen } = ${viewer};
    let beyond = 0;
    for (let i = 0; i < faces.length; i += 2) beyond += !cut.keepsCell(faces[i]);
    let kept = 0;
    for (let c = 0; c < mesh.numberOfCells; ++c) kept += cut.keptCells[c];
    return { beyond, kept, all: mesh.numberOfCells, ...seen, facetsOfAll: mesh.numberOfFacets };
  })()`);
  assert.equal(cut.beyond, 0);
  assert.ok(cut.kept > 0 && cut.kept < cut.all && cut.faces > 10 && cut.facets < cut.facetsOfAll, JSON.stringify(cut));
  await tab.evaluate(press('button[title="Look along z"]'));
  await tab.evaluate(picture);
  await tab.screenshot(join(FOLDER, "cut.png"));
  // The middle of a face that was laid bare and that nothing hides.
  const told = await tab.evaluate(`(() => {
    const v = ${viewer}, texts = new Set();
    for (let i = 0; i < v.faces.length && texts.size < 4; i += 2) {
      const kind = v.mesh.cellKind[v.faces[i]];
      const start = v.mesh.cellStart[v.faces[i]];
      const center = v.mesh.centerOf(v.mesh.cellCorners.subarray(start, start + [4, 5, 6, 8][kind]));
      const at = v.stage.project(v.local(center.map((x, k) => x + v.mesh.origin[k])));
      if (!at) continue;
      v.pick(at[0], at[1]);
      const text = v.picked.textContent;
      if (/^(tetrahedron|pyramid|hexahedron)/.test(text)) texts.add(text);
    }
    return [...texts];
  })()`);
  assert.ok(told.length > 0);
  for (const text of told) assert.match(text, /region.*quality.*size.*branch.*radius here.*place/);
  await tab.evaluate(`(() => { document.getElementById("cut-turned").click(); })()`);
  await tab.evaluate(choose("cut-by", "view"));
  await tab.waitFor(`${viewer}.seen.faces > 0`);
  await tab.evaluate(`(() => { document.getElementById("cut-turned").click(); })()`);
  await tab.evaluate(choose("cut-by", ""));
  await tab.waitFor(`${viewer}.seen.faces === 0`);
});

test("hides a region: the other is laid bare", async () => {
  const before = await tab.evaluate(`${viewer}.seen.facets`);
  await tab.evaluate(`document.getElementById("Regions-1").click()`);
  await tab.waitFor(`${viewer}.seen.facets !== ${before}`);
  await tab.evaluate(`document.getElementById("Regions-1").click()`);
  await tab.waitFor(`${viewer}.seen.facets === ${before}`);
});

test("a click tells of the facet and of the opening", async () => {
  await tab.evaluate(`window.scrollTo(0, 0)`);
  await tab.evaluate(press("#openings button.show"));
  await tab.waitFor(`document.getElementById("picked").textContent.includes("alert(1)")`);
  const opening = await tab.evaluate(`(() => {
    const v = ${viewer}, o = v.report.openings[0];
    v.stage.focus(v.local(o.center), o.radius * 3, v.stage.middle.clone().set(...o.normal));
    v.stage.drawNow();
    const box = v.canvas.getBoundingClientRect();
    const at = v.stage.project(v.local(o.center));
    return [box.left + at[0], box.top + at[1]];
  })()`);
  await tab.evaluate(`${viewer}.clear()`);
  await tab.click(...opening);
  await tab.waitFor(`document.getElementById("picked").textContent.includes("opening's radius")`, 10);
  assert.ok((await tab.evaluate(`document.getElementById("picked").textContent`)).includes(HOSTILE.split(" ")[0]));
  await tab.screenshot(join(FOLDER, "opening.png"));
});

test("shows branches and places", async () => {
  await tab.evaluate(press("#branches button.show"));
  assert.match(await tab.evaluate(`document.getElementById("picked").textContent`), /^branch 0.*length/);
  await tab.evaluate(press("#quality button.show"));
  assert.ok(await tab.evaluate(`${viewer}.stage.marker.visible`));
  await tab.evaluate(press("#lines"));
  await tab.evaluate(choose("wall", "0.25"));
  await tab.evaluate(press("#names"));
  await tab.evaluate(press('button[title="Show all of it"]'));
  await tab.evaluate(picture);
  await tab.screenshot(join(FOLDER, "lines.png"));
  await tab.evaluate(press("#names"));
  await tab.evaluate(press("#lines"));
  await tab.evaluate(choose("wall", "1"));
});

test("obeys the keyboard", async () => {
  await tab.evaluate(`${viewer}.canvas.focus()`);
  const place = `${viewer}.stage.camera.position.toArray().join()`;
  for (const [key, modifiers] of [["ArrowLeft"], ["ArrowUp"], ["ArrowRight", 8], ["+"], ["-"], ["Home"]]) {
    const before = await tab.evaluate(place);
    await tab.key(key, modifiers);
    await tab.waitFor(`${place} !== ${JSON.stringify(before)}`, 10);
  }
  await tab.evaluate(`${viewer}.showPlace(${viewer}.report.openings[0].center, 1, "x")`);
  await tab.evaluate(`${viewer}.stage.drawNow()`);
  await tab.key("Enter");
  assert.match(await tab.evaluate(`document.getElementById("picked").textContent`), /quality/);
  await tab.key("Escape");
  assert.equal(await tab.evaluate(`document.getElementById("picked").textContent`), "");
  // Everything that can be pressed can be reached, and has a name.
  const nameless = await tab.evaluate(`[...document.querySelectorAll("button, select, input, a, canvas")].filter((e) =>
    !e.hidden && (e.tabIndex < 0 || !(e.getAttribute("aria-label") || e.textContent.trim() || e.labels?.length))).map((e) => e.outerHTML)`);
  assert.deepEqual(nameless, []);
});

test("names are text, whatever they hold", async () => {
  const name = await tab.evaluate(`document.querySelector("#openings tbody th").textContent`);
  assert.equal(name, HOSTILE);
  assert.ok((await tab.evaluate(`document.getElementById("command-line").textContent`)).includes("alert(1)"));
  assert.ok(!/<script>alert/.test(readFileSync(mixed, "utf8")));
  assert.deepEqual(tab.errors, []);
});

const leastContrast = `(() => {
  const numbers = (c) => c.match(/[\\d.]+/g).map(Number);
  const light = (c) => { const [r, g, b] = c.map((x) => { x /= 255; return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4; });
    return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
  const behind = (e) => { for (; e; e = e.parentElement) { const c = numbers(getComputedStyle(e).backgroundColor);
    if (c.length === 3 || c[3] > 0) return c; } return [255, 255, 255]; };
  let least = [99, ""];
  for (const e of document.querySelectorAll("body *")) {
    if (![...e.childNodes].some((n) => n.nodeType === 3 && n.data.trim()) || !e.checkVisibility() || e.closest("svg, script, style")) continue;
    const a = light(numbers(getComputedStyle(e).color)), b = light(behind(e));
    const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    if (contrast < least[0]) least = [contrast, e.outerHTML.slice(0, 120)];
  }
  return least;
})()`;

test("has contrast, in the light and in the dark, and room on a phone", async () => {
  for (const scheme of ["light", "dark"]) {
    await tab.scheme(scheme);
    const [contrast, where] = await tab.evaluate(leastContrast);
    assert.ok(contrast >= 4.5, `${scheme}: ${contrast} at ${where}`);
  }
  await tab.evaluate(picture);
  await tab.screenshot(join(FOLDER, "dark.png"));
  await tab.scheme("light");
  await tab.resize(360, 740, true);
  await tab.waitFor(`${viewer}.canvas.clientWidth <= 360`);
  assert.ok(await tab.evaluate(`document.documentElement.scrollWidth <= 360`));
  await tab.evaluate(picture);
  await tab.screenshot(join(FOLDER, "phone.png"));
  await tab.resize(1280, 860);
  assert.deepEqual(tab.errors, []);
});

test("says what was left out, and cuts without it", async () => {
  const page = pageOf("budget", "-n", "10", "--report-budget", "0");
  const other = await browser.open();
  await other.visit(url(page));
  assert.match(await other.evaluate(`document.getElementById("left-out").textContent`), /none of the \d+ cells/);
  const all = await other.evaluate(`${viewer}.seen.facets`);
  await other.evaluate(choose("cut-by", "x"));
  await other.waitFor(`${viewer}.seen.facets < ${all}`);
  assert.deepEqual(other.errors, []);
  assert.ok(statSync(page).size < statSync(plain).size);
});

test("is small, and draws a surface as well", async () => {
  assert.ok(statSync(plain).size < 2e6, `${statSync(plain).size}`);
  const surface = join(FOLDER, "surface.html");
  execFileSync(TOOL, [SURFACE, "-c", CENTERLINES, "-t", "surface", "-n", "8", "-o", join(FOLDER, "s.vtp"), "--report", surface, "-q"]);
  const other = await browser.open();
  await other.visit(url(surface));
  assert.ok((await other.evaluate(picture)).share > 0.03);
  await other.evaluate(choose("cut-by", "x"));
  await other.waitFor(`${viewer}.seen.facets < ${viewer}.mesh.numberOfFacets`);
  assert.deepEqual(other.errors, []);
});

test("has still pictures and tables where there is no 3D", async () => {
  const without = new Browser(CHROMIUM, ["--disable-3d-apis"]);
  try {
    const other = await without.open();
    await other.visit(url(plain), `document.readyState === "complete" && !!document.querySelector("#viewer p")`);
    assert.match(await other.evaluate(`document.querySelector("#viewer p").textContent`), /cannot be shown in 3D/);
    assert.ok(await other.evaluate(`document.querySelector("svg.still").checkVisibility()`));
    assert.ok(await other.evaluate(`document.querySelectorAll("#openings tbody tr").length >= 2`));
    await other.screenshot(join(FOLDER, "stills.png"));
  } finally {
    await without.close();
  }
});
