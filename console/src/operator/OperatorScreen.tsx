import { lazy, Suspense } from "react";
import { useScreen, useSnapshot } from "../app/context";
import { ToolPathPanel } from "../view/ToolPathPanel";
import { t } from "../words/words";
import { Aside } from "./Aside";
import { EasyButtons } from "./EasyButtons";
import { FullBar } from "./FullBar";
import { JobBar } from "./JobBar";
import { Lamps } from "./Lamps";
import { ListingPanel } from "./ListingPanel";
import { LocationDisplay } from "./LocationDisplay";
import { ProgressPicture } from "./ProgressPicture";
import { StatusPanel } from "./StatusPanel";
import { WordsPanel } from "./WordsPanel";
import "./operator-screen.css";

/** Jobs come with what draws them: fetched when one is open. */
const JobColumns = lazy(async () => ({
  default: (await import("../job/JobColumns")).JobColumns,
}));

/** Everything needed while a machine runs, on one screen without scrolling. */
export function OperatorScreen() {
  const face = useScreen("face");
  const kind = useSnapshot("opened")?.kind ?? "program";
  // Started for files only: no command keys.
  const filesOnly = useSnapshot("start")?.display === 9;
  return (
    <div className="operator">
      <h1 className="hidden-text">{t("Operate")}</h1>
      <div className="operator-left">
        <LocationDisplay />
        <StatusPanel />
        <Lamps />
        <ProgressPicture />
      </div>
      {kind === "program" ? (
        <ProgramColumns />
      ) : (
        <Suspense fallback={<ProgramColumns />}>
          <JobColumns />
        </Suspense>
      )}
      {!filesOnly && (
        <div className="operator-foot">{face === "easy" ? <EasyButtons /> : <FullBar />}</div>
      )}
    </div>
  );
}

/** The picture and the lines of a program. */
function ProgramColumns() {
  return (
    <>
      <div className="operator-middle">
        <ToolPathPanel />
        <JobBar />
      </div>
      <div className="operator-right">
        <Aside>
          <ListingPanel />
        </Aside>
        <WordsPanel />
      </div>
    </>
  );
}
