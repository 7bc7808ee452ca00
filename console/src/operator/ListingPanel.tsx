import { useShown, useSnapshot } from "../app/context";
import { Panel } from "../ui/Panel";
import { t } from "../words/words";
import { Listing } from "./Listing";
import { filesOfTool } from "./toolLine";
import { useRunningLine } from "./useRunningLine";

/** The open file with the line that runs. */
export function ListingPanel() {
  const opened = useSnapshot("opened");
  const line = useRunningLine(opened?.name);
  return (
    <Panel
      title="Program"
      className="listing-panel"
      aside={<span className="listing-count">{opened ? t("{0} lines", opened.lines) : ""}</span>}
    >
      <OpenFiles />
      {opened ? (
        <Listing name={opened.name} hash={opened.hash} lines={opened.lines} running={line} />
      ) : (
        <p className="tail-empty">{t("No file is open.")}</p>
      )}
    </Panel>
  );
}

/** The files that run, the outermost first, each with its line; that of the last is the tool's. */
function OpenFiles() {
  const snapshot = useShown((shown) => shown.snapshot);
  const files = snapshot ? filesOfTool(snapshot) : [];
  if (files.length === 0) return null;
  return (
    <ol className="listing-calls" aria-label={t("Files that run")}>
      {files.map(({ file, line }, n) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: a file can call itself
        <li key={n}>
          {file || t("command line")} {line > 0 && <b>{t("line {0}", line)}</b>}
        </li>
      ))}
    </ol>
  );
}
