import { readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { firstSnapshot } from "../../tests/standin/snapshot";
import type { Change, Snapshot } from "../wire/messages";
import { fold } from "./fold";

interface Vectors {
  readonly first: Snapshot;
  /** A change, and the sections that are others after it. */
  readonly steps: readonly { readonly change: Change; readonly after: Partial<Snapshot> }[];
}

/** Made by the server's own `Snapshot::apply`. */
const vectors: Vectors = JSON.parse(
  readFileSync(join(import.meta.dirname, "../wire/fold.json"), "utf8"),
);

describe("changes of the snapshot", () => {
  it("make of it what the server makes of it, each sort of them", () => {
    let now = vectors.first;
    for (const { change, after } of vectors.steps) {
      const next = fold(now, change);
      expect(next, change.change).toEqual({ ...now, ...after });
      now = next;
    }
    expect(vectors.steps.length).toBeGreaterThan(30);
  });

  it("replace a section and leave the others the same objects", () => {
    const overrides = { feedPercent: 80, rapidPercent: null, spindlePercent: null };
    const next = fold(firstSnapshot, { change: "overrides", overrides });
    expect(next.overrides).toBe(overrides);
    expect(next.motion).toBe(firstSnapshot.motion);
  });
});
