import { expect, it } from "vitest";
import { routeOf, routes, shownIn } from "./routes";

it("shows none of the machine's screens where only drawings are worked on", () => {
  const shown = (only: boolean) => [...new Set(routes.map(({ path }) => shownIn(path, only)))];
  expect(shown(false)).toEqual(routes.map(({ path }) => path));
  expect(shown(true).sort()).toEqual(["/draw", "/edit", "/help"]);
  expect(shownIn("/", true)).toBe("/draw");
});

it("leads from the address that jobs had to the operator's screen", () => {
  expect(["/job", "/draw", "/nowhere"].map(routeOf)).toEqual(["/", "/draw", "/"]);
});
