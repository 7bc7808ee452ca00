// Parallel projection, so that lengths in one direction can be compared anywhere in the picture.
// The turntable has two angles: around the vertical, and how far the eye is above the table.

class Camera {
  constructor() {
    this.around = 0;
    this.above = Math.PI / 2;
    this.target = [0, 0, 0];
    /** Pixels a millimetre. */
    this.scale = 1;
    this.width = this.height = 1;
  }

  static VIEWS = {
    top: [0, Math.PI / 2],
    front: [0, 0],
    side: [Math.PI / 2, 0],
    iso: [Math.PI / 5, Math.PI / 5],
  };

  look(name) {
    [this.around, this.above] = Camera.VIEWS[name];
  }

  /** Unit vectors to the right, up, and back to the eye. */
  axes() {
    const [s, c] = [Math.sin(this.around), Math.cos(this.around)];
    const [t, u] = [Math.sin(this.above), Math.cos(this.above)];
    return { right: [c, s, 0], up: [-s * t, c * t, u], back: [s * u, -c * u, t] };
  }

  /** Pixel of a place, and how near it is. */
  project(p, axes = this.axes()) {
    const d = [p[0] - this.target[0], p[1] - this.target[1], p[2] - this.target[2]];
    return [
      this.width / 2 + dot(d, axes.right) * this.scale,
      this.height / 2 - dot(d, axes.up) * this.scale,
      dot(d, axes.back),
    ];
  }

  turn(dx, dy) {
    this.around -= dx * 0.01;
    this.above = Math.min(Math.max(this.above + dy * 0.01, -Math.PI / 2), Math.PI / 2);
  }

  pan(dx, dy) {
    const { right, up } = this.axes();
    this.target = this.target.map((v, i) => v + (-dx * right[i] + dy * up[i]) / this.scale);
  }

  /** Zooms so that what is under the pixel stays there. */
  zoom(factor, x = this.width / 2, y = this.height / 2) {
    const dx = x - this.width / 2, dy = y - this.height / 2;
    this.pan(-dx, -dy);
    this.scale *= factor;
    this.pan(dx, dy);
  }

  /** Shows a box within the margins left, top, right and bottom, in pixels. */
  fit(low, high, [left, top, right, bottom]) {
    this.target = low.map((v, i) => (v + high[i]) / 2);
    const axes = this.axes(), half = low.map((v, i) => (high[i] - v) / 2);
    const reach = (along) => along.reduce((sum, v, i) => sum + Math.abs(v) * half[i], 0);
    const w = Math.max(this.width - left - right, 50), h = Math.max(this.height - top - bottom, 50);
    const scale = Math.min(w / 2 / reach(axes.right), h / 2 / reach(axes.up));
    this.scale = Number.isFinite(scale) && scale > 0 ? scale : 1;
    this.pan((left - right) / 2, (top - bottom) / 2);
  }
}

function dot(a, b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
