/**
 * Journeys of people who bring their own files, with the number of actions that each may take: by mouse, by keys alone,
 * and by touch.
 *
 * An action is what a person decides: a control that is pressed, a shortcut, a file that is chosen in what the browser
 * opens, a text that is typed. The way there, with the mouse, with Tab or with the cursor, is none.
 */

import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Locator, Page } from "playwright-core";
import { afterAll, beforeAll, beforeEach, describe, expect, it } from "vitest";
import type { SettingArea } from "../../src/wire/messages";
import { comesToRest, openWorkshop, stateOf, until, type Workshop } from "./workshop";

const desk = { width: 1280, height: 720 };
const phone = { width: 390, height: 844 };

let workshop: Workshop;

beforeAll(async () => {
  workshop = await openWorkshop({ rate: 100 });
  const asks = ['INPUT "How deep?", &deep', 'MSGBOX("Go on?", YesNo)', "MX,1", "END", ""];
  writeFileSync(join(workshop.parts, "asks.sbp"), asks.join("\n"));
});
afterAll(() => workshop?.close());

interface File {
  readonly name: string;
  readonly mimeType: string;
  readonly buffer: Buffer;
}

const file = (name: string, content: string): File => ({
  name,
  mimeType: "",
  buffer: Buffer.from(content),
});

/** Somebody at a page, whose actions are counted. */
abstract class Person {
  actions = 0;
  readonly page: Page;

  constructor(page: Page) {
    this.page = page;
  }

  /** Presses a control. */
  async press(control: Locator): Promise<void> {
    this.actions += 1;
    await control.waitFor();
    await this.reach(control);
  }

  button(name: string | RegExp): Promise<void> {
    const exact = typeof name === "string";
    return this.press(this.page.getByRole("button", { name, exact }));
  }

  /** Presses what opens the files of the computer, and chooses one. */
  async choose(name: string, chosen: File): Promise<void> {
    const chooser = this.page.waitForEvent("filechooser");
    await this.button(name);
    this.actions += 1;
    await (await chooser).setFiles(chosen);
  }

  /** Types a text where the cursor is. */
  async type(text: string): Promise<void> {
    this.actions += 1;
    await this.page.keyboard.type(text);
  }

  /** Saves what is in the editor. */
  save(): Promise<void> {
    return this.button("Save");
  }

  /** Types another text in place of what stands behind the cursor in its line. */
  async retype(text: string): Promise<void> {
    await this.page.keyboard.press("Shift+End");
    await this.type(text);
  }

  protected abstract reach(control: Locator): Promise<void>;
}

class Mouse extends Person {
  protected reach(control: Locator): Promise<void> {
    return control.click();
  }
}

class Finger extends Person {
  protected reach(control: Locator): Promise<void> {
    return control.tap();
  }
}

class Keys extends Person {
  override async save(): Promise<void> {
    this.actions += 1;
    await this.page.keyboard.press("Control+s");
  }

  protected async reach(control: Locator): Promise<void> {
    for (let n = 0; n < 250; n += 1) {
      if (await control.evaluate((at) => at === document.activeElement)) {
        return this.page.keyboard.press("Enter");
      }
      await this.page.keyboard.press("Tab");
    }
    throw new Error(`Tab never comes to ${control}`);
  }
}

type Size = typeof desk;

const people: readonly [string, (size?: Size) => Promise<Person>][] = [
  ["mouse", async (size = desk) => new Mouse(await workshop.page(size))],
  ["keys", async (size = desk) => new Keys(await workshop.page(size))],
  [
    "touch",
    async (size = { width: 1024, height: 768 }) => new Finger(await workshop.page(size, true)),
  ],
];

const setting = async (key: string) => {
  const areas: SettingArea[] = await (await fetch(`${workshop.address}/api/settings`)).json();
  return areas.flatMap((area) => area.settings).find((entry) => entry.key === key)?.value;
};

const isPreviewed = (name: string) =>
  until(async () => {
    const { opened } = await stateOf(workshop);
    return opened?.name === name && opened.preview.state === "ready";
  }, `${name} is previewed`);

const plate = [
  "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1",
  "10\n10\n20\n10\n10\n60\n20\n10\n10\n60\n20\n40\n10\n10\n20\n40\n0\nENDSEC\n0\nEOF\n",
].join("\n");

describe.each(people)("by %s", (way, person) => {
  beforeEach(() => comesToRest(workshop));

  it("a program of one's own is brought from the disk and cut in four actions", async () => {
    const somebody = await person();
    const name = `own-${way}.sbp`;
    await somebody.button(/^Choose file/);
    await somebody.choose("Upload…", file(name, "MX,1\nMZ,-0.1\nMX,2\nEND\n"));
    const { page } = somebody;
    await isPreviewed(name);
    const before = (await stateOf(workshop)).job?.run ?? 0;
    await somebody.button("Start");
    await until(async () => {
      const { job, machine } = await stateOf(workshop);
      return (job?.run ?? 0) > before && job?.ended === "ok" && machine.state === "idle";
    }, "it is cut");
    expect((await stateOf(workshop)).job?.file).toBe(name);
    expect(somebody.actions).toBeLessThanOrEqual(4);
    await page.close();
  });

  it("a drawing of one's own is brought from the disk into Draw in two actions", async () => {
    const somebody = await person();
    const { page } = somebody;
    await page.goto(`${workshop.address}/draw`);
    const name = `plate-${way}.dxf`;
    await somebody.choose("Open from disk…", file(name, plate));
    await until(async () => (await stateOf(workshop)).drawing?.name === name, "it is opened");
    await page.locator(".drawing-name", { hasText: name }).waitFor();
    await page.getByRole("dialog").waitFor({ state: "detached" });
    expect(somebody.actions).toBeLessThanOrEqual(2);
    await page.close();
  });

  it("a mistake is found and mended in three actions", async () => {
    const name = `wrong-${way}.sbp`;
    writeFileSync(join(workshop.parts, name), "MX,1\nMQ,1\nMX,2\nEND\n");
    const somebody = await person();
    const { page } = somebody;
    await page.request.post(`${workshop.address}/api/do/open`, { data: { name } });
    await somebody.press(page.getByRole("button", { name: /^1 mistake: see line 2/ }));
    await page.locator(".cm-content").waitFor();
    await until(
      () => page.evaluate(() => document.activeElement?.closest(".cm-content") !== null),
      "the editor has the cursor",
    );
    await somebody.retype("MY,1");
    await somebody.save();
    await until(
      async () => (await stateOf(workshop)).opened?.broken === false,
      "it has no mistake any more",
    );
    expect(readFileSync(join(workshop.parts, name), "utf8")).toBe("MX,1\nMY,1\nMX,2\nEND\n");
    expect(somebody.actions).toBeLessThanOrEqual(3);
    await page.close();
  });

  it("settings are saved, and restored in three actions each", async () => {
    const somebody = await person();
    const { page } = somebody;
    await page.goto(`${workshop.address}/settings`);
    const saved = page.waitForEvent("download");
    await somebody.button("Save settings");
    const kept = join(workshop.parts, `.kept-${way}.txt`);
    await (await saved).saveAs(kept);
    expect(somebody.actions).toBeLessThanOrEqual(3);
    somebody.actions = 0;
    const text = readFileSync(kept, "utf8");
    const other = text.replace(/^cutter.diameter_mm = .*$/m, "cutter.diameter_mm = 12.7");
    for (const [content, value] of [
      [other, "12.7"],
      [text, "6.35"],
    ] as const) {
      somebody.actions = 0;
      await somebody.choose("Load settings…", file("machine-settings.txt", content));
      await somebody.button("Change 1 setting");
      await expect.poll(() => setting("cutter.diameter_mm")).toBe(value);
      expect(somebody.actions).toBeLessThanOrEqual(3);
    }
    await page.close();
  });

  it("a job that asks is answered on a screen of a phone", async () => {
    const somebody = await person(phone);
    const { page } = somebody;
    await page.request.post(`${workshop.address}/api/do/open`, { data: { name: "asks.sbp" } });
    await isPreviewed("asks.sbp");
    await somebody.button("Start");
    await page.getByRole("dialog").getByRole("textbox").waitFor();
    somebody.actions = 0;
    await somebody.type("0.25");
    await somebody.button("OK");
    await somebody.button("Yes");
    await until(async () => (await stateOf(workshop)).machine.state === "idle", "it is over");
    expect((await stateOf(workshop)).job?.ended).toBe("ok");
    expect(somebody.actions).toBeLessThanOrEqual(3);
    await page.close();
  });
});

/** Chromium gives typed text the style of what it replaces, which no page of Kerf allows. */
const isStyled = (mistake: string) => /^Applying inline style.*\/edit$/.test(mistake);

it("nothing went wrong on the pages", () =>
  expect(workshop.mistakes.filter((mistake) => !isStyled(mistake))).toEqual([]));
