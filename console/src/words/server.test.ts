import { expect, it } from "vitest";
import { sentences } from "./german/sentences/sentences";
import { notForPages, texts } from "./otherTexts";
import { textsOfCrate } from "./rustTexts";
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
  ["LINE without length: left out", "LINE ohne Länge: ausgelassen"],
  [
    "SPLINE with fewer than two different points: left out (line 7)",
    "SPLINE mit weniger als zwei verschiedenen Punkten: ausgelassen (line 7)",
  ],
  [
    "line 3: X would reach 650, the table limit is 610 (table base coordinates) (why)",
    "Zeile 3: X käme nach 650, die Tischgrenze ist 610 (Koordinaten des Tisches) (why)",
  ],
  [
    "grbl:/dev/ttyUSB0 does not answer any more; the machine stands at 1, 2, 3",
    "grbl:/dev/ttyUSB0 antwortet nicht mehr; die Maschine steht bei 1, 2, 3",
  ],
  ["a sentence that is in no table", "a sentence that is in no table"],
])("%s", (said, german) => expect(inGerman(said)).toBe(german));

/** Crates whose sentences reach a page as text. */
const speaking = [
  ...["server", "control", "model", "machine", "sequence", "toolpath", "part", "drawing"],
  ...["driver-grbl", "driver-linuxcnc", "driver-klipper", "transport"],
  ...["files", "journal", "import", "formats", "workspace"],
];

/** Crates whose other sentences are findings, which have their German by the code. */
const findings = ["sbp"];

const said = (sentence: string): string => sentence.replace(/\{\d\}/g, "{}");

/** Two words side by side, or a word with a value behind it. */
const isSentence = (text: string): boolean =>
  /\p{L}{2}\S* +\S*\p{L}{2}|^[a-z]+:? \{\}/u.test(text) && !/[%<>]\w+=|=%/.test(text);

it("every sentence of the server that a page shows has German words", () => {
  const german = new Set(Object.keys(sentences).map(said));
  const missing = speaking.flatMap((crate) =>
    [...textsOfCrate(crate)]
      .filter(([text, file]) => isSentence(text) && !notForPages[crate]?.test(file))
      .filter(([text]) => !german.has(text) && !texts.includes(text))
      .map(([text, file]) => `${crate}/${file}: ${text}`),
  );
  expect(missing).toEqual([]);
});

it("the server says every sentence of the table, and every text that is left English", () => {
  const spoken = new Set(
    [...speaking, ...findings].flatMap((crate) => [...textsOfCrate(crate).keys()]),
  );
  const table = Object.keys(sentences).map(said);
  expect([...table, ...texts].filter((text) => !spoken.has(text))).toEqual([]);
});

it("German sentences have the values of the English ones", () => {
  const places = (text: string): string => (text.match(/\{\d\}/g) ?? []).sort().join();
  const other = Object.entries(sentences).filter(([en, de]) => places(en) !== places(de));
  expect(other.map(([english]) => english)).toEqual(["nothing to {0}"]);
});
