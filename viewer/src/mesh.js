// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

import { readPart, readPoints, readQuality } from "./unpack.js";

export const NONE = 0xffffffff;

/** What a kind of elements is called, and its faces by its corners: tetrahedra, pyramids, prisms, hexahedra. */
export const KINDS = ["tetrahedron", "pyramid", "prism", "hexahedron", "triangle", "quad"];
const CORNERS = [4, 5, 6, 8];
export const FACES = [
  [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]],
  [[0, 3, 2, 1], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
  [[0, 2, 1], [3, 4, 5], [0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]],
  [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]],
];

/**
 * The mesh of the page: its facets, and its cells once they are needed. Points are in the unit of the surface, relative
 * to `origin`; those on facets come first.
 */
export class Mesh {
  constructor(header, facets) {
    this.header = header;
    this.step = header.step;
    this.origin = header.origin;
    this.readFacets(facets, header.facets);
    this.numberOfCells = 0; // none is read yet
  }

  static async read(document) {
    const header = JSON.parse(document.getElementById("scene").textContent);
    const mesh = new Mesh(header, await readPart(document.getElementById("part-0"), header.facets));
    mesh.document = document;
    return mesh;
  }

  readFacets(sections, header) {
    const triangles = header.triangles;
    const n = (this.numberOfFacets = triangles + header.quads);
    this.points = new Float32Array(3 * header.points);
    readPoints(sections.points, header.points, this.points, 0);
    for (let i = 0; i < this.points.length; ++i) this.points[i] *= this.step;
    this.facetCorners = new Uint32Array(4 * n).fill(NONE);
    let first = 0;
    for (let f = 0; f < n; ++f) {
      let last = first;
      for (let k = 0; k < (f < triangles ? 3 : 4); ++k) {
        last += sections.corners.signed();
        this.facetCorners[4 * f + k] = last;
        if (k === 0) first = last;
      }
    }
    this.patch = sections.patch.differences(n, Uint16Array);
    this.facetBranch = sections.branch.differences(n, Uint32Array);
    this.facetKind = sections.kind.differences(n, Uint8Array);
    this.facetRegion = sections.region.differences(n, Uint16Array);
    this.beyond = sections.beyond.differences(n, Uint16Array);
    this.facetQuality = readQuality(sections.quality, n);
    this.sides = [sections.cell.differences(n, Uint32Array), sections.other_cell.differences(n, Uint32Array)];
  }

  /** Reads all cells of the page; at once if they are there. */
  readCells() {
    this.reading ??= this.readAllCells();
    return this.reading;
  }

  async readAllCells() {
    const { chunks } = this.header;
    const read = [];
    for (let i = 0; i < chunks.length; ++i)
      read.push(await readPart(this.document.getElementById(`part-${i + 1}`), chunks[i]));
    let points = this.points.length / 3;
    const outer = points;
    let cells = 0;
    let corners = 0;
    for (const chunk of chunks) {
      points += chunk.points;
      chunk.cells.forEach((n, kind) => {
        cells += n;
        corners += n * CORNERS[kind];
      });
    }
    const old = this.points;
    this.points = new Float32Array(3 * points);
    this.cellStart = new Uint32Array(cells + 1);
    this.cellCorners = new Uint32Array(corners);
    this.cellKind = new Uint8Array(cells);
    this.cellRegion = new Uint16Array(cells);
    this.cellBranch = new Uint32Array(cells);
    this.cellQuality = new Float32Array(cells);
    let cell = 0;
    let point = outer;
    for (let i = 0; i < chunks.length; ++i) {
      this.readChunk(read[i], chunks[i], cell, point, outer);
      cell += chunks[i].cells.reduce((a, b) => a + b);
      point += chunks[i].points;
    }
    for (let i = old.length; i < this.points.length; ++i) this.points[i] *= this.step;
    this.points.set(old);
    this.numberOfCells = cells;
  }

  readChunk(sections, header, cell, point, outer) {
    readPoints(sections.points, header.points, this.points, point);
    const begin = cell;
    const first = [0, 0];
    header.cells.forEach((n, kind) => {
      for (let i = 0; i < n; ++i, ++cell) {
        const inside = sections.inside.byte();
        const last = [first[0], first[1]];
        const isFirst = [true, true];
        let at = this.cellStart[cell];
        for (let k = 0; k < CORNERS[kind]; ++k) {
          const side = (inside >> k) & 1;
          last[side] += sections.corners.signed();
          if (isFirst[side]) {
            first[side] = last[side];
            isFirst[side] = false;
          }
          this.cellCorners[at++] = side ? outer + last[side] : last[side];
        }
        this.cellKind[cell] = kind;
        this.cellStart[cell + 1] = at;
      }
    });
    const number = cell - begin;
    this.cellRegion.set(sections.region.differences(number, Uint16Array), begin);
    this.cellBranch.set(sections.branch.differences(number, Uint32Array), begin);
    this.cellQuality.set(readQuality(sections.quality, number), begin);
  }

  /** The corners of a facet. */
  facet(f) {
    const corners = this.facetCorners.subarray(4 * f, 4 * f + 4);
    return corners[3] === NONE ? corners.subarray(0, 3) : corners;
  }

  centerOf(corners) {
    const center = [0, 0, 0];
    for (const v of corners) for (let k = 0; k < 3; ++k) center[k] += this.points[3 * v + k] / corners.length;
    return center;
  }

  cell(c) {
    return this.cellCorners.subarray(this.cellStart[c], this.cellStart[c + 1]);
  }

  distance(a, b) {
    const p = this.points;
    return Math.hypot(p[3 * a] - p[3 * b], p[3 * a + 1] - p[3 * b + 1], p[3 * a + 2] - p[3 * b + 2]);
  }

  /** The mean length of the edges of a face. */
  sizeOf(corners) {
    let sum = 0;
    for (let i = 0; i < corners.length; ++i) sum += this.distance(corners[i], corners[(i + 1) % corners.length]);
    return sum / corners.length;
  }
}
