import type { ControllerSetting } from "../wire/messages";

/** A setting whose value in a file is another one. */
export interface Differing {
  readonly setting: ControllerSetting;
  readonly value: string;
}

/** The settings as a file that `kerf machine settings restore` reads, too: `$110=5000.000`, a line each. */
export const fileOf = (machine: string, settings: readonly ControllerSetting[]): string =>
  `; ${machine}\n${settings.map(({ number, value }) => `$${number}=${value}\n`).join("")}`;

/** The values of such a file by their numbers; lines that are none are left out. */
export function valuesOf(text: string): ReadonlyMap<number, string> {
  const lines = text.matchAll(/^\s*\$(\d+)\s*=\s*([^\s;(]+)/gm);
  return new Map([...lines].map(([, number, value]) => [Number(number), value ?? ""]));
}

/** The setting of what reports tell: it is as Kerf needs it while Kerf drives, and put back afterwards. */
const ofReports = 10;

/** Settings of which a file says another value. */
export const differing = (
  settings: readonly ControllerSetting[],
  values: ReadonlyMap<number, string>,
): Differing[] =>
  settings.flatMap((setting) => {
    const value = setting.number === ofReports ? undefined : values.get(setting.number);
    return value === undefined || isSame(setting.value, value) ? [] : [{ setting, value }];
  });

/** Numbers of settings in a file that the controller does not have. */
export const unknownOf = (
  settings: readonly ControllerSetting[],
  values: ReadonlyMap<number, string>,
): number[] => [...values.keys()].filter((number) => settings.every((it) => it.number !== number));

/** A controller writes 500 as 500.000. */
function isSame(a: string, b: string): boolean {
  const [x, y] = [Number(a), Number(b)];
  return a.trim() === b.trim() || (a !== "" && b !== "" && x === y);
}

/** The settings in whose number, words or unit all words of a search stand. */
export function found(
  settings: readonly ControllerSetting[],
  search: string,
  worded: (setting: ControllerSetting) => string,
): readonly ControllerSetting[] {
  const words = search.toLowerCase().split(/\s+/).filter(Boolean);
  const has = (it: ControllerSetting) => `$${it.number} ${worded(it)} ${it.unit}`.toLowerCase();
  return settings.filter((it) => words.every((word) => has(it).includes(word)));
}
