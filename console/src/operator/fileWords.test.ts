import { expect, it } from "vitest";
import type { UnixSeconds } from "../units/quantity";
import { message } from "../units/testing";
import { aboutText, sizeText, timeText } from "./fileWords";

const at = (text: string) => message<UnixSeconds>(new Date(text).getTime() / 1000);

it("says times of today without the day", () => {
  const now = new Date("2026-11-24T15:00:00");
  expect(timeText(at("2026-11-24T14:03:00"), now)).toMatch(/^today .*03/);
  expect(timeText(at("2026-11-23T14:03:00"), now)).not.toContain("today");
});

it("says sizes in the unit that fits", () => {
  expect([999, 8123, 2_500_000].map(sizeText)).toEqual(["999 B", "8 kB", "2.5 MB"]);
});

it("says what a file is, how large and since when", () => {
  const about = { name: "a.sbp", what: "a part program of 2 lines", bytes: 12, hash: "" };
  const text = aboutText({ ...about, changed: at("2020-01-02T10:00:00") });
  expect(text).toMatch(/^a part program of 2 lines, 12 B, changed .*2020/);
});
