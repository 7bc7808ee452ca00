/** The material as a shaded surface: a plane whose heights come from a picture of numbers. */

import {
  Color,
  DataTexture,
  DoubleSide,
  FloatType,
  GLSL3,
  Mesh,
  PlaneGeometry,
  RawShaderMaterial,
  RedFormat,
} from "three";
import type { Stock } from "../stock";
import type { Palette } from "./palette";

const vertexShader = `
in vec3 position;
in vec2 uv;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
uniform sampler2D heights;
uniform vec2 corner;
uniform vec2 extent;
uniform float top;
out vec3 vNormal;
out float vDepth;
float heightAt(ivec2 cell) {
  ivec2 size = textureSize(heights, 0);
  return texelFetch(heights, clamp(cell, ivec2(0), size - 1), 0).r;
}
void main() {
  ivec2 size = textureSize(heights, 0);
  ivec2 cell = ivec2(round(uv * vec2(size - 1)));
  vec2 step = extent / vec2(size - 1);
  float z = heightAt(cell);
  float dx = (heightAt(cell + ivec2(1, 0)) - heightAt(cell - ivec2(1, 0))) / (2.0 * step.x);
  float dy = (heightAt(cell + ivec2(0, 1)) - heightAt(cell - ivec2(0, 1))) / (2.0 * step.y);
  vNormal = normalize(vec3(-dx, -dy, 1.0));
  vDepth = top - z;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(corner + uv * extent, z, 1.0);
}`;

const fragmentShader = `
precision highp float;
uniform vec3 whole;
uniform vec3 bared;
in vec3 vNormal;
in float vDepth;
out vec4 colour;
void main() {
  float light = 0.45 + 0.55 * max(dot(normalize(vNormal), normalize(vec3(-0.5, 0.4, 0.9))), 0.0);
  vec3 wood = vDepth > 1e-4 ? bared : whole;
  colour = vec4(wood * light, 1.0);
}`;

/** A mesh that shows a stock; `show` it whenever it was cut. */
export class StockMesh {
  readonly mesh: Mesh;
  readonly #material: RawShaderMaterial;
  readonly #texture: DataTexture;

  constructor(stock: Stock) {
    const { columns, rows, cell, shape } = stock;
    this.#texture = new DataTexture(stock.heights, columns, rows, RedFormat, FloatType);
    this.#texture.needsUpdate = true;
    this.#material = new RawShaderMaterial({
      glslVersion: GLSL3,
      side: DoubleSide,
      vertexShader,
      fragmentShader,
      uniforms: {
        heights: { value: this.#texture },
        corner: { value: [shape.x, shape.y] },
        extent: { value: [(columns - 1) * cell, (rows - 1) * cell] },
        top: { value: shape.top },
        whole: { value: new Color() },
        bared: { value: new Color() },
      },
    });
    this.mesh = new Mesh(new PlaneGeometry(1, 1, columns - 1, rows - 1), this.#material);
    this.mesh.frustumCulled = false;
  }

  /** The heights changed. */
  show(): void {
    this.#texture.needsUpdate = true;
  }

  paint(palette: Palette): void {
    const colour = (style: string) => new Color().setStyle(style).convertLinearToSRGB();
    Object.assign(this.#material.uniforms, {
      whole: { value: colour(palette.whole) },
      bared: { value: colour(palette.bared) },
    });
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.#material.dispose();
    this.#texture.dispose();
  }
}
