/**
 * A text of any length as the editor works on it, without a string a line: the bytes stay as they came, and what is
 * looked at is made of them. The editor keeps its text as a tree whose leaves are a few lines each; here a leaf knows
 * where its bytes are.
 *
 * ```text
 *  bytes ── folded (a worker) ──► bytes with line feeds, where each leaf begins ── textOf ──► tree of leaves
 * ```
 */

import { Line, Text } from "@codemirror/state";

export type LineEnd = "\n" | "\r\n" | "\r";

const [lineFeed, carriageReturn] = [10, 13];

/** Lines of a leaf: more than the editor's own have, which are made anew where somebody types. */
const leafLines = 512;

/** The bytes before a text that tell that it is UTF-8. */
const mark = [0xef, 0xbb, 0xbf];

/** A text as bytes; its lines end with a line feed. */
export interface StoredText {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** The beginning of each leaf, and that of one more. */
  readonly starts: Uint32Array<ArrayBuffer>;
  /** Characters of each leaf, as strings count them. */
  readonly lengths: Uint32Array<ArrayBuffer>;
  readonly lines: number;
  /** The end of its first line. */
  readonly ends: LineEnd;
}

/** Finds the leaves of a text; its bytes are moved where its lines end otherwise. */
export function folded(came: Uint8Array<ArrayBuffer>): StoredText {
  const { bytes, ends } = withLineFeeds(came);
  const starts = [0];
  let lines = 1;
  for (let at = bytes.indexOf(lineFeed); at >= 0; at = bytes.indexOf(lineFeed, at + 1)) {
    if (lines % leafLines === 0) starts.push(at + 1);
    lines += 1;
  }
  // As if a line feed stood behind the last line too.
  starts.push(bytes.length + 1);
  const all = Uint32Array.from(starts);
  return { bytes, starts: all, lengths: lengthsOf(bytes, all), lines, ends };
}

function withLineFeeds(came: Uint8Array<ArrayBuffer>): Pick<StoredText, "bytes" | "ends"> {
  const bytes = mark.every((byte, n) => came[n] === byte) ? came.subarray(mark.length) : came;
  const [first, feed] = [bytes.indexOf(carriageReturn), bytes.indexOf(lineFeed)];
  if (first < 0) return { bytes, ends: "\n" };
  const next = bytes[first + 1] === lineFeed ? "\r\n" : "\r";
  let [to, before] = [first, 0];
  for (let from = first; from < bytes.length; from += 1) {
    const byte = bytes[from] ?? 0;
    if (byte !== lineFeed || before !== carriageReturn) {
      bytes[to] = byte === carriageReturn ? lineFeed : byte;
      to += 1;
    }
    before = byte;
  }
  return { bytes: bytes.subarray(0, to), ends: feed >= 0 && feed < first ? "\n" : next };
}

const decoder = new TextDecoder("utf-8", { ignoreBOM: true });

/** The characters of each leaf: its bytes, where all are of ASCII. */
function lengthsOf(
  bytes: Uint8Array<ArrayBuffer>,
  starts: Uint32Array<ArrayBuffer>,
): Uint32Array<ArrayBuffer> {
  const lengths = new Uint32Array(starts.length - 1);
  for (let n = 0; n < lengths.length; n += 1) {
    const leaf = bytes.subarray(starts[n], (starts[n + 1] ?? 0) - 1);
    const isAscii = leaf.every((byte) => byte < 128);
    lengths[n] = isAscii ? leaf.length : decoder.decode(leaf).length;
  }
  return lengths;
}

/** The parts of the editor's own leaves that stored ones make otherwise. */
interface OwnLeaf extends Omit<Pick<Text, keyof Text>, "sliceString"> {
  sliceString(from: number, to?: number, lineEnd?: string): string;
  /** The line with a number, or that at a place; the leaf's first line has this number, and begins at this place. */
  lineInner(target: number, isLine: boolean, line: number, offset: number): Line;
}

/** The editor's own sorts of text, of which it exports only what they have in common. */
const Leaf = Text.of([""]).constructor as unknown as new (
  lines: string[],
  length: number,
) => OwnLeaf;
const OwnLine = Line as unknown as new (
  from: number,
  to: number,
  number: number,
  text: string,
) => Line;
const Tree = Text.of(Array(leafLines + 1).fill("")).constructor as unknown as {
  from(parts: readonly Text[], length: number): Text;
};

/** Leaves whose lines are kept: what is in sight lies in two or three. */
const mostSeen = 4;

/** The leaves that were looked at last, the last one first, with their lines. */
let seen: readonly { readonly leaf: StoredLeaf; readonly lines: string[] }[] = [];

const noLines: string[] = [];

/** A few lines of a stored text, which become strings when they are looked at. */
class StoredLeaf extends Leaf {
  readonly #bytes: Uint8Array;
  readonly #from: number;
  readonly #to: number;
  readonly #lines: number;

  constructor(bytes: Uint8Array, from: number, to: number, lines: number, length: number) {
    super(noLines, length);
    this.#bytes = bytes;
    this.#from = from;
    this.#to = to;
    this.#lines = lines;
  }

  override get lines(): number {
    return this.#lines;
  }

  get text(): string[] {
    const known = seen.find(({ leaf }) => leaf === this);
    if (known) return known.lines;
    const lines = this.#decoded().split("\n");
    seen = [{ leaf: this, lines }, ...seen].slice(0, mostSeen);
    return lines;
  }

  // The editor's own leaf sets its lines once, when it is made.
  set text(_: string[]) {}

  /** One line is found by its bytes, where each is a character: the others need no strings. */
  override lineInner(target: number, isLine: boolean, line: number, offset: number): Line {
    if (this.length !== this.#to - this.#from) return super.lineInner(target, isLine, line, offset);
    let [from, begin, number] = [this.#from, offset, line];
    for (;;) {
      const feed = this.#bytes.indexOf(lineFeed, from);
      const to = feed < 0 ? this.#to : Math.min(feed, this.#to);
      const end = begin + to - from;
      if ((isLine ? number : end) >= target || to === this.#to)
        return new OwnLine(begin, end, number, this.#decoded(from, to));
      [from, begin, number] = [to + 1, end + 1, number + 1];
    }
  }

  override sliceString(from: number, to = this.length, lineEnd = "\n"): string {
    if (lineEnd !== "\n") return super.sliceString(from, to, lineEnd);
    return this.#decoded().slice(Math.max(from, 0), Math.max(to, 0));
  }

  #decoded(from = this.#from, to = this.#to): string {
    return decoder.decode(this.#bytes.subarray(from, to));
  }
}

/** The text as the editor has it. */
export function textOf({ bytes, starts, lengths, lines }: StoredText): Text {
  const leaves = Array.from(lengths, (length, n) => {
    const [from, to] = [starts[n] ?? 0, (starts[n + 1] ?? 0) - 1];
    return new StoredLeaf(bytes, from, to, Math.min(leafLines, lines - n * leafLines), length);
  });
  const breaks = leaves.length - 1;
  return Tree.from(
    leaves,
    lengths.reduce((sum, length) => sum + length, breaks),
  );
}
