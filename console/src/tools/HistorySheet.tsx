import { useState } from "react";
import { useHands, useSnapshot } from "../app/context";
import { beginNotifying, endNotifying, notifies } from "../app/notify";
import { durationText } from "../app/units";
import { timeText } from "../operator/fileWords";
import { openToRun } from "../operator/openFile";
import { Button } from "../ui/Button";
import { Choice } from "../ui/Choice";
import { Sheet } from "../ui/Sheet";
import type { RunRecord } from "../wire/messages";
import { phrase, t } from "../words/words";
import { endText, partsMade } from "./runs";
import { useKept } from "./useKept";

/** Rows that are drawn. */
const most = 300;

/** The runs: file, time, duration, end and driver; and the number of parts that each file gave. */
export function HistorySheet({ onClose }: { onClose: () => void }) {
  const runs = useKept<RunRecord>("/api/history");
  return (
    <Sheet title="History of runs" shape="wide" onClose={onClose} foot={<NotifyChoice />}>
      {runs?.length === 0 && <p className="tail-empty">{t("No file has run yet.")}</p>}
      {runs && runs.length > 0 && (
        <>
          <Counters runs={runs} />
          <Runs runs={runs.slice(0, most)} />
        </>
      )}
    </Sheet>
  );
}

const choices = [
  { value: "no", words: "No notifications" },
  { value: "yes", words: "Notify" },
] as const;

/** Switches the notifications of this browser. */
function NotifyChoice() {
  const { screen } = useHands();
  const [on, setOn] = useState(notifies);
  const choose = async (value: string) => {
    if (value === "no") endNotifying();
    else if (!(await beginNotifying()))
      screen.tell(t("This browser does not allow notifications here: allow them in its settings."));
    setOn(notifies());
  };
  return (
    <div className="list-line">
      <span>{t("When somebody is needed, and when a run is done or fails:")}</span>
      <Choice
        label="Notifications of this browser"
        options={choices}
        value={on ? "yes" : "no"}
        onChange={(value) => void choose(value)}
      />
    </div>
  );
}

function Counters({ runs }: { runs: readonly RunRecord[] }) {
  return (
    <ul className="runs-made" aria-label={t("Parts made")}>
      {partsMade(runs)
        .slice(0, 12)
        .map(({ file, today, all }) => (
          <li key={file}>{phrase("{0} {1} today, {2} in all", <b>{file}</b>, today, all)}</li>
        ))}
    </ul>
  );
}

function Runs({ runs }: { runs: readonly RunRecord[] }) {
  const hands = useHands();
  const folder = useSnapshot("folder")?.name ?? "";
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what is longer than its box is scrolled by keys
    <div className="runs" tabIndex={0}>
      <table className="list-table" aria-label={t("Runs")}>
        <thead>
          <tr>
            {[t("When"), t("File"), t("End"), t("Time"), t("By")].map((title) => (
              <th key={title} scope="col">
                {title}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {runs.map((run) => (
            <tr key={`${run.begun} ${run.file} ${run.line}`}>
              <td>{timeText(run.begun)}</td>
              <td>
                <Button
                  size="small"
                  look="quiet"
                  onPress={() => void openToRun(hands, run.file, folder)}
                >
                  {run.file}
                </Button>
              </td>
              <td className={run.ended === "ok" || run.ended === null ? "" : "runs-bad"}>
                {endText(run)}
              </td>
              <td>{run.seconds > 0 ? durationText(run.seconds) : "–"}</td>
              <td>{run.by || t("this machine")}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}
