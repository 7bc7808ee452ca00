import { expect, it } from "vitest";
import type { JobView } from "../wire/messages";
import { pathAt, planOf, type Standing, shareOf } from "./plan";

const line = (number: number, y: number) => ({
  number,
  group: "black",
  closed: false,
  points: [0, y, 0, 100, y, 0],
  z: null,
  pause: false,
  traversal: false,
  tool: 1,
});

const view = { paths: [line(1, 0), line(2, 10), line(3, 10)] } as unknown as JobView;

it("finds the nearest path, of equally near ones the first that is cut", () => {
  const plan = planOf(view);
  const at = (y: number) => pathAt(plan, { x: 50, y }, 4);
  expect([at(1), at(9), at(5), at(30)]).toEqual([1, 2, null, null]);
});

it("knows what is left out, done, cut and still to come", () => {
  const standing: Standing = { runs: true, at: 3, start: 2, finished: false };
  const shares = (standing: Standing) => [1, 2, 3, 4].map((n) => shareOf(n, standing));
  expect(shares(standing)).toEqual(["skipped", "done", "running", "waiting"]);
  expect(shares({ ...standing, runs: false })).toEqual(["skipped", ...Array(3).fill("waiting")]);
  expect(shares({ ...standing, finished: true })).toEqual(["skipped", ...Array(3).fill("done")]);
});
