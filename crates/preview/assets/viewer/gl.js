// Draws with WebGL 2: every piece is one instance of a quad that the vertex shader lays along it,
// so that a million pieces need no more memory than their points.

const PROJECT = `
uniform vec3 right, up, back, target;
uniform vec2 view;
uniform float scale, radius;
vec3 project(vec3 p) { vec3 d = p - target; return vec3(dot(d, right) * scale, dot(d, up) * scale, dot(d, back)); }
// The corner of a quad of so many pixels along a line; nearer is smaller in depth.
vec4 corner(vec3 a, vec3 b, float width, float lift, out float along) {
  vec3 p = project(a), q = project(b);
  float far = distance(p.xy, q.xy);
  vec2 dir = far > 1e-4 ? (q.xy - p.xy) / far : vec2(1.0, 0.0);
  bool end = gl_VertexID >= 2;
  vec3 base = end ? q : p;
  float half_width = 0.5 * width, side = (gl_VertexID & 1) == 0 ? -half_width : half_width;
  vec2 at = base.xy + vec2(-dir.y, dir.x) * side + dir * (end ? 0.5 : -0.5) * half_width;
  along = end ? far : 0.0;
  return vec4(at / (0.5 * view), clamp(-base.z / radius, -0.99, 0.99) - lift, 1.0);
}`;

const PIECE_VERTEX = `#version 300 es
precision highp float;
layout(location = 0) in vec3 a;
layout(location = 1) in vec3 b;
layout(location = 2) in uint kind;
${PROJECT}
uniform vec3 ramp[16], jog, air, ground;
uniform vec2 depth, width;
uniform float fade;
uniform bool jogs;
out vec3 colour;
out float along;
flat out float dashed;
vec3 shade(float z) {
  if (z > depth.x + 1e-4) return air;
  float range = depth.x - depth.y, share = range > 1e-6 ? clamp((depth.x - z) / range, 0.0, 1.0) * 15.0 : 15.0;
  int low = int(floor(share));
  return mix(ramp[low], ramp[min(low + 1, 15)], share - float(low));
}
void main() {
  dashed = kind == 2u ? 1.0 : 0.0;
  bool hidden = kind == 0u || (kind == 2u && !jogs);
  vec4 at = corner(a, b, kind == 2u ? width.y : width.x, 0.0, along);
  gl_Position = hidden ? vec4(2.0, 2.0, 2.0, 1.0) : at;
  vec3 strong = kind == 2u ? jog : shade((gl_VertexID >= 2 ? b : a).z);
  colour = mix(strong, ground, fade);
}`;

const LINE_VERTEX = `#version 300 es
precision highp float;
layout(location = 0) in vec3 a;
layout(location = 1) in vec3 b;
layout(location = 2) in vec4 look;
${PROJECT}
uniform float lift, pixel;
out vec3 colour;
out float along;
flat out float dashed;
void main() {
  dashed = 0.0;
  gl_Position = corner(a, b, look.w * pixel, lift, along);
  colour = look.rgb;
}`;

const FRAGMENT = `#version 300 es
precision mediump float;
in vec3 colour;
in float along;
flat in float dashed;
uniform float dash;
out vec4 paint;
void main() {
  if (dashed > 0.5 && mod(along, dash) > 0.6 * dash) discard;
  paint = vec4(colour, 1.0);
}`;

class GlPainter {
  /** Throws when there is no WebGL 2. */
  constructor(canvas, facts, motion) {
    const gl = canvas.getContext("webgl2", { antialias: true, alpha: false });
    if (!gl) throw new Error("no WebGL 2");
    Object.assign(this, { gl, facts, motion });
    this.pieces = this.program(PIECE_VERTEX);
    this.lines = this.program(LINE_VERTEX);
    this.points = this.buffer(motion.points);
    this.kinds = this.buffer(motion.kinds);
    this.scratch = gl.createBuffer();
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
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

  buffer(data) {
    const { gl } = this, buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    return buffer;
  }

  /** Draws a frame; `step` leaves out pieces while the picture moves. */
  draw({ camera, colours, jogs, still, live, done, step, pixel }) {
    const { gl } = this;
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    gl.clearColor(...colours.ground, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.drawLines(camera, colours, still, 0, pixel);
    this.use(this.pieces, camera, pixel);
    const { at } = this.pieces, { depth, middle } = this.facts;
    gl.uniform3fv(at.ramp, colours.ramp.flat());
    for (const name of ["jog", "air", "ground"]) gl.uniform3fv(at[name], colours[name]);
    gl.uniform2f(at.depth, depth[0] - middle[2], depth[1] - middle[2]);
    gl.uniform2f(at.width, 2 * pixel, 1.5 * pixel);
    gl.uniform1i(at.jogs, jogs);
    gl.uniform1f(at.dash, 10 * pixel);
    this.drawPieces(0, done, 0, step);
    this.drawPieces(done, this.motion.count, 0.8, step);
    this.drawLines(camera, colours, live, 0.005, pixel);
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

  drawPieces(first, end, fade, step) {
    const { gl } = this, count = Math.floor((end - first) / step);
    if (count <= 0) return;
    gl.uniform1f(this.pieces.at.fade, fade);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.points);
    this.attribute(0, 3, gl.FLOAT, 12 * step, 12 * first);
    this.attribute(1, 3, gl.FLOAT, 12 * step, 12 * (first + 1));
    gl.bindBuffer(gl.ARRAY_BUFFER, this.kinds);
    gl.enableVertexAttribArray(2);
    gl.vertexAttribIPointer(2, 1, gl.UNSIGNED_BYTE, step, first);
    gl.vertexAttribDivisor(2, 1);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, count);
  }

  drawLines(camera, colours, lines, lift, pixel) {
    if (!lines.length) return;
    const { gl } = this, data = new Float32Array(10 * lines.length);
    lines.forEach(([a, b, colour, width], i) => data.set([...a, ...b, ...colours[colour], width], 10 * i));
    this.use(this.lines, camera, pixel);
    gl.uniform1f(this.lines.at.lift, lift);
    gl.uniform1f(this.lines.at.pixel, pixel);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.scratch);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
    this.attribute(0, 3, gl.FLOAT, 40, 0);
    this.attribute(1, 3, gl.FLOAT, 40, 12);
    this.attribute(2, 4, gl.FLOAT, 40, 24);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, lines.length);
  }

  attribute(index, size, type, stride, offset) {
    const { gl } = this;
    gl.enableVertexAttribArray(index);
    gl.vertexAttribPointer(index, size, type, false, stride, offset);
    gl.vertexAttribDivisor(index, 1);
  }
}
