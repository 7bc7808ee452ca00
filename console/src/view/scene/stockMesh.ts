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
  RGFormat,
} from "three";
import { slopesOf } from "../slopes";
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
out vec2 vCell;
out vec3 vPlace;
void main() {
  vec2 last = vec2(textureSize(heights, 0) - 1);
  vCell = uv * last;
  float z = texelFetch(heights, ivec2(round(vCell)), 0).r;
  vPlace = vec3(corner + uv * extent, z);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(vPlace, 1.0);
}`;

const fragmentShader = `
precision highp float;
uniform sampler2D slopes;
uniform float top;
uniform vec3 whole;
uniform vec3 bared;
in vec2 vCell;
in vec3 vPlace;
out vec4 colour;
// The slope between the middles of cells.
vec2 slopeAt(vec2 at) {
  ivec2 last = textureSize(slopes, 0) - 1;
  ivec2 low = ivec2(floor(at));
  ivec2 high = min(low + 1, last);
  vec2 share = at - vec2(low);
  vec2 front = mix(texelFetch(slopes, low, 0).rg, texelFetch(slopes, ivec2(high.x, low.y), 0).rg, share.x);
  vec2 back = mix(texelFetch(slopes, ivec2(low.x, high.y), 0).rg, texelFetch(slopes, high, 0).rg, share.x);
  return mix(front, back, share.y);
}

void main() {
  // What is level stays level, next to a wall too.
  vec3 facet = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
  float up = abs(facet.z);
  vec2 slope = slopeAt(vCell);
  bool level = up > 0.98 || slope == vec2(0.0);
  // A face is as steep as it lies there, and looks the way that the curve through its steps does.
  vec3 normal = level ? vec3(0.0, 0.0, 1.0) : vec3(-normalize(slope) * sqrt(1.0 - up * up), up);
  float light = 0.45 + 0.55 * max(dot(normal, normalize(vec3(-0.5, 0.4, 0.9))), 0.0);
  vec3 wood = top - vPlace.z > 1e-4 ? bared : whole;
  colour = vec4(wood * light, 1.0);
}`;

/** A mesh that shows a stock; `show` it whenever it was cut. */
export class StockMesh {
  readonly mesh: Mesh;
  readonly #material: RawShaderMaterial;
  readonly #stock: Stock;
  readonly #heights: DataTexture;
  readonly #slopes: DataTexture;

  constructor(stock: Stock) {
    const { columns, rows, cell, shape } = stock;
    this.#stock = stock;
    this.#heights = new DataTexture(stock.heights, columns, rows, RedFormat, FloatType);
    const slopes = new Float32Array(2 * stock.heights.length);
    this.#slopes = new DataTexture(slopes, columns, rows, RGFormat, FloatType);
    this.show();
    this.#material = new RawShaderMaterial({
      glslVersion: GLSL3,
      side: DoubleSide,
      vertexShader,
      fragmentShader,
      uniforms: {
        heights: { value: this.#heights },
        slopes: { value: this.#slopes },
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
    slopesOf(this.#stock.heights, this.#stock, this.#slopes.image.data as Float32Array);
    this.#heights.needsUpdate = true;
    this.#slopes.needsUpdate = true;
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
    this.#heights.dispose();
    this.#slopes.dispose();
  }
}
