import { defaultKeymap, history, historyKeymap, indentWithTab } from "@codemirror/commands";
import { lintGutter } from "@codemirror/lint";
import { highlightSelectionMatches, searchKeymap } from "@codemirror/search";
import { EditorState } from "@codemirror/state";
import {
  drawSelection,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  keymap,
  lineNumbers,
} from "@codemirror/view";
import { useEffect, useRef } from "react";
import type { Finding } from "../wire/messages";
import { assistance } from "./assistance";
import { breakpoints, toggleBreakpoint } from "./breakpoints";
import { look } from "./look";
import { openSbp } from "./opensbp";
import { markRunning, runningLineMark } from "./running";

export interface CodeEditorProps {
  name: string;
  /** What stands in it at first. */
  text: string;
  /** The line that runs; 0 when none does. */
  running: number;
  onChange: (text: string) => void;
  onFindings: (findings: readonly Finding[]) => void;
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
  return <div className="code-editor" ref={box} />;
}

/** What allows the style sheets that the editor makes. */
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
      breakpoints((lines) => latest.current.onBreakpoints(lines)),
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
      assistance(name, (findings) => latest.current.onFindings(findings)),
      keymap.of([
        { key: "Mod-s", run: save },
        { key: "F9", run: toggleBreakpoint },
        ...historyKeymap,
        ...searchKeymap,
        ...defaultKeymap,
        indentWithTab,
      ]),
      EditorView.cspNonce.of(nonceOfPage()),
      EditorView.contentAttributes.of({ "aria-label": `Text of ${name}` }),
      EditorView.updateListener.of((update) => {
        if (update.docChanged) latest.current.onChange(update.state.doc.toString());
      }),
    ],
  });
}
