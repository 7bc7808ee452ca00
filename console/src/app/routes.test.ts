import { expect, it } from "vitest";
import { routes, shownIn } from "./routes";

it("shows none of the machine's screens where only drawings are worked on", () => {
  const shown = (only: boolean) => [...new Set(routes.map(({ path }) => shownIn(path, only)))];
  expect(shown(false)).toEqual(routes.map(({ path }) => path));
  expect(shown(true).sort()).toEqual(["/draw", "/edit", "/help"]);
  expect(shownIn("/", true)).toBe("/draw");
});
