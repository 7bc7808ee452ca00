/**
 * The lines of a text of any length, without a string a line: the bytes stay as they came, and the
 * beginning of each line is known.
 */

const newline = 10;
const carriageReturn = 13;

/** Lines that are looked for before others on the page get their turn. */
const batch = 20_000;

export interface LineIndex {
  readonly bytes: Uint8Array<ArrayBuffer>;
  /** Offset at which each line begins; one more for the end. */
  readonly starts: Uint32Array<ArrayBuffer>;
}

const pause = () => new Promise<void>((resolve) => setTimeout(resolve));

/** Finds the lines of a text that is known to have about so many. */
export async function indexLines(bytes: Uint8Array<ArrayBuffer>): Promise<LineIndex> {
  let starts = new Uint32Array(1024);
  let count = 1;
  for (let at = bytes.indexOf(newline); at >= 0; at = bytes.indexOf(newline, at + 1)) {
    if (count + 1 >= starts.length) starts = grown(starts);
    starts[count] = at + 1;
    count += 1;
    if (count % batch === 0) await pause();
  }
  const ended = starts[count - 1] === bytes.length && count > 1;
  if (!ended) {
    starts[count] = bytes.length;
    count += 1;
  }
  return { bytes, starts: starts.slice(0, count) };
}

function grown(starts: Uint32Array<ArrayBuffer>): Uint32Array<ArrayBuffer> {
  const larger = new Uint32Array(starts.length * 2);
  larger.set(starts);
  return larger;
}

const decoder = new TextDecoder();

/** A line, counted from 1, without its end. */
export function lineAt({ bytes, starts }: LineIndex, line: number): string {
  const [from, to] = [starts[line - 1], starts[line]];
  if (from === undefined || to === undefined) return "";
  let end = to;
  while (end > from && (bytes[end - 1] === newline || bytes[end - 1] === carriageReturn)) end -= 1;
  return decoder.decode(bytes.subarray(from, end));
}

export const lineCount = ({ starts }: LineIndex): number => starts.length - 1;
