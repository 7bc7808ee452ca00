// Draws with the plain canvas: the lines over the picture, and everything where there is no WebGL.

/** Strokes lines of an overlay. */
function strokeLines(pen, camera, colours, lines) {
  const axes = camera.axes();
  pen.lineCap = "round";
  for (const [a, b, colour, width] of lines) {
    pen.strokeStyle = css(colours[colour]);
    pen.lineWidth = width;
    pen.beginPath();
    pen.moveTo(...camera.project(a, axes).slice(0, 2));
    pen.lineTo(...camera.project(b, axes).slice(0, 2));
    pen.stroke();
  }
}

function css(colour) {
  return `rgb(${colour.map((v) => Math.round(255 * v)).join(" ")})`;
}

/** The same as the painter with WebGL, without an order in depth. */
class CanvasPainter {
  constructor(canvas, facts, motion) {
    Object.assign(this, { pen: canvas.getContext("2d"), facts });
    this.full = motion;
    this.coarse = motion.coarse(Math.hypot(...facts.high.map((v, i) => v - facts.low[i])));
  }

  draw({ camera, colours, jogs, still, done, coarse, pixel }) {
    const { pen } = this, chain = coarse ? this.coarse : this.full, split = Math.min(reached(chain, done), chain.count);
    pen.setTransform(pixel, 0, 0, pixel, 0, 0);
    pen.fillStyle = css(colours.ground);
    pen.fillRect(0, 0, camera.width, camera.height);
    strokeLines(pen, camera, colours, still);
    this.pieces(chain, camera, colours, jogs, split, chain.count, 0.8);
    this.pieces(chain, camera, colours, jogs, 0, split, 0);
  }

  finish() {}

  /** One path for each shade, so that the canvas changes its pen seldom. */
  pieces({ points, kinds }, camera, colours, jogs, first, end, fade) {
    const { pen } = this, axes = camera.axes(), paths = Array.from({ length: 18 }, () => new Path2D());
    const pixel = (i) => camera.project([points[3 * i], points[3 * i + 1], points[3 * i + 2]], axes);
    for (let i = first; i < end; i++) {
      const kind = kinds[i];
      if (kind === GAP || (kind === JOG && !jogs)) continue;
      const a = pixel(i), b = pixel(i + 1), path = paths[kind === JOG ? 17 : this.shade(this.full.height(points[3 * i + 4], points[3 * i + 5]))];
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
