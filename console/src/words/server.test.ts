import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { serverSentences } from "./german/server";
import { inGerman } from "./server";

it.each([
  ["nothing is held", "Nichts wird gehalten."],
  ["stopped by stop input 4", "Angehalten durch Halteingang 4."],
  [
    "the file has mistakes, the first in line 3: MX needs 1 {0} value",
    "Die Datei hat Fehler, den ersten in Zeile 3: MX needs 1 {0} value",
  ],
  ["a sentence that is in no table", "a sentence that is in no table"],
])("%s", (said, german) => expect(inGerman(said)).toBe(german));

/** The texts of the crates that speak to pages; what a format puts in is `{}`. */
function textsOfServer(): string {
  const crates = join(import.meta.dirname, "../../../crates");
  const files = ["server", "control", "model"].flatMap((crate) => {
    const folder = join(crates, crate, "src");
    const names = readdirSync(folder, { recursive: true, encoding: "utf8" });
    return names.filter((name) => name.endsWith(".rs")).map((name) => join(folder, name));
  });
  const joined = files.map((file) => readFileSync(file, "utf8").replace(/\\\n\s*/g, ""));
  return joined.join("\n").replace(/\{[\w:?]*\}/g, "{}");
}

it("the server says every sentence of the table", () => {
  const texts = textsOfServer();
  const isSaid = (said: string) => texts.includes(`"${said.replace(/\{\d\}/g, "{}")}"`);
  expect(Object.keys(serverSentences).filter((said) => !isSaid(said))).toEqual([]);
});
