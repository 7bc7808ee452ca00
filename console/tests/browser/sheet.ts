/** The drawing's sheet as a hand works on it, for tests: places are millimetres of the drawing. */

import type { Page } from "playwright-core";
import { expect } from "vitest";
import { catchUp, stateOf, type Workshop } from "./workshop";

export type Point = readonly [x: number, y: number];

export interface Listed {
  readonly number: number;
  readonly group: string;
  readonly closed: boolean;
  /** x, y and bulge of each vertex. */
  readonly points: readonly number[];
}

/** So much larger than the drawing is the window that shows all of it. */
const expansion = 1.05;

const round = (value: number) => Math.round(value * 1000) / 1000 + 0;

export class Sheet {
  /** Pixels of the page for a place of the drawing. */
  #pixel: (at: Point) => Point = (at) => at;
  /** Shapes that were there when it was given. */
  #given = 0;

  readonly workshop: Workshop;
  readonly page: Page;

  constructor(workshop: Workshop, page: Page) {
    this.workshop = workshop;
    this.page = page;
  }

  async post(op: object): Promise<void> {
    const address = `${this.workshop.address}/api/do/draw`;
    const answer = await this.page.request.post(address, { data: { op } });
    expect(await answer.text()).toContain('"problem":null');
  }

  /** The shapes that the server has, in cutting order, to a thousandth of a millimetre. */
  async shapes(): Promise<Listed[]> {
    const answer = await this.page.request.get(`${this.workshop.address}/api/drawing/shapes`);
    const list: { shapes: Listed[] } = await answer.json();
    return list.shapes.map((shape) => ({ ...shape, points: shape.points.map(round) }));
  }

  /** The shapes drawn since the drawing was given. */
  readonly added = async (): Promise<Listed[]> => (await this.shapes()).slice(this.#given);

  /** Numbers of the shapes that are selected, at the server and on the page. */
  readonly selected = async () => {
    const { drawing } = await stateOf(this.workshop);
    await catchUp(this.workshop);
    return drawing?.selection ?? [];
  };

  /** Waits until the page has so many shapes more than were given; while nothing is selected. */
  async shows(more: number): Promise<void> {
    const count = String(this.#given + more);
    await expect.poll(() => this.fact("Shapes").textContent()).toBe(count);
  }

  /** Waits for the one shape that was drawn. */
  readonly drawn = async (): Promise<Listed> => {
    await this.shows(1);
    const [shape] = await this.added();
    if (!shape) throw new Error("nothing was drawn");
    return shape;
  };

  readonly fact = (name: string) =>
    this.page.locator(".facts div").filter({ hasText: name }).locator("dd");

  async #put(clauses: string): Promise<void> {
    await this.post({ op: "new" });
    this.#given = 0;
    await this.shows(0);
    await this.post({ op: "do", clauses: `${clauses}; select none` });
    this.#given = (await this.shapes()).length;
    await this.shows(0);
  }

  async #box() {
    const sheet = await this.page.getByRole("application").boundingBox({ timeout: 10_000 });
    if (!sheet) throw new Error("there is no sheet");
    return sheet;
  }

  /** A drawing with all of it in sight, and where its places are on the page. */
  async given(clauses: string): Promise<void> {
    await this.#put(clauses);
    await this.page.locator('[data-key="a"]').click();
    const sheet = await this.#box();
    const low: Point = [sheet.x + 40, sheet.y + sheet.height - 40];
    const high: Point = [sheet.x + sheet.width - 40, sheet.y + 40];
    const [a, b] = [await this.placeAt(low), await this.placeAt(high)];
    const along = (k: 0 | 1, at: Point) =>
      low[k] + ((at[k] - a[k]) * (high[k] - low[k])) / (b[k] - a[k]);
    this.#pixel = (at) => [along(0, at), along(1, at)];
  }

  /**
   * A drawing at a scale, millimetres for a pixel, about a place: two points near corners of the sheet make
   * it so. The origin lies on a whole pixel.
   */
  async scaled(clauses: string, mmPerPixel: number, [x, y]: Point = [0, 0]): Promise<void> {
    const sheet = await this.#box();
    const half: Point = [sheet.x + sheet.width / 2, sheet.y + sheet.height / 2];
    const whole = (middle: number, at: number) => {
      const pixel = middle / mmPerPixel;
      return (Math.round(pixel - at) + at) * mmPerPixel;
    };
    const [mx, my] = [whole(x, half[0]), -whole(-y, half[1])];
    const far = (sheet.width * mmPerPixel) / expansion / 2;
    const high = 0.45 * sheet.height * mmPerPixel;
    const frame = `point ${mx - far},${my - high}; point ${mx + far},${my + high}`;
    await this.#put(clauses === "" ? frame : `${clauses}; ${frame}`);
    await this.page.locator('[data-key="a"]').click();
    this.#pixel = (at) => [
      half[0] + (at[0] - mx) / mmPerPixel,
      half[1] - (at[1] - my) / mmPerPixel,
    ];
    await this.#agrees([sheet.x + 40, sheet.y + 40], mmPerPixel);
  }

  /** The line below the drawing tells the place that a pixel is said to be. */
  async #agrees(at: Point, mmPerPixel: number): Promise<void> {
    const place = await this.placeAt(at);
    const back = this.#pixel(place);
    const slack = 0.02 / mmPerPixel;
    expect(Math.hypot(back[0] - at[0], back[1] - at[1])).toBeLessThan(slack);
  }

  /** The pixel in the middle of the sheet. */
  async middle(): Promise<Point> {
    const { x, y, width, height } = await this.#box();
    return [x + width / 2, y + height / 2];
  }

  readonly place = () => this.page.locator(".sheet-status-place");

  /** The place of the mouse as the line below the drawing tells it, millimetres. */
  async placeAt([x, y]: Point): Promise<Point> {
    await this.page.mouse.move(x - 3, y);
    const before = await this.place().textContent();
    await this.page.mouse.move(x, y);
    await expect.poll(() => this.place().textContent()).not.toBe(before);
    return this.pointer();
  }

  /** The place that is told now, millimetres. */
  async pointer(): Promise<Point> {
    const told = (await this.place().textContent()) ?? "";
    const [across = 0, up = 0] = told.split(/[, ]+/).map(Number);
    const mm = told.endsWith("in") ? 25.4 : 1;
    return [across * mm, up * mm];
  }

  /** The pixel of the page at a place of the drawing. */
  readonly pixel = (at: Point): Point => this.#pixel(at);

  readonly tool = (name: string) => this.page.getByRole("button", { name, exact: true }).click();

  readonly move = (at: Point) => this.page.mouse.move(...this.#pixel(at));

  readonly click = (at: Point, button: "left" | "right" = "left") =>
    this.page.mouse.click(...this.#pixel(at), { button });

  /** Presses, moves and lets go. */
  async drag(from: Point, to: Point): Promise<void> {
    await this.move(from);
    await this.page.mouse.down();
    await this.page.mouse.move(...this.#pixel(to), { steps: 4 });
    await this.page.mouse.up();
  }

  /** Clicks what a snap finds, the nearest vertex unless told. */
  async snap(at: Point, key = "v"): Promise<void> {
    await this.move(at);
    await this.page.keyboard.press(key);
    await this.click(at);
  }

  /** Types a place or a number for what is asked. */
  async type(text: string): Promise<void> {
    await this.page.keyboard.press("t");
    await this.page.locator("#drawing-entry").fill(text);
    await this.page.keyboard.press("Enter");
  }

  /** The words of the line below the drawing. */
  readonly prompt = () => this.page.locator(".sheet-status-prompt");
}

/** A page with the drawing's sheet. */
export async function openSheet(workshop: Workshop): Promise<Sheet> {
  const page = await workshop.page();
  await page.goto(`${workshop.address}/draw`);
  return new Sheet(workshop, page);
}
