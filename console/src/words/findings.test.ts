import { readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { findingInGerman } from "./findings";
import { findingTexts } from "./german/findings/findings";

const german = (code: string, message: string): string =>
  findingInGerman({ code, message, hint: "" }).message;

it.each([
  ["S002", "unknown command QX", "Unbekannter Befehl: QX"],
  ["S012", "THEN expected", "THEN fehlt"],
  ["R003", "division by zero", "Division durch null"],
  ["R001", "&depth has no value", "&depth hat keinen Wert"],
  ["S009", "MX takes 1 value, this is one too many", "MX nimmt 1 Wert; das ist einer zu viel"],
  [
    "M001",
    "X would reach 650, the table limit is 610 (table base coordinates)",
    "X käme nach 650, die Tischgrenze ist 610 (Koordinaten des Tisches)",
  ],
  ["", "a sentence of a drawing", "a sentence of a drawing"],
])("%s %s", (code, message, expected) => expect(german(code, message)).toBe(expected));

it("a finding tells in German how it is mended", () => {
  const { hint } = findingInGerman({ code: "S012", message: "THEN expected", hint: "write THEN" });
  expect(hint).toBe(findingTexts.S012?.mend);
});

/** The codes of the one table that `kerf explain` reads. */
function codesOfTable(): string[] {
  const table = join(import.meta.dirname, "../../../crates/diag/src/codes.rs");
  const rows = readFileSync(table, "utf8").matchAll(
    /^ {4}\w+ "([A-Z]\d{3})" (?:Error|Warning|Note) "/gm,
  );
  return [...rows].map(([, code = ""]) => code).sort();
}

it("every code of the table has German words, and no other", () => {
  expect(codesOfTable().length).toBeGreaterThan(100);
  expect(Object.keys(findingTexts).sort()).toEqual(codesOfTable());
});
