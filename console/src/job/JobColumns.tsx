import { useSnapshot } from "../app/context";
import { Aside } from "../operator/Aside";
import { JobBar } from "../operator/JobBar";
import { WordsPanel } from "../operator/WordsPanel";
import { ToolPathPanel } from "../view/ToolPathPanel";
import { CutPanel } from "./CutPanel";
import { JobHead } from "./JobHead";
import { JobSheet } from "./JobSheet";
import { NoJob } from "./NoJob";
import { PathPanel } from "./PathPanel";
import { useJob, useStanding } from "./useJob";
import "../draw/drawing-sheet.css";
import "./job-screen.css";

/**
 * The operator's screen of a job, or of a drawing that is to become one: its paths to choose from where a program has its
 * picture, and the picture of the tool's path while it runs.
 */
export function JobColumns() {
  const plan = useJob();
  const standing = useStanding(plan);
  const runs = useSnapshot("machine")?.state === "running";
  return (
    <>
      <div className="operator-middle">
        {runs ? (
          <ToolPathPanel />
        ) : (
          <div className="job-place">
            <JobHead />
            {plan ? <JobSheet plan={plan} standing={standing} /> : <NoJob />}
          </div>
        )}
        <JobBar />
      </div>
      <div className="operator-right">
        <Aside>
          <div className="job-values">
            {plan && <PathPanel plan={plan} standing={standing} />}
            {plan && <CutPanel plan={plan} />}
          </div>
        </Aside>
        <WordsPanel />
      </div>
    </>
  );
}
