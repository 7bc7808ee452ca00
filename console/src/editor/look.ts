/** Theme of the editor: the design tokens of the page. */

import { HighlightStyle, syntaxHighlighting } from "@codemirror/language";
import { EditorView } from "@codemirror/view";
import { tags } from "@lezer/highlight";

const frame = EditorView.theme({
  "&": { height: "100%", color: "var(--text)", backgroundColor: "var(--panel)" },
  "&.cm-focused": { outline: "2px solid var(--focus)", outlineOffset: "-2px" },
  ".cm-scroller": { font: "15px/1.5 var(--mono)" },
  ".cm-content": { caretColor: "var(--text)" },
  ".cm-cursor": { borderLeftColor: "var(--text)", borderLeftWidth: "2px" },
  ".cm-gutters": {
    color: "var(--muted)",
    backgroundColor: "var(--sunken)",
    borderRight: "1px solid var(--line)",
  },
  ".cm-activeLine": { backgroundColor: "color-mix(in srgb, var(--accent) 10%, transparent)" },
  ".cm-activeLineGutter": { color: "var(--text)", backgroundColor: "var(--raised)" },
  "&.cm-focused .cm-selectionBackground, .cm-selectionBackground": {
    backgroundColor: "color-mix(in srgb, var(--accent) 35%, transparent)",
  },
  ".cm-tooltip": {
    border: "1px solid var(--line-strong)",
    borderRadius: "var(--radius)",
    color: "var(--text)",
    backgroundColor: "var(--panel)",
    maxWidth: "520px",
  },
  ".cm-tooltip-hover": { padding: "6px 10px", whiteSpace: "pre-wrap" },
  ".cm-tooltip.cm-tooltip-autocomplete > ul > li[aria-selected]": {
    color: "var(--accent-text)",
    backgroundColor: "var(--accent)",
  },
  ".cm-completionDetail": { color: "inherit", opacity: "0.8", fontStyle: "normal" },
  ".cm-diagnostic-error": { borderLeftColor: "var(--stop)" },
  ".cm-diagnostic-warning": { borderLeftColor: "var(--hold)" },
  ".cm-running": { backgroundColor: "var(--hold)", color: "var(--hold-text)" },
  ".cm-breakpoints": { width: "18px", cursor: "pointer" },
  ".cm-breakpoint": { color: "var(--stop)", paddingLeft: "3px" },
  ".cm-panels": { color: "var(--text)", backgroundColor: "var(--raised)" },
});

const colours = HighlightStyle.define([
  { tag: tags.comment, color: "var(--code-comment)" },
  { tag: tags.keyword, color: "var(--code-keyword)", fontWeight: "650" },
  { tag: tags.operatorKeyword, color: "var(--code-keyword)" },
  { tag: tags.tagName, color: "var(--code-command)", fontWeight: "700" },
  { tag: tags.variableName, color: "var(--code-variable)" },
  { tag: tags.atom, color: "var(--code-variable)" },
  { tag: tags.labelName, color: "var(--code-label)", fontWeight: "700" },
  { tag: tags.string, color: "var(--code-string)" },
  { tag: tags.number, color: "var(--code-number)" },
]);

export const look = [frame, syntaxHighlighting(colours)];
