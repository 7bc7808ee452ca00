import { describe, expect, it } from "vitest";
import type { World } from "./action";
import { actionOfKey, type KeyPress, keyName } from "./keys";
import { actions } from "./registry";

const press = (key: string, more: Partial<KeyPress> = {}): KeyPress => ({
  key,
  ctrlKey: false,
  altKey: false,
  metaKey: false,
  shiftKey: false,
  repeat: false,
  ...more,
});

describe("keys", () => {
  it.each<[KeyPress, string]>([
    [press("k"), "k"],
    [press("K", { shiftKey: true }), "k"],
    [press("k", { ctrlKey: true }), "Ctrl+K"],
    [press("n", { ctrlKey: true, shiftKey: true }), "Ctrl+Shift+N"],
    [press("F10"), "F10"],
    [press(" "), "Space"],
    [press("o", { metaKey: true }), "Ctrl+O"],
  ])("are named", (key, name) => expect(keyName(key)).toBe(name));

  it("mean one action each, and another one at the most at times", () => {
    const all = actions.flatMap(({ keys, when }) => (keys ?? []).map((key) => `${!when} ${key}`));
    expect(new Set(all).size).toBe(all.length);
  });

  it("start the job that is open on Operate, and are those of every screen elsewhere", () => {
    const ten = (route: string, kind: string) => {
      const shown = { snapshot: { opened: { kind } } };
      const world = { shown, screen: { get: () => ({ route }) } } as unknown as World;
      return actionOfKey(actions, press("F10"), true, world)?.id;
    };
    expect([ten("/", "job"), ten("/", "drawing")]).toEqual(["job.startKey", "job.startKey"]);
    expect(ten("/", "program")).toBe("sheet.calculator");
    expect(ten("/draw", "job")).toBe("sheet.calculator");
  });

  it("belong to actions of different names", () => {
    const ids = actions.map((action) => action.id);
    expect(new Set(ids).size).toBe(ids.length);
  });

  it("are not heard while somebody types, nor when they repeat", () => {
    expect(actionOfKey(actions, press("k"), false)?.id).toBe("sheet.keypad");
    expect(actionOfKey(actions, press("k"), true)).toBeUndefined();
    expect(actionOfKey(actions, press("k", { repeat: true }), false)).toBeUndefined();
    expect(actionOfKey(actions, press("k", { ctrlKey: true }), true)?.id).toBe("sheet.palette");
  });

  it("move nothing when they are bare letters", () => {
    const bare = actions.filter((action) => action.keys?.some((key) => /^[a-z]$/.test(key)));
    expect(bare.every((action) => action.id.startsWith("sheet."))).toBe(true);
  });
});
