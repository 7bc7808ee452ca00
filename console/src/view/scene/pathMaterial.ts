/** Paints a tool path: cuts that are made, cuts that are to come, jogs dashed, gaps not at all. */

import { Color, GLSL3, RawShaderMaterial } from "three";
import type { Palette } from "./palette";

const vertexShader = `
in vec3 position;
in float kind;
in float over;
uniform mat4 modelViewMatrix;
uniform mat4 projectionMatrix;
// Lines are one pixel wide; drawn again beside itself, a path looks wider.
uniform vec2 shift;
// A segment has the kind and the time of the vertex that ends it.
flat out float vKind;
flat out float vOver;
out float vHeight;
void main() {
  vKind = kind;
  vOver = over;
  vHeight = position.z;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_Position.xy += shift;
}`;

const fragmentShader = `
precision highp float;
uniform vec3 cutColour;
uniform vec3 jogColour;
uniform vec3 doneColour;
uniform vec3 paper;
uniform float now;
uniform float jogs;
uniform vec2 heights;
flat in float vKind;
flat in float vOver;
in float vHeight;
out vec4 colour;
void main() {
  if (vKind > 1.5) discard;
  bool isJog = vKind < 0.5;
  if (isJog && jogs < 0.5) discard;
  if (isJog && mod(gl_FragCoord.x + gl_FragCoord.y, 9.0) > 5.0) discard;
  float range = heights.y - heights.x;
  float depth = range > 1e-3 ? clamp((heights.y - vHeight) / range, 0.0, 1.0) : 1.0;
  vec3 ahead = isJog ? jogColour : mix(mix(paper, cutColour, 0.62), cutColour, depth);
  bool made = vOver <= now;
  colour = vec4(made ? (isJog ? mix(paper, jogColour, 0.45) : doneColour) : ahead, 1.0);
}`;

export class PathMaterial extends RawShaderMaterial {
  constructor() {
    super({
      glslVersion: GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: {
        cutColour: { value: new Color() },
        jogColour: { value: new Color() },
        doneColour: { value: new Color() },
        paper: { value: new Color() },
        now: { value: 0 },
        jogs: { value: 1 },
        heights: { value: [0, 1] },
        shift: { value: [0, 0] },
      },
    });
  }

  /** Planned time up to which everything is made, seconds. */
  set now(seconds: number) {
    this.#uniform("now").value = seconds;
  }

  /** Jogs are drawn. */
  set jogs(drawn: boolean) {
    this.#uniform("jogs").value = drawn ? 1 : 0;
  }

  /** Least and greatest height of the cuts: deeper ones are stronger. */
  set heights(range: readonly [number, number]) {
    this.#uniform("heights").value = [...range];
  }

  /** Moves what is drawn next in the picture, in shares of half its size. */
  set shift(by: readonly [number, number]) {
    this.#uniform("shift").value = [...by];
    this.uniformsNeedUpdate = true;
  }

  paint(palette: Palette): void {
    this.#uniform("cutColour").value = bare(palette.cut);
    this.#uniform("jogColour").value = bare(palette.jog);
    this.#uniform("doneColour").value = bare(palette.done);
    this.#uniform("paper").value = bare(palette.paper);
  }

  #uniform(name: string): { value: unknown } {
    const uniform = this.uniforms[name];
    if (!uniform) throw new Error(`no uniform ${name}`);
    return uniform;
  }
}

/** A colour as it stands in the style sheet, not converted for lighting. */
function bare(style: string): Color {
  return new Color().setStyle(style).convertLinearToSRGB();
}
