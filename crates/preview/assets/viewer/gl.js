// Draws with WebGL 2 straight from the points of the motion: every piece is one instance of a quad
// that the vertex shader lays along it; very long motion is one strip of thin lines, which needs no
// graphics hardware to be bearable.

const PROJECT = `
uniform vec3 right, up, back, target;
uniform vec2 view;
uniform float scale, radius;
vec3 project(vec3 p) { vec3 d = p - target; return vec3(dot(d, right) * scale, dot(d, up) * scale, dot(d, back)); }
float nearness(float z) { return clamp(-z / radius, -0.99, 0.99); }
// The corner of a quad of so many pixels along a line; nearer is smaller in depth.
vec4 corner(vec3 a, vec3 b, float width, out float along) {
  vec3 p = project(a), q = project(b);
  float far = distance(p.xy, q.xy);
  vec2 dir = far > 1e-4 ? (q.xy - p.xy) / far : vec2(1.0, 0.0);
  bool end = gl_VertexID >= 2;
  vec3 base = end ? q : p;
  float half_width = 0.5 * width, side = (gl_VertexID & 1) == 0 ? -half_width : half_width;
  vec2 at = base.xy + vec2(-dir.y, dir.x) * side + dir * (end ? 0.5 : -0.5) * half_width;
  along = end ? far : 0.0;
  return vec4(at / (0.5 * view), nearness(base.z), 1.0);
}`;

// What quads and thin lines have in common: the colour of a height and of a kind.
const SHADE = `
uniform vec3 ramp[16], jog, air, ground;
uniform vec2 depth;
uniform vec3 cylinder;
uniform float fade;
// How high the tool was; on a cylinder (its axis in Y and Z, and a 1) as far out as it was.
float height(vec3 p) { return cylinder.z > 0.5 ? length(p.yz - cylinder.xy) + cylinder.y : p.z; }
vec3 shade(float z, uint kind) {
  float range = depth.x - depth.y, share = range > 1e-6 ? clamp((depth.x - z) / range, 0.0, 1.0) * 15.0 : 15.0;
  int low = int(floor(share));
  vec3 cut = z > depth.x + 1e-4 ? air : mix(ramp[low], ramp[min(low + 1, 15)], share - float(low));
  return mix(kind == 2u ? jog : cut, ground, fade);
}`;

const QUAD_VERTEX = `#version 300 es
precision highp float;
layout(location = 0) in vec3 a;
layout(location = 1) in vec3 b;
layout(location = 2) in uint kind;
${PROJECT}${SHADE}
uniform vec2 width;
out vec3 colour;
out float along;
flat out uint what;
void main() {
  what = kind;
  gl_Position = corner(a, b, kind == 2u ? width.y : width.x, along);
  colour = shade(height(gl_VertexID >= 2 ? b : a), kind);
}`;

// Flat values come from the last point of a line: the kind of the piece that ends there.
const THIN_VERTEX = `#version 300 es
precision highp float;
layout(location = 0) in vec3 a;
layout(location = 2) in uint kind;
${PROJECT}${SHADE}
out vec3 colour;
out float along;
flat out uint what;
void main() {
  what = kind;
  vec3 p = project(a);
  along = p.x + p.y;
  gl_Position = vec4(p.xy / (0.5 * view), nearness(p.z), 1.0);
  colour = shade(height(a), kind);
}`;

const LINE_VERTEX = `#version 300 es
precision highp float;
layout(location = 0) in vec3 a;
layout(location = 1) in vec3 b;
layout(location = 2) in vec4 look;
${PROJECT}
uniform float pixel;
out vec3 colour;
out float along;
flat out uint what;
void main() {
  what = 1u;
  gl_Position = corner(a, b, look.w * pixel, along);
  colour = look.rgb;
}`;

const FRAGMENT = `#version 300 es
precision mediump float;
in vec3 colour;
in float along;
flat in uint what;
uniform float dash;
uniform bool jogs;
out vec4 paint;
void main() {
  if (what == 0u || (what == 2u && (!jogs || mod(along, dash) > 0.6 * dash))) discard;
  paint = vec4(colour, 1.0);
}`;

class GlPainter {
  /** Throws when there is no WebGL 2. */
  constructor(canvas, facts, motion) {
    const gl = canvas.getContext("webgl2", { antialias: true, alpha: false });
    if (!gl) throw new Error("no WebGL 2");
    Object.assign(this, { gl, facts, motion });
    this.thin = motion.count > MANY_PIECES;
    this.pieces = this.program(this.thin ? THIN_VERTEX : QUAD_VERTEX);
    this.lines = this.program(LINE_VERTEX);
    this.full = this.chain(motion);
    this.coarse = this.thin ? this.chain(motion.coarse(Math.hypot(...facts.high.map((v, i) => v - facts.low[i])))) : this.full;
    this.scratch = gl.createBuffer();
    gl.enable(gl.DEPTH_TEST);
  }

  program(vertex) {
    const { gl } = this, program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) || "shader");
    const at = {};
    for (let i = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) - 1; i >= 0; i--) {
      const name = gl.getActiveUniform(program, i).name.replace("[0]", "");
      at[name] = gl.getUniformLocation(program, name);
    }
    return { program, at };
  }

  /** The buffers of a chain; the kind of a piece stands at its end, so there is one more of them. */
  chain({ points, kinds, first, count }) {
    const shifted = new Uint8Array(count + 1);
    shifted.set(kinds, 1);
    return { points: this.buffer(points), kinds: this.buffer(shifted), first, count };
  }

  buffer(data) {
    const { gl } = this, buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    return buffer;
  }

  /** Draws a frame; pieces from `done` on are faint. */
  draw({ camera, colours, jogs, still, done, coarse, pixel }) {
    const { gl } = this;
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.clearColor(...colours.ground, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.drawLines(camera, colours, still, pixel);
    this.use(this.pieces, camera, pixel);
    const { at } = this.pieces, { depth, middle } = this.facts;
    gl.uniform3fv(at.ramp, colours.ramp.flat());
    for (const name of ["jog", "air", "ground"]) gl.uniform3fv(at[name], colours[name]);
    gl.uniform2f(at.depth, depth[0] - middle[2], depth[1] - middle[2]);
    gl.uniform3f(at.cylinder, ...(this.motion.axis || [0, 0]), this.motion.axis ? 1 : 0);
    gl.uniform2f(at.width, 2 * pixel, 1.5 * pixel);
    gl.uniform1i(at.jogs, jogs);
    gl.uniform1f(at.dash, 10 * pixel);
    const chain = coarse ? this.coarse : this.full, split = Math.min(reached(chain, done), chain.count);
    // From above, cuts lie over earlier ones as they do in the drawing, so that the deepest pass shows.
    gl.depthFunc(camera.axes().back[2] > 0.999 ? gl.ALWAYS : gl.LEQUAL);
    this.drawPieces(chain, 0, split, 0);
    gl.depthFunc(gl.LEQUAL);
    this.drawPieces(chain, split, chain.count, 0.8);
  }

  /** Waits until the frame is painted. */
  finish() {
    this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  use({ program, at }, camera, pixel) {
    const { gl } = this, axes = camera.axes();
    gl.useProgram(program);
    for (const name of ["right", "up", "back"]) gl.uniform3fv(at[name], axes[name]);
    gl.uniform3fv(at.target, camera.target);
    gl.uniform2f(at.view, camera.width * pixel, camera.height * pixel);
    gl.uniform1f(at.scale, camera.scale * pixel);
    gl.uniform1f(at.radius, this.radius(camera));
  }

  /** From the target to the farthest corner of what is drawn. */
  radius(camera) {
    const { low, high, middle, table } = this.facts;
    let far = 1e-3;
    for (let i = 0; i < 3; i++) far += Math.max(Math.abs(low[i] - middle[i] - camera.target[i]), Math.abs(high[i] - middle[i] - camera.target[i]));
    if (table) far += table.size[0] + table.size[1];
    return far;
  }

  drawPieces(chain, first, end, fade) {
    const { gl } = this, count = end - first, each = this.thin ? 0 : 1;
    if (count <= 0) return;
    gl.uniform1f(this.pieces.at.fade, fade);
    gl.bindBuffer(gl.ARRAY_BUFFER, chain.points);
    this.attribute(0, 3, gl.FLOAT, 12, 12 * first, each);
    if (each) this.attribute(1, 3, gl.FLOAT, 12, 12 * (first + 1), each); else gl.disableVertexAttribArray(1);
    gl.bindBuffer(gl.ARRAY_BUFFER, chain.kinds);
    gl.enableVertexAttribArray(2);
    gl.vertexAttribIPointer(2, 1, gl.UNSIGNED_BYTE, 1, first + each);
    gl.vertexAttribDivisor(2, each);
    if (each) gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count); else gl.drawArrays(gl.LINE_STRIP, 0, count + 1);
  }

  drawLines(camera, colours, lines, pixel) {
    if (!lines.length) return;
    const { gl } = this, data = new Float32Array(10 * lines.length);
    lines.forEach(([a, b, colour, width], i) => data.set([...a, ...b, ...colours[colour], width], 10 * i));
    this.use(this.lines, camera, pixel);
    gl.uniform1f(this.lines.at.pixel, pixel);
    gl.depthFunc(gl.LEQUAL);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.scratch);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    this.attribute(0, 3, gl.FLOAT, 40, 0, 1);
    this.attribute(1, 3, gl.FLOAT, 40, 12, 1);
    this.attribute(2, 4, gl.FLOAT, 40, 24, 1);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, lines.length);
  }

  attribute(index, size, type, stride, offset, each) {
    const { gl } = this;
    gl.enableVertexAttribArray(index);
    gl.vertexAttribPointer(index, size, type, false, stride, offset);
    gl.vertexAttribDivisor(index, each);
  }
}

/** How many pieces of a chain begin before a piece of the motion. */
function reached(chain, piece) {
  if (!chain.first) return piece;
  let low = 0, high = chain.count;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (chain.first[middle] < piece) low = middle + 1; else high = middle;
  }
  return low;
}
