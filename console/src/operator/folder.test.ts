import { describe, expect, it } from "vitest";
import { inFolder, matches, parentOf } from "./folder";

const file = (name: string, folder = false) => ({
  name,
  folder,
  bytes: 1,
  changed: 0,
  header: null,
  part: !name.endsWith(".log"),
});
const files = [
  file("b.log"),
  file("b.sbp"),
  file("a.nc"),
  file("doors", true),
  file("doors/left.sbp"),
];
const names = (folder: string, mask: string) =>
  inFolder(files, folder, mask).map(({ name }) => name);

describe("the part folder", () => {
  it("shows folders first, then files by name", () =>
    expect(names("", "")).toEqual(["doors", "a.nc", "b.sbp"]));

  it("shows logs and the like only to a mask that asks for them", () => {
    expect(names("", "*")).toEqual(["doors", "a.nc", "b.log", "b.sbp"]);
    expect(names("", "log")).toEqual(["doors", "b.log"]);
  });

  it("shows one folder", () => expect(names("doors", "")).toEqual(["doors/left.sbp"]));

  it("keeps folders in sight whatever the mask", () =>
    expect(names("", "*.sbp")).toEqual(["doors", "b.sbp"]));

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
