/** Names of settings as a person reads them, and the words by which they are looked for. */

import { settingNames } from "../words/english/machineSettings";
import { machineSettings, topics } from "../words/german/machineSettings";
import { language, t } from "../words/words";

const german = language === "de";

/** Endings of keys that name the unit, which stands beside the name. */
const unitEnding = /_(mm_s[23]?|mm|s|ms|ns|us|hz|khz|deg|percent|px|twips)$/;

const wordsOf = (key: string): string[] =>
  key.split(".").map((part) => part.replace(unitEnding, "").replaceAll("_", " "));

const large = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** An axis or a motor in a key: `.xy`, `.z2.`, `_x`. */
const axis =
  /(?<=^(?:speeds|ramps)\.(?:cut|jog)\.|^(?:homing|motors|pendant|board)\.|^board\.home_)(?:xy|[xyz]2|[xyzabcwqr])(?=\.|$)/;

/** A key by which a table of texts knows settings that differ by their axis only. */
export const starred = (key: string): string => key.replace(axis, "*");

const letterOf = (key: string): string => axis.exec(key)?.[0].toUpperCase() ?? "";

/** The entry of a table for a key: that of the key itself, or that of all axes. */
const inTable = <T>(table: Readonly<Record<string, T>>, key: string): T | undefined =>
  table[key] ?? table[starred(key)];

/** The name that the language of the page has for a setting, whatever its axis. */
const ownName = (key: string): string | undefined =>
  german ? inTable(machineSettings, key)?.name : inTable(settingNames, key);

/** `speeds.cut.xy` in full: Speeds, cut, xy. */
export function fullName(key: string): string {
  const own = ownName(key);
  const [section = "", ...rest] = wordsOf(key);
  if (own === undefined) return large([section, ...rest].join(", "));
  if (rest.length === 0) return own;
  const letter = letterOf(key);
  const named = letter === "" || letter === own ? own : `${own}, ${letter}`;
  return german ? named : `${large(section)}, ${named}`;
}

/** `speeds.cut.xy` below the title of its topic: Cut, xy; the name of its row where its axis heads a column. */
export function shortName(key: string, isRow = false): string {
  const own = ownName(key);
  const letter = isRow ? "" : letterOf(key);
  if (own !== undefined) return letter === "" || letter === own ? own : `${own}, ${letter}`;
  const plain = isRow ? key.replace(axis, "").replace(/\.(?=\.|$)/, "") : key;
  const [first = "", ...rest] = wordsOf(plain);
  return large(rest.length > 0 ? rest.join(", ") : first);
}

/** The title of a topic. */
export const topicName = (title: string): string => (german ? (topics[title] ?? title) : title);

/** The description of a setting. */
export const docOf = ({ key, doc }: { key: string; doc: string }): string =>
  (german ? inTable(machineSettings, key)?.doc : undefined) ?? doc;

/** Values that a setting may have, as a sentence part. */
export function boundText(bound: string): string {
  const [, least = "", most = ""] = /^(\S+) to (\S+)$/.exec(bound) ?? [];
  if (most !== "") return t("{0} to {1}", least, most);
  const [, floor = ""] = /^(\S+) or greater$/.exec(bound) ?? [];
  if (floor !== "") return t("{0} or greater", floor);
  const [, above = ""] = /^greater than (\S+)$/.exec(bound) ?? [];
  return above === "" ? bound : t("greater than {0}", above);
}

/** Words that people look for, by the beginning of the keys that they mean. */
const alsoCalled: readonly (readonly [string, string])[] = [
  ["units", "inch inches metric imperial millimetre zoll millimeter"],
  ["axes", "number of axes rotary 4th"],
  ["limits", "soft limits table size work area envelope travel"],
  ["view.table", "bed size work area"],
  ["axis.length", "travel soft limits size"],
  ["homing", "home limit switch endstop reference endschalter"],
  ["speeds", "feed feedrate rapid vorschub"],
  ["ramps", "acceleration accel jerk corner"],
  ["dynamics", "acceleration max speed jerk"],
  ["steps", "steps per mm resolution calibrate microstep"],
  ["cutter.diameter", "bit tool size fräser werkzeug"],
  ["cutter.safe_z", "clearance retract height"],
  ["tabs", "bridges holding haltestege"],
  ["ask_spindle", "router vfd rpm"],
  ["spindle", "router vfd rpm"],
  ["io.", "switch wiring input output relay"],
  ["estop", "emergency stop button e-stop notaus"],
  ["pendant", "jog keys remote mpg"],
  ["driver", "controller port serial usb connection"],
  ["motors", "stepper invert direction reverse"],
  ["laser", "beam power"],
  ["zpos", "clearance surface depth height"],
  ["smoothing", "corner cornering max feed"],
  ["height", "thc torch"],
];

/** Tells whether a person who types this means the setting. */
export function isMeant(
  entry: { key: string; doc: string },
  title: string,
  wanted: string,
): boolean {
  const also = alsoCalled
    .filter(([begin]) => entry.key.startsWith(begin))
    .map(([, words]) => words);
  const own = [fullName(entry.key), docOf(entry), topicName(title)];
  const all = [entry.key, ...own, entry.doc, title, ...also].join(" ").toLowerCase();
  return wanted
    .toLowerCase()
    .split(/\s+/)
    .every((word) => all.includes(word));
}
