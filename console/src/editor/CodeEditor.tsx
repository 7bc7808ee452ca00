import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { lintGutter } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { type ChangeSet, EditorState, type Text } from "@codemirror/state";
import {
  drawSelection,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  keymap,
  lineNumbers,
} from "@codemirror/view";
import { useEffect, useRef } from "react";
import { t } from "../words/words";
import { assistance } from "./assistance";
import { breakpoints, toggleBreakpoint } from "./breakpoints";
import type { Check } from "./check";
import { look } from "./look";
import { openSbp } from "./opensbp";
import { markRunning, runningLineMark } from "./running";

export interface CodeEditorProps {
  name: string;
  /** Text with which it opens. */
  text: Text;
  /** The line that runs; 0 when none does. */
  running: number;
  onChange: (text: Text, changes: ChangeSet) => void;
  /** The line that is to be shown; nothing once it is. */
  spot: number | null;
  onSpotShown: () => void;
  /** Lines at which going line by line halts, when it begins. */
  breakpoints: readonly number[];
  onCheck: (check: Check) => void;
  onBreakpoints: (lines: number[]) => void;
  onSave: () => void;
}

/** The editor of part files. Another file is another editor: give it a `key`. */
export function CodeEditor(props: CodeEditorProps) {
  const box = useRef<HTMLDivElement>(null);
  const view = useRef<EditorView | null>(null);
  const latest = useRef(props);
  latest.current = props;
  useEffect(() => {
    if (!box.current) return;
    const made = new EditorView({ parent: box.current, state: firstState(latest) });
    // Reached by key even where the text in it is not.
    made.scrollDOM.tabIndex = 0;
    view.current = made;
    return () => made.destroy();
  }, []);
  useEffect(() => {
    if (view.current) markRunning(view.current, props.running);
  }, [props.running]);
  useEffect(() => {
    if (!view.current || props.spot === null) return;
    showLine(view.current, props.spot);
    latest.current.onSpotShown();
  }, [props.spot]);
  return <div className="code-editor" ref={box} />;
}

/** Puts the cursor on a line and brings it into sight. */
function showLine(view: EditorView, line: number): void {
  const { doc } = view.state;
  const anchor = doc.line(Math.min(Math.max(line, 1), doc.lines)).from;
  const effects = EditorView.scrollIntoView(anchor, { y: "center" });
  view.dispatch({ selection: { anchor }, effects });
  view.focus();
}

/** Nonce that allows the style sheets which the editor makes. */
const nonceOfPage = (): string =>
  document.querySelector<HTMLMetaElement>('meta[property="csp-nonce"]')?.nonce ?? "";

function firstState(latest: { readonly current: CodeEditorProps }): EditorState {
  const { name, text } = latest.current;
  const save = () => {
    latest.current.onSave();
    return true;
  };
  return EditorState.create({
    doc: text,
    extensions: [
      breakpoints(latest.current.breakpoints, (lines) => latest.current.onBreakpoints(lines)),
      lineNumbers(),
      lintGutter(),
      history(),
      drawSelection(),
      highlightActiveLine(),
      highlightActiveLineGutter(),
      highlightSelectionMatches(),
      openSbp,
      look,
      runningLineMark,
      assistance(name, text, (check) => latest.current.onCheck(check)),
      keymap.of([
        { key: "Mod-s", run: save },
        { key: "F9", run: toggleBreakpoint },
        ...historyKeymap,
        ...searchKeymap,
        ...defaultKeymap,
        indentWithTab,
      ]),
      EditorView.cspNonce.of(nonceOfPage()),
      EditorView.contentAttributes.of({ "aria-label": t("Text of {0}", name) }),
      EditorView.updateListener.of((update) => {
        if (update.docChanged) latest.current.onChange(update.state.doc, update.changes);
      }),
    ],
  });
}
