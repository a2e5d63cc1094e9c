// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

import { FACES } from "./mesh.js";

/**
 * Which facets are seen, and which faces of cells a cut lays bare. A cut takes whole cells away: those whose centre is
 * beyond the plane, and those of regions that are hidden.
 */
export class Cut {
  constructor(mesh) {
    this.mesh = mesh;
    this.normal = null; // none: nothing is cut
    this.offset = 0;
    this.hiddenRegions = new Set();
    this.hiddenPatches = new Set();
    this.facetHeights = null;
  }

  /** Along a normal, or null. Returns the range of heights. */
  setNormal(normal) {
    this.normal = normal;
    if (!normal) return null;
    const { mesh } = this;
    const heights = new Float32Array(mesh.points.length / 3);
    let low = Infinity;
    let high = -Infinity;
    for (let v = 0; v < heights.length; ++v) {
      const h = normal[0] * mesh.points[3 * v] + normal[1] * mesh.points[3 * v + 1] + normal[2] * mesh.points[3 * v + 2];
      heights[v] = h;
      if (h < low) low = h;
      if (h > high) high = h;
    }
    this.facetHeights = new Float32Array(mesh.numberOfFacets);
    for (let f = 0; f < mesh.numberOfFacets; ++f) {
      const corners = mesh.facet(f);
      let sum = 0;
      for (const v of corners) sum += heights[v];
      this.facetHeights[f] = sum / corners.length;
    }
    this.cellHeights = new Float32Array(mesh.numberOfCells);
    for (let c = 0; c < mesh.numberOfCells; ++c) {
      let sum = 0;
      for (let i = mesh.cellStart[c]; i < mesh.cellStart[c + 1]; ++i) sum += heights[mesh.cellCorners[i]];
      this.cellHeights[c] = sum / (mesh.cellStart[c + 1] - mesh.cellStart[c]);
    }
    return [low, high];
  }

  get isCutting() {
    return this.normal !== null || this.hiddenRegions.size > 0;
  }

  keepsCell(c) {
    return (
      !(this.normal && this.cellHeights[c] > this.offset) && !this.hiddenRegions.has(this.mesh.cellRegion[c])
    );
  }

  /** Whether there is a cell on a side of a facet that stays; where it is not on the page, by the facet's own centre. */
  keepsSide(f, side) {
    const { mesh } = this;
    const cell = mesh.sides[side][f];
    if (cell > 0 && mesh.numberOfCells > 0) return this.keptCells[cell - 1] === 1;
    if (side === 1 && mesh.beyond[f] === 0) return false;
    if (this.normal && this.facetHeights[f] > this.offset) return false;
    return !this.hiddenRegions.has(side === 0 ? mesh.facetRegion[f] : mesh.beyond[f] - 1);
  }

  /** The facets that are seen, and the faces laid bare as [cell, face of the cell] one after another. */
  seen() {
    const { mesh } = this;
    const n = mesh.numberOfCells;
    this.keptCells = new Uint8Array(n);
    const faces = [];
    if (n > 0 && this.isCutting) this.findFaces(faces);
    else this.keptCells.fill(1);
    const facets = [];
    for (let f = 0; f < mesh.numberOfFacets; ++f)
      if (!this.hiddenPatches.has(mesh.patch[f]) && this.keepsSide(f, 0) !== this.keepsSide(f, 1)) facets.push(f);
    return { facets, faces };
  }

  // A face that is laid bare has corners that all belong to cells that were taken away. So do a few behind it.
  findFaces(faces) {
    const { mesh, keptCells } = this;
    const bare = new Uint8Array(mesh.points.length / 3);
    for (let c = 0; c < mesh.numberOfCells; ++c) {
      if (this.keepsCell(c)) keptCells[c] = 1;
      else for (let i = mesh.cellStart[c]; i < mesh.cellStart[c + 1]; ++i) bare[mesh.cellCorners[i]] = 1;
    }
    for (let c = 0; c < mesh.numberOfCells; ++c) {
      if (!keptCells[c]) continue;
      const start = mesh.cellStart[c];
      let number = 0;
      for (let i = start; i < mesh.cellStart[c + 1]; ++i) number += bare[mesh.cellCorners[i]];
      if (number < 3) continue;
      FACES[mesh.cellKind[c]].forEach((face, k) => {
        if (face.every((corner) => bare[mesh.cellCorners[start + corner]])) faces.push(c, k);
      });
    }
  }
}

/** The corners of a face of a cell. */
export function cornersOf(mesh, cell, face) {
  const start = mesh.cellStart[cell];
  return FACES[mesh.cellKind[cell]][face].map((corner) => mesh.cellCorners[start + corner]);
}
