/** Lines at which a single-stepped run halts: a click in the gutter sets and removes one. */

import { RangeSet, StateEffect, StateField } from "@codemirror/state";
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

/** Lines with a breakpoint, from 1. */
export function breakpointsOf(view: EditorView): number[] {
  const lines: number[] = [];
  view.state.field(field).between(0, view.state.doc.length, (from) => {
    lines.push(view.state.doc.lineAt(from).number);
  });
  return lines;
}

/** Sets or removes the breakpoint of the line that the cursor is in. */
export function toggleBreakpoint(view: EditorView): boolean {
  const { from } = view.state.doc.lineAt(view.state.selection.main.head);
  view.dispatch({ effects: toggled.of(from) });
  return true;
}

/** The gutter; tells whenever the breakpoints change. */
export const breakpoints = (told: (lines: number[]) => void) => [
  field,
  gutter({
    class: "cm-breakpoints",
    markers: (view) => view.state.field(field),
    initialSpacer: () => mark,
    domEventHandlers: {
      mousedown(view, line) {
        view.dispatch({ effects: toggled.of(line.from) });
        return true;
      },
    },
  }),
  EditorView.updateListener.of((update) => {
    if (update.startState.field(field) !== update.state.field(field))
      told(breakpointsOf(update.view));
  }),
];
