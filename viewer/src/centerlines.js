// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

import { Group, Vector3 } from "three";
import { lines } from "./stage.js";

/** The branches of the page: their points and radii, in the mesh's coordinates. */
export class Centerlines {
  constructor({ branches, step }) {
    this.branches = branches.map((numbers) => {
      const points = [];
      for (let i = 0; i < numbers.length; i += 4)
        points.push({
          at: new Vector3(numbers[i], numbers[i + 1], numbers[i + 2]).multiplyScalar(step),
          radius: numbers[i + 3] * step,
        });
      return points;
    });
  }

  /** Lines, and rings of their radius. */
  object() {
    const segments = [];
    const rings = [];
    for (const points of this.branches) {
      let since = Infinity;
      for (let i = 1; i < points.length; ++i) {
        const a = points[i - 1];
        const b = points[i];
        segments.push(...a.at.toArray(), ...b.at.toArray());
        since += a.at.distanceTo(b.at);
        if (since < b.radius || i + 1 === points.length) continue;
        since = 0;
        addRing(rings, b, b.at.clone().sub(a.at));
      }
    }
    const group = new Group();
    group.add(lines(segments, 0x111111, { over: true }), lines(rings, 0x333333, { over: true, opacity: 0.5 }));
    return group;
  }

  highlight(branch) {
    const points = this.branches[branch];
    const segments = [];
    for (let i = 1; i < points.length; ++i) segments.push(...points[i - 1].at.toArray(), ...points[i].at.toArray());
    const rings = [];
    points.forEach((p, i) => {
      if (i > 0) addRing(rings, p, p.at.clone().sub(points[i - 1].at));
    });
    const group = new Group();
    group.add(lines(segments, 0xd50057, { over: true }), lines(rings, 0xd50057, { over: true, opacity: 0.4 }));
    group.renderOrder = 3;
    return group;
  }

  /** A ball around a branch. */
  extent(branch) {
    const points = this.branches[branch];
    const center = points[0].at.clone().add(points[points.length - 1].at).multiplyScalar(0.5);
    let radius = 0;
    for (const p of points) radius = Math.max(radius, p.at.distanceTo(center) + p.radius);
    return { center, radius };
  }

  /** The radius of a branch where it is nearest to a point. */
  radiusAt(branch, point) {
    let best = null;
    for (const p of this.branches[branch] ?? [])
      if (!best || p.at.distanceToSquared(point) < best.at.distanceToSquared(point)) best = p;
    return best?.radius;
  }
}

function addRing(positions, { at, radius }, direction) {
  const n = 24;
  const axis = direction.lengthSq() > 0 ? direction.normalize() : new Vector3(0, 0, 1);
  const u = new Vector3(Math.abs(axis.x) < 0.7 ? 1 : 0, Math.abs(axis.x) < 0.7 ? 0 : 1, 0).cross(axis).normalize();
  const v = axis.clone().cross(u);
  const corner = (i) => {
    const a = (2 * Math.PI * i) / n;
    return at.clone().addScaledVector(u, radius * Math.cos(a)).addScaledVector(v, radius * Math.sin(a)).toArray();
  };
  for (let i = 0; i < n; ++i) positions.push(...corner(i), ...corner(i + 1));
}
