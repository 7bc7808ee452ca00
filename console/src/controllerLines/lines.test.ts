import { expect, it } from "vitest";
import type { ControllerLine } from "../wire/messages";
import { kept, mostKept, mostShown, shownOf, timeOf, type Way } from "./lines";

const line = (number: number, sent: boolean, kind: ControllerLine["kind"], text: string) =>
  ({ number, at: 0, sent, kind, text, words: "" }) as unknown as ControllerLine;

const some = [
  line(0, false, "link", ""),
  line(1, true, "line", "G53 G1 X1"),
  line(2, false, "error", "error:9"),
  line(3, true, "atOnce", "!"),
  line(4, false, "alarm", "ALARM:1"),
];

it("shows one way, or what went wrong, and always what became of the line", () => {
  const check = (way: Way, search: string, numbers: readonly number[]) => {
    const words = ({ kind }: ControllerLine) => (kind === "error" ? "it is locked" : "");
    expect(shownOf(some, way, search, words).map(({ number }) => number)).toEqual(numbers);
  };
  check("all", "", [0, 1, 2, 3, 4]);
  check("sent", "", [0, 1, 3]);
  check("came", "", [0, 2, 4]);
  check("errors", "", [0, 2, 4]);
  check("all", " g53 ", [1]);
  check("errors", "LOCKED", [2]);
  check("sent", "locked", []);
});

it("keeps and shows the last lines, not all that there ever were", () => {
  const many = Array.from({ length: mostKept + 7 }, (_, at) => line(at, true, "line", "G1"));
  const all = kept(many.slice(0, 10), many.slice(10));
  expect([all.length, all[0]?.number]).toEqual([mostKept, 7]);
  const shown = shownOf(all, "all", "", () => "");
  expect([shown.length, shown.at(-1)?.number]).toEqual([mostShown, mostKept + 6]);
  expect(kept(some, [])).toBe(some);
});

it("tells the time of day to the thousandth", () => {
  const at = new Date(2026, 10, 28, 4, 3, 7, 45).getTime() / 1000;
  expect(timeOf({ ...line(0, true, "line", ""), at } as ControllerLine)).toBe("04:03:07.045");
});
