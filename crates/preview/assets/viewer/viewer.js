// The page: what is shown, from where, and when.

const $ = (id) => document.getElementById(id);
const facts = JSON.parse($("facts").textContent);
const motion = new Motion(facts, $("motion").textContent);
const overlay = new Overlay(facts), camera = new Camera(), canvas = $("view");

/** Everything that changes; `draw` shows it. */
const state = { moment: motion.total, playing: false, jogs: facts.show_jogs, rotary: false, marked: -1, moving: false, slow: null, pointer: null };

function newPainter() {
  try {
    return new GlPainter(canvas, facts, motion);
  } catch {
    // A canvas that has tried WebGL may refuse another kind of context.
    return new CanvasPainter(canvas, facts, motion);
  }
}

let painter = newPainter(), otherPainter = null;

// ---- Colours

function colours() {
  const style = getComputedStyle(document.documentElement), named = {};
  for (const name of ["ground", "grid", "edge", "jog", "air", "tool", "mark", "x", "y", "z"]) named[name] = rgb(style.getPropertyValue(`--${name}`).trim());
  return { ...named, ramp: ramp().map(rgb) };
}

function ramp() {
  return dark.matches ? facts.dark : facts.light;
}

function rgb(hex) {
  return [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);
}

const dark = matchMedia("(prefers-color-scheme: dark)");
let palette = colours();
dark.addEventListener("change", () => {
  palette = colours();
  depthLegend();
  keyLegend();
  redraw();
});

// ---- Words

const number = (mm) => (mm / facts.unit_mm).toFixed(facts.decimals).replace(/^-(?=0\.?0*$)/, "").replace("-", "−");

function where(place) {
  return ["X", "Y", "Z"].map((axis, i) => `${axis} ${number(place[i] + facts.middle[i])}`).join("  ");
}

function clock(moment) {
  if (!motion.timed) return `${number(moment)} ${facts.unit}`;
  const s = Math.round(moment), two = (v) => String(v).padStart(2, "0");
  return `${Math.floor(s / 3600)}:${two(Math.floor(s / 60) % 60)}:${two(s % 60)}`;
}

// ---- Drawing

/** A frame that takes longer is drawn coarsely while it moves, milliseconds. */
const SLOW_MS = 60;

// The motion and the lines over it are drawn apart: the pointer changes only the latter.
let due = null;

function redraw() {
  if (!due) requestAnimationFrame(draw);
  due = "all";
}

function redrawLive() {
  if (!due) requestAnimationFrame(draw);
  due = due || "live";
}

function draw(now) {
  const all = due === "all";
  due = null;
  if (state.playing) advance(now);
  const { piece, place } = motion.at(state.moment), atEnd = state.moment >= motion.total;
  if (all) paint(atEnd ? motion.count : piece);
  point();
  live(piece, place, atEnd);
  labels();
  readout(piece, place, atEnd);
  if (state.playing) redraw();
}

const density = () => Math.min(devicePixelRatio || 1, 2);

function paint(done) {
  const since = performance.now(), coarse = state.slow && (state.moving || state.playing);
  painter.draw({ camera, colours: palette, jogs: state.jogs, still: overlay.still, done, coarse, pixel: density() });
  if (state.slow === null) {
    painter.finish();
    state.slow = performance.now() - since > SLOW_MS;
  }
}

/** The tool and the marked line. */
function live(piece, place, atEnd) {
  const pen = $("live").getContext("2d"), lines = [], pixel = density();
  if (motion.count && !atEnd) {
    if (motion.kinds[piece] !== GAP) lines.push([motion.point(piece), place, "tool", 2.5]);
    if (facts.draw_tool && !state.rotary) lines.push(...overlay.tool(place));
  }
  if (state.marked >= 0) lines.push(...overlay.marked(motion, state.marked));
  pen.setTransform(pixel, 0, 0, pixel, 0, 0);
  pen.clearRect(0, 0, camera.width, camera.height);
  strokeLines(pen, camera, palette, lines);
}

function labels() {
  const box = $("labels"), axes = camera.axes();
  if (!box.children.length) {
    for (const [text, colour] of overlay.names()) {
      const span = document.createElement("span");
      span.textContent = text;
      span.style.color = `var(--${colour})`;
      box.append(span);
    }
  }
  overlay.names().forEach(([, , place], i) => {
    const [x, y] = camera.project(place, axes);
    box.children[i].style.transform = `translate(${x}px, ${y}px) translate(-50%, -50%)`;
  });
}

function readout(piece, place, atEnd) {
  $("clock").textContent = `${clock(state.moment)} / ${clock(motion.total)}`;
  $("time").value = state.moment;
  $("time").setAttribute("aria-valuetext", `${clock(state.moment)} of ${clock(motion.total)}`);
  const line = motion.lines[Math.min(piece, motion.count - 1)];
  $("place").textContent = motion.count && !atEnd ? `${line ? `line ${line} · ` : ""}${where(place)} ${facts.unit}` : "";
  document.querySelectorAll(".toolpath").forEach((button, i) => {
    const next = facts.toolpaths[i + 1], here = !atEnd && piece >= facts.toolpaths[i].piece && (!next || piece < next.piece);
    button.setAttribute("aria-current", here);
  });
}

// ---- Size and view

function resize() {
  const first = camera.width === 1;
  camera.width = innerWidth;
  camera.height = innerHeight;
  for (const sheet of [canvas, $("live")]) {
    sheet.width = Math.round(innerWidth * density());
    sheet.height = Math.round(innerHeight * density());
  }
  if (first) look("iso"); else redraw();
}

function look(name) {
  camera.look(name);
  fit();
}

function fit() {
  const wide = innerWidth > 760 && $("legend").open;
  const box = (corner) => corner.map((v, i) => v - facts.middle[i]);
  let [low, high] = [box(facts.low), box(facts.high)];
  if (!motion.count && facts.table) {
    const [x, y] = facts.table.origin, [w, h] = facts.table.size;
    [low, high] = [overlay.at(x, y, 0), overlay.at(x + w, y + h, 0)];
  }
  const least = overlay.size() * 0.05;
  high = high.map((v, i) => Math.max(v, low[i] + least));
  camera.fit(low, high, [40, 90, wide ? 310 : 40, 90]);
  redraw();
}

function toggleJogs() {
  state.jogs = !state.jogs;
  $("jogs").setAttribute("aria-pressed", state.jogs);
  redraw();
}

/** The motion on the cylinder, or flat again. */
function toggleRotary() {
  if (!motion.rolled) return;
  state.rotary = !state.rotary;
  [motion.points, motion.rolled] = [motion.rolled, motion.points];
  motion.axis = state.rotary ? [-facts.middle[1], facts.axis - facts.middle[2]] : null;
  [[facts.low, facts.high], facts.rolled] = [facts.rolled, [facts.low, facts.high]];
  [painter, otherPainter] = [otherPainter || newPainter(), painter];
  $("rotary").setAttribute("aria-pressed", state.rotary);
  fit();
}

// ---- Time

let before = 0;

function advance(now) {
  const passed = before ? Math.min((now - before) / 1000, 0.25) : 0;
  before = now;
  state.moment = Math.min(state.moment + passed * speed(), motion.total);
  if (state.moment >= motion.total) play(false);
}

/** Seconds of the machine, or millimetres, in one second of the viewer. */
function speed() {
  return Number($("speed").value);
}

function play(on) {
  if (on && state.moment >= motion.total) state.moment = 0;
  state.playing = on && motion.count > 0;
  before = 0;
  $("play").textContent = state.playing ? "❚❚" : "▶";
  $("play").setAttribute("aria-label", state.playing ? "Pause" : "Play");
  redraw();
}

function seek(moment) {
  state.moment = Math.min(Math.max(moment, 0), motion.total);
  redraw();
}
