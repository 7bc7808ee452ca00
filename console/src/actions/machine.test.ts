import { describe, expect, it } from "vitest";
import { firstSnapshot } from "../../tests/standin/snapshot";
import type { LinkStatus } from "../link/shown";
import type { State } from "../wire/messages";
import type { Action, World } from "./action";
import { start } from "./job";
import { arm, hold, home, moveMode, preview, resume, stop } from "./machine";

const states: State[] = ["idle", "running", "jogging", "held", "asking", "stopped", "alarm"];

function world(state: State, armed = true, status: LinkStatus = "open", startArms = true): World {
  const offers = { ...firstSnapshot.machine.offers, startArms };
  const machine = { ...firstSnapshot.machine, state, armed, offers };
  const snapshot = { ...firstSnapshot, machine };
  return { shown: { status, who: null, snapshot, roundTripMs: 1, aheadMs: 0 } } as World;
}

const allowed = (action: Action, armed = true, startArms = true) =>
  states.filter((state) => action.refused?.(world(state, armed, "open", startArms)) === undefined);

describe("what can be done when", () => {
  it("STOP always", () => {
    expect(allowed(stop)).toEqual(states);
    expect(stop.refused?.(world("running", true, "lost"))).toBeUndefined();
  });

  it("hold what moves, resume what is held", () => {
    expect(allowed(hold)).toEqual(["running", "jogging"]);
    expect(allowed(resume)).toEqual(["held"]);
  });

  it("start only what stands, is armed and was previewed", () => {
    expect(allowed(start)).toEqual(["idle"]);
    expect(allowed(start, false, false)).toEqual([]);
    expect(allowed(start, true, false)).toEqual(["idle"]);
    const opened = { ...world("idle"), shown: { ...world("idle").shown } };
    const closed = { ...firstSnapshot, opened: null };
    expect(start.refused?.({ ...opened, shown: { ...opened.shown, snapshot: closed } })).toBe(
      "Open a file first.",
    );
  });

  it("start arms a machine that hurts nobody", () => {
    expect(allowed(start, false)).toEqual(["idle"]);
  });

  it("start draws a part file in preview, armed or not", () => {
    const { shown, ...rest } = world("idle", false, "open", false);
    const offers = { ...firstSnapshot.machine.offers, startArms: false };
    const machine = { ...firstSnapshot.machine, mode: "preview" as const, armed: false, offers };
    const inPreview = (kind: "program" | "job") => {
      const opened = firstSnapshot.opened && { ...firstSnapshot.opened, kind };
      return { ...rest, shown: { ...shown, snapshot: { ...firstSnapshot, machine, opened } } };
    };
    expect(start.refused?.(inPreview("program"))).toBeUndefined();
    expect(start.refused?.(inPreview("job"))).toContain("only part files");
  });

  it("arm what stands disarmed", () => {
    expect(allowed(arm, false)).toEqual(["idle", "held", "asking", "stopped"]);
    expect(allowed(arm, true)).toEqual([]);
  });

  it("modes also while it is disarmed; moves only armed", () => {
    expect(allowed(preview, false)).toEqual(["idle"]);
    expect(allowed(moveMode, false)).toEqual(["idle"]);
    expect(allowed(home, false)).toEqual([]);
  });

  it("nothing that moves without a link", () =>
    expect(start.refused?.(world("idle", true, "lost"))).toBe("There is no link to the machine."));
});
