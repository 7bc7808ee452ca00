import { DigitizePanel } from "../digitize/DigitizePanel";
import { JobBar } from "../operator/JobBar";
import { LocationDisplay } from "../operator/LocationDisplay";
import { t } from "../words/words";
import { CutPanel } from "./CutPanel";
import { JobHead } from "./JobHead";
import { JobSheet } from "./JobSheet";
import { NoJob } from "./NoJob";
import { PathPanel } from "./PathPanel";
import { useJob, useStanding } from "./useJob";
import "../draw/drawing-sheet.css";
import "./job-screen.css";

/** The machine's side of a drawing: its tool paths, how they are cut, how far the job is. */
export function JobScreen() {
  const plan = useJob();
  const standing = useStanding(plan);
  return (
    <div className="job-screen">
      <h1 className="hidden-text">{t("Job")}</h1>
      <div className="job-page-left">
        <LocationDisplay />
        {plan && <CutPanel plan={plan} />}
      </div>
      <div className="job-page-middle">
        <JobHead />
        {plan ? <JobSheet plan={plan} standing={standing} /> : <NoJob />}
        <JobBar />
      </div>
      <div className="job-page-right">
        {plan && <PathPanel plan={plan} standing={standing} />}
        <DigitizePanel />
      </div>
    </div>
  );
}
