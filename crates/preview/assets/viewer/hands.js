// What hands do: pointers turn, move and zoom the picture, and mark the line below them; keys the same.

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
  f: fit, j: toggleJogs, r: toggleRotary, " ": () => play(!state.playing),
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
