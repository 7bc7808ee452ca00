import { expect, test } from "vitest";
import { inches, millimetres, mm } from "../units/quantity";
import type { HeightMap, PreviewInfo } from "../wire/messages";
import { fileText, gridOver, heightText, placesOf, probedPlaces, rangeText } from "./heights";

test.each([
  [0.314, "+0.31"],
  [-0.12, "−0.12"],
  [-0.001, "0.00"],
])("the height %d is %s", (height, text) => {
  expect(heightText(mm(height), millimetres)).toBe(text);
});

test("a range is told in the unit of the page", () => {
  expect(rangeText(mm(-0.12), mm(0.31), millimetres)).toBe("−0.12 … +0.31 mm");
  expect(rangeText(mm(-2.54), mm(0), inches)).toBe("−0.1000 … 0.0000 in");
});

test("places are what was printed in the run, and become a file and a map again", () => {
  const earlier = ["Heights of 2 places", "Height: 9,9,9"];
  const printed = [
    ...earlier,
    "Heights of 4 places",
    "Height: 0,0,1",
    "something",
    "Height: 10,0,-0.5",
    "Height: 10,x,1",
  ];
  const { places, of } = probedPlaces(printed);
  expect(of).toBe(4);
  expect(places).toEqual([
    [0, 0, 1],
    [10, 0, -0.5],
  ]);
  expect(fileText(places)).toBe("kerf heights, mm\n0,0,1\n10,0,-0.5\n");
  const map = { xs: [0, 10], ys: [0, 5], zs: [1, 2, 3, 4] } as unknown as HeightMap;
  expect(placesOf(map)[3]).toEqual([10, 5, 4]);
});

test("a grid lies over the cuts, counted from working zero", () => {
  const bounds = [
    [110, 55, 0],
    [210, 65, 0],
  ];
  const info = { bounds } as unknown as PreviewInfo;
  const entries = gridOver(info, [mm(100), mm(50)], millimetres);
  expect(entries).toEqual({
    X: "10",
    Y: "5",
    "Width, X": "100",
    "Height, Y": "10",
    Columns: "6",
    Rows: "2",
    Units: "as set",
  });
  expect(gridOver({ ...info, bounds: null }, [mm(0), mm(0)], millimetres)).toBeUndefined();
});
