// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_PAGE_PAGE_STYLE_H
#define TUBULAR_MESH_PAGE_PAGE_STYLE_H

/* The style of the page: light or dark as the reader's system is; text has a contrast of at least 4.5 to 1. */
constexpr const char* page_style = R"css(
:root { color-scheme: light dark; --text: #1c1c1c; --quiet: #5a5a5a; --page: #ffffff; --canvas: #f4f4f4;
  --line: #b8b8b8; --link: #0b57a4; --button: #e9eef4; --mark: #b00048; }
@media (prefers-color-scheme: dark) {
  :root { --text: #ececec; --quiet: #b4b4b4; --page: #17181a; --canvas: #26282b; --line: #55585c; --link: #8ec5ff;
    --button: #31363c; --mark: #ff8db5; }
}
* { box-sizing: border-box; }
body { margin: 0; font: 15px/1.45 system-ui, sans-serif; color: var(--text); background: var(--page); }
header, main { padding: 0 1rem; }
h1 { font-size: 1.35rem; margin: .7rem 0 .2rem; overflow-wrap: anywhere; }
h2 { font-size: 1.1rem; margin: 1.6rem 0 .4rem; }
h3 { font-size: 1rem; margin: 1rem 0 .3rem; }
a { color: var(--link); }
p, li, code { overflow-wrap: anywhere; }
nav a { margin-right: .8em; display: inline-block; padding: .15rem 0; }
.skip { position: absolute; left: -99rem; }
.skip:focus { left: 1rem; top: .3rem; background: var(--page); padding: .3rem; z-index: 2; }
:focus-visible { outline: 3px solid var(--link); outline-offset: 1px; }
.scroll { overflow: auto; max-height: 26rem; border: 1px solid var(--line); }
table { border-collapse: collapse; width: 100%; }
th, td { padding: .25rem .55rem; text-align: left; font-weight: normal; border-bottom: 1px solid var(--line); vertical-align: top; }
thead th { position: sticky; top: 0; background: var(--page); font-weight: 600; white-space: nowrap; }
th.number, td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
tbody th { overflow-wrap: anywhere; min-width: 5rem; }
pre { overflow: auto; padding: .6rem; border: 1px solid var(--line); background: var(--canvas); white-space: pre-wrap; overflow-wrap: anywhere; }
button, select, summary { font: inherit; color: inherit; background: var(--button); border: 1px solid var(--line);
  border-radius: 4px; padding: .2rem .5rem; min-height: 1.9rem; }
button { cursor: pointer; }
button.show { white-space: nowrap; }
[hidden] { display: none !important; }
.charts { display: flex; flex-wrap: wrap; gap: 1rem; margin: .8rem 0; }
svg.histogram { font-size: 12px; fill: currentColor; max-width: 100%; }
svg.still { width: 100%; max-width: 720px; height: auto; background: #fff; }
svg.still .names { font-size: 12px; text-anchor: middle; fill: #111; stroke: #fff; stroke-width: 3px; paint-order: stroke; }
.bar { height: .9rem; }
td .bar { background: var(--link); min-width: 1px; }
#viewer .bar { height: auto; display: flex; flex-wrap: wrap; gap: .4rem .8rem; align-items: center; margin: .4rem 0; }
#viewer label { white-space: nowrap; }
#viewer .check input { width: 1.05rem; height: 1.05rem; vertical-align: -.15rem; }
#cut-at { width: 9rem; }
#viewer .canvas { position: relative; overflow: hidden; height: 62vh; min-height: 18rem; border: 1px solid var(--line);
  background: var(--canvas); }
#viewer canvas { position: absolute; width: 100%; height: 100%; touch-action: none; display: block; }
#viewer .names span { position: absolute; left: 0; top: 0; pointer-events: none; font-size: 12px; padding: 0 .25rem;
  background: var(--page); border: 1px solid var(--line); border-radius: 3px; white-space: nowrap; max-width: 12rem;
  overflow: hidden; text-overflow: ellipsis; }
#legend { display: flex; flex-wrap: wrap; gap: .2rem .9rem; align-items: center; padding: .3rem 0; min-height: 1.9rem;
  overflow-wrap: anywhere; }
#legend .swatch { display: inline-block; width: .9rem; height: .9rem; margin-right: .3rem; border: 1px solid var(--line); vertical-align: -.1rem; }
#legend .scale { display: inline-block; width: 12rem; max-width: 50vw; height: .9rem; border: 1px solid var(--line); }
#picked { min-height: 1.5rem; overflow-wrap: anywhere; }
#picked dl { display: flex; flex-wrap: wrap; gap: .1rem 1.2rem; margin: 0; }
#picked dt, #picked dd { display: inline; margin: 0; }
#picked dt { color: var(--quiet); }
#picked dt::after { content: ": "; }
.switches { margin: .3rem 0; }
.switches div { display: flex; flex-wrap: wrap; gap: .1rem .9rem; max-height: 9rem; overflow: auto; padding: .3rem 0; }
.has-viewer #stills { display: none; }
@media (min-width: 70rem) {
  main { display: grid; grid-template-columns: minmax(0, 1.25fr) minmax(0, 1fr); gap: 1.5rem; align-items: start; }
  #show { position: sticky; top: .3rem; }
  #tables > section:first-child h2 { margin-top: .3rem; }
}
@media (max-width: 40rem) {
  header, main { padding: 0 .6rem; }
  button, select, summary { min-height: 2.4rem; }
  #viewer .canvas { height: 58vh; }
  #cut-at { width: 100%; }
}
@media print { #viewer { display: none; } .has-viewer #stills { display: block; } .scroll { max-height: none; } }
)css";

#endif // TUBULAR_MESH_PAGE_PAGE_STYLE_H
