import { describe, expect, it } from "vitest";
import type { UnixSeconds } from "../units/quantity";
import { message } from "../units/testing";
import type { FileInfo } from "../wire/messages";
import { listed, matches, parentOf } from "./folder";

const file = (name: string, folder = false): FileInfo => ({
  name,
  folder,
  bytes: 1,
  changed: message<UnixSeconds>(0),
  header: null,
  part: !name.endsWith(".log"),
  opens: folder || name.endsWith(".log") ? null : "program",
});
const files = [file("b.log"), file("b.sbp"), file("a.nc"), file("doors", true)];
const names = (word: string) => listed(files, word).map(({ name }) => name);

describe("the part folder", () => {
  it("shows folders first, then files by name", () =>
    expect(names("")).toEqual(["doors", "a.nc", "b.sbp"]));

  it("shows logs and the like only to a mask that asks for them", () => {
    expect(names("*")).toEqual(["a.nc", "b.log", "b.sbp"]);
    expect(names("b")).toEqual(["b.sbp"]);
  });

  it.each([
    ["Box.SBP", "*.sbp", true],
    ["box.sbpx", "*.sbp", false],
    ["a1.nc", "a?.nc", true],
    ["a12.nc", "a?.nc", false],
    ["a+b.nc", "a+*", true],
    ["coaster.sbp", "coast", true],
  ])("%s by the mask %s", (name, mask, is) => expect(matches(name, mask)).toBe(is));

  it("knows the folder above", () => {
    expect(parentOf("a/b/c.sbp")).toBe("a/b");
    expect(parentOf("c.sbp")).toBe("");
  });
});
