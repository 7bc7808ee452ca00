import { useHands, useShown, useSnapshot } from "../app/context";
import { Panel } from "../ui/Panel";
import type { Opened } from "../wire/messages";
import { Listing } from "./Listing";
import { filesOfTool, toolLine } from "./toolLine";
import { useRunningLine } from "./useRunningLine";

/** The open file with the line that runs. */
export function ListingPanel() {
  const opened = useSnapshot("opened");
  const line = useRunningLine(opened?.name);
  return (
    <Panel
      title="Program"
      aside={<span className="listing-count">{opened ? countOf(opened) : ""}</span>}
    >
      <OpenFiles />
      {opened && opened.kind !== "program" ? (
        <NoLines kind={opened.kind} />
      ) : opened ? (
        <Listing name={opened.name} hash={opened.hash} lines={opened.lines} running={line} />
      ) : (
        <p className="tail-empty">No file is open.</p>
      )}
    </Panel>
  );
}

const countOf = ({ kind, lines }: Opened): string =>
  kind === "job" ? `${lines} paths` : kind === "drawing" ? "" : `${lines} lines`;

/** A job has paths where a program has lines; they are on its own screen. */
function NoLines({ kind }: { kind: "job" | "drawing" }) {
  const { screen } = useHands();
  const words =
    kind === "job"
      ? "A job: the tool path of a drawing. Its paths are on the screen of jobs."
      : "A drawing, which has no tool path yet.";
  return (
    <p className="tail-empty">
      {words}{" "}
      <button type="button" className="listing-link" onClick={() => screen.go("/job")}>
        Go to the job
      </button>
    </p>
  );
}

/** The files that run, the outermost first; the last one with the line of the tool. */
function OpenFiles() {
  const snapshot = useShown((shown) => shown.snapshot);
  const tool = snapshot && toolLine(snapshot);
  if (!tool) return null;
  const files = filesOfTool(snapshot);
  return (
    <ol className="listing-calls" aria-label="Files that run">
      {files.map((file, n) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: a file can call itself
        <li key={n}>
          {file || "command line"} {n === files.length - 1 && <b>line {tool.line}</b>}
        </li>
      ))}
    </ol>
  );
}
