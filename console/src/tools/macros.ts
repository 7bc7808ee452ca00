/** Macros: lines of OpenSBP under a name, with values that are asked for before they run. This browser keeps them. */

const key = "kerf.macros";

export interface Macro {
  readonly name: string;
  /** `JZ,{height=1}` asks for height, 1 at first. */
  readonly lines: string;
}

/** Examples that a new browser begins with. */
const usual: readonly Macro[] = [{ name: "Park", lines: "SA\nJZ,{height=1}\nJ2,{x=0},{y=0}" }];

export function readMacros(): readonly Macro[] {
  try {
    const kept: unknown = JSON.parse(localStorage.getItem(key) ?? "null");
    return Array.isArray(kept) ? kept.filter(isMacro) : usual;
  } catch {
    // Another program may have written there: what it wrote is no list.
    return usual;
  }
}

const isMacro = (one: unknown): one is Macro =>
  typeof one === "object" &&
  one !== null &&
  typeof (one as Macro).name === "string" &&
  typeof (one as Macro).lines === "string";

export const keepMacros = (macros: readonly Macro[]): void =>
  localStorage.setItem(key, JSON.stringify(macros));

export interface MacroValue {
  readonly name: string;
  readonly first: string;
}

const asked = /\{\s*([a-z]\w*)\s*(?:=([^}]*))?\}/gi;

/** The values that a macro asks for, each once. */
export function valuesOf(lines: string): MacroValue[] {
  const values = new Map<string, string>();
  for (const [, name = "", first = ""] of lines.matchAll(asked))
    values.set(name, values.get(name) || first.trim());
  return [...values].map(([name, first]) => ({ name, first }));
}

/** The lines with values in their places. */
export const filledIn = (lines: string, values: Readonly<Record<string, string>>): string =>
  lines.replaceAll(asked, (_, name: string) => (values[name] ?? "").trim());
