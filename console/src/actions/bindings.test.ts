import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { actions } from "./registry";

/** A browser that keeps what it is told. */
beforeEach(() => {
  const kept = new Map<string, string>();
  vi.stubGlobal("localStorage", {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => void kept.set(key, value),
  });
  vi.stubGlobal("navigator", { language: "en" });
  vi.resetModules();
});
afterEach(() => vi.unstubAllGlobals());

const here = async () => ({
  ...(await import("./bindings")),
  ...(await import("./keys")),
});

const press = (key: string, ctrlKey = false) => ({
  key,
  ctrlKey,
  altKey: false,
  metaKey: false,
  shiftKey: false,
  repeat: false,
});

it("a key that is set means its action, also in the page that is opened next", async () => {
  const { bind, actionOfKey } = await here();
  const palette = actions.find(({ id }) => id === "sheet.palette");
  if (!palette) throw new Error("there is no palette");
  bind(palette, "F2");
  expect(actionOfKey(actions, press("F2"), false)?.id).toBe("sheet.palette");
  expect(actionOfKey(actions, press("k", true), false)).toBeUndefined();
  vi.resetModules();
  const next = await here();
  expect(next.actionOfKey(actions, press("F2"), false)?.id).toBe("sheet.palette");
  next.unbindAll();
  expect(next.actionOfKey(actions, press("k", true), false)?.id).toBe("sheet.palette");
});

it.each([
  ["Ctrl+O", "Ctrl+O means: Open a file. Take it away there first."],
  ["Space", "Space keeps its meaning."],
  ["Escape", "Escape keeps its meaning."],
  ["F2", undefined],
  ["Ctrl+K", undefined],
])("%s for the palette: %s", async (key, why) => {
  const { refusedKey } = await here();
  const palette = actions.find(({ id }) => id === "sheet.palette");
  expect(palette && refusedKey(actions, palette, key)).toBe(why);
});

it("STOP keeps the space bar", async () => {
  const { isFixed, keysOf } = await here();
  const fixed = actions.filter(isFixed);
  expect(fixed.map((action) => [action.id, keysOf(action)])).toEqual([
    ["machine.space", ["Space"]],
  ]);
});
