import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import type { Asked } from "../wire/messages";
import { askedInGerman, buttonInGerman } from "./asked";
import { answerButtons, questionTitles } from "./german/answers";
import { textsOfCrate } from "./rustTexts";

const asked = (kind: string, title: string, text: string) =>
  askedInGerman({ kind, title, text } as Asked);

it.each([
  ["paused", "Job", "Start with shape 3?", "Auftrag", "Mit Form 3 beginnen?"],
  ["limit", "Limits", "stopped by limit input 2", "Grenzen", "Angehalten durch Endschalter 2."],
  [
    "msgbox",
    "Location",
    "Position unverified: the data folder is new. Continue, if the location is right; else zero it first.",
    "Ort",
    "Der Ort ist nicht sicher: the data folder is new. Weiter, wenn der Ort stimmt; sonst zuerst nullen.",
  ],
  ["pause", "a.sbp", "Continue?", "a.sbp", "Weiter?"],
  ["msgbox", "Stock", "nothing is held", "Stock", "nothing is held"],
  ["input", "a.sbp", "no file is open", "a.sbp", "no file is open"],
])("a question of kind %s, %s: %s", (kind, title, text, german, said) => {
  const told = asked(kind, title, text);
  expect([told.title, told.text]).toEqual([german, said]);
});

it("every button of a question has German words, each its own", () => {
  const host = join(import.meta.dirname, "../../../crates/program/src/host.rs");
  const source = readFileSync(host, "utf8");
  const words = [...source.matchAll(/Self::\w+ => "(\w+)",/g)].map(([, word = ""]) => word);
  expect(words).toContain("Cancel");
  const shown = Object.keys(answerButtons).map(buttonInGerman);
  expect(words.filter((word) => answerButtons[word] === undefined)).toEqual([]);
  expect(new Set(shown).size).toBe(shown.length);
});

it("every title of a question is one that Kerf gives", () => {
  const said = ["control", "sequence", "machine"].flatMap((crate) => [
    ...textsOfCrate(crate).keys(),
  ]);
  expect(Object.keys(questionTitles).filter((title) => !said.includes(title))).toEqual([]);
});
