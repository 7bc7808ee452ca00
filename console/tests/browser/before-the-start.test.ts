import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { lengthText } from "../../src/app/units";
import { place } from "../../src/draw/geometry/vec";
import { expansionFactor, fitted, toPixels } from "../../src/draw/window";
import { mm, ofUnit, shown } from "../../src/units/quantity";
import type { JobView, SettingArea } from "../../src/wire/messages";
import {
  act,
  arm,
  location,
  moment,
  openWorkshop,
  script,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

const shots = process.env.KERF_SHOTS;
let workshop: Workshop;
let page: Page;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 100 });
  page = await workshop.page({ width: 1360, height: 800 });
});
afterAll(() => workshop?.close());

const draw = async (op: object) => expect(await script(workshop, "draw", { op })).toBe(200);
const drawn = async (name: string, clauses: string) => {
  await draw({ op: "new" });
  await draw({ op: "do", clauses });
  await draw({ op: "save", name });
};
const show = (screen: string) => page.getByRole("link", { name: screen, exact: true }).click();
const setting = async (key: string) => {
  const areas: SettingArea[] = await (await fetch(`${workshop.address}/api/settings`)).json();
  return areas.flatMap(({ settings }) => settings).find((entry) => entry.key === key)?.value;
};
const previewed = () =>
  until(async () => (await stateOf(workshop)).opened?.preview.state === "ready", "previewed");
const rests = () =>
  until(async () => (await stateOf(workshop)).machine.state === "idle", "the machine is at rest");
/** The location display as it is, X and Y, mm. */
const displayed = async () => {
  const { units } = await stateOf(workshop);
  const [x, y] = [await location(page, "X"), await location(page, "Y")];
  return [ofUnit(shown(x), units), ofUnit(shown(y), units)];
};
/** Changes a setting on its page, as a person does. */
const change = async (key: string, value: string) => {
  await show("Settings");
  await page.getByLabel("Search settings").fill(key);
  const field = page.locator(`.setting[data-key="${key}"] input`).first();
  const other = page.locator(".setting input").first();
  const box = (await field.count()) > 0 ? field : other;
  await box.fill(value);
  await box.press("Enter");
  await expect.poll(() => setting(key)).toBe(value);
};

it("pro_job_origin_cmp: the page tells where the tool is from the job origin, before any start", async () => {
  await drawn("plate.rsg", "rect 0,0 40,30; comment Anna | 18 mm birch, two sheets");
  expect(await script(workshop, "machine", { drawing: "plate.rsg" })).toBe(200);
  await previewed();
  await show("Operate");
  await arm(page);
  await moved(() => page.getByRole("button", { name: "Move to…" }).click(), { X: "4", Y: "3" });
  await until(async () => (await stateOf(workshop)).motion.at.machine[1] > 76.1, "it is there");
  await rests();
  const [x = 0, y = 0] = (await stateOf(workshop)).motion.at.machine;
  const title = page.getByRole("region", { name: "From the job origin" });
  await title.waitFor();
  expect(await displayed()).toEqual([expect.closeTo(x, 1), expect.closeTo(y, 1)]);
  await page.getByRole("button", { name: "Set it here" }).click();
  await expect.poll(async () => (await displayed()).map(Math.abs)).toEqual([0, 0]);
  expect((await stateOf(workshop)).job?.hash ?? null).toBeNull();
  // The other frames are a click away, and their zeros are where they were.
  await page.getByRole("radio", { name: "Working" }).click();
  await expect.poll(async () => (await displayed())[0]).toBeCloseTo(x, 1);
  await page.getByRole("radio", { name: "Job", exact: true }).click();
  await show("Operate");
  await expect.poll(async () => (await displayed()).map(Math.abs)).toEqual([0, 0]);
  const view: JobView = await (await fetch(`${workshop.address}/api/job`)).json();
  expect(view.origin).toEqual([expect.closeTo(x, 3), expect.closeTo(y, 3)]);
});

it("pro_files_comments: whoever draws, and whoever cuts, reads the comments of the file", async () => {
  const words = "Anna\n18 mm birch, two sheets";
  await show("Operate");
  const comments = page.getByRole("region", { name: "Comments of the file" });
  await expect.poll(() => comments.textContent()).toBe(words);
  if (shots) await page.screenshot({ path: `${shots}/job.png` });
  await show("Operate");
  await page.getByRole("radio", { name: "File", exact: true }).click();
  await expect.poll(() => page.locator(".word-printed").textContent()).toBe(words);
  await draw({ op: "open", name: "plate.rsg" });
  await show("Draw");
  const kept = page.getByRole("region", { name: "Comments", exact: true });
  await expect.poll(() => kept.locator("p").textContent()).toBe(words);
});

it("pro_smoothing_recreate: a job of other smoothing values says so, before the start and at it", async () => {
  const warning = "tool path made with other smoothing values: the factor was 0.6 and is 0.3 now";
  await show("Operate");
  await expect.poll(() => page.locator(".path-row").count()).toBe(1);
  expect(await page.getByRole("list", { name: "Findings" }).count()).toBe(0);
  await change("smoothing.factor", "0.3");
  await show("Operate");
  await page.getByRole("list", { name: "Findings" }).getByText(warning).waitFor();
  await previewed();
  await page.getByRole("button", { name: "Start", exact: true }).click();
  await show("Operate");
  await page.locator(".word-warning", { hasText: warning }).first().waitFor();
  await until(async () => (await stateOf(workshop)).job?.ended === "ok", "it is cut");
  await rests();
  // Made anew, there is nothing to say.
  const anew = { drawing: "plate.rsg", anew: true };
  expect(await script(workshop, "machine", anew)).toBe(200);
  await show("Operate");
  await expect.poll(() => page.locator(".path-row").count()).toBe(1);
  await expect.poll(() => page.getByRole("list", { name: "Findings" }).count()).toBe(0);
});

/** The pixel of a place on the sheet when all of this box is shown with an expansion in percent. */
const pixel = async (
  at: [number, number],
  box: [number, number, number, number],
  percent: number,
) => {
  const sheet = await page
    .getByRole("application", { name: "Shapes of the drawing" })
    .boundingBox();
  if (!sheet) throw new Error("there is no sheet");
  const all = { min: place(box[0], box[1]), max: place(box[2], box[3]) };
  const window = fitted(all, sheet, expansionFactor(percent));
  const { x, y } = toPixels(window, sheet, place(at[0], at[1]));
  return { x: sheet.x + x, y: sheet.y + y };
};
const selection = async () => (await stateOf(workshop)).drawing?.selection;
/** Clicks where the middle of the upper edge of a rectangle must be. */
const picks = async (box: [number, number, number, number], percent: number) => {
  await draw({ op: "do", clauses: "select none" });
  const { x, y } = await pixel([(box[0] + box[2]) / 2, box[3]], box, percent);
  await page.mouse.click(x, y);
  await moment(200);
  return selection();
};

it("pro_display_expansion: how much larger the window is than what is drawn is a setting", async () => {
  const box: [number, number, number, number] = [0, 0, 100, 100];
  await drawn("square.rsg", "rect 0,0 100,100");
  await show("Draw");
  await page.getByRole("button", { name: "Show all" }).first().click();
  expect(await picks(box, 5)).toEqual([1]);
  await change("options.window_expansion_percent", "80");
  await show("Draw");
  await page.getByRole("button", { name: "Show all" }).first().click();
  expect(await picks(box, 5)).toEqual([]);
  expect(await picks(box, 80)).toEqual([1]);
  await change("options.window_expansion_percent", "0");
  await show("Draw");
  await page.getByRole("button", { name: "Show all" }).first().click();
  expect(await picks(box, 80)).toEqual([]);
  expect(await picks(box, 0)).toEqual([1]);
  await change("options.window_expansion_percent", "5");
});

it("pro_array_spacing: the page shows the array that there is, and its pitch", async () => {
  await drawn("array.rsg", "rect 0,0 100,50");
  await show("Draw");
  expect(await page.getByRole("region", { name: "Arrays" }).count()).toBe(0);
  await draw({ op: "do", clauses: "array block 2x3 gap 10,20 start tr order row-snake" });
  const { units } = await stateOf(workshop);
  const length = (one: number) => lengthText(mm(one), units, 3);
  const arrays = page.getByRole("region", { name: "Arrays" });
  await arrays.getByText("Blocks in a job: 2 × 3").waitFor();
  await arrays.getByText(`Pitch: X ${length(110)}, Y ${length(70)}`).waitFor();
  await arrays.getByText("Begins top right, rows forth and back").waitFor();
  if (shots) await page.screenshot({ path: `${shots}/array.png` });
  // The form begins with what there is: one number is changed, the others stay.
  await arrays.getByRole("button", { name: "Change…" }).click();
  const sheet = page.getByRole("dialog", { name: "Array" });
  const rows = sheet.getByLabel("Rows x columns");
  await expect.poll(() => rows.inputValue()).toBe("2x3");
  await rows.fill("4x3");
  await sheet.getByRole("button", { name: "Apply" }).click();
  await arrays.getByText("Blocks in a job: 4 × 3").waitFor();
  const [block] = (await stateOf(workshop)).drawing?.arrays ?? [];
  expect(block).toMatchObject({ grid: [4, 3], start: "tr", order: "row-snake" });
  expect(block?.gap).toEqual([expect.closeTo(10, 3), expect.closeTo(20, 3)]);
});

it("pro_toolpath_selfloop_warn: a shape that crosses itself is cautioned about when its path is made", async () => {
  await drawn("loop.rsg", "line 0,0 100,0 100,50 50,50 50,-50; set black offset=5");
  await show("Draw");
  await page.getByRole("button", { name: "Machine", exact: true }).click();
  await page.locator(".job-head", { hasText: "loop.rsm" }).waitFor();
  await expect.poll(() => page.locator(".path-row").count()).toBe(1);
  await page.locator(".notice", { hasText: "it crosses itself at 50,0" }).first().waitFor();
});

it("pro_clipboard_dxf_via_clip: a second drawing comes into sight, and what was copied is pasted into it", async () => {
  await drawn("far.rsg", "rect 5000,5000 5100,5100");
  await drawn("near.rsg", "rect 0,0 40,40");
  await show("Draw");
  await draw({ op: "do", clauses: "select all; clip" });
  await page.getByRole("button", { name: "Open…" }).click();
  await page.getByRole("button", { name: "far.rsg", exact: true }).click();
  await until(async () => (await stateOf(workshop)).drawing?.name === "far.rsg", "it is open");
  await moment(500);
  expect(await picks([5000, 5000, 5100, 5100], 5)).toEqual([1]);
  expect((await stateOf(workshop)).drawing?.clipboard).toBe(1);
  await page.getByRole("button", { name: "Paste", exact: true }).click();
  const { x, y } = await pixel([5050, 5050], [5000, 5000, 5100, 5100], 5);
  await page.mouse.click(x, y);
  await until(async () => (await stateOf(workshop)).drawing?.shapes === 2, "it is pasted");
  expect(workshop.mistakes).toEqual([]);
});

it("pro_options_doublestart: double start is on the page of the program, too, and is one value", async () => {
  await show("Settings");
  await page.getByLabel("Search settings").fill("");
  const area = async (title: string) => {
    await page.getByLabel("Topic").selectOption(title);
    const region = page.getByRole("region", { name: title, exact: true });
    return region.getByRole("radiogroup", { name: "Misc, double start" });
  };
  let other = "";
  await until(async () => {
    const titles = await page.getByLabel("Topic").locator("option").allTextContents();
    other = titles.find((title) => title.startsWith("Misc")) ?? "";
    return other !== "";
  }, "the topics are listed");
  const here = await area("Options of the program");
  await here.getByRole("radio", { name: "yes" }).click();
  await expect.poll(() => setting("misc.double_start")).toBe("true");
  const there = await area(other);
  const chosen = there.getByRole("radio", { name: "yes" });
  await expect.poll(() => chosen.getAttribute("aria-checked")).toBe("true");
  await there.getByRole("radio", { name: "no" }).click();
  await expect.poll(() => setting("misc.double_start")).toBe("false");
});

interface Summary {
  readonly seconds: number;
  readonly cutMm: number;
  readonly bounds: readonly (readonly number[])[];
}

const sheet = () => page.getByRole("dialog", { name: "Move the tool to" });
/** Opens the sheet of moves, enters places, and moves. */
async function moved(open: () => Promise<void>, places: Record<string, string>, way?: string) {
  const before = (await stateOf(workshop)).job?.run ?? 0;
  await open();
  const part = sheet().getByRole("region", { name: "MoveTo", exact: true });
  for (const letter of ["X", "Y", "Z"])
    await part.getByLabel(letter, { exact: true }).fill(places[letter] ?? "");
  if (way) await part.getByRole("radio", { name: way }).click();
  await part.getByRole("button", { name: "Move", exact: true }).click();
  await until(async () => {
    const { job } = await stateOf(workshop);
    return (job?.run ?? 0) > before && job?.ended === "ok";
  }, "it is there");
  await rests();
  await sheet().getByRole("button", { name: "Close" }).click();
}
/** As the palette leads to it. */
const byPalette = async () => {
  await act(page, "Move the tool to a place");
};
const machinePlace = async () => (await stateOf(workshop)).motion.at.machine;

it("pro_move_moveto_abs: places in numbers, on chosen axes", async () => {
  await script(workshop, "close");
  await show("Operate");
  await moved(byPalette, { X: "10mm", Y: "20mm", Z: "-5mm" }, "2D: X and Y, then the others");
  expect((await machinePlace()).slice(0, 3).map(Math.round)).toEqual([10, 20, -5]);
  await byPalette();
  await sheet().getByRole("radio", { name: "Here" }).click();
  const part = sheet().getByRole("region", { name: "MoveTo", exact: true });
  await part.getByLabel("X", { exact: true }).fill("5mm");
  if (shots) await page.screenshot({ path: `${shots}/move.png` });
  await part.getByRole("button", { name: "Move", exact: true }).click();
  await until(async () => Math.abs((await machinePlace())[0] - 15) < 0.01, "5 mm further");
  await rests();
  const home = sheet().getByRole("region", { name: "Move to home" });
  await home.getByLabel("X", { exact: true }).uncheck();
  await home.getByRole("button", { name: "Move home" }).click();
  await until(async () => Math.abs((await machinePlace())[1]) < 0.01, "Y is at home");
  await rests();
  expect((await machinePlace()).slice(0, 3).map(Math.round)).toEqual([15, 0, 0]);
  await sheet().getByRole("button", { name: "Close" }).click();
});

it("pro_move_moveto_2d: all axes together, or X and Y first", async () => {
  const seconds = async (way: string) => {
    await moved(byPalette, { X: "0", Y: "0", Z: "-10mm" }, way);
    await moved(byPalette, { X: "2000mm", Y: "0", Z: "-30mm" }, way);
    expect((await machinePlace()).slice(0, 3).map(Math.round)).toEqual([2000, 0, -30]);
    return ((await stateOf(workshop)).job as unknown as { summary: Summary }).summary.seconds;
  };
  // Z needs a quarter of a second, which comes behind X and Y or goes with them.
  const [after, together] = [
    await seconds("2D: X and Y, then the others"),
    await seconds("3D: all together"),
  ];
  expect(after).toBeGreaterThan(together + 0.2);
});

it("pro_move_cutmoveto_cut: a move at Z top, or a cut of one line", async () => {
  const { setup } = await stateOf(workshop);
  const ends = async (x: string, cut: boolean) => {
    const before = (await stateOf(workshop)).job?.run ?? 0;
    await byPalette();
    const part = sheet().getByRole("region", { name: "CutMoveTo" });
    await part.getByLabel("X", { exact: true }).fill(x);
    await part.getByLabel("Y", { exact: true }).fill("0");
    await part.getByRole("radio", { name: cut ? "Yes" : "No" }).click();
    await part.getByRole("button", { name: cut ? "Cut there" : "Move there" }).click();
    await until(async () => {
      const { job } = await stateOf(workshop);
      return (job?.run ?? 0) > before && job?.ended === "ok";
    }, "it is there");
    await rests();
    await sheet().getByRole("button", { name: "Close" }).click();
    // What a run came to is told to scripts; pages do not show it.
    return ((await stateOf(workshop)).job as unknown as { summary: Summary }).summary;
  };
  const moved = await ends("0", false);
  expect(moved.cutMm).toBe(0);
  expect((await machinePlace())[2]).toBeCloseTo(setup.heights.top, 3);
  const cut = await ends("100mm", true);
  expect(cut.cutMm).toBeGreaterThanOrEqual(99.9);
  expect(cut.bounds[0]?.[2]).toBeCloseTo(setup.heights.bottom, 3);
  expect((await machinePlace())[0]).toBeCloseTo(100, 2);
});

it("pro_io_diag_write: an output bit of the card is switched on the page", async () => {
  await act(page, "ports of the card");
  const ports = page.getByRole("dialog", { name: "Ports of the card" });
  const byte = ports.getByRole("region", { name: "Output port B" }).locator("output");
  expect(await byte.textContent()).toBe("0x00");
  await ports.getByRole("button", { name: "Switch tool2 on" }).click();
  await expect.poll(() => byte.textContent()).toBe("0x04");
  if (shots) await page.screenshot({ path: `${shots}/ports.png` });
  await ports.getByRole("button", { name: "Switch tool2 off" }).click();
  await expect.poll(() => byte.textContent()).toBe("0x00");
});

it("pro_io_diag_step: a motor is stepped once on the page", async () => {
  const ports = page.getByRole("dialog", { name: "Ports of the card" });
  const [x] = await machinePlace();
  const [perMm = 0] = JSON.parse((await setting("steps.per_unit")) ?? "[]") as number[];
  const step = 1 / perMm;
  await ports.getByRole("button", { name: "Step x forward" }).click();
  await until(async () => Math.abs((await machinePlace())[0] - x - step) < 1e-6, "a step");
  await rests();
  await ports.getByRole("button", { name: "Step x back" }).click();
  await until(async () => Math.abs((await machinePlace())[0] - x) < 1e-6, "and back");
  await ports.getByRole("button", { name: "Close" }).click();
  expect(workshop.mistakes).toEqual([]);
});
