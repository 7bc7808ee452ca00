import { expect, it } from "vitest";
import { message } from "../units/testing";
import type { RunRecord } from "../wire/messages";
import { earlier, endText, partsMade, wanting, withOneMore } from "./runs";

const now = new Date(2026, 10, 24, 15, 0);
const at = (day: number) => new Date(2026, 10, day, 9, 0).getTime() / 1000;
const run = (file: string, day: number, ended: string | null, line = 0): RunRecord =>
  message<RunRecord>({
    file,
    begun: at(day),
    seconds: 10,
    ended,
    line,
    by: "",
  });

it.each<[RunRecord, string]>([
  [run("a", 1, null), "runs"],
  [run("a", 1, "ok", 9), "finished"],
  [run("a", 1, "stopped", 9), "stopped behind line 9"],
  [run("a", 1, "cut short"), "cut short"],
])("%j", (told, text) => expect(endText(told)).toBe(text));

it("parts are counted that came to their end", () =>
  expect(
    partsMade(
      [run("a", 24, "ok"), run("b", 24, "failed"), run("a", 24, null), run("a", 23, "ok")],
      now,
    ),
  ).toEqual([{ file: "a", today: 1, all: 2 }]));

it("a list of jobs grows, shrinks to one, and is put in order", () => {
  const list = withOneMore(withOneMore(withOneMore([], "a"), "b"), "a");
  expect(list).toEqual([
    { file: "a", wanted: 2, made: 0 },
    { file: "b", wanted: 1, made: 0 },
  ]);
  expect(wanting(list, "a", -5)[0]?.wanted).toBe(1);
  expect(earlier(list, "b").map(({ file }) => file)).toEqual(["b", "a"]);
  expect(earlier(list, "a")).toEqual(list);
});
