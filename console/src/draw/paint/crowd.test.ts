import { expect, it } from "vitest";
import { place } from "../geometry/vec";
import type { Mark } from "../picture";
import { apart } from "./crowd";

const mark = (x: number): Mark => ({ kind: "vertex", ink: "--text", at: place(x, 0) });
const marks = (number: number, apartBy: number) =>
  Array.from({ length: number }, (_, n) => mark(n * apartBy));

it("leaves a crowd one mark for each small square of the screen, in order", () => {
  const seen = apart(marks(3000, 1), (at) => at);
  expect(seen.length).toBe(500);
  expect(seen.slice(0, 2)).toEqual([mark(0), mark(6)]);
});

it("leaves fewer marks as they are", () => {
  expect(apart(marks(2000, 0.001), (at) => at).length).toBe(2000);
});

it("goes by the place on the screen", () => {
  const near = ({ x, y }: { x: number; y: number }) => place(x * 10, y);
  expect(apart(marks(3000, 1), near).length).toBe(3000);
});
