// Lines around the motion: table, grid, zero, the tool, and the moves of one source line.
// Each is [from, to, colour name, width in pixels]; places are relative to the middle.

class Overlay {
  constructor(facts) {
    this.facts = facts;
    this.still = [...this.table(), ...this.axes()];
  }

  /** A working place relative to the middle. */
  at(x, y, z) {
    const m = this.facts.middle;
    return [x - m[0], y - m[1], z - m[2]];
  }

  /** The table lies under the deepest cut. */
  floor() {
    return Math.min(this.facts.depth[1], this.facts.surface);
  }

  table() {
    const { table } = this.facts, lines = [];
    if (!table) return lines;
    const [x, y] = table.origin, [w, h] = table.size, z = this.floor();
    const put = (x0, y0, x1, y1, colour, width) => lines.push([this.at(x0, y0, z), this.at(x1, y1, z), colour, width]);
    const grid = table.grid * Math.max(1, Math.ceil(Math.max(w, h) / table.grid / 200));
    for (let k = grid; grid > 0 && k < w; k += grid) put(x + k, y, x + k, y + h, "grid", 1);
    for (let k = grid; grid > 0 && k < h; k += grid) put(x, y + k, x + w, y + k, "grid", 1);
    for (const [a, b, c, d] of [[0, 0, w, 0], [w, 0, w, h], [w, h, 0, h], [0, h, 0, 0]]) put(x + a, y + b, x + c, y + d, "edge", 1.5);
    return lines;
  }

  axes() {
    const length = this.size() * 0.12, zero = this.at(0, 0, 0);
    return [[length, 0, 0, "x"], [0, length, 0, "y"], [0, 0, length, "z"]].map(([x, y, z, colour]) => [zero, this.at(x, y, z), colour, 2.5]);
  }

  /** Names at the tips of the axes. */
  names() {
    const length = this.size() * 0.135;
    return [["X", "x", this.at(length, 0, 0)], ["Y", "y", this.at(0, length, 0)], ["Z", "z", this.at(0, 0, length)]];
  }

  size() {
    const { low, high } = this.facts;
    const size = Math.max(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    const table = this.facts.table ? 0.2 * Math.max(...this.facts.table.size) : 0;
    return size || table || 100;
  }

  /** The outline of a cutter standing on a place. */
  tool(place) {
    const radius = this.facts.cutter / 2 || this.size() * 0.008;
    const length = Math.max(6 * radius, this.size() * 0.06), sides = 12, lines = [];
    const rim = (k, z) => [place[0] + radius * Math.cos(k * 2 * Math.PI / sides), place[1] + radius * Math.sin(k * 2 * Math.PI / sides), place[2] + z];
    for (let k = 0; k < sides; k++) {
      lines.push([rim(k, 0), rim(k + 1, 0), "tool", 1.5], [rim(k, length), rim(k + 1, length), "tool", 1.5]);
      if (k % 3 === 0) lines.push([rim(k, 0), rim(k, length), "tool", 1.5]);
    }
    return lines;
  }

  /** The pieces of a source line around a piece; at most a thousand of them. */
  marked(motion, piece) {
    const lines = [], first = Math.max(motion.firstOf(piece), piece - 500), last = Math.min(motion.lastOf(piece), piece + 500);
    for (let i = first; i <= last; i++) {
      if (motion.kinds[i] !== GAP) lines.push([motion.point(i), motion.point(i + 1), "mark", 5]);
    }
    return lines;
  }
}
