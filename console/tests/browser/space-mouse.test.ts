/** The mouse over the drawing in 3D: what is told of it lies on the z-plane, and is seen where the mouse is. */

import { afterAll, beforeAll, beforeEach, expect, it } from "vitest";
import { isMetric } from "../../src/units/quantity";
import { type Pixel, painted } from "./pixels";
import { type Point, Sheet } from "./sheet";
import {
  arm,
  carryOut,
  commandDesk,
  openWorkshop,
  stateOf,
  until,
  type Workshop,
} from "./workshop";

/** The height of the plane, mm. */
const height = -10;

/** Marks of the drawing in that plane: corners of a rectangle, from the lower left one, away from the tool. */
const [x0, y0, wide, high] = [60, 40, 120, 80];
const marks: readonly Point[] = [
  [x0, y0],
  [x0 + wide, y0],
  [x0, y0 + high],
  [x0 + wide, y0 + high],
];

let workshop: Workshop;
let sheet: Sheet;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 100 });
  const page = await commandDesk(workshop);
  await arm(page);
  await carryOut(workshop, page, "VD,,,1");
  await until(async () => isMetric((await stateOf(workshop)).units), "millimetres");
  await page.getByRole("link", { name: "Draw", exact: true }).click();
  sheet = new Sheet(workshop, page);
});
afterAll(() => workshop?.close());

beforeEach(async () => {
  await look("Top");
  await sheet.given(marks.map(([x, y]) => `point ${x},${y}`).join("; "));
  const { setup } = await stateOf(workshop);
  const over = height - (setup?.heights.surface ?? 0);
  await sheet.post({ op: "do", clauses: `set black height=${over}` });
});

const look = (view: string) => sheet.page.getByRole("radio", { name: view, exact: true }).click();
const plane = async () => (await sheet.page.locator(".sheet-status-plane").textContent()) ?? "";

const far = (a: Point, b: Point) => Math.hypot(a[0] - b[0], a[1] - b[1]);
const isGreen = ([r, g, b]: Pixel) => g > r + 8 && g > b + 8;

/** The middles of the green rings on the sheet, pixels of the page. */
async function rings(): Promise<Point[]> {
  const box = await sheet.page.locator(".sheet-canvas").boundingBox();
  if (!box) throw new Error("there is no sheet");
  const seen = await painted(sheet.page, sheet.page.locator("html"));
  const found: { sum: [number, number]; weight: number }[] = [];
  for (let y = Math.ceil(box.y) + 1; y < box.y + box.height - 1; y += 1)
    for (let x = Math.ceil(box.x) + 1; x < box.x + box.width - 1; x += 1) {
      const pixel = seen.at(x, y);
      if (!isGreen(pixel)) continue;
      // The darker, the more of the pixel is ink.
      const weight = 255 - pixel[0];
      const at: Point = [x + 0.5, y + 0.5];
      const near = found.find(({ sum, weight }) => far(at, [sum[0] / weight, sum[1] / weight]) < 9);
      const ring = near ?? { sum: [0, 0], weight: 0 };
      if (!near) found.push(ring);
      ring.sum[0] += at[0] * weight;
      ring.sum[1] += at[1] * weight;
      ring.weight += weight;
    }
  return found.map(({ sum, weight }) => [sum[0] / weight, sum[1] / weight]);
}

/** Maps places of the plane to pixels, from the pixels of three marks; the fourth has to agree. */
function seenBy(corners: readonly Point[]): (at: Point) => Point {
  const [o = [0, 0], x = [0, 0], y = [0, 0], both = [0, 0]] = corners;
  const along = (k: 0 | 1, at: Point) =>
    o[k] + ((x[k] - o[k]) * (at[0] - x0)) / wide + ((y[k] - o[k]) * (at[1] - y0)) / high;
  const pixel = (at: Point): Point => [along(0, at), along(1, at)];
  expect(far(pixel([x0 + wide, y0 + high]), both), "the marks are seen in parallel").toBeLessThan(
    0.3,
  );
  return pixel;
}

/** The one of these points that lies farthest in a direction of the page. */
const farthest = (points: readonly Point[], [x, y]: Point): Point =>
  points.reduce((best, at) => (at[0] * x + at[1] * y > best[0] * x + best[1] * y ? at : best));

/** Four places of the mouse between the marks, whole pixels. */
const between = (pixel: (at: Point) => Point): Point[] =>
  [0.15, 0.4, 0.65, 0.9].map((share) => {
    const [x, y] = pixel([x0 + wide * share, y0 + high * (1 - share * share)]);
    return [Math.round(x), Math.round(y)];
  });

/** Greatest distance between the mouse and the place that is told of it, over several places, pixels. */
async function away(pixel: (at: Point) => Point): Promise<number> {
  const all: number[] = [];
  for (const at of between(pixel)) all.push(far(pixel(await sheet.placeAt(at)), at));
  return Math.max(...all);
}

/** The marks as they are seen in 3D at first: X to the right and upwards, Y to the left and upwards. */
async function tilted(): Promise<(at: Point) => Point> {
  await expect.poll(async () => (await rings()).length).toBe(marks.length);
  const found = await rings();
  return seenBy(
    [
      [0, 1],
      [1, 0],
      [-1, 0],
      [0, -1],
    ].map(([x = 0, y = 0]) => farthest(found, [x, y])),
  );
}

/** Sets the z-plane from the side: with Z pressed where the height is, nearer each time. */
async function setPlane(): Promise<void> {
  await look("Side");
  const box = await sheet.page.getByRole("application").boundingBox();
  if (!box) throw new Error("there is no view");
  const x = Math.round(box.x + box.width / 2);
  const heightAt = async (y: number) => {
    await sheet.page.mouse.move(x - 2, y);
    await sheet.page.mouse.move(x, y);
    return Number(/Z (-?[\d.]+)/.exec((await sheet.place().textContent()) ?? "")?.[1]);
  };
  const [low, top] = [Math.round(box.y + box.height - 60), Math.round(box.y + 60)];
  for (let n = 0; n < 20 && (await plane()) !== `z-plane ${height.toFixed(3)} mm`; n += 1) {
    const [a, b] = [await heightAt(low), await heightAt(top)];
    await heightAt(Math.round(low + ((height - a) * (top - low)) / (b - a)));
    await sheet.page.keyboard.press("z");
  }
  expect(await plane()).toBe(`z-plane ${height.toFixed(3)} mm`);
}

it("pro_display_v3d_mousexy: a tilted view tells the place on the z-plane that is under the mouse", async () => {
  await look("3D");
  expect(await plane()).toBe("z-plane 0.000 mm");
  const pixel = await tilted();
  // The marks lie 10 mm below the plane that is set.
  expect(await away(pixel)).toBeGreaterThan(3);
  await setPlane();
  await look("3D");
  expect(await away(await tilted())).toBeLessThan(0.5);
});

it("pro_display_v3d_mousexy: from the top it tells what the drawing in 2D tells", async () => {
  const flat: Point[] = [];
  // The last mark lies below the buttons of the view.
  const places = [...marks.slice(0, 3), [x0 + wide / 3, y0 + high / 3] as const];
  for (const at of places) flat.push(await sheet.placeAt(sheet.pixel(at)));
  await setPlane();
  // The plane is kept where the drawing is worked on meanwhile.
  await look("Top");
  await look("3D");
  expect(await plane()).toBe(`z-plane ${height.toFixed(3)} mm`);
  const [x, y] = await sheet.middle();
  // An eighth of a turn to the left, and upright as far as it goes: half a turn is 500 pixels.
  await sheet.page.mouse.move(x, y - 100);
  await sheet.page.mouse.down();
  await sheet.page.mouse.move(x - 125, y + 100, { steps: 5 });
  await sheet.page.mouse.up();
  const found = await rings();
  const corners: readonly Point[] = [
    [-1, 1],
    [1, 1],
    [-1, -1],
    [1, -1],
  ];
  const pixel = seenBy(corners.map((way) => farthest(found, way)));
  const [left, right] = [pixel([x0, y0]), pixel([x0 + wide, y0])];
  expect(Math.abs(left[1] - right[1]), "X lies level").toBeLessThan(0.2);
  const mmPerPixel = wide / far(left, right);
  expect(await away(pixel)).toBeLessThan(0.5);
  for (const [n, at] of places.entries())
    expect(far(await sheet.placeAt(pixel(at)), flat[n] ?? [0, 0])).toBeLessThan(0.5 * mmPerPixel);
  expect(workshop.mistakes).toEqual([]);
});
