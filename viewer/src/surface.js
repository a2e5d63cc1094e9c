// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

import { BufferAttribute, BufferGeometry, DoubleSide, GLSL3, Mesh as Object3D, RawShaderMaterial, Ray, Vector3 } from "three";
import { MeshBVH } from "three-mesh-bvh";

const VERTEX = `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
in vec4 color; // its last: which sides are no edges of an element
out vec3 vColor, vSide, vPosition;
void main() {
  int corner = gl_VertexID % 3, hidden = int(color.a * 255.0 + 0.5);
  vSide = vec3(corner == 0 || (hidden & 1) != 0, corner == 1 || (hidden & 2) != 0, corner == 2 || (hidden & 4) != 0);
  vColor = color.rgb;
  vec4 p = modelViewMatrix * vec4(position, 1.0);
  vPosition = p.xyz;
  gl_Position = projectionMatrix * p;
}`;

// Flat light from where the reader is, a little from above; edges fade where elements are but a few pixels wide.
const FRAGMENT = `
precision highp float;
uniform float edges, opacity;
in vec3 vColor, vSide, vPosition;
out vec4 result;
void main() {
  vec3 n = normalize(cross(dFdx(vPosition), dFdy(vPosition)));
  float light = 0.4 + 0.6 * abs(dot(n, vec3(0.0, 0.33, 0.944)));
  if (edges > 0.0) {
    vec3 width = max(fwidth(vSide), 1e-6);
    vec3 near = smoothstep(0.5 * width, 1.3 * width, vSide);
    float fade = clamp(1.4 - 5.0 * max(width.x, max(width.y, width.z)), 0.0, 1.0);
    light *= 1.0 - 0.65 * fade * (1.0 - min(near.x, min(near.y, near.z)));
  }
  result = vec4(vColor * light, opacity);
}`;

function material(offset) {
  return new RawShaderMaterial({
    glslVersion: GLSL3,
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: { edges: { value: 1 }, opacity: { value: 1 } },
    side: DoubleSide,
    polygonOffset: offset,
    polygonOffsetFactor: 1,
    polygonOffsetUnits: 1,
  });
}

// Sides of a triangle that are no edges, by the bit of the corner across: of a quad's two, the side between them.
const OF_TRIANGLE = [[0, 1, 2, 0]];
const OF_QUAD = [
  [0, 1, 2, 2],
  [0, 2, 3, 4],
];

/** Faces of three or four corners as triangles, each with a colour, that can be drawn and picked. */
export class Surface {
  constructor(isBehind) {
    this.material = material(isBehind);
    this.object = new Object3D(new BufferGeometry(), this.material);
    this.object.frustumCulled = false;
  }

  /** Of n faces: their corners, and the points. */
  setFaces(n, cornersOf, points) {
    let triangles = 0;
    for (let i = 0; i < n; ++i) triangles += cornersOf(i).length - 2;
    const positions = new Float32Array(9 * triangles);
    this.colors = new Uint8Array(12 * triangles);
    this.faceOf = new Uint32Array(triangles);
    this.firstOf = new Uint32Array(n + 1);
    let t = 0;
    for (let i = 0; i < n; ++i) {
      const corners = cornersOf(i);
      this.firstOf[i] = t;
      for (const [a, b, c, hidden] of corners.length === 4 ? OF_QUAD : OF_TRIANGLE) {
        for (let k = 0; k < 3; ++k) {
          const v = corners[k === 0 ? a : k === 1 ? b : c];
          for (let x = 0; x < 3; ++x) positions[9 * t + 3 * k + x] = points[3 * v + x];
          this.colors[12 * t + 4 * k + 3] = hidden;
        }
        this.faceOf[t++] = i;
      }
    }
    this.firstOf[n] = t;
    this.object.geometry.dispose();
    const geometry = (this.object.geometry = new BufferGeometry());
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("color", new BufferAttribute(this.colors, 4, true));
    this.bvh = null;
    this.isSeen = null;
  }

  setColors(colorOf) {
    for (let i = 0; i + 1 < this.firstOf.length; ++i) {
      const [r, g, b] = colorOf(i);
      for (let v = 3 * this.firstOf[i]; v < 3 * this.firstOf[i + 1]; ++v) {
        this.colors[4 * v] = r;
        this.colors[4 * v + 1] = g;
        this.colors[4 * v + 2] = b;
      }
    }
    this.object.geometry.attributes.color.needsUpdate = true;
  }

  /** Draws some of the faces alone. */
  show(faces) {
    const n = this.firstOf.length - 1;
    this.isSeen = new Uint8Array(n);
    for (const f of faces) this.isSeen[f] = 1;
    const { geometry } = this.object;
    if (faces.length === n) {
      geometry.setIndex(null);
      geometry.setDrawRange(0, Infinity);
      return;
    }
    this.index ??= new BufferAttribute(new Uint32Array(3 * this.faceOf.length), 1); // one for all cuts
    let at = 0;
    for (const f of faces)
      for (let v = 3 * this.firstOf[f]; v < 3 * this.firstOf[f + 1]; ++v) this.index.array[at++] = v;
    this.index.needsUpdate = true;
    geometry.setIndex(this.index);
    geometry.setDrawRange(0, at);
  }

  setOpacity(opacity) {
    this.material.uniforms.opacity.value = opacity;
    this.material.transparent = opacity < 1;
    this.material.depthWrite = opacity === 1;
    this.object.visible = opacity > 0;
  }

  /** The nearest face along a ray that is seen: { face, distance }, or null. */
  pick(ray) {
    if (!this.object.visible || !this.firstOf || this.firstOf.length < 2) return null;
    if (!this.bvh) {
      const all = new BufferGeometry(); // with those that are not drawn now
      all.setAttribute("position", this.object.geometry.attributes.position);
      this.bvh = new MeshBVH(all, { indirect: true });
    }
    let best = null;
    for (const hit of this.bvh.raycast(ray, DoubleSide)) {
      const face = this.faceOf[hit.faceIndex];
      if ((!this.isSeen || this.isSeen[face]) && (!best || hit.distance < best.distance))
        best = { face, distance: hit.distance, point: hit.point };
    }
    return best;
  }
}

export function rayOf(origin, direction) {
  return new Ray(new Vector3(...origin), new Vector3(...direction));
}
