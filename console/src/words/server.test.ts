import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";
import { drawingSentences } from "./german/drawingSentences";
import { findingSentences } from "./german/findings/sentences";
import { serverSentences } from "./german/server";
import { inGerman } from "./server";

it.each([
  ["nothing is held", "Nichts wird gehalten."],
  ["stopped by stop input 4", "Angehalten durch Halteingang 4."],
  [
    "the file has mistakes, the first in line 3: MX needs 1 {0} value",
    "Die Datei hat Fehler, den ersten in Zeile 3: MX needs 1 {0} value",
  ],
  [
    "the file has mistakes, the first in line 3: there is no label END",
    "Die Datei hat Fehler, den ersten in Zeile 3: Die Marke END gibt es nicht",
  ],
  ["shape 12 at 10,5.25: why", "Form 12 bei 10,5.25: why"],
  ["shape 12: why", "Form 12: why"],
  ["a sentence that is in no table", "a sentence that is in no table"],
])("%s", (said, german) => expect(inGerman(said)).toBe(german));

/** The texts of the crates that speak to pages; what a format puts in is `{}`. */
function textsOfServer(): string {
  const crates = join(import.meta.dirname, "../../../crates");
  const speaking = ["server", "control", "model", "sbp", "drawing"];
  const files = speaking.flatMap((crate) => {
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
  const sentences = Object.keys({ ...serverSentences, ...findingSentences, ...drawingSentences });
  expect(sentences.filter((said) => !isSaid(said))).toEqual([]);
});
