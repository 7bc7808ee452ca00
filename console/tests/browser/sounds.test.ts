import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";
import { afterAll, beforeAll, expect, it } from "vitest";
import { arm, openWorkshop, script, stateOf, until, type Workshop } from "./workshop";

let workshop: Workshop;

/** A second of sound: 8000 samples of 8 bits. */
function wav(seconds: number): Uint8Array {
  const samples = 8000 * seconds;
  const bytes = new Uint8Array(44 + samples);
  const view = new DataView(bytes.buffer);
  const word = (at: number, letters: string) => bytes.set(new TextEncoder().encode(letters), at);
  word(0, "RIFF");
  view.setUint32(4, 36 + samples, true);
  word(8, "WAVEfmt ");
  view.setUint32(16, 16, true);
  view.setUint16(20, 1, true);
  view.setUint16(22, 1, true);
  view.setUint32(24, 8000, true);
  view.setUint32(28, 8000, true);
  view.setUint16(32, 1, true);
  view.setUint16(34, 8, true);
  word(36, "data");
  view.setUint32(40, samples, true);
  for (let n = 0; n < samples; n += 1) bytes[44 + n] = 128 + Math.round(60 * Math.sin(n / 3));
  return bytes;
}

beforeAll(async () => {
  workshop = await openWorkshop();
  mkdirSync(join(workshop.parts, "media"));
  writeFileSync(join(workshop.parts, "media", "tada.wav"), wav(2));
  writeFileSync(join(workshop.parts, "media", "secret.txt"), "secret");
  writeFileSync(join(workshop.parts, "ding.WAV"), wav(1));
  writeFileSync(
    join(workshop.parts, "a.sbp"),
    "PLAY C:\\WINDOWS\\Media\\Tada.wav\nMX,1\nPLAY ding.WAV\n",
  );
  writeFileSync(join(workshop.parts, "none.sbp"), "PLAY nofile.wav\nMX,1\n");
});
afterAll(() => workshop?.close());

/** Opens a part file and runs it to its end. */
async function runs(page: Page, name: string): Promise<void> {
  const before = (await stateOf(workshop)).job?.run ?? 0;
  await script(workshop, "open", { name });
  await until(async () => (await stateOf(workshop)).opened?.preview.state === "ready", "previewed");
  await page.getByRole("button", { name: "Start" }).click();
  await until(async () => {
    const { job } = await stateOf(workshop);
    return (job?.run ?? 0) > before && job?.ended === "ok";
  }, "its end");
}

/** Sounds that a page began to play, and those that it heard to their end. */
async function listens(page: Page): Promise<() => Promise<{ played: string[]; ended: string[] }>> {
  await page.evaluate(() => {
    const heard = { played: [] as string[], ended: [] as string[] };
    Reflect.set(window, "heard", heard);
    const player = document.querySelector("audio");
    const note = (list: string[]) => () => list.push(new URL(player?.src ?? "").pathname);
    player?.addEventListener("playing", note(heard.played));
    player?.addEventListener("ended", note(heard.ended));
  });
  return () => page.evaluate(() => Reflect.get(window, "heard"));
}

it("sbp_io_play: a page plays the sound of the media folder while the file goes on; each sound once", async () => {
  const page = await workshop.page();
  await arm(page);
  const heard = await listens(page);
  await runs(page, "a.sbp");
  await until(async () => (await heard()).ended.length > 0, "a sound is heard to its end");
  const { played, ended } = await heard();
  expect(played[0]).toBe("/api/media/C%3A%5CWINDOWS%5CMedia%5CTada.wav");
  expect(played).toHaveLength(2);
  expect(ended).toEqual(["/api/media/ding.WAV"]);
  // The file has not waited for the two seconds of the first.
  expect((await stateOf(workshop)).motion.t).toBeLessThan(2);
  await page.reload();
  await page.getByRole("button", { name: "Start" }).waitFor();
  expect(await page.evaluate(() => document.querySelector("audio")?.src)).toBe("");
  expect(workshop.mistakes).toEqual([]);
  await page.close();
});

it("sbp_io_play: nothing but sounds leaves the media folder, and a missing one is only told", async () => {
  for (const name of ["secret.txt", "..%2Fa.sbp", "..%2F..%2Fetc%2Fpasswd", "none.wav", "a.sbp"]) {
    expect((await fetch(`${workshop.address}/api/media/${name}`)).status, name).toBe(404);
  }
  const got = await fetch(`${workshop.address}/api/media/tada.wav`);
  expect(got.headers.get("content-type")).toBe("audio/wav");
  const page = await workshop.page();
  await arm(page);
  await runs(page, "none.sbp");
  await page.getByText("there is no sound nofile.wav").first().waitFor();
  await page.close();
});
