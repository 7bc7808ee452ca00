import { expect, it } from "vitest";
import { firstSnapshot } from "../../tests/standin/snapshot";
import type { Shown } from "../link/shown";
import { lacks } from "./GoesOn";

/** Page 4 with whoever drives, and whether the machine is armed. */
function shown(driver: number | null, armed: boolean): Shown {
  const lease = driver === null ? null : { number: 9, client: driver, device: "" };
  return {
    status: "open",
    who: { client: 4, role: "operator", device: "" },
    snapshot: { ...firstSnapshot, lease, machine: { ...firstSnapshot.machine, armed } },
    roundTripMs: 1,
    aheadMs: 0,
    waitsFor: null,
  };
}

it("lets whoever drives an armed machine go on, and tells everybody else what is lacking", () => {
  expect(lacks(shown(4, true))).toBeUndefined();
  expect(lacks(shown(4, false))).toBe("arming");
  expect(lacks(shown(5, true))).toBe("control");
  expect(lacks(shown(null, false))).toBe("arming");
  expect(lacks(shown(null, true))).toBe("arming");
});
