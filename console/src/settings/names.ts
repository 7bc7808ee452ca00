/** Names of settings as a person reads them, and the words by which they are looked for. */

/** Endings of keys that name the unit, which stands beside the name. */
const unitEnding = /_(mm_s[23]?|mm|s|ms|ns|us|hz|khz|deg|percent|px|twips)$/;

const wordsOf = (key: string): string[] =>
  key.split(".").map((part) => part.replace(unitEnding, "").replaceAll("_", " "));

const large = (text: string): string => text.charAt(0).toUpperCase() + text.slice(1);

/** `speeds.cut.xy` in full: Speeds, cut, xy. */
export const fullName = (key: string): string => large(wordsOf(key).join(", "));

/** `speeds.cut.xy` below the title of its topic: Cut, xy. */
export function shortName(key: string): string {
  const [first = "", ...rest] = wordsOf(key);
  return large(rest.length > 0 ? rest.join(", ") : first);
}

/** Words that people look for, by the beginning of the keys that they mean. */
const alsoCalled: readonly (readonly [string, string])[] = [
  ["units", "inch inches metric imperial millimetre"],
  ["axes", "number of axes rotary 4th"],
  ["limits", "soft limits table size work area envelope travel"],
  ["view.table", "bed size work area"],
  ["axis.length", "travel soft limits size"],
  ["homing", "home limit switch endstop reference"],
  ["speeds", "feed feedrate rapid"],
  ["ramps", "acceleration accel jerk corner"],
  ["dynamics", "acceleration max speed jerk"],
  ["steps", "steps per mm resolution calibrate microstep"],
  ["cutter.diameter", "bit tool size"],
  ["cutter.safe_z", "clearance retract height"],
  ["tabs", "bridges holding"],
  ["ask_spindle", "router vfd rpm"],
  ["spindle", "router vfd rpm"],
  ["io.", "switch wiring input output relay"],
  ["estop", "emergency stop button e-stop"],
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
  const all = [entry.key, fullName(entry.key), entry.doc, title, ...also].join(" ").toLowerCase();
  return wanted
    .toLowerCase()
    .split(/\s+/)
    .every((word) => all.includes(word));
}
