import { expect, it } from "vitest";
import { withNewest } from "./recent";

it("the newest file is first, and each is there once; the oldest ones go", () => {
  expect(withNewest([], "a")).toEqual(["a"]);
  expect(withNewest(["a", "b"], "b")).toEqual(["b", "a"]);
  expect(withNewest(["a", "b", "c", "d", "e", "f"], "g")).toEqual(["g", "a", "b", "c", "d", "e"]);
});
