import { describe, expect, it } from "vitest";
import { inches } from "../../units/quantity";
import type { OperationPart, OperationValue } from "../../wire/messages";
import { clauseOf, type Entries, firstEntries, labelsOf } from "./form";

const part = (
  lead: string,
  value: OperationValue | null,
  change: Partial<OperationPart> = {},
): OperationPart => ({ lead, value, optional: false, repeats: false, ...change });

const length = (name: string): OperationValue => ({ is: "length", name });
const given = { unit: inches, selected: [3, 5] };

const made = (parts: readonly OperationPart[], ...entries: Entries) =>
  clauseOf({ name: "do" }, parts, entries, given);

describe("a form of an operation", () => {
  it("turns lengths of the user's unit into millimetres, and leaves other numbers", () => {
    const parts = [part("", length("RADIUS")), part("at ", { is: "pair" }, { optional: true })];
    expect(made(parts, "1/2", "1,2mm")).toEqual({ clause: "do 12.7 at 25.4,2" });
    expect(made(parts, "1/2", "")).toEqual({ clause: "do 12.7" });
    expect(made([part("", { is: "number", name: "ANGLE" })], "45*2")).toEqual({ clause: "do 90" });
    expect(made([part("lead-in=", { is: "arc" })], "1,90")).toEqual({
      clause: "do lead-in=25.4,90",
    });
  });

  it("says words, choices and what comes again", () => {
    expect(made([part("keep", null, { optional: true })], "on")).toEqual({ clause: "do keep" });
    expect(made([part("keep", null, { optional: true })], "")).toEqual({ clause: "do" });
    const pass = part("pass=", { is: "wordsOr", words: ["off"], length: true });
    expect(made([pass], "OFF")).toEqual({ clause: "do pass=off" });
    expect(made([pass], "1")).toEqual({ clause: "do pass=25.4" });
    const line = part("", { is: "vertex" }, { repeats: true });
    expect(made([line], "0,0 1,0,0.5 1,1")).toEqual({ clause: "do 0,0 25.4,0,0.5 25.4,25.4" });
  });

  it("tells what is wrong where it is wrong, all at once", () => {
    const parts = [part("", { is: "pair" }), part("", { is: "grid" }), part("", length("D"))];
    const found = made(parts, "5", "2 by 3", "");
    expect("wrong" in found && [...found.wrong.keys()]).toEqual([0, 1, 2]);
  });

  it("begins with what is selected", () => {
    const parts = [part("", { is: "shape" }), part("", { is: "shapes" }), part("auto", null)];
    expect(firstEntries(parts, given)).toEqual(["3", "3,5", "on"]);
  });

  it("has a name for every field", () => {
    const parts = [
      part("from ", { is: "pair" }),
      part("", { is: "pair" }),
      part("", { is: "pair" }),
      part("lead-in=", { is: "arc" }),
      part("", length("D")),
    ];
    expect(labelsOf(parts)).toEqual(["From", "Place", "Place 2", "Lead in", "Diameter"]);
  });
});
