// Legend and controls, and the first frame.

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
$("rotary").hidden = !facts.rolled;
$("rotary").addEventListener("click", toggleRotary);
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
// Cutting is simulated: it plays by itself, until somebody stops it.
if (facts.simulate) play(true);
