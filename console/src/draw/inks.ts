/** Reads the colours of the drawing's inks, for tests. */

import { readFileSync } from "node:fs";

const tokens = readFileSync(new URL("../theme/tokens.css", import.meta.url), "utf8");

/** Hues in degrees at which names end. */
const names: readonly (readonly [number, string])[] = [
  [15, "red"],
  [40, "orange"],
  [70, "yellow"],
  [170, "green"],
  [195, "cyan"],
  [260, "blue"],
  [345, "magenta"],
  [360, "red"],
];

/** The name of a colour `#rrggbb`. */
function nameOf(hex: string): string {
  const [r = 0, g = 0, b = 0] = [1, 3, 5].map((n) => Number.parseInt(hex.slice(n, n + 2), 16));
  const [most, least] = [Math.max(r, g, b), Math.min(r, g, b)];
  const range = most - least;
  if (range < 40) return most < 90 ? "black" : least > 165 ? "white" : "grey";
  const sixth =
    most === r ? ((g - b) / range + 6) % 6 : most === g ? (b - r) / range + 2 : (r - g) / range + 4;
  return names.find(([end]) => sixth * 60 < end)?.[1] ?? "red";
}

/** The colours that a token has in the themes, the light one first. */
export function coloursOf(token: string): string[] {
  const found = tokens.matchAll(new RegExp(`${token}: (#[0-9a-f]{6});`, "g"));
  return [...found].map(([, hex = ""]) => nameOf(hex));
}
