/**
 * Arithmetic as people type it into fields: `12+11/16`, `3/4in + 2mm`, `2*(1.5-1/8)`.
 *
 * A number with a unit is turned into the unit that the field is in. Angles are in radians, as in
 * part files.
 */

import {
  inUnit,
  type LengthUnit,
  type Mm,
  millimetres,
  mm,
  ofUnit,
  oneOf,
  shown,
} from "../units/quantity";

const functions: Record<string, (x: number) => number> = {
  sqrt: Math.sqrt,
  sqr: Math.sqrt,
  abs: Math.abs,
  sin: Math.sin,
  cos: Math.cos,
  tan: Math.tan,
  atn: Math.atan,
  int: Math.floor,
  log: Math.log,
  exp: Math.exp,
};

const tokenPattern = /\s*(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+|[A-Za-z]+|[-+*/^()"'])/y;

/** Splits a text; nothing when a character has no meaning. */
function tokensOf(text: string): string[] | undefined {
  const tokens: string[] = [];
  const trimmed = text.trimEnd();
  tokenPattern.lastIndex = 0;
  while (tokenPattern.lastIndex < trimmed.length) {
    const found = tokenPattern.exec(trimmed)?.[1];
    if (found === undefined) return undefined;
    tokens.push(found);
  }
  return tokens;
}

class Parser {
  readonly #tokens: readonly string[];
  readonly #unit: LengthUnit;
  #at = 0;

  constructor(tokens: readonly string[], unit: LengthUnit) {
    this.#tokens = tokens;
    this.#unit = unit;
  }

  /** The value of the whole text; `NaN` when it makes no sense. */
  whole(): number {
    const value = this.#sum();
    return this.#at === this.#tokens.length ? value : Number.NaN;
  }

  #take(...wanted: string[]): string | undefined {
    const token = this.#tokens[this.#at];
    if (token === undefined || !wanted.includes(token)) return undefined;
    this.#at += 1;
    return token;
  }

  #sum(): number {
    let value = this.#product();
    for (let sign = this.#take("+", "-"); sign; sign = this.#take("+", "-")) {
      const next = this.#product();
      value = sign === "+" ? value + next : value - next;
    }
    return value;
  }

  #product(): number {
    let value = this.#signed();
    for (let sign = this.#take("*", "/"); sign; sign = this.#take("*", "/")) {
      const next = this.#signed();
      value = sign === "*" ? value * next : value / next;
    }
    return this.#inUnit(value);
  }

  /** A unit behind a product belongs to all of it: `3/4in` is three quarters of an inch. */
  #inUnit(value: number): number {
    const one = oneOf(this.#tokens[this.#at] ?? "");
    if (one === undefined) return value;
    this.#at += 1;
    return inUnit(mm(value * one), this.#unit);
  }

  #signed(): number {
    if (this.#take("-")) return -this.#signed();
    if (this.#take("+")) return this.#signed();
    return this.#power();
  }

  #power(): number {
    const base = this.#atom();
    return this.#take("^") ? base ** this.#signed() : base;
  }

  #atom(): number {
    if (this.#take("(")) return this.#closed();
    const token = this.#tokens[this.#at];
    if (token === undefined) return Number.NaN;
    this.#at += 1;
    const call = functions[token.toLowerCase()];
    if (call) return this.#take("(") ? call(this.#closed()) : Number.NaN;
    return token.toLowerCase() === "pi" ? Math.PI : Number(token);
  }

  #closed(): number {
    const value = this.#sum();
    return this.#take(")") ? value : Number.NaN;
  }
}

/** The value of an expression in the unit of the field; nothing when it has none. */
export function evaluate(text: string, unit: LengthUnit = millimetres): number | undefined {
  const tokens = tokensOf(text);
  if (!tokens || tokens.length === 0) return undefined;
  const value = new Parser(tokens, unit).whole();
  return Number.isFinite(value) ? value : undefined;
}

/** A result as it is shown: six digits behind the point at most, no zeros at the end. */
export const resultText = (value: number): string => String(Number(value.toFixed(6)));

/** Tells whether a text is more than a plain number. */
export const isExpression = (text: string): boolean =>
  text.trim() !== "" && Number.isNaN(Number(text)) && evaluate(text) !== undefined;

/** The length that an expression gives in a field of lengths; nothing when it has none. */
export function lengthOf(text: string, unit: LengthUnit): Mm | undefined {
  const value = evaluate(text, unit);
  return value === undefined ? undefined : ofUnit(shown(value), unit);
}
