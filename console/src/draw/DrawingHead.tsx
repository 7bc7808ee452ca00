import { useState } from "react";
import { FileTrigger } from "react-aria-components";
import { attempt } from "../actions/action";
import { ask } from "../actions/ask";
import { beginDrawing, isUnsaved, unsaved } from "../actions/draw";
import { writing } from "../actions/replace";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { drawingWords } from "../app/drawingWords";
import { machine } from "../job/actions";
import { Button } from "../ui/Button";
import { drawingEndings, jobEnding, savedEndings } from "../wire/endings";
import type { Op } from "../wire/messages";
import { t } from "../words/words";
import { FileSheet } from "./FileSheet";
import type { Desk } from "./useDesk";
import { fitted, type Size } from "./window";

type Asking = "open" | "save" | "program";

/** The drawing's name, its files, undo and redo, and the way to the machine. */
export function DrawingHead({ desk }: { desk: Desk }) {
  const hands = useHands();
  const drawing = useSnapshot("drawing");
  const drawingOnly = useSnapshot("drawingOnly") ?? false;
  const [asking, setAsking] = useState<Asking | null>(null);
  const [given, setGiven] = useState<readonly File[]>([]);
  const openGiven = (files: readonly File[]) => {
    setGiven(files);
    setAsking("open");
  };
  // Tool paths that were opened stay tool paths: their name is not that of their drawing.
  const isJob = drawing?.name?.toLowerCase().endsWith(`.${jobEnding}`) ?? false;
  const empty = drawing?.shapes ? undefined : t("The drawing has no shapes yet.");
  const draw = (op: Op) => ask(worldOf(hands), { do: "draw", op });
  /** Writes a file of the drawing; one that is there already is replaced when the person says so. */
  const write = (op: "save" | "program", name: string) =>
    writing(worldOf(hands), name, async (replaces) => {
      const reply = await hands.link.ask({ do: "draw", op: { op, name, replaces } });
      for (const note of reply.notes) hands.screen.tell(drawingWords(note));
      return reply.problem;
    });
  const program = async (name: string) => {
    if (!(await write("program", name))) return false;
    if (drawingOnly) hands.screen.tell(t("{0} is written into the part folder.", name));
    else hands.screen.go("/");
    return true;
  };
  return (
    <header className="drawing-head">
      <p className="drawing-name">
        {drawing?.name ?? t("New drawing")}
        {drawing?.changed && <span title={t("changed since it was saved")}> ●</span>}
      </p>
      <div className="drawing-buttons">
        <Button size="small" onPress={() => attempt(beginDrawing, worldOf(hands))}>
          New
        </Button>
        <Button size="small" onPress={() => openGiven([])}>
          Open…
        </Button>
        <FileTrigger
          acceptedFileTypes={drawingEndings.map((ending) => `.${ending}`)}
          onSelect={(files) => openGiven([...(files ?? [])])}
        >
          <Button size="small">Open from disk…</Button>
        </FileTrigger>
        <Button size="small" onPress={() => setAsking("save")}>
          Save…
        </Button>
        <span className="drawing-gap" />
        <Button
          size="small"
          refused={drawing?.canUndo ? undefined : t("There is nothing to take back.")}
          onPress={() => void draw({ op: "undo" })}
        >
          Undo
        </Button>
        <Button
          size="small"
          refused={drawing?.canRedo ? undefined : t("There is nothing to make again.")}
          onPress={() => void draw({ op: "redo" })}
        >
          Redo
        </Button>
        <Button
          size="small"
          onPress={() => desk.set((s) => ({ ...s, window: allOf(desk, s.size) }))}
        >
          Show all
        </Button>
        <span className="drawing-gap" />
        <Button size="small" refused={empty} onPress={() => setAsking("program")}>
          Make the part program…
        </Button>
        {!drawingOnly && (
          <Button
            size="small"
            look="primary"
            refused={empty}
            onPress={() => void machine(worldOf(hands), null)}
          >
            Machine
          </Button>
        )}
      </div>
      {asking === "open" && (
        <FileSheet
          title={t("Open a drawing")}
          warning={isUnsaved(worldOf(hands)) ? unsaved : undefined}
          endings={drawingEndings}
          given={given}
          onClose={() => setAsking(null)}
          onName={(name) => draw({ op: "open", name })}
        />
      )}
      {asking === "save" && (
        <FileSheet
          title={t("Save the drawing")}
          endings={isJob ? [jobEnding, ...savedEndings] : savedEndings}
          proposal={named(drawing?.name, isJob ? jobEnding : "rsg")}
          onClose={() => setAsking(null)}
          onName={(name) => write("save", name)}
        />
      )}
      {asking === "program" && (
        <FileSheet
          title={t("Part program of the tool paths")}
          endings={["sbp", "nc"]}
          proposal={named(drawing?.name, "sbp")}
          onClose={() => setAsking(null)}
          onName={program}
        />
      )}
    </header>
  );
}

const allOf = ({ around: { box, expansion } }: Desk, size: Size) => fitted(box, size, expansion);

/** A drawing's name with another ending. */
const named = (name: string | null | undefined, ending: string): string =>
  `${(name ?? "drawing").replace(/\.[^./]*$/, "")}.${ending}`;
