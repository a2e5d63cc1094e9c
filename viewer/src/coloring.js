// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

import { KINDS } from "./mesh.js";

function rgb(hex) {
  const n = parseInt(hex.slice(1), 16);
  return [n >> 16, (n >> 8) & 255, n & 255];
}

/** The colours of facets and of faces that are laid bare; what they are by, and the legend to it. */
export class Coloring {
  constructor(mesh) {
    this.mesh = mesh;
    const { palette, scale, patches, regions } = mesh.header;
    this.palette = palette.map(rgb);
    this.scale = scale.map(rgb);
    this.patches = patches.map((p) => rgb(p.color));
    this.regions = regions.length ? regions.map((r) => rgb(r.color)) : [[201, 218, 232]];
    this.by = "patch";
    this.findSizes();
  }

  findSizes() {
    const { mesh } = this;
    const sizes = new Float32Array(mesh.numberOfFacets);
    for (let f = 0; f < sizes.length; ++f) sizes[f] = mesh.sizeOf(mesh.facet(f));
    sizes.sort();
    const hundredth = Math.floor(sizes.length / 100);
    this.sizes = [sizes[hundredth], sizes[sizes.length - 1 - hundredth]];
  }

  onScale(t) {
    const at = Math.min(Math.max(t || 0, 0), 1) * (this.scale.length - 1);
    const i = Math.min(Math.floor(at), this.scale.length - 2);
    const w = at - i;
    return this.scale[i].map((x, k) => (1 - w) * x + w * this.scale[i + 1][k]);
  }

  numbered(i) {
    return this.palette[i % this.palette.length];
  }

  ofSize(size) {
    const [low, high] = this.sizes;
    return this.onScale(high > low ? Math.log(size / low) / Math.log(high / low) : 0.5);
  }

  ofFacet(f) {
    const { mesh } = this;
    switch (this.by) {
      case "region":
        return this.regions[mesh.facetRegion[f]];
      case "type":
        return this.numbered(mesh.facetKind[f]);
      case "quality":
        return this.onScale(mesh.facetQuality[f]);
      case "size":
        return this.ofSize(mesh.sizeOf(mesh.facet(f)));
      case "branch":
        return this.numbered(mesh.facetBranch[f]);
      default:
        return this.patches[mesh.patch[f]];
    }
  }

  ofFace(cell, corners) {
    const { mesh } = this;
    switch (this.by) {
      case "type":
        return this.numbered(mesh.cellKind[cell]);
      case "quality":
        return this.onScale(mesh.cellQuality[cell]);
      case "size":
        return this.ofSize(mesh.sizeOf(corners));
      case "branch":
        return this.numbered(mesh.cellBranch[cell]);
      default:
        return this.regions[mesh.cellRegion[cell]];
    }
  }

  /** Colours with what they stand for, or a scale with its ends; what has no end is cut off. */
  legend() {
    const { mesh } = this;
    const { patches, regions, palette, scale } = mesh.header;
    const some = (list) => (list.length > 9 ? [...list.slice(0, 8), { name: `and ${list.length - 8} more` }] : list);
    switch (this.by) {
      case "region":
        return { entries: some(regions) };
      case "type": {
        const kinds = [...new Set(mesh.facetKind)].sort();
        for (const chunk of mesh.header.chunks)
          chunk.cells.forEach((n, kind) => {
            if (n > 0 && !kinds.includes(kind)) kinds.push(kind);
          });
        return { entries: kinds.map((k) => ({ name: KINDS[k], color: palette[k % palette.length] })) };
      }
      case "quality":
        return { scale, low: "0", high: "1" };
      case "size":
        return { scale, low: this.sizes[0].toPrecision(3), high: this.sizes[1].toPrecision(3) };
      case "branch":
        return { entries: [{ name: "each branch has the colour of its number, from eight" }] };
      default:
        return { entries: some(patches) };
    }
  }
}
