import { useEffect, useState } from "react";
import { ask } from "../actions/ask";
import { openFiles } from "../actions/go";
import { useHands, useScreen, useSnapshot, worldOf } from "../app/context";
import { Watched } from "../debugger/Watched";
import { readFile, writeFile } from "../link/http";
import { useRunningLine } from "../operator/useRunningLine";
import { ActionButton } from "../ui/ActionButton";
import { Button } from "../ui/Button";
import type { Opened } from "../wire/messages";
import { CodeEditor } from "./CodeEditor";
import { type Check, checking } from "./check";
import { DebugBar } from "./DebugBar";
import { type EditedFile, edited, isChanged, newFile, opened, saved, written } from "./document";
import "./edit-screen.css";
import { FindingList } from "./FindingList";
import { SaveAs } from "./SaveAs";

/** What was found in the whole file when it was opened; nothing where the text is not that of the file. */
function savedFindings(open: Opened | null | undefined, { name }: EditedFile) {
  return open?.name === name && open?.preview.state === "ready" ? open.findings : null;
}

/** The editor of part files (FE), and the debugger in it (FG). */
export function EditScreen() {
  const hands = useHands();
  const open = useSnapshot("opened");
  const [file, setFile] = useState<EditedFile>(newFile);
  const [check, setCheck] = useState<Check>(checking);
  const [naming, setNaming] = useState(false);

  const name = open?.name;
  // biome-ignore lint/correctness/useExhaustiveDependencies: reads when another file is opened
  useEffect(() => {
    if (name === undefined || isChanged(file) || hands.screen.get().edits) return;
    readFile(name).then(
      (text) => setFile(opened(name, text)),
      (error: Error) => hands.screen.tell(error.message),
    );
  }, [name]);

  const asked = useScreen("edits");
  useEffect(() => {
    if (!asked) return;
    if (asked.name === "") return setFile(newFile);
    readFile(asked.name).then(
      (text) => setFile(opened(asked.name, text)),
      (error: Error) => hands.screen.tell(error.message),
    );
  }, [asked, hands]);

  const running = useRunningLine(file.name ?? undefined);
  const spot = useScreen("spot");
  // biome-ignore lint/correctness/useExhaustiveDependencies: reads another file only when it is asked for
  useEffect(() => {
    if (!spot || spot.file === file.name) return;
    if (isChanged(file)) {
      hands.screen.tell(`Save ${file.name ?? "the new file"} first: then ${spot.file} is shown.`);
      return hands.screen.lineShown();
    }
    readFile(spot.file).then(
      (text) => setFile(opened(spot.file, text)),
      (error: Error) => hands.screen.tell(error.message),
    );
  }, [spot, hands]);
  const marks = useScreen("breakpoints").filter((mark) => mark.file === file.name);

  const save = async (as: string | null) => {
    if (as === null) return setNaming(true);
    try {
      await writeFile(as, written(file));
      setFile((now) => saved(now, as));
      setNaming(false);
      // While a program waits for the editor, it stays the open file.
      if (asked === null) await ask(worldOf(hands), { do: "open", name: as });
    } catch (error) {
      hands.screen.tell(String(error));
    }
  };
  const kept = check.is === "unchecked" && !isChanged(file) ? savedFindings(open, file) : null;
  return (
    <div className="edit">
      <header className="edit-head">
        <h1>
          {file.name ?? "New file"}
          {isChanged(file) && <span className="edit-changed"> · not saved</span>}
        </h1>
        <ActionButton action={openFiles}>Open…</ActionButton>
        <Button onPress={() => setFile(newFile)} isDisabled={isChanged(file)}>
          New
        </Button>
        <Button onPress={() => setNaming(true)}>Save as…</Button>
        <Button look="primary" onPress={() => save(file.name)} isDisabled={!isChanged(file)}>
          Save
        </Button>
      </header>
      {naming && <SaveAs first={file.name ?? ""} onSave={save} onCancel={() => setNaming(false)} />}
      <DebugBar changed={isChanged(file)} file={file.name ?? ""} />
      <div className="edit-body">
        <CodeEditor
          key={file.name}
          name={file.name ?? "new.sbp"}
          text={file.text}
          running={running}
          onChange={(text) => setFile((now) => edited(now, text))}
          spot={spot !== null && spot.file === file.name ? spot.line : null}
          onSpotShown={hands.screen.lineShown}
          breakpoints={marks.map(({ line }) => line)}
          onCheck={setCheck}
          onBreakpoints={(lines) => hands.screen.mark(file.name ?? "", lines)}
          onSave={() => void save(file.name)}
        />
        <Watched />
      </div>
      <FindingList
        check={kept ? { is: "checked", findings: kept } : check}
        file={file.name ?? ""}
        onShow={(place) => hands.screen.showLine(place)}
      />
    </div>
  );
}
