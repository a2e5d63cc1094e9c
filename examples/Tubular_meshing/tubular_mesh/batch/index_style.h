// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_BATCH_INDEX_STYLE_H
#define TUBULAR_MESH_BATCH_INDEX_STYLE_H

/* The style of the index, light or dark as the reader's system is; on a phone each row is a block of its own. */
constexpr const char* index_style = R"css(
:root { color-scheme: light dark; --failed: #b3001b; --quiet: #5a5a5a; --line: #b8b8b8; }
@media (prefers-color-scheme: dark) { :root { --failed: #ff8f9a; --quiet: #b4b4b4; --line: #55585c; } }
body { font: 15px/1.4 system-ui, sans-serif; margin: 1em; }
h1 { font-size: 1.35rem; overflow-wrap: anywhere; }
table { border-collapse: collapse; }
th, td { padding: .25em .6em; text-align: left; vertical-align: top; border-bottom: 1px solid var(--line); }
th { position: sticky; top: 0; background: Canvas; font-weight: 600; }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
td.picture img { display: block; background: #fff; object-fit: contain; }
td.name { font-weight: 600; overflow-wrap: anywhere; }
td.sentence { min-width: 18em; max-width: 40em; overflow-wrap: anywhere; }
tr.failed td.status { color: var(--failed); font-weight: 600; }
tr.waiting td.status { color: var(--quiet); }
@media (max-width: 50em) {
  table, tbody, tr, td { display: block; }
  thead { display: none; }
  tr { border-bottom: 2px solid var(--line); padding: .5em 0; }
  td, td.number { border: 0; padding: .1em 0; text-align: left; white-space: normal; }
  td.sentence { min-width: 0; max-width: none; }
  td:empty { display: none; }
  td[data-label]:not(.name)::before { content: attr(data-label) ": "; color: var(--quiet); font-weight: 400; }
}
)css";

#endif // TUBULAR_MESH_BATCH_INDEX_STYLE_H
