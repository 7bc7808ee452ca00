// Which piece is under the pointer.

/** How near a piece must be, pixels. */
const NEAR_PX = 7;

/** The nearest piece among the first `done`, the one nearer to the eye where two are close; or −1. */
function pick(motion, camera, x, y, jogs, done) {
  const { right, up, back } = camera.axes(), { points, kinds } = motion, [tx, ty, tz] = camera.target;
  const s = camera.scale, px = (x - camera.width / 2) / s, py = (camera.height / 2 - y) / s, near = NEAR_PX / s;
  let best = -1, bestRank = Infinity, u = 0, v = 0;
  for (let i = 0, k = 0; i <= done; i++, k += 3) {
    const dx = points[k] - tx, dy = points[k + 1] - ty, dz = points[k + 2] - tz;
    const nu = dx * right[0] + dy * right[1] - px, nv = dx * up[0] + dy * up[1] + dz * up[2] - py;
    const kind = i ? kinds[i - 1] : GAP;
    if (kind === CUT || (kind === JOG && jogs)) {
      const off = toOrigin(u, v, nu, nv);
      if (off < near) {
        // Pixels count in steps of two, then nearness to the eye.
        const depth = dx * back[0] + dy * back[1] + dz * back[2];
        const rank = Math.round(off * s / 2) * 1e7 - depth;
        if (rank < bestRank) [best, bestRank] = [i - 1, rank];
      }
    }
    u = nu; v = nv;
  }
  return best;
}

/** Distance of the origin from a line between two places of the plane. */
function toOrigin(au, av, bu, bv) {
  const du = bu - au, dv = bv - av, length = du * du + dv * dv;
  const share = length > 0 ? Math.min(Math.max(-(au * du + av * dv) / length, 0), 1) : 0;
  return Math.hypot(au + du * share, av + dv * share);
}
