import { describe, expect, it } from "vitest";
import { entry, parameter } from "./fixtures";
import {
  argumentsOf,
  commandOf,
  emptyLine,
  isImmediate,
  lettersOf,
  parameterAt,
  recalled,
  sent,
  typed,
} from "./line";

const m2 = entry("M2", [parameter("X"), parameter("Y")]);
const table = [entry("MX", [parameter("X")]), m2, entry("MH", [])];
const type = (text: string) =>
  [...text].reduce((state, key) => typed(state, state.text + key, table), emptyLine);

describe("the command line", () => {
  it("puts the comma behind two letters", () => {
    expect(type("mx2").text).toBe("MX,2");
    expect(type("mx,2").text).toBe("MX,2");
    expect(type("mx 2").text).toBe("MX,2");
    expect(type("m2,1,2").text).toBe("M2,1,2");
    expect(type("m2,,3").text).toBe("M2,,3");
    expect(type("mh").text).toBe("mh");
    expect(type("&x=3").text).toBe("&x=3");
  });

  it("lets a person take the comma back", () =>
    expect(typed(type("mx"), "MX", table).text).toBe("MX"));

  it("knows the command", () => {
    expect(lettersOf("mx,2")).toBe("MX");
    expect(lettersOf("m")).toBeUndefined();
    expect(lettersOf("mxy")).toBeUndefined();
    expect(commandOf(table, "m2 1")?.letters).toBe("M2");
  });

  it.each<[string, string[]]>([
    ["MX,", []],
    ["MX,2", ["2"]],
    ["M2,,3", ["", "3"]],
    ["M2,1,", ["1", ""]],
    ["M2 1, 2", ["1", "2"]],
    ['FP,"a,b.sbp",2', ['"a,b.sbp"', "2"]],
  ])("parts %s", (text, parts) => expect(argumentsOf(text)).toEqual(parts));

  it("tells which parameter is being written", () => {
    expect(parameterAt(m2, "M2,")?.name).toBe("X");
    expect(parameterAt(m2, "M2,1")?.name).toBe("X");
    expect(parameterAt(m2, "M2,1,")?.name).toBe("Y");
    expect(parameterAt(m2, "M2,1,2,3")).toBeUndefined();
  });

  it("acts at once when there is nothing to tell", () => {
    expect(isImmediate(commandOf(table, "MH"))).toBe(true);
    expect(isImmediate(commandOf(table, "MX"))).toBe(false);
    expect(isImmediate(undefined)).toBe(false);
  });

  it("recalls what was sent, each once", () => {
    let line = emptyLine;
    for (const text of ["MX,1", "MX,2", "MX,1"]) line = sent({ ...line, text });
    expect(line.history).toEqual(["MX,2", "MX,1"]);
    const up = recalled(line, -1);
    expect(up.text).toBe("MX,1");
    expect(recalled(up, -1).text).toBe("MX,2");
    expect(recalled(recalled(recalled(up, -1), -1), -1).text).toBe("MX,2");
    expect(recalled(up, 1).text).toBe("");
  });
});
