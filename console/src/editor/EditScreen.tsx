import { useEffect, useState } from "react";
import { openFiles } from "../actions/go";
import { useHands, useScreen, useSnapshot } from "../app/context";
import { Watched } from "../debugger/Watched";
import { useRunningLine } from "../operator/useRunningLine";
import { ActionButton } from "../ui/ActionButton";
import { Button } from "../ui/Button";
import type { Opened } from "../wire/messages";
import { t } from "../words/words";
import { CodeEditor } from "./CodeEditor";
import { type Check, checking } from "./check";
import { DebugBar } from "./DebugBar";
import { DropChanges } from "./DropChanges";
import { type EditedFile, isChanged } from "./document";
import "./edit-screen.css";
import { FindingList } from "./FindingList";
import { NotSaved } from "./NotSaved";
import { SaveAs } from "./SaveAs";
import { useEdited } from "./useEdited";

/** Findings in the whole file from its opening; nothing where the text is not that of the file. */
function savedFindings(open: Opened | null | undefined, { name }: EditedFile) {
  return open?.name === name && open?.preview.state === "ready" ? open.findings : null;
}

/** The line that somebody wants to see in the file of the editor; another file is shown for it. */
function useSpot(name: string | null, show: (name: string) => Promise<void>): number | null {
  const spot = useScreen("spot");
  // biome-ignore lint/correctness/useExhaustiveDependencies: shows another file only when it is asked for
  useEffect(() => {
    if (spot && spot.file !== name) void show(spot.file);
  }, [spot]);
  return spot?.file === name ? (spot?.line ?? null) : null;
}

/** Reasons for which a new text cannot be begun, and none saved or dropped. */
const refusals = (changed: boolean, name: string | null) => ({
  begin: changed && name === null ? t("Save the new file first, or drop its changes.") : undefined,
  save: changed ? undefined : t("Nothing was changed."),
});

/** The editor of part files (FE), and the debugger in it (FG). */
export function EditScreen() {
  const hands = useHands();
  const open = useSnapshot("opened");
  const { file, shown, others, show, change, save, drop } = useEdited();
  const running = useRunningLine(file.name ?? undefined);
  const [check, setCheck] = useState<Check>(checking);
  const [asking, setAsking] = useState<"name" | "drop" | null>(null);
  const spot = useSpot(file.name, show);
  const marks = useScreen("breakpoints").filter((mark) => mark.file === file.name);
  const saveAs = async (as: string | null) => {
    if (as === null) setAsking("name");
    else if (await save(as)) setAsking(null);
  };
  const changed = isChanged(file);
  const isWhole = check.is === "checked" || check.is === "checking";
  const kept = isWhole || changed ? null : savedFindings(open, file);
  const refused = refusals(changed, file.name);
  return (
    <div className="edit">
      <header className="edit-head">
        <h1>
          {file.name ?? t("New file")}
          {changed && <span className="edit-changed"> {t("· not saved")}</span>}
        </h1>
        <NotSaved
          drafts={others}
          file={file.name ?? ""}
          onShow={({ name, page }) => void show(name, page)}
        />
        <ActionButton action={openFiles}>Open…</ActionButton>
        <Button onPress={() => void show("")} refused={refused.begin}>
          New
        </Button>
        <Button onPress={() => setAsking("drop")} refused={refused.save}>
          Drop changes…
        </Button>
        <Button onPress={() => setAsking("name")}>Save as…</Button>
        <Button look="primary" onPress={() => void saveAs(file.name)} refused={refused.save}>
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
          name={file.name ?? t("the new file")}
          onDrop={() => void drop()}
          onClose={() => setAsking(null)}
        />
      )}
      <DebugBar changed={changed} file={file.name ?? ""} />
      <div className="edit-body">
        <CodeEditor
          key={`${file.name} ${shown}`}
          name={file.name ?? "new.sbp"}
          text={file.text}
          running={running}
          onChange={change}
          spot={spot}
          onSpotShown={hands.screen.lineShown}
          breakpoints={marks.map(({ line }) => line)}
          onCheck={setCheck}
          onBreakpoints={(lines) => hands.screen.mark(file.name ?? "", lines)}
          onSave={() => void saveAs(file.name)}
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
