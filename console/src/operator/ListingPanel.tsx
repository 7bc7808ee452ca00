import { useSnapshot } from "../app/context";
import { Panel } from "../ui/Panel";
import { Listing } from "./Listing";
import { useRunningLine } from "./useRunningLine";

/** The open file with the line that runs. */
export function ListingPanel() {
  const opened = useSnapshot("opened");
  const line = useRunningLine();
  return (
    <Panel
      title="Program"
      aside={<span className="listing-count">{opened ? `${opened.lines} lines` : ""}</span>}
    >
      <OpenFiles />
      {opened ? (
        <Listing name={opened.name} hash={opened.hash} lines={opened.lines} running={line} />
      ) : (
        <p className="tail-empty">No file is open.</p>
      )}
    </Panel>
  );
}

/** The files that run, the outermost first, each with its line. */
function OpenFiles() {
  const job = useSnapshot("job");
  if (!job || job.ended !== null || job.calls.length === 0) return null;
  return (
    <ol className="listing-calls" aria-label="Files that run">
      {job.calls.map(({ file, line }, n) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: a file can call itself
        <li key={n}>
          {file || "command line"} <b>line {line}</b>
        </li>
      ))}
    </ol>
  );
}
