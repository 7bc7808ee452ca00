// Draws with the plain canvas where there is no WebGL: no depth order, but the same lines.

/** Pieces drawn in one frame while the picture moves. */
const MOVING_PIECES = 40000;

class CanvasPainter {
  constructor(canvas, facts, motion) {
    Object.assign(this, { pen: canvas.getContext("2d"), facts, motion });
  }

  draw({ camera, colours, jogs, still, live, done, moving, pixel }) {
    const { pen } = this;
    pen.setTransform(pixel, 0, 0, pixel, 0, 0);
    pen.fillStyle = css(colours.ground);
    pen.fillRect(0, 0, camera.width, camera.height);
    pen.lineCap = pen.lineJoin = "round";
    this.lines(camera, colours, still);
    const step = moving ? Math.ceil(this.motion.count / MOVING_PIECES) || 1 : 1;
    this.pieces(camera, colours, jogs, done, this.motion.count, 0.8, step);
    this.pieces(camera, colours, jogs, 0, done, 0, step);
    this.lines(camera, colours, live);
  }

  lines(camera, colours, lines) {
    const { pen } = this, axes = camera.axes();
    for (const [a, b, colour, width] of lines) {
      pen.strokeStyle = css(colours[colour]);
      pen.lineWidth = width;
      pen.beginPath();
      pen.moveTo(...camera.project(a, axes).slice(0, 2));
      pen.lineTo(...camera.project(b, axes).slice(0, 2));
      pen.stroke();
    }
  }

  /** One path for each shade, so that the canvas changes its pen seldom. */
  pieces(camera, colours, jogs, first, end, fade, step) {
    const { motion, pen } = this, axes = camera.axes(), paths = Array.from({ length: 18 }, () => new Path2D());
    for (let i = first; i < end; i += step) {
      const kind = motion.kinds[i];
      if (kind === GAP || (kind === JOG && !jogs)) continue;
      const a = camera.project(motion.point(i), axes), b = camera.project(motion.point(i + 1), axes);
      const path = paths[kind === JOG ? 17 : this.shade(motion.points[3 * i + 5])];
      path.moveTo(a[0], a[1]);
      path.lineTo(b[0], b[1]);
    }
    const inks = [...colours.ramp, colours.air, colours.jog];
    paths.forEach((path, i) => {
      pen.strokeStyle = css(inks[i].map((v, k) => v + (colours.ground[k] - v) * fade));
      pen.lineWidth = i === 17 ? 1.2 : 1.6;
      pen.setLineDash(i === 17 ? [6, 4] : []);
      pen.stroke(path);
    });
    pen.setLineDash([]);
  }

  /** 0 to 15, or 16 above the surface. */
  shade(z) {
    const [top, bottom] = this.facts.depth, height = z + this.facts.middle[2];
    if (height > top + 1e-4) return 16;
    return top > bottom ? Math.min(Math.max(Math.round(15 * (top - height) / (top - bottom)), 0), 15) : 15;
  }
}

function css(colour) {
  return `rgb(${colour.map((v) => Math.round(255 * v)).join(" ")})`;
}
