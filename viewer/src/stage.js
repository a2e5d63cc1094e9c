// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  LineBasicMaterial,
  LineSegments,
  Mesh as Object3D,
  MeshBasicMaterial,
  PerspectiveCamera,
  Raycaster,
  Scene,
  SphereGeometry,
  Vector2,
  Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

/** The canvas, its camera, and what is drawn beside the mesh. It draws when something has changed, and not otherwise. */
export class Stage {
  constructor(canvas, mesh) {
    this.canvas = canvas;
    this.mesh = mesh;
    const isSlow = drawsBySoftware();
    this.renderer = new WebGLRenderer({ canvas, antialias: !isSlow });
    this.renderer.setPixelRatio(isSlow ? 1 : Math.min(window.devicePixelRatio, 2));
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(30, 1, 1, 10);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.controls.zoomToCursor = true;
    this.afterDraw = () => {};
    this.findExtent();
    this.addMarker();
    this.look(mesh.header.from);
  }

  findExtent() {
    const { points } = this.mesh;
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < points.length; ++i) {
      const k = i % 3;
      if (points[i] < low[k]) low[k] = points[i];
      if (points[i] > high[k]) high[k] = points[i];
    }
    this.middle = new Vector3(...low).add(new Vector3(...high)).multiplyScalar(0.5);
    this.radius = new Vector3(...high).sub(this.middle).length() || 1;
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (width === 0 || height === 0) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  setBackground(color) {
    this.scene.background = new Color(color);
    this.draw();
  }

  /** At all of it, from a direction; or from where one looks now. */
  look(from) {
    const direction = from ? new Vector3(...from) : this.camera.position.clone().sub(this.controls.target);
    this.focus(this.middle, this.radius * 1.02, direction);
  }

  /** At a ball around a point, from where one looks now or from another direction. */
  focus(center, radius, from) {
    const direction = (from ?? this.camera.position.clone().sub(this.controls.target)).normalize();
    // OrbitControls cannot look straight along its axis, from where it cannot turn.
    if (Math.abs(direction.z) > 0.999) direction.set(direction.x, direction.y - 0.03, direction.z).normalize();
    const angle = (this.camera.fov * Math.PI) / 360;
    const narrow = Math.min(1, this.camera.aspect);
    this.controls.target.copy(center);
    this.camera.position.copy(center).addScaledVector(direction, radius / Math.sin(angle) / narrow);
    this.controls.update();
    this.draw();
  }

  draw() {
    if (this.isDue) return;
    this.isDue = true;
    requestAnimationFrame(() => {
      this.isDue = false;
      this.drawNow();
    });
  }

  drawNow() {
    const distance = this.camera.position.distanceTo(this.middle);
    this.camera.far = distance + this.radius * 1.1;
    this.camera.near = Math.max(distance - this.radius * 1.1, this.radius * 1e-4);
    this.camera.updateProjectionMatrix();
    const size = this.camera.position.distanceTo(this.controls.target) * 0.008;
    if (!this.marker.userData.radius) this.marker.scale.setScalar(size);
    this.renderer.render(this.scene, this.camera);
    this.afterDraw();
  }

  /** Draws n frames from all around, and waits for each: frames per second. */
  benchmark(n) {
    const gl = this.renderer.getContext();
    const pixel = new Uint8Array(4);
    const position = this.camera.position.clone();
    const finished = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    this.drawNow();
    finished();
    const begin = performance.now();
    for (let i = 0; i < n; ++i) {
      this.camera.position
        .sub(this.controls.target)
        .applyAxisAngle(this.camera.up, (2 * Math.PI) / n)
        .add(this.controls.target);
      this.camera.lookAt(this.controls.target);
      this.drawNow();
      finished();
    }
    const seconds = (performance.now() - begin) / 1000;
    this.camera.position.copy(position);
    this.controls.update();
    return n / seconds;
  }

  turn(right, up) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    offset.applyAxisAngle(this.camera.up, -right);
    const side = new Vector3().crossVectors(this.camera.up, offset).normalize();
    const turned = offset.clone().applyAxisAngle(side, -up);
    if (Math.abs(turned.clone().normalize().dot(this.camera.up)) < 0.995) offset.copy(turned);
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.draw();
  }

  move(right, up) {
    const distance = this.camera.position.distanceTo(this.controls.target);
    const step = new Vector3(right * distance, up * distance, 0).applyQuaternion(this.camera.quaternion);
    this.camera.position.add(step);
    this.controls.target.add(step);
    this.controls.update();
    this.draw();
  }

  zoom(factor) {
    const { target } = this.controls;
    this.camera.position.sub(target).multiplyScalar(factor).add(target);
    this.controls.update();
    this.draw();
  }

  /** The direction from which one looks. */
  from() {
    return this.camera.position.clone().sub(this.controls.target).normalize().toArray();
  }

  /** Through a place of the canvas, in its pixels. */
  ray(x, y) {
    const { clientWidth, clientHeight } = this.canvas;
    const caster = new Raycaster();
    caster.setFromCamera(new Vector2((x / clientWidth) * 2 - 1, 1 - (y / clientHeight) * 2), this.camera);
    return caster.ray;
  }

  /** Where a point is on the canvas, in its pixels; null behind the camera. */
  project(point) {
    const p = point.clone().project(this.camera);
    if (p.z > 1) return null;
    return [((p.x + 1) / 2) * this.canvas.clientWidth, ((1 - p.y) / 2) * this.canvas.clientHeight];
  }

  addMarker() {
    const material = new MeshBasicMaterial({ color: 0xd50057, depthTest: false, transparent: true, opacity: 0.85 });
    this.marker = new Object3D(new SphereGeometry(1, 16, 12), material);
    this.marker.renderOrder = 4;
    this.marker.visible = false;
    this.scene.add(this.marker);
  }

  mark(point) {
    this.marker.visible = point !== null;
    if (point) this.marker.position.copy(point);
    this.draw();
  }
}

// Whether there is no graphics processor: then each pixel takes time.
function drawsBySoftware() {
  const gl = document.createElement("canvas").getContext("webgl2");
  const name = gl ? String(gl.getParameter(gl.RENDERER)) + gl.getParameter(extensionOf(gl)) : "";
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software/i.test(name);
}

function extensionOf(gl) {
  return gl.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER;
}

/** Segments, three coordinates a point, that are seen through the mesh or not. */
export function lines(positions, color, { over = false, width = 1, opacity = 1 } = {}) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
  const material = new LineBasicMaterial({ color, linewidth: width, opacity, transparent: over || opacity < 1, depthTest: !over });
  const object = new LineSegments(geometry, material);
  object.renderOrder = over ? 2 : 0;
  object.frustumCulled = false;
  return object;
}
