/** A long text in pieces of whole lines, each looked at by itself: what is typed makes a few of them new. */

import type { ChangeSet, Text } from "@codemirror/state";
import type { Finding } from "../wire/messages";

/** Characters that a piece has, about. */
const usual = 1 << 18;

/** Findings that are kept of a piece: nobody reads more. */
const most = 100;

/** A piece, between the places at which the one before it and the one behind it end. */
export interface CheckedPiece {
  /** Characters, with the one that ends its last line. */
  readonly length: number;
  /** Findings in it, by its own lines; nothing where nobody has looked yet. */
  readonly findings: readonly Finding[] | null;
}

export type Pieces = readonly CheckedPiece[];

/** Pieces of which none was looked at, of the lines from a place up to another at which lines begin. */
export function piecesOf(text: Text, from = 0, to = text.length + 1): CheckedPiece[] {
  const pieces: CheckedPiece[] = [];
  while (from < to) {
    const end = from + usual >= to - 1 ? to : text.lineAt(from + usual).to + 1;
    pieces.push({ length: Math.min(end, to) - from, findings: null });
    from += pieces.at(-1)?.length ?? to;
  }
  return pieces;
}

/** The same after changes, which made this text. */
export function changedPieces(pieces: Pieces, changes: ChangeSet, text: Text): Pieces {
  let now = pieces;
  // From the end: what stands before a change is still where it was.
  for (const [from, to, length] of rangesOf(changes).reverse()) {
    const [first, last] = [indexAt(now, from), indexAt(now, to)];
    const whole = lengthOf(now.slice(first, last + 1)) + length - (to - from);
    now = [...now.slice(0, first), { length: whole, findings: null }, ...now.slice(last + 1)];
  }
  return now === pieces ? pieces : now.length > 0 ? split(now, text) : piecesOf(text);
}

/** Places of the text before, between which something else stands now, of this length. */
function rangesOf(changes: ChangeSet): [number, number, number][] {
  const ranges: [number, number, number][] = [];
  changes.iterChangedRanges((fromA, toA, fromB, toB) => ranges.push([fromA, toA, toB - fromB]));
  return ranges;
}

/** Pieces that have grown long become several. */
function split(pieces: Pieces, text: Text): Pieces {
  let end = 0;
  return pieces.flatMap((piece) => {
    end += piece.length;
    return piece.length > 2 * usual ? piecesOf(text, end - piece.length, end) : [piece];
  });
}

const lengthOf = (pieces: Pieces): number => pieces.reduce((sum, { length }) => sum + length, 0);

/** The index of the piece in which a place is. */
function indexAt(pieces: Pieces, place: number): number {
  let end = 0;
  const index = pieces.findIndex(({ length }) => {
    end += length;
    return place < end;
  });
  return index < 0 ? pieces.length - 1 : index;
}

/** The piece that is to be looked at next: that at a place, or the nearest one. */
export function nextPiece(pieces: Pieces, place: number): CheckedPiece | undefined {
  const here = indexAt(pieces, place);
  for (let far = 0; far < pieces.length; far += 1) {
    const near = [pieces[here - far], pieces[here + far]];
    const next = near.find((piece) => piece?.findings === null);
    if (next) return next;
  }
  return undefined;
}

/** The lines of a piece that is one of these. */
export function linesOf(pieces: Pieces, piece: CheckedPiece, text: Text): string {
  const from = lengthOf(pieces.slice(0, pieces.indexOf(piece)));
  return text.sliceString(from, from + piece.length - 1);
}

/** The same after somebody has looked at a piece; it may have become another one meanwhile. */
export const withFindings = (pieces: Pieces, of: CheckedPiece, findings: Finding[]): Pieces =>
  pieces.map((piece) => (piece === of ? { ...piece, findings: findings.slice(0, most) } : piece));

/** All findings, by the lines of the text. */
export function findingsOf(pieces: Pieces, text: Text): Finding[] {
  let from = 0;
  return pieces.flatMap(({ length, findings }) => {
    const begin = from;
    from += length;
    // A line is looked for only where something is to be told: this is done with every key.
    if (!findings?.length) return [];
    const before = text.lineAt(Math.min(begin, text.length)).number - 1;
    return findings.map((finding) => ({ ...finding, line: finding.line + before }));
  });
}

/** The share of the text that was looked at, from 0 to 1. */
export const shareOf = (pieces: Pieces): number =>
  lengthOf(pieces.filter(({ findings }) => findings)) / Math.max(lengthOf(pieces), 1);
