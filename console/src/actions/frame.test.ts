import { expect, it } from "vitest";
import { firstSnapshot } from "../../tests/standin/snapshot";
import { mm } from "../units/quantity";
import { message } from "../units/testing";
import type { PreviewInfo } from "../wire/messages";
import { frameLines, tooLow } from "./frame";

const info = (bounds: PreviewInfo["bounds"]) =>
  ({ bounds, zero: [25.4, 0, 10] }) as unknown as PreviewInfo;
const bounds = message<PreviewInfo["bounds"]>([
  [25.4, 0, 4],
  [76.2, 25.4, 12],
]);

it("goes round the bounds in working locations, whatever numbers mean", () => {
  const round =
    "J2,0.0000,0.0000\nJ2,2.0000,0.0000\nJ2,2.0000,1.0000\nJ2,0.0000,1.0000\nJ2,0.0000,0.0000";
  expect(frameLines(info(bounds), firstSnapshot.units)).toBe(round);
  const relative = { ...firstSnapshot.units, absolute: false };
  expect(frameLines(info(bounds), relative)).toBe(`SA\n${round}\nSR`);
  expect(frameLines(info(null), firstSnapshot.units)).toBeUndefined();
});

it("goes round above the surface and the highest cut only", () => {
  expect(tooLow(mm(2.9), info(bounds))).toMatch(/Raise the tool/);
  expect(tooLow(mm(3), info(bounds))).toBeUndefined();
  expect(tooLow(mm(0.5), info(null))).toMatch(/Raise the tool/);
});
