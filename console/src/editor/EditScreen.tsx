import { useState } from "react";
import { openFiles } from "../actions/go";
import { useHands } from "../app/context";
import { Watched } from "../debugger/Watched";
import { useRunningLine } from "../operator/useRunningLine";
import { ActionButton } from "../ui/ActionButton";
import { Button } from "../ui/Button";
import type { Finding } from "../wire/messages";
import { CodeEditor } from "./CodeEditor";
import { DebugBar } from "./DebugBar";
import { DropChanges } from "./DropChanges";
import { isChanged } from "./document";
import "./edit-screen.css";
import { FindingList } from "./FindingList";
import { NotSaved } from "./NotSaved";
import { SaveAs } from "./SaveAs";
import { useEdited } from "./useEdited";

/** The editor of part files (FE), and the debugger in it (FG). */
export function EditScreen() {
  const hands = useHands();
  const running = useRunningLine();
  const { file, shown, others, show, change, save, drop } = useEdited();
  const [findings, setFindings] = useState<readonly Finding[]>([]);
  const [asking, setAsking] = useState<"name" | "drop" | null>(null);
  const saveAs = async (as: string | null) => {
    if (as === null) setAsking("name");
    else if (await save(as)) setAsking(null);
  };
  const changed = isChanged(file);
  return (
    <div className="edit">
      <header className="edit-head">
        <h1>
          {file.name ?? "New file"}
          {changed && <span className="edit-changed"> · not saved</span>}
        </h1>
        <NotSaved names={others} onShow={(name) => void show(name)} />
        <ActionButton action={openFiles}>Open…</ActionButton>
        <Button onPress={() => void show("")} isDisabled={changed && file.name === null}>
          New
        </Button>
        <Button onPress={() => setAsking("drop")} isDisabled={!changed}>
          Drop changes…
        </Button>
        <Button onPress={() => setAsking("name")}>Save as…</Button>
        <Button look="primary" onPress={() => void saveAs(file.name)} isDisabled={!changed}>
          Save
        </Button>
      </header>
      {asking === "name" && (
        <SaveAs
          first={file.name ?? ""}
          onSave={(name) => void saveAs(name)}
          onCancel={() => setAsking(null)}
        />
      )}
      {asking === "drop" && (
        <DropChanges
          name={file.name ?? "the new file"}
          onDrop={() => void drop()}
          onClose={() => setAsking(null)}
        />
      )}
      <DebugBar changed={changed} />
      <div className="edit-body">
        <CodeEditor
          key={`${file.name} ${shown}`}
          name={file.name ?? "new.sbp"}
          text={file.text}
          running={running}
          onChange={change}
          onFindings={setFindings}
          onBreakpoints={hands.screen.mark}
          onSave={() => void saveAs(file.name)}
        />
        <Watched />
      </div>
      <FindingList findings={findings} />
    </div>
  );
}
