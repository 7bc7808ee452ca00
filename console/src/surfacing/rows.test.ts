import { expect, test } from "vitest";
import { rings, rowsAcross, zigzag } from "./rows";

const surface = { width: 10, height: 6, bit: 2, overlap: 25 };

test("rows lie no farther apart than the overlap allows, half a row from the edges", () => {
  expect(rowsAcross(6, surface)).toEqual([0.75, 2.25, 3.75, 5.25]);
  expect(rowsAcross(1e6, surface)).toHaveLength(40);
});

test("the way goes to and fro from the lower left corner", () => {
  expect(zigzag({ ...surface, height: 3 }, true)).toBe("M0 2.25L10 2.25L10 0.75L0 0.75");
  expect(zigzag({ ...surface, width: 1.5 }, false)).toBe("M0.75 6L0.75 0");
});

test("rings stay within the area", () => {
  expect(rings(surface)).toBe("M1 1h8v4h-8ZM2.5 2.5h5v1h-5Z");
});
