/**
 * Measures how soon a large part file is seen, how smoothly it turns and what it costs: `npm run bench`.
 *
 * Figures are of this computer; without a graphics card its processor draws.
 */

import type { CDPSession, Page } from "playwright-core";
import { afterAll, beforeAll, it } from "vitest";
import { openWorkshop, script, stateOf, type Workshop } from "../browser/workshop";
import { type Figure, tell } from "./record";
import { writeRows } from "./rows";

let workshop: Workshop;

beforeAll(async () => {
  workshop = await openWorkshop();
});
afterAll(async () => {
  await workshop?.close();
  tell("the console's preview", figures);
});

const figures: Figure[] = [];

/** Script by which the page takes notes about itself from its first line on. */
const notes = `
  window.longest = 0;
  window.tasks = [];
  new PerformanceObserver((list) => {
    for (const task of list.getEntries()) {
      window.longest = Math.max(window.longest, task.duration);
      window.tasks.push([Math.round(task.startTime), Math.round(task.duration)]);
    }
  }).observe({ entryTypes: ["longtask"] });
`;

const longest = (page: Page) => page.evaluate("window.longest") as Promise<number>;

/** Times between frames while the picture is turned by the mouse, sorted. */
async function turned(page: Page): Promise<{ frames: number[]; each: number }> {
  await page.getByRole("radio", { name: "3D" }).click();
  const box = await page.locator(".path-box").boundingBox();
  if (!box) throw new Error("there is no picture");
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const pictures = async () =>
    Number(await page.locator(".path-lines").getAttribute("data-pictures"));
  const [first, began] = [await pictures(), performance.now()];
  await page.evaluate(`
    window.frames_ms = [];
    let before = performance.now();
    const tick = (now) => {
      window.frames_ms.push(now - before);
      before = now;
      window.frame_id = requestAnimationFrame(tick);
    };
    window.frame_id = requestAnimationFrame(tick);
  `);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let n = 0; n < 60; n += 1) await page.mouse.move(x + n * 3, y + n);
  await page.mouse.up();
  const frames = (await page.evaluate(
    "cancelAnimationFrame(window.frame_id), window.frames_ms",
  )) as number[];
  const each = (performance.now() - began) / Math.max((await pictures()) - first, 1);
  return { frames: frames.slice(1).sort((a, b) => a - b), each };
}

interface Heap {
  readonly usedSize: number;
  readonly backingStorageSize?: number;
}

const sizeOf = ({ usedSize, backingStorageSize }: Heap): number =>
  usedSize + (backingStorageSize ?? 0);

/** Asks the workers of a page for what they hold, bytes. */
async function heldByWorkers(session: CDPSession): Promise<number> {
  const answers: Promise<number>[] = [];
  session.on("Target.attachedToTarget", ({ sessionId }) => {
    const ask = (id: number, method: string) =>
      session.send("Target.sendMessageToTarget", {
        sessionId,
        message: JSON.stringify({ id, method }),
      });
    answers.push(
      new Promise((done) => {
        session.on("Target.receivedMessageFromTarget", (told) => {
          const answer = JSON.parse(told.message) as { id?: number; result?: Heap };
          if (told.sessionId === sessionId && answer.id === 2 && answer.result)
            done(sizeOf(answer.result));
        });
        void ask(1, "HeapProfiler.collectGarbage").then(() => ask(2, "Runtime.getHeapUsage"));
      }),
    );
  });
  const attach = { autoAttach: true, waitForDebuggerOnStart: false, flatten: false };
  await session.send("Target.setAutoAttach", attach);
  await new Promise((resolve) => setTimeout(resolve, 500));
  return (await Promise.all(answers)).reduce((sum, bytes) => sum + bytes, 0);
}

/** Memory of the page and its workers, MB: their objects, and the arrays beside them. */
async function held(session: CDPSession): Promise<number> {
  await session.send("HeapProfiler.collectGarbage");
  const own = sizeOf((await session.send("Runtime.getHeapUsage")) as Heap);
  return (own + (await heldByWorkers(session))) / 1e6;
}

const whole = (key: string) => `[data-path="${key}"]`;

const sizes = process.env.SEGMENTS ? [Number(process.env.SEGMENTS)] : [100_000, 1_000_000];

it.each(sizes)(
  "a part file of %i moves",
  async (segments) => {
    const name = `rows-${segments}.sbp`;
    writeRows(workshop.parts, name, segments);
    const page = await workshop.page();
    await page.addInitScript(notes);
    await page.goto(workshop.address);
    await page.locator(".location-number").first().waitFor();
    const session = await page.context().newCDPSession(page);
    // What the page itself costs is another figure.
    await new Promise((resolve) => setTimeout(resolve, 2000));
    await page.evaluate("window.longest = 0");
    const begin = performance.now();
    await script(workshop, "open", { name });
    while ((await stateOf(workshop)).opened?.preview.state !== "ready") {
      await new Promise((resolve) => setTimeout(resolve, 10));
    }
    const readyMs = performance.now() - begin;
    await page.locator(`${whole("some")}, ${whole("all")}`).waitFor({ timeout: 120_000 });
    const pictureMs = performance.now() - begin;
    await page.locator(whole("all")).waitFor({ timeout: 120_000 });
    const allMs = performance.now() - begin;
    await new Promise((resolve) => setTimeout(resolve, 1500));
    const loading = await longest(page);
    const { frames, each } = await turned(page);
    await new Promise((resolve) => setTimeout(resolve, 1500));
    const figure = (share: number) => frames[Math.floor(frames.length * share)] ?? 0;
    const input = `${segments.toLocaleString("en")} moves`;
    const ms = (what: string, value: number, goal?: number): Figure => ({
      input,
      what,
      value,
      unit: "ms",
      ...(goal === undefined ? {} : { goal }),
    });
    figures.push(
      ms("plan ready in the server", readyMs),
      ms("first picture after opening", pictureMs, 1000),
      ms("all of it drawn", allMs),
      ms("longest task of the page while it loads", loading, 50),
      ms("longest task of the page with turning", await longest(page), 50),
      ms("picture of the path while turning", each),
      ms("frame of the page while turning, median", figure(0.5)),
      ms("frame of the page while turning, 19 of 20", figure(0.95)),
      {
        input,
        what: "memory of the page and its worker",
        value: await held(session),
        unit: "MB",
        goal: 150,
      },
    );
    if (process.env.TASKS) console.log(await page.evaluate("JSON.stringify(window.tasks)"));
    await page.close();
  },
  600_000,
);
