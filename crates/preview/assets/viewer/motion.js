// What moved: a chain of points, relative to the middle of the motion, with one piece between each
// two neighbours. The layout of the bytes is told in src/html/motion.rs.

const GAP = 0, CUT = 1, JOG = 2;

/** Longer motion is drawn as thin lines, and coarsely while it moves on a slow machine. */
const MANY_PIECES = 150000;
/** Pieces of the coarse drawing. */
const COARSE_PIECES = 50000;

class Motion {
  constructor(facts, text) {
    const n = facts.pieces, bytes = Motion.bytes(text), buffer = bytes.buffer;
    let at = 0;
    const take = (Type, length) => {
      const part = new Type(buffer, at, length);
      at += part.byteLength;
      return part;
    };
    this.count = n;
    this.points = take(Float32Array, n ? 3 * (n + 1) : 0);
    // The same places on the cylinder of a rotary axis.
    this.rolled = facts.rolled ? take(Float32Array, n ? 3 * (n + 1) : 0) : null;
    // Y and Z of its axis while the motion is drawn on it.
    this.axis = null;
    this.lines = take(Uint32Array, n);
    this.timed = facts.times;
    const times = facts.times ? take(Float32Array, n) : null;
    this.kinds = take(Uint8Array, n);
    // Where each piece ends on the slider: seconds, or millimetres of path without times.
    this.ends = times || this.lengths();
    this.total = n ? this.ends[n - 1] : 0;
  }

  static bytes(text) {
    const letters = atob(text), bytes = new Uint8Array(letters.length);
    for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
    return bytes;
  }

  /**
   * The motion with fewer pieces: pieces of one kind are joined until they are long enough. `first`
   * tells the piece of the motion at which each begins.
   */
  coarse(size) {
    for (let long = size / 2000; ; long *= 1.5) {
      const chain = this.joined(long);
      if (chain.count <= COARSE_PIECES || long > size) return chain;
    }
  }

  joined(long) {
    const points = [...this.point(0)], kinds = [], first = [];
    for (let i = 0, start = 0; i < this.count; i++) {
      const a = 3 * start, b = 3 * i + 3, p = this.points, kind = this.kinds[i];
      const far = Math.hypot(p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]) >= long;
      if (!far && i + 1 < this.count && this.kinds[i + 1] === kind) continue;
      points.push(p[b], p[b + 1], p[b + 2]);
      kinds.push(kind);
      first.push(start);
      start = i + 1;
    }
    return { points: Float32Array.from(points), kinds: Uint8Array.from(kinds), first: Uint32Array.from(first), count: kinds.length };
  }

  lengths() {
    const p = this.points, ends = new Float64Array(this.count);
    let sum = 0;
    for (let i = 0; i < this.count; i++) {
      const k = 3 * i;
      if (this.kinds[i] !== GAP) sum += Math.hypot(p[k + 3] - p[k], p[k + 4] - p[k + 1], p[k + 5] - p[k + 2]);
      ends[i] = sum;
    }
    return ends;
  }

  /** How high the tool was at a point; on a cylinder as far out as it was. */
  height(y, z) {
    return this.axis ? Math.hypot(y - this.axis[0], z - this.axis[1]) + this.axis[1] : z;
  }

  point(i) {
    return [this.points[3 * i], this.points[3 * i + 1], this.points[3 * i + 2]];
  }

  /** The piece under way at a moment, and where the tool is in it. */
  at(moment) {
    let low = 0, high = this.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.ends[middle] < moment) low = middle + 1; else high = middle;
    }
    if (low >= this.count) return { piece: this.count, place: this.point(Math.max(this.count, 0)) };
    const start = low ? this.ends[low - 1] : 0, length = this.ends[low] - start;
    const share = length > 0 ? Math.min(Math.max((moment - start) / length, 0), 1) : 1;
    const a = this.point(low), b = this.point(low + 1);
    return { piece: low, place: a.map((v, i) => v + (b[i] - v) * share) };
  }

  /** A moment just after a piece has begun. */
  start(piece) {
    if (piece >= this.count) return this.total;
    const start = piece > 0 ? this.ends[piece - 1] : 0;
    return start + 0.001 * (this.ends[piece] - start);
  }

  /** The moment of the next source line, or of the one before. */
  step(moment, forward) {
    let { piece } = this.at(moment);
    if (forward) {
      const line = this.lines[piece];
      while (piece < this.count && (this.lines[piece] === line || this.ends[piece] <= moment)) piece++;
      return piece < this.count ? this.ends[this.lastOf(piece)] : this.total;
    }
    const line = this.lines[Math.min(piece, this.count - 1)];
    while (piece > 0 && (piece >= this.count || this.lines[piece] === line)) piece--;
    return piece > 0 ? this.ends[piece] : 0;
  }

  /** The last piece with the same source line. */
  lastOf(piece) {
    while (piece + 1 < this.count && this.lines[piece + 1] === this.lines[piece]) piece++;
    return piece;
  }

  /** The first piece with the same source line. */
  firstOf(piece) {
    while (piece > 0 && this.lines[piece - 1] === this.lines[piece]) piece--;
    return piece;
  }
}
