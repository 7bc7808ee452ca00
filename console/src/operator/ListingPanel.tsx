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
      {opened ? (
        <Listing name={opened.name} hash={opened.hash} lines={opened.lines} running={line} />
      ) : (
        <p className="tail-empty">No file is open.</p>
      )}
    </Panel>
  );
}
