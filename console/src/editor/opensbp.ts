/** Colours of OpenSBP: what a word is, line by line. The meaning of a file is the server's business. */

import { StreamLanguage, type StreamParser, type StringStream } from "@codemirror/language";

interface LineState {
  /** True as long as nothing of the line was read. */
  start: boolean;
}

/** A sort of word; the first that matches is it. */
interface Word {
  readonly pattern: RegExp;
  readonly name: string;
  /** Only where a line or a command behind THEN begins. */
  readonly first?: true;
}

const words: readonly Word[] = [
  { pattern: /^'.*/, name: "comment" },
  { pattern: /^rem\b.*/i, name: "comment" },
  { pattern: /^[A-Za-z_][\w ]*:(?!=)/, name: "labelName", first: true },
  { pattern: /^"[^"]*"?/, name: "string" },
  { pattern: /^[&$][\w.[\]]*/, name: "variableName" },
  { pattern: /^%\s*\(\s*\d*\s*\)?/, name: "atom" },
  {
    pattern:
      /^(?:if|then|else|goto|gosub|return|end|endall|pause|print|open|close|write|msgbox|input|shell|on|inp|for|as|append|output|getkey|play)\b/i,
    name: "keyword",
  },
  {
    pattern: /^(?:and|or|not|mod|sin|cos|tan|atn|sqr|abs|int|log|exp|rnd|len|val)\b/i,
    name: "operatorKeyword",
  },
  { pattern: /^[A-Za-z][A-Za-z0-9#](?=[\s,]|$)/, name: "tagName", first: true },
  { pattern: /^(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?/, name: "number" },
  { pattern: /^(?:<=|>=|<>|:=|[-+*/^=<>(),])/, name: "punctuation" },
];

/** Reads one word and tells what it is. */
function wordOf(stream: StringStream, first: boolean): string | null {
  for (const { pattern, name, first: onlyFirst } of words) {
    if ((!onlyFirst || first) && stream.match(pattern)) return name;
  }
  if (!stream.match(/^\w+/)) stream.next();
  return null;
}

const parser: StreamParser<LineState> = {
  name: "OpenSBP",
  startState: () => ({ start: true }),
  token(stream, state) {
    const first = stream.sol() || state.start;
    if (stream.eatSpace()) {
      state.start = first;
      return null;
    }
    const name = wordOf(stream, first);
    state.start = /^then$/i.test(stream.current());
    return name;
  },
  languageData: { commentTokens: { line: "'" } },
};

export const openSbp = StreamLanguage.define(parser);
