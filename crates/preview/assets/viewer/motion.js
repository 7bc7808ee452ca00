// What moved: a chain of points, relative to the middle of the motion, with one piece between each
// two neighbours. The layout of the bytes is told in src/html/motion.rs.

const GAP = 0, CUT = 1, JOG = 2;

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

  /** The moment at which a piece begins. */
  start(piece) {
    return piece > 0 && this.count ? this.ends[Math.min(piece, this.count) - 1] : 0;
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
