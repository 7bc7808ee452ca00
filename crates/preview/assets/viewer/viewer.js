// The page: what is shown, what hands and keys do, and the clock.

const $ = (id) => document.getElementById(id);
const facts = JSON.parse($("facts").textContent);
const motion = new Motion(facts, $("motion").textContent);
const overlay = new Overlay(facts), camera = new Camera(), canvas = $("view");

/** Everything that changes; `draw` shows it. */
const state = { moment: motion.total, playing: false, jogs: facts.show_jogs, marked: -1, moving: false, slow: null, pointer: null };

let painter;
try {
  painter = new GlPainter(canvas, facts, motion);
} catch {
  // A canvas that has tried WebGL may refuse another kind of context.
  painter = new CanvasPainter(canvas, facts, motion);
}

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
    lines.push(...overlay.tool(place));
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

// ---- Pointer: one turns or moves, two move and zoom

const pointers = new Map();

/** Marks the line under a pointer that is at rest or passing, not one that turns the picture. */
function point() {
  const tip = $("tip"), seen = state.pointer && !state.moving && motion.count;
  const done = state.moment >= motion.total ? motion.count : motion.at(state.moment).piece;
  state.marked = seen ? pick(motion, camera, state.pointer.x, state.pointer.y, state.jogs, done) : -1;
  tip.hidden = state.marked < 0;
  if (state.marked < 0) return;
  const { x, y } = state.pointer;
  const line = motion.lines[state.marked], kind = motion.kinds[state.marked] === JOG ? "jog" : "cut";
  tip.textContent = `${line ? `line ${line} · ` : ""}${kind} to ${where(motion.point(motion.lastOf(state.marked) + 1))}`;
  const left = Math.min(x + 14, innerWidth - tip.offsetWidth - 8), top = Math.min(y + 16, innerHeight - tip.offsetHeight - 8);
  tip.style.transform = `translate(${left}px, ${top}px)`;
}

canvas.addEventListener("pointerdown", (event) => {
  canvas.setPointerCapture(event.pointerId);
  canvas.focus({ preventScroll: true });
  pointers.set(event.pointerId, event);
  state.moving = true;
  canvas.classList.add("moving");
});

canvas.addEventListener("pointermove", (event) => {
  const last = pointers.get(event.pointerId);
  state.pointer = { x: event.clientX, y: event.clientY };
  if (!last) return redrawLive();
  const dx = event.clientX - last.clientX, dy = event.clientY - last.clientY;
  if (pointers.size === 2) pinch(event, dx, dy);
  else if (event.buttons & 6 || event.shiftKey || event.ctrlKey) camera.pan(dx, dy);
  else camera.turn(dx, dy);
  pointers.set(event.pointerId, event);
  redraw();
});

function pinch(event, dx, dy) {
  const other = [...pointers.values()].find((p) => p.pointerId !== event.pointerId), last = pointers.get(event.pointerId);
  const apart = (p) => Math.hypot(p.clientX - other.clientX, p.clientY - other.clientY);
  camera.pan(dx / 2, dy / 2);
  if (apart(last) > 0) camera.zoom(apart(event) / apart(last), (event.clientX + other.clientX) / 2, (event.clientY + other.clientY) / 2);
}

function release(event) {
  pointers.delete(event.pointerId);
  if (event.pointerType !== "mouse") state.pointer = null;
  if (pointers.size) return;
  state.moving = false;
  canvas.classList.remove("moving");
  redraw();
}

// Wheel and keys turn in steps; the picture is at rest a moment after the last one.
const REST_MS = 250;
let rest = 0;

function nudged() {
  state.moving = true;
  clearTimeout(rest);
  rest = setTimeout(() => {
    state.moving = pointers.size > 0;
    redraw();
  }, REST_MS);
  redraw();
}

canvas.addEventListener("pointerup", release);
canvas.addEventListener("pointercancel", release);
canvas.addEventListener("pointerleave", () => {
  state.pointer = null;
  redrawLive();
});
canvas.addEventListener("contextmenu", (event) => event.preventDefault());
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  camera.zoom(Math.exp(-event.deltaY * (event.deltaMode ? 0.05 : 0.0015)), event.clientX, event.clientY);
  nudged();
}, { passive: false });
canvas.addEventListener("dblclick", fit);

// ---- Keys

const TURN_PX = 12, PAN_PX = 30;
const KEYS = {
  "1": () => look("top"), "2": () => look("front"), "3": () => look("side"), "4": () => look("iso"),
  f: fit, j: toggleJogs, " ": () => play(!state.playing),
  "+": () => camera.zoom(1.25), "=": () => camera.zoom(1.25), "-": () => camera.zoom(0.8),
  ",": () => seek(motion.step(state.moment, false)), ".": () => seek(motion.step(state.moment, true)),
};
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  // Controls keep their own keys.
  const control = event.target.closest?.("input, select, button, summary");
  const arrow = ARROWS[event.key], action = KEYS[event.key.toLowerCase()];
  if (control && (arrow || event.key === " ")) return;
  if (arrow) {
    const [x, y] = arrow;
    if (event.shiftKey) camera.pan(-x * PAN_PX, -y * PAN_PX); else camera.turn(x * TURN_PX, y * TURN_PX);
    nudged();
  } else if (action) {
    action();
  } else {
    return;
  }
  event.preventDefault();
  redraw();
});

// ---- Legend and controls

function depthLegend() {
  const [top, bottom] = facts.depth, flat = top - bottom < 1e-6;
  $("depth").hidden = !motion.count;
  $("depth").querySelector("h2").textContent = `Depth of cut (Z), ${facts.unit}`;
  $("depth").querySelector(".ramp").style.background = flat ? ramp()[15] : `linear-gradient(to right, ${ramp().join(",")})`;
  const heights = flat ? [bottom] : [0, 0.5, 1].map((s) => top + (bottom - top) * s);
  $("depth").querySelector(".ticks").replaceChildren(...heights.map((z) => {
    const span = document.createElement("span");
    span.textContent = number(z);
    return span;
  }));
}

function keyLegend() {
  const signs = [["cut", "cut", CUT], ["jog", "jog", JOG]].filter(([, , kind]) => motion.kinds.includes(kind));
  $("key").replaceChildren(...signs.map(([name, text]) => {
    const row = document.createElement("p"), line = document.createElement("i");
    row.className = "sign";
    line.className = name;
    if (name === "cut") line.style.borderTopColor = ramp()[10];
    row.append(line, text);
    return row;
  }));
}

function toolpathLegend() {
  $("toolpaths").hidden = !facts.toolpaths.length;
  for (const toolpath of facts.toolpaths) {
    const button = document.createElement("button"), name = document.createElement("span"), time = document.createElement("time");
    button.className = "toolpath";
    name.textContent = [toolpath.name, toolpath.tool].filter(Boolean).join(" · ") || "unnamed";
    time.textContent = toolpath.time;
    button.title = "Go to its start";
    button.append(name, time);
    button.addEventListener("click", () => seek(motion.start(toolpath.piece)));
    $("toolpaths").append(button);
  }
}

/** Speeds to choose from; the first that plays the whole within a minute is taken. */
function speeds() {
  const least = motion.timed ? 1 : 10, all = [1, 2, 5, 10, 30, 100, 1000, 10000].map((v) => v * least);
  const chosen = all.find((v) => motion.total / v <= 60) || all.at(-1);
  for (const v of all) {
    const text = motion.timed ? `${v}×` : `${Number((v / facts.unit_mm).toPrecision(2))} ${facts.unit}/s`;
    $("speed").append(new Option(text, v, v === chosen, v === chosen));
  }
}

for (const button of document.querySelectorAll("[data-view]")) button.addEventListener("click", () => look(button.dataset.view));
$("fit").addEventListener("click", fit);
$("jogs").addEventListener("click", toggleJogs);
$("play").addEventListener("click", () => play(!state.playing));
$("time").max = motion.total || 1;
$("time").addEventListener("input", (event) => {
  play(false);
  seek(Number(event.target.value));
});
$("player").hidden = !motion.count;
$("jogs").setAttribute("aria-pressed", state.jogs);
$("legend").open = innerWidth > 760;
addEventListener("resize", resize);
depthLegend();
keyLegend();
toolpathLegend();
speeds();
resize();
