/** Marks the line that runs. */

import { StateEffect, StateField } from "@codemirror/state";
import { Decoration, type DecorationSet, EditorView } from "@codemirror/view";

const moved = StateEffect.define<number>();
const line = Decoration.line({ class: "cm-running" });

const field = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(marks, change) {
    let now = marks.map(change.changes);
    for (const effect of change.effects) {
      if (effect.is(moved)) now = markedAt(effect.value, change.state.doc.lines, change.state.doc);
    }
    return now;
  },
  provide: (marks) => EditorView.decorations.from(marks),
});

function markedAt(n: number, lines: number, doc: { line(n: number): { from: number } }) {
  return n >= 1 && n <= lines ? Decoration.set([line.range(doc.line(n).from)]) : Decoration.none;
}

export const runningLineMark = field;

/** Marks a line and brings it into sight; 0 takes the mark away. */
export function markRunning(view: EditorView, n: number): void {
  const { doc } = view.state;
  const there = n >= 1 && n <= doc.lines;
  view.dispatch({
    effects: there
      ? [moved.of(n), EditorView.scrollIntoView(doc.line(n).from, { y: "center" })]
      : [moved.of(0)],
  });
}
