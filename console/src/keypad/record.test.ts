import { expect, it } from "vitest";
import { firstSnapshot } from "../../tests/standin/snapshot";
import { recorded } from "./record";

it("keeps a place as a jog to the axes that are wanted", () => {
  const motion = {
    ...firstSnapshot.motion,
    at: {
      ...firstSnapshot.motion.at,
      working: [76.2, 101.6, -3.175, 0, 0, 0] as typeof firstSnapshot.motion.at.working,
    },
  };
  const { axes } = firstSnapshot.units;
  expect(recorded(2, motion, axes)).toBe("J2,3,4");
  expect(recorded(3, motion, axes)).toBe("J3,3,4,-0.125");
});
