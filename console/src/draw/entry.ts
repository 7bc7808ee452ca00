/**
 * What a person types for a place or a number.
 *
 * Places: `x,y`, `@dx,dy` from the last place, `len<angle` from the last place. Numbers are sums and
 * products, each term with a unit of its own or in the user's: `3/4in+2mm`, `(10+5)/2`.
 */

import { type Place, place } from "./geometry/vec";

const unitsMm: Record<string, number> = { mm: 1, cm: 10, m: 1000, in: 25.4, '"': 25.4, ft: 304.8 };

/** A reading, or words that say what is wrong. */
export type Read<T> = { readonly value: T } | { readonly wrong: string };

export const isWrong = <T>(read: Read<T>): read is { readonly wrong: string } => "wrong" in read;

class Mistake extends Error {}

/** A length: millimetres. `unitMm` is the user's unit. */
export const readLength = (text: string, unitMm: number): Read<number> =>
  reading(() => new Reader(text, unitMm).whole());

/** A number without a unit: degrees, a factor, a count, a bulge. */
export const readNumber = (text: string): Read<number> =>
  reading(() => new Reader(text, null).whole());

/** A place. `base` is the last place, from which `@` and `<` count; else from the origin. */
export function readPlace(text: string, unitMm: number, base: Place | null): Read<Place> {
  const from = base ?? place(0, 0);
  return reading(() => {
    const polar = text.split("<");
    if (polar.length === 2) return readPolar(polar, unitMm, from);
    const relative = text.trim().startsWith("@");
    const parts = text.trim().replace(/^@/, "").split(",");
    if (parts.length !== 2) throw new Mistake("a place is x,y or @dx,dy or length<angle");
    const [x, y] = parts.map((part) => new Reader(part, unitMm).whole());
    return relative ? place(from.x + (x ?? 0), from.y + (y ?? 0)) : place(x ?? 0, y ?? 0);
  });
}

function readPolar(
  [length = "", angle = ""]: readonly string[],
  unitMm: number,
  from: Place,
): Place {
  const far = new Reader(length.replace(/^\s*@/, ""), unitMm).whole();
  const radians = (new Reader(angle, null).whole() * Math.PI) / 180;
  return place(from.x + far * Math.cos(radians), from.y + far * Math.sin(radians));
}

function reading<T>(read: () => T): Read<T> {
  try {
    return { value: read() };
  } catch (error) {
    if (error instanceof Mistake) return { wrong: error.message };
    throw error;
  }
}

/** Reads sums and products from left to right; a unit stands behind a term. */
class Reader {
  readonly #words: readonly string[];
  /** Millimetres in a term without a unit; nothing where no unit may stand. */
  readonly #unitMm: number | null;
  #at = 0;

  constructor(text: string, unitMm: number | null) {
    this.#words = text.match(/\d*\.?\d+(?:e[+-]?\d+)?|[a-z]+|[^\s]/gi) ?? [];
    this.#unitMm = unitMm;
  }

  /** All of the text. */
  whole(): number {
    if (this.#words.length === 0) throw new Mistake("a number is missing");
    const value = this.#sum();
    const rest = this.#words[this.#at];
    if (rest !== undefined) throw new Mistake(`“${rest}” is not understood`);
    if (!Number.isFinite(value)) throw new Mistake("that is no finite number");
    return value;
  }

  #takes(...words: readonly string[]): string | undefined {
    const word = this.#words[this.#at];
    if (word === undefined || !words.includes(word)) return undefined;
    this.#at += 1;
    return word;
  }

  #sum(): number {
    let value = this.#term();
    for (let sign = this.#takes("+", "-"); sign; sign = this.#takes("+", "-")) {
      value += sign === "+" ? this.#term() : -this.#term();
    }
    return value;
  }

  #term(): number {
    let value = this.#factor();
    for (let sign = this.#takes("*", "/"); sign; sign = this.#takes("*", "/")) {
      value = sign === "*" ? value * this.#factor() : value / this.#factor();
    }
    return value * this.#unit();
  }

  #factor(): number {
    if (this.#takes("-")) return -this.#factor();
    if (this.#takes("(")) {
      const inner = new Inner(this.#words.slice(this.#at));
      const value = inner.value();
      this.#at += inner.length;
      return value;
    }
    const word = this.#words[this.#at] ?? "";
    if (!/^[\d.]/.test(word))
      throw new Mistake(word ? `“${word}” is no number` : "a number is missing");
    this.#at += 1;
    return Number(word);
  }

  #unit(): number {
    if (this.#unitMm === null) return 1;
    const named = this.#takes(...Object.keys(unitsMm));
    return named === undefined ? this.#unitMm : (unitsMm[named] ?? 1);
  }
}

/** What stands within brackets: numbers without units, up to the bracket that closes. */
class Inner {
  readonly length: number;
  readonly #text: string;

  constructor(words: readonly string[]) {
    let depth = 1;
    const end = words.findIndex((word) => {
      depth += word === "(" ? 1 : word === ")" ? -1 : 0;
      return depth === 0;
    });
    if (end < 0) throw new Mistake("a bracket is not closed");
    this.#text = words.slice(0, end).join(" ");
    this.length = end + 1;
  }

  value(): number {
    return new Reader(this.#text, null).whole();
  }
}
