/** Lines at which a single-stepped run halts: a click in the gutter sets and removes one. */

import { RangeSet, StateEffect, StateField, type Text } from "@codemirror/state";
import { EditorView, GutterMarker, gutter } from "@codemirror/view";

const toggled = StateEffect.define<number>();

const mark = new (class extends GutterMarker {
  override toDOM() {
    const dom = document.createElement("span");
    dom.className = "cm-breakpoint";
    dom.textContent = "●";
    dom.title = "Breakpoint";
    return dom;
  }
})();

const field = StateField.define<RangeSet<GutterMarker>>({
  create: () => RangeSet.empty,
  update(marks, change) {
    let now = marks.map(change.changes);
    for (const effect of change.effects) {
      if (!effect.is(toggled)) continue;
      const at = effect.value;
      let there = false;
      now.between(at, at, () => {
        there = true;
      });
      now = there
        ? now.update({ filter: (from) => from !== at })
        : now.update({ add: [mark.range(at)] });
    }
    return now;
  },
});

/** A line at which nothing is ever due: it is empty, or only names a place. */
const isPassed = (line: string): boolean => /^\s*(\w+:\s*('.*)?)?$/.test(line);

/** The place of a breakpoint that is set at a line: at the next one that does something. */
function placeFrom(doc: Text, at: number): number {
  let line = doc.lineAt(at);
  while (isPassed(line.text) && line.number < doc.lines) line = doc.line(line.number + 1);
  return isPassed(line.text) ? at : line.from;
}

/** Lines with a breakpoint, from 1. */
export function breakpointsOf(view: EditorView): number[] {
  const lines: number[] = [];
  view.state.field(field).between(0, view.state.doc.length, (from) => {
    lines.push(view.state.doc.lineAt(from).number);
  });
  return lines;
}

/** Marks of these lines, where a text has them. */
function marksOf(doc: Text, lines: readonly number[]): RangeSet<GutterMarker> {
  const there = lines.filter((line) => line >= 1 && line <= doc.lines);
  return RangeSet.of(
    there.map((line) => mark.range(doc.line(line).from)),
    true,
  );
}

/** Sets or removes the breakpoint of the line that the cursor is in. */
export function toggleBreakpoint(view: EditorView): boolean {
  const { doc, selection } = view.state;
  view.dispatch({ effects: toggled.of(placeFrom(doc, doc.lineAt(selection.main.head).from)) });
  return true;
}

/** The gutter with breakpoints that are set already; tells whenever they change. */
export const breakpoints = (set: readonly number[], told: (lines: number[]) => void) => [
  field.init(({ doc }) => marksOf(doc, set)),
  gutter({
    class: "cm-breakpoints",
    markers: (view) => view.state.field(field),
    initialSpacer: () => mark,
    domEventHandlers: {
      mousedown(view, line) {
        view.dispatch({ effects: toggled.of(placeFrom(view.state.doc, line.from)) });
        return true;
      },
    },
  }),
  EditorView.updateListener.of((update) => {
    if (update.startState.field(field) !== update.state.field(field))
      told(breakpointsOf(update.view));
  }),
];
