/**
 * Kills the server at any moment and measures the loss of typed and drawn work; KERF_KILLS is the number of
 * kills.
 */

import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { expect, it } from "vitest";
import type { TextDraft } from "../../src/wire/messages";
import { edit, type } from "./editing";
import { openWorkshop, script, stateOf, type Workshop } from "./workshop";

const kills = Number(process.env.KERF_KILLS ?? 12);

/** Age of the oldest lost input at the kill, ms; 0 where nothing is lost. */
const lostMs = (made: readonly number[], kept: number, killed: number): number =>
  kept < made.length ? killed - (made[kept] ?? killed) : 0;

interface Lost {
  readonly text: number;
  readonly drawing: number;
}

/** Types and draws until the server is killed, and looks at what a next one has. */
async function round(folder: string): Promise<Lost> {
  const workshop = await openWorkshop({ folder });
  const page = await workshop.page();
  await edit(page, "a.sbp");
  await type(page, "");
  const typed: number[] = [];
  const drawn: number[] = [];
  const state = { goes: true };
  const writes = async () => {
    while (state.goes) {
      const done = await page.keyboard.type("X").then(
        () => true,
        () => false,
      );
      if (!done) return;
      typed.push(performance.now());
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  };
  const draws = async () => {
    while (state.goes) {
      const n = drawn.length;
      const status = await script(workshop, "draw", {
        op: { op: "do", clauses: `circle ${n},0 1` },
      }).catch(() => 0);
      // Only what the server has said to be drawn counts.
      if (status === 200 && state.goes) drawn.push(performance.now());
    }
  };
  const work = Promise.all([writes(), draws()]);
  await new Promise((resolve) => setTimeout(resolve, 800 + Math.random() * 1500));
  const killed = performance.now();
  await workshop.kill();
  state.goes = false;
  const before = (moments: readonly number[]) => moments.filter((moment) => moment <= killed);
  const [text, shapes] = [before(typed), before(drawn)];
  await work;
  const next = await openWorkshop({ folder });
  const kept = await left(next);
  await next.close();
  return {
    text: lostMs(text, kept.letters, killed),
    drawing: lostMs(shapes, kept.shapes, killed),
  };
}

async function left(workshop: Workshop): Promise<{ letters: number; shapes: number }> {
  const { address, shows: headers } = workshop;
  const drafts = (await (await fetch(`${address}/api/texts`, { headers })).json()) as TextDraft[];
  const letters = [...(drafts[0]?.text ?? "")].filter((letter) => letter === "X").length;
  return { letters, shapes: (await stateOf(workshop)).drawing?.shapes ?? 0 };
}

it("loses half a second of text and of a drawing at most", async () => {
  const lost: Lost[] = [];
  for (let n = 0; n < kills; n += 1) {
    const folder = mkdtempSync(join(tmpdir(), "kerf-killed-"));
    writeFileSync(join(folder, "a.sbp"), "'begins\n");
    lost.push(await round(folder));
    rmSync(folder, { recursive: true, force: true });
  }
  for (const what of ["text", "drawing"] as const) {
    const sorted = lost.map((one) => one[what]).sort((a, b) => a - b);
    const at = (share: number) => Math.round(sorted[Math.floor(share * (sorted.length - 1))] ?? 0);
    console.log(
      `${what} lost in ${kills} kills: half within ${at(0.5)} ms, 90 % within ${at(0.9)} ms, most ${at(1)} ms`,
    );
    // The promise is half a second; a computer that does other work as well is slower now and then.
    expect(at(0.5), what).toBeLessThan(500);
    expect(at(1), what).toBeLessThan(1500);
  }
}, 600_000);
