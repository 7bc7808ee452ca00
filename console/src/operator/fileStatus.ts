/** Status of the open file and progress of the run, as they stand beside its name. */

import { endWord } from "../app/endWords";
import type { Spot } from "../app/screen";
import { durationText } from "../app/units";
import type { Shown } from "../link/shown";
import type { Seconds } from "../units/quantity";
import type { Call, CurrentRun, Finding, LastRun, Opened, Snapshot, State } from "../wire/messages";
import { language, t } from "../words/words";
import { toolLine } from "./toolLine";

export interface FileStatus {
  readonly words: string;
  readonly look: "plain" | "warning" | "error";
  /** Place at which that is mended. */
  readonly place?: Spot | undefined;
}

type Told = Pick<Snapshot, "opened" | "job" | "interrupted" | "machine" | "motion" | "asked">;

/** Tells whether a job is under way. */
export const isUnderWay = (job: CurrentRun | null): job is CurrentRun & { ended: null } =>
  job !== null && job.ended === null;

/** Tells whether the run under way, or the last one, is of the open file. */
const isOpenFile = ({ job, opened }: Told): boolean =>
  job !== null && job.hash !== null && job.hash === opened?.hash;

/** Moves of the open file that were made in its run; of what else runs none belong to it. */
export const movesMade = ({ snapshot }: Shown): number =>
  snapshot && isOpenFile(snapshot) ? snapshot.motion.made : 0;

export const errorsOf = ({ findings }: Opened): Finding[] =>
  findings.filter(({ level }) => level === "error");

/** The place of a finding in the part folder; nothing where it has none. */
export function placeOf(finding: Finding | undefined, opened: Opened): Spot | undefined {
  if (!finding || finding.line === 0) return undefined;
  return { file: finding.file || opened.name, line: finding.line };
}

const lineText = (place: Spot, opened: Opened): string =>
  place.file === opened.name
    ? t("line {0}", place.line)
    : t("line {0} of {1}", place.line, place.file);

/** `3 mistakes: see line 12`. */
export function mistakesText(opened: Opened): string {
  const errors = errorsOf(opened);
  const count = errors.length === 1 ? t("1 mistake") : t("{0} mistakes", errors.length);
  const place = placeOf(errors[0], opened);
  return place ? t("{0}: see {1}", count, lineText(place, opened)) : count;
}

const plain = (words: string): FileStatus => ({ words, look: "plain" });
const warning = (words: string, place?: Spot): FileStatus => ({ words, look: "warning", place });

/** Words for the state of a run of the open file that is under way. */
const running: Partial<Record<State, string>> = {
  held: t("held"),
  asking: t("waits for an answer"),
  stopped: t("stopped, waits"),
};

const runsText = ({ fromCard }: CurrentRun): string =>
  fromCard ? t("runs from the controller's card") : t("running");

/** Words for the end of a run that belongs to no open file. */
const outcomes: Record<string, string> = {
  ok: t("finished"),
  ended: t("ended by itself"),
  limit: t("ended at a limit"),
};

/** Status of the run under way, else of the open file; where none is open, of the last run. */
export function fileStatus(told: Told, now = new Date()): FileStatus {
  const { opened, job, machine, interrupted } = told;
  if (isUnderWay(job)) {
    return plain(`${running[machine.state] ?? runsText(job)}${toolText(told)}`);
  }
  if (!opened) return plain(job?.ended ? (outcomes[job.ended] ?? job.ended) : "");
  if (opened.kind === "drawing") return plain(t("no tool path yet"));
  if (opened.preview.state === "working") return plain(t("being checked"));
  if (opened.broken) return broken(opened);
  const same = interrupted?.hash === null || interrupted?.hash === opened.content;
  if (interrupted?.file === opened.name && same) {
    return warning(behind(interrupted.line, opened), lineOf(interrupted.line, opened));
  }
  if (opened.ran) return ranStatus(opened.ran, opened, now);
  const place = placeOf(errorsOf(opened)[0], opened);
  return place
    ? warning(t("its preview ends at {0}", lineText(place, opened)), place)
    : plain(t("ready, never run"));
}

/** The place of the tool in words: `, line 14`, `, path 3`; nothing where no line tells it. */
function toolText(told: Told): string {
  const { opened, job } = told;
  const tool = toolLine(told);
  if (!tool || tool.line === 0 || tool.file === "") return "";
  if (!opened || !isOpenFile(told)) return t(", line {0}", tool.line);
  const own = tool.file === opened.name || tool.file === job?.file;
  return `, ${unitOf(opened)} ${tool.line}${own ? "" : t(" of {0}", tool.file)}`;
}

/** A line of the open file that the editor can show: the paths of a job are no lines. */
const lineOf = (line: number, { kind, name }: Opened): Spot | undefined =>
  line > 0 && kind === "program" ? { file: name, line } : undefined;

/** The place that a message is about. */
export const placeOfMessage = (place: Call | null): Spot | undefined =>
  place && place.file !== "" ? { file: place.file, line: place.line } : undefined;

function broken(opened: Opened): FileStatus {
  const [first] = errorsOf(opened);
  const words = first ? mistakesText(opened) : t("it cannot run");
  return { words, look: "error", place: placeOf(first, opened) };
}

const unitOf = ({ kind }: Opened): string => (kind === "job" ? t("path") : t("line"));

const behind = (line: number, opened: Opened): string =>
  line > 0
    ? t("interrupted behind {0} {1}", unitOf(opened), line)
    : t("interrupted before its first move");

function ranStatus({ ended, at, line }: LastRun, opened: Opened, now: Date): FileStatus {
  const when = timeText(new Date(at * 1000), now);
  const behind = line > 0 ? t(" behind {0} {1}", unitOf(opened), line) : "";
  const place = lineOf(line, opened);
  switch (ended) {
    case "ok":
      return plain(t("finished at {0}", when));
    case "ended":
      return plain(t("ended by itself{0} at {1}", behind, when));
    case "limit":
      return warning(t("ended at a limit{0} at {1}", behind, when), place);
    default:
      return warning(t("{0}{1} at {2}", endWord(ended), behind, when), place);
  }
}

/** `14:03`, with the day where it is another. */
function timeText(then: Date, now: Date): string {
  const time = then.toLocaleTimeString(language, {
    hour: "2-digit",
    minute: "2-digit",
    hour12: false,
  });
  const today = then.toDateString() === now.toDateString();
  return today ? time : `${time}, ${then.toLocaleDateString(language)}`;
}

export interface RunProgress {
  /** Name of the file that runs, or that is open. */
  readonly name: string;
  /** Progress, 0 … 1; nothing where no plan says. */
  readonly part: number | undefined;
  /** Meaning of the seconds. */
  readonly words: "left" | "planned";
  /** Nothing where no plan says. */
  readonly seconds: Seconds | undefined;
  /** The time of the run under way, or of the last one of this file: `so far 0:14`, `took 1:15`. */
  readonly spent: string | undefined;
}

/** Progress of the run under way; else of the open file, as far as it was made last. */
export function progressOf(told: Told): RunProgress {
  const { opened, job, motion } = told;
  const ran = job && (job.command ?? job.file);
  const name = opened?.name ?? ran ?? t("No file is open");
  if (isUnderWay(job)) {
    const known = job.seconds > 0;
    return {
      name: isOpenFile(told) ? name : (ran ?? name),
      part: known || job.fromCard ? motion.progress : undefined,
      words: "left",
      seconds: known ? motion.remaining : undefined,
      spent: t("so far {0}", durationText(motion.elapsed)),
    };
  }
  return atRest(told, name);
}

/** The share of the open file that was made last. */
function atRest(told: Told, name: string): RunProgress {
  const { opened, motion } = told;
  // A preview that ended at an error is no plan of the whole file.
  const halts = opened ? errorsOf(opened).length > 0 : false;
  const ready = opened?.preview.state === "ready" && !halts;
  const made = halts ? undefined : motion.progress;
  return {
    name,
    part: isOpenFile(told) ? made : 0,
    words: "planned",
    seconds: ready ? opened.seconds : undefined,
    spent: opened?.ran?.seconds ? t("took {0}", durationText(opened.ran.seconds)) : undefined,
  };
}
