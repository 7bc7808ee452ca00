import { expect, it } from "vitest";
import type { SettingArea, SettingEntry } from "../wire/messages";
import { isMeant } from "./names";
import { fileOf, readFile } from "./settingsFile";
import { topicOf } from "./tables";

const entry = (key: string, value: string, kind: SettingEntry["kind"]): SettingEntry => ({
  key,
  value,
  kind,
  default: value,
  unit: "mm/s",
  bound: "",
  least: null,
  most: null,
  doc: "Speed.",
});
const number = { is: "number", none: false } as const;
const area: SettingArea = {
  title: "Speeds",
  manual: "",
  settings: [
    entry("speeds.cut.xy", "50", number),
    entry("speeds.cut.z", "25", number),
    entry("speeds.top", "[1, 2, 3, 4, 5, 6]", { is: "list", length: 6, none: false }),
    entry("speeds.note", "a = b", { is: "text" }),
  ],
};

it("a file that was saved holds every setting, and is the machine's own", () => {
  expect(readFile(fileOf([area], "test"), [area])).toEqual({ wanted: [], unknown: [] });
});

it("a file tells what is another, and which lines mean nothing", () => {
  const text = "speeds.cut.z = 30\n# speeds.cut.xy = 1\nspeed = 3\nnonsense\n";
  expect(readFile(text, [area])).toEqual({
    wanted: [{ key: "speeds.cut.z", from: "25", to: "30" }],
    unknown: ["speed = 3", "nonsense"],
  });
});

it("axes stand side by side", () => {
  const { tables, single } = topicOf(area);
  expect(tables.map(({ columns }) => columns)).toEqual([["XY", "X", "Y", "Z", "A", "B", "C"]]);
  expect(tables[0]?.rows.map(({ name }) => name)).toEqual(["Cut", "Top"]);
  expect(tables[0]?.rows[1]?.cells.get("C")?.at).toBe(5);
  expect(single.map(({ key }) => key)).toEqual(["speeds.note"]);
});

it.each([
  ["inch", "units", true],
  ["soft limits", "limits.high", true],
  ["feed", "speeds.cut.xy", true],
  ["inch", "speeds.cut.xy", false],
])("%s finds %s: %s", (wanted, key, found) => {
  expect(isMeant({ key, doc: "" }, "", wanted)).toBe(found);
});
