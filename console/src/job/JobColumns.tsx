import { JobBar } from "../operator/JobBar";
import { WordsPanel } from "../operator/WordsPanel";
import { CutPanel } from "./CutPanel";
import { JobHead } from "./JobHead";
import { JobSheet } from "./JobSheet";
import { NoJob } from "./NoJob";
import { PathPanel } from "./PathPanel";
import { useJob, useStanding } from "./useJob";
import "../draw/drawing-sheet.css";
import "./job-screen.css";

/** The operator's screen of a job, or of a drawing that is to become one: its paths where a program has its own. */
export function JobColumns() {
  const plan = useJob();
  const standing = useStanding(plan);
  return (
    <>
      <div className="operator-middle">
        <div className="job-place">
          <JobHead />
          {plan ? <JobSheet plan={plan} standing={standing} /> : <NoJob />}
        </div>
        <JobBar />
      </div>
      <div className="operator-right">
        <div className="job-values">
          {plan && <PathPanel plan={plan} standing={standing} />}
          {plan && <CutPanel plan={plan} />}
        </div>
        <WordsPanel />
      </div>
    </>
  );
}
