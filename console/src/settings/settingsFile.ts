/** The settings of a machine as a file: a line `key = value` each, as people read and compare them. */

import type { SettingArea, SettingEntry } from "../wire/messages";

/** A file of settings begins with it. */
const head = "# Kerf: settings of the machine";

/** True for the text of a file of settings. */
export const isOfSettings = (text: string): boolean => text.startsWith(head);

/** Every setting, by topic. */
export function fileOf(areas: readonly SettingArea[], machine: string): string {
  const told = new Set<string>();
  const lines = areas.flatMap(({ title, settings }) => {
    const fresh = settings.filter(({ key }) => !told.has(key) && told.add(key));
    return ["", `# ${title}`, ...fresh.map(({ key, value }) => `${key} = ${value}`)];
  });
  return [`${head} ${machine}`, ...lines, ""].join("\n");
}

export interface Wanted {
  readonly key: string;
  readonly from: string;
  readonly to: string;
}

export interface Loaded {
  /** Settings whose value in the file is another. */
  readonly wanted: readonly Wanted[];
  /** Lines that name no setting of this machine. */
  readonly unknown: readonly string[];
}

/** Reads a file of settings, and compares it with the machine's. */
export function readFile(text: string, areas: readonly SettingArea[]): Loaded {
  const known = new Map<string, SettingEntry>();
  for (const entry of areas.flatMap(({ settings }) => settings)) known.set(entry.key, entry);
  const wanted: Wanted[] = [];
  const unknown: string[] = [];
  for (const line of text.split(/\r?\n/)) {
    if (/^\s*(#.*)?$/.test(line)) continue;
    const at = line.indexOf("=");
    const [key, to] = [line.slice(0, at).trim(), line.slice(at + 1).trim()];
    const entry = at > 0 ? known.get(key) : undefined;
    if (!entry) unknown.push(line.trim());
    else if (entry.value !== to) wanted.push({ key, from: entry.value, to });
  }
  return { wanted, unknown };
}
