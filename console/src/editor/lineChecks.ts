/** Checks a long text in the background: piece by piece, the nearest to the cursor first. */

import { setDiagnostics } from "@codemirror/lint";
import { type EditorView, ViewPlugin, type ViewUpdate } from "@codemirror/view";
import { checkAfterMs, diagnosticOf } from "./assistance";
import { type Check, unchecked } from "./check";
import {
  changedPieces,
  findingsOf,
  linesOf,
  nextPiece,
  type Pieces,
  piecesOf,
  shareOf,
  withFindings,
} from "./checkedPieces";
import { checkLines } from "./language";

class LineChecks {
  readonly #view: EditorView;
  readonly #name: string;
  readonly #told: (check: Check) => void;
  #pieces: Pieces;
  #marked = 0;
  #timer: ReturnType<typeof setTimeout>;
  #works = false;
  #isOver = false;

  constructor(view: EditorView, name: string, told: (check: Check) => void) {
    [this.#view, this.#name, this.#told] = [view, name, told];
    this.#pieces = piecesOf(view.state.doc);
    this.#timer = setTimeout(() => void this.#work(), checkAfterMs);
  }

  update(update: ViewUpdate): void {
    if (!update.docChanged) return;
    this.#pieces = changedPieces(this.#pieces, update.changes, update.state.doc);
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => void this.#work(), checkAfterMs);
    this.#tell();
  }

  destroy(): void {
    this.#isOver = true;
    clearTimeout(this.#timer);
  }

  async #work(): Promise<void> {
    if (this.#works) return;
    this.#works = true;
    this.#tell();
    try {
      while (!this.#isOver && (await this.#checkNext()));
    } catch (error) {
      if (!this.#isOver) this.#told(unchecked(error));
    }
    this.#works = false;
  }

  /** Looks at a piece; tells whether there was one. */
  async #checkNext(): Promise<boolean> {
    const { state } = this.#view;
    const piece = nextPiece(this.#pieces, state.selection.main.head);
    if (!piece) return false;
    const lines = linesOf(this.#pieces, piece, state.doc);
    const { findings } = await checkLines(this.#name, lines);
    if (this.#isOver) return false;
    this.#pieces = withFindings(this.#pieces, piece, findings);
    this.#mark();
    this.#tell();
    return true;
  }

  /** Marks what was found in the text. */
  #mark(): void {
    const { state } = this.#view;
    const findings = findingsOf(this.#pieces, state.doc);
    if (findings.length === 0 && this.#marked === 0) return;
    this.#marked = findings.length;
    const marks = findings.map((finding) => diagnosticOf(finding, state.doc));
    this.#view.dispatch(setDiagnostics(state, marks));
  }

  #tell(): void {
    const share = shareOf(this.#pieces);
    const findings = findingsOf(this.#pieces, this.#view.state.doc);
    this.#told({ is: "lines", share, findings });
  }
}

/** Looks at every line of a long text, and tells how far that is. */
export const checksOfLines = (name: string, told: (check: Check) => void) =>
  ViewPlugin.define((view) => new LineChecks(view, name, told));
