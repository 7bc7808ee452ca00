/** Diagnostics, completion and hover of the editor, all from the server's one core. */

import {
  autocompletion,
  type CompletionContext,
  type CompletionResult,
} from "@codemirror/autocomplete";
import { type Diagnostic, linter } from "@codemirror/lint";
import type { Extension, Text } from "@codemirror/state";
import { EditorView, hoverTooltip, type Tooltip } from "@codemirror/view";
import type { Finding, Level } from "../wire/messages";
import { hoverWords, offerWords } from "../words/commands";
import { findingWords } from "../words/findings";
import { type Check, checked, checking } from "./check";
import { longest } from "./document";
import { type At, checkText, completionsAt, hoverAt } from "./language";
import { checksOfLines } from "./lineChecks";

/** Pause in typing after which the text is checked, milliseconds. */
export const checkAfterMs = 350;

const grown =
  "the text has become long; once it is saved and opened again it is checked line by line";

/** Of a long text so many lines before and behind the cursor are looked at for words. */
const near = 2000;

const severities: Record<Level, Diagnostic["severity"]> = {
  error: "error",
  warning: "warning",
  note: "info",
};

/** A finding as the editor marks it. */
export function diagnosticOf(finding: Finding, text: Text): Diagnostic {
  const line = text.line(Math.min(Math.max(finding.line, 1), text.lines));
  const from = Math.min(line.from + Math.max(finding.column - 1, 0), line.to);
  const to = finding.length > 0 ? Math.min(from + finding.length, line.to) : line.to;
  const said = findingWords(finding);
  const hint = said.hint ? `\n${said.hint}` : "";
  return {
    from,
    to: Math.max(from, to),
    severity: severities[finding.level],
    source: finding.code,
    message: said.message + hint,
  };
}

function placeIn(text: Text, position: number, name: string): At {
  const line = text.lineAt(position);
  const first = text.length > longest ? Math.max(1, line.number - near) : 1;
  const last = text.length > longest ? Math.min(text.lines, line.number + near) : text.lines;
  return {
    name,
    text: text.sliceString(text.line(first).from, text.line(last).to),
    line: line.number - first + 1,
    column: position - line.from + 1,
  };
}

/** Checks the text after each pause in typing, and tells how far that is. */
function checks(name: string, told: (check: Check) => void): Extension {
  return [
    EditorView.updateListener.of((update) => {
      if (update.docChanged) told(checking);
    }),
    linter(
      async (view) => {
        const { doc } = view.state;
        if (doc.length > longest) told({ is: "unchecked", why: grown });
        if (doc.length > longest) return [];
        told(checking);
        const outcome = await checked(() => checkText(name, doc.toString()));
        // Another text is checked anew: what is told is of the one that stands there.
        if (view.state.doc !== doc) return [];
        told(outcome);
        if (outcome.is !== "checked") return [];
        const own = outcome.findings.filter(({ file }) => file === "" || file === name);
        return own.map((finding) => diagnosticOf(finding, doc));
      },
      { delay: checkAfterMs },
    ),
  ];
}

const completing = (name: string) => async (context: CompletionContext) => {
  const word = context.matchBefore(/[&$%]?\w*/);
  if (!word || (word.from === word.to && !context.explicit)) return null;
  const offered = await completionsAt(placeIn(context.state.doc, context.pos, name));
  const options = offered.map(offerWords).map(({ label, kind, detail, doc }) => ({
    label,
    type: kind === "command" ? "function" : kind,
    detail,
    info: doc,
  }));
  return { from: word.from, options } satisfies CompletionResult;
};

const hovering = (name: string) =>
  hoverTooltip(async (view: EditorView, position: number): Promise<Tooltip | null> => {
    const { doc } = view.state;
    const known = await hoverAt(placeIn(doc, position, name));
    if (!known) return null;
    const start = doc.lineAt(position).from - 1;
    return {
      pos: start + known.from,
      end: start + known.to,
      create: () => {
        const dom = document.createElement("div");
        dom.textContent = hoverWords(known.text);
        return { dom };
      },
    };
  });

/** Everything the server helps with, for a file of this name. */
export const assistance = (name: string, text: Text, told: (check: Check) => void): Extension => [
  text.length > longest ? checksOfLines(name, told) : checks(name, told),
  autocompletion({ override: [completing(name)] }),
  hovering(name),
];
