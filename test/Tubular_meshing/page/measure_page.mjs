// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints of pages: their size, how long they take to open, and the frames per second that a browser without a graphics
// processor draws.
//
//   node measure_page.mjs CHROMIUM PAGE.html...

import { statSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { Browser } from "./browser.mjs";

const viewer = "window.tubularMeshViewer";
const [chromium, ...pages] = process.argv.slice(2);
const browser = new Browser(chromium);
try {
  for (const page of pages) {
    const tab = await browser.open();
    const seconds = await tab.visit(pathToFileURL(resolve(page)).href);
    const frames = await tab.evaluate(`${viewer}.stage.benchmark(30)`);
    const cells = await tab.evaluate(
      `(async () => { const t = performance.now(); await ${viewer}.needCells(); return (performance.now() - t) / 1000; })()`,
    );
    const cut = await tab.evaluate(`(async () => { const t = performance.now();
      document.getElementById("cut-by").value = "x"; await ${viewer}.setCut("x"); return (performance.now() - t) / 1000; })()`);
    const moved = await tab.evaluate(`(() => { const t = performance.now(); ${viewer}.slider.value = 520;
      ${viewer}.moveCut(); return (performance.now() - t) / 1000; })()`);
    const framesOfCut = await tab.evaluate(`${viewer}.stage.benchmark(30)`);
    console.log(
      `${page}: ${(statSync(page).size / 1e6).toFixed(2)} MB; opens in ${seconds.toFixed(2)} s; ${frames.toFixed(1)} frames/s; ` +
        `cells read in ${cells.toFixed(2)} s, first cut ${cut.toFixed(2)} s, moved ${moved.toFixed(2)} s, then ${framesOfCut.toFixed(1)} frames/s`,
    );
    if (tab.errors.length > 0) console.log(tab.errors.join("\n"));
  }
} finally {
  await browser.close();
}
