// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Bundles the viewer into one script, and that into a C++ source if a second file is named:
//
//   node build.mjs BUNDLE.js [SOURCE.cpp]

import { build } from "esbuild";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const [bundle = join(here, "viewer.js"), source] = process.argv.slice(2);

// Who has the page has these: their licenses go with it.
const licenses = ["three", "three-mesh-bvh"]
  .map((name) => `${name}\n\n${readFileSync(join(here, "node_modules", name, "LICENSE"), "utf8").trim()}`)
  .join("\n\n");

await build({
  entryPoints: [join(here, "src", "main.js")],
  outfile: bundle,
  bundle: true,
  minify: true,
  format: "iife",
  target: ["chrome105", "firefox113", "safari16.4"],
  charset: "ascii",
  legalComments: "none",
  banner: { js: `/*\n${licenses.replace(/\*\//g, "* /").replace(/[^\x00-\x7f]/g, "(c)")}\n*/` },
  logLevel: "warning",
});

const text = readFileSync(bundle, "utf8");
if (/<\/script|<!--/i.test(text)) throw new Error("the bundle cannot stand in a page: it would end its script element");
if (source) {
  const delimiter = "tubular_mesh_vw";
  if (text.includes(`)${delimiter}"`)) throw new Error("the bundle has the delimiter of its string in it");
  const pieces = text.match(/[\s\S]{1,8000}/g).map((piece) => `R"${delimiter}(${piece})${delimiter}"`);
  writeFileSync(
    source,
    `// Made by viewer/build.mjs.\n#include "page/viewer_bundle.h"\n\nconst char viewer_bundle[] =\n${pieces.join("\n")};\n`,
  );
}
