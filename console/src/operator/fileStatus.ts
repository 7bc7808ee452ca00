/** How the open file stands, and how far what runs is: what is told beside its name. */

import type { Spot } from "../app/screen";
import { durationText } from "../app/units";
import type { Shown } from "../link/shown";
import type { Call, Finding, Job, LastRun, Opened, Snapshot, State } from "../wire/messages";
import { toolLine } from "./toolLine";

export interface FileStatus {
  readonly words: string;
  readonly look: "plain" | "warning" | "error";
  /** Where that is mended. */
  readonly place?: Spot | undefined;
}

type Told = Pick<Snapshot, "opened" | "job" | "interrupted" | "machine" | "motion" | "asked">;

/** Whether a job is under way. */
export const isUnderWay = (job: Job | null): job is Job & { ended: null } =>
  job !== null && job.ended === null;

/** Whether what runs, or ran last, is the file that is open. */
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
  place.file === opened.name ? `line ${place.line}` : `line ${place.line} of ${place.file}`;

/** `3 mistakes: see line 12`. */
export function mistakesText(opened: Opened): string {
  const errors = errorsOf(opened);
  const count = errors.length === 1 ? "1 mistake" : `${errors.length} mistakes`;
  const place = placeOf(errors[0], opened);
  return place ? `${count}: see ${lineText(place, opened)}` : count;
}

const plain = (words: string): FileStatus => ({ words, look: "plain" });
const warning = (words: string, place?: Spot): FileStatus => ({ words, look: "warning", place });

/** How a run of the open file that is under way stands. */
const running: Partial<Record<State, string>> = {
  held: "held",
  asking: "waits for an answer",
  stopped: "stopped, waits",
};

/** How a run ended that belongs to no open file. */
const outcomes: Record<string, string> = {
  ok: "finished",
  ended: "ended by itself",
  limit: "ended at a limit",
};

/** How what runs stands, else the file that is open; where none is, what ran last. */
export function fileStatus(told: Told, now = new Date()): FileStatus {
  const { opened, job, machine, interrupted } = told;
  if (isUnderWay(job)) {
    return plain(`${running[machine.state] ?? "running"}${toolText(told)}`);
  }
  if (!opened) return plain(job?.ended ? (outcomes[job.ended] ?? job.ended) : "");
  if (opened.kind === "drawing") return plain("no tool path yet");
  if (opened.preview.state === "working") return plain("being checked");
  if (opened.broken) return broken(opened);
  const same = interrupted?.hash === null || interrupted?.hash === opened.content;
  if (interrupted?.file === opened.name && same) {
    return warning(behind(interrupted.line, opened), lineOf(interrupted.line, opened));
  }
  if (opened.ran) return ranStatus(opened.ran, opened, now);
  const place = placeOf(errorsOf(opened)[0], opened);
  return place
    ? warning(`its preview ends at ${lineText(place, opened)}`, place)
    : plain("ready, never run");
}

/** The place of the tool in words: `, line 14`, `, path 3`; nothing where no line tells it. */
function toolText(told: Told): string {
  const { opened, job } = told;
  const tool = toolLine(told);
  if (!tool || tool.line === 0 || tool.file === "") return "";
  if (!opened || !isOpenFile(told)) return `, line ${tool.line}`;
  const own = tool.file === opened.name || tool.file === job?.file;
  return `, ${unitOf(opened)} ${tool.line}${own ? "" : ` of ${tool.file}`}`;
}

/** A line of the open file that the editor can show: the paths of a job are no lines. */
const lineOf = (line: number, { kind, name }: Opened): Spot | undefined =>
  line > 0 && kind === "program" ? { file: name, line } : undefined;

/** The place that a message is about. */
export const placeOfMessage = (place: Call | null): Spot | undefined =>
  place && place.file !== "" ? { file: place.file, line: place.line } : undefined;

function broken(opened: Opened): FileStatus {
  const [first] = errorsOf(opened);
  const words = first ? mistakesText(opened) : "it cannot run";
  return { words, look: "error", place: placeOf(first, opened) };
}

const unitOf = ({ kind }: Opened): string => (kind === "job" ? "path" : "line");

const behind = (line: number, opened: Opened): string =>
  line > 0 ? `interrupted behind ${unitOf(opened)} ${line}` : "interrupted before its first move";

function ranStatus({ ended, at, line }: LastRun, opened: Opened, now: Date): FileStatus {
  const when = timeText(new Date(at * 1000), now);
  const behind = line > 0 ? ` behind ${unitOf(opened)} ${line}` : "";
  const place = lineOf(line, opened);
  switch (ended) {
    case "ok":
      return plain(`finished at ${when}`);
    case "ended":
      return plain(`ended by itself${behind} at ${when}`);
    case "limit":
      return warning(`ended at a limit${behind} at ${when}`, place);
    default:
      return warning(`${ended}${behind} at ${when}`, place);
  }
}

/** `14:03`, with the day where it is another. */
function timeText(then: Date, now: Date): string {
  const time = then.toLocaleTimeString([], { hour: "2-digit", minute: "2-digit", hour12: false });
  const today = then.toDateString() === now.toDateString();
  return today ? time : `${time}, ${then.toLocaleDateString()}`;
}

export interface RunProgress {
  /** What runs, or what is open. */
  readonly name: string;
  /** How far it is, 0 … 1; nothing where no plan says. */
  readonly part: number | undefined;
  /** What the seconds are. */
  readonly words: "left" | "planned";
  /** Nothing where no plan says. */
  readonly seconds: number | undefined;
  /** The time of the run under way, or of the last one of this file: `so far 0:14`, `took 1:15`. */
  readonly spent: string | undefined;
}

/** How far what runs is; else the file that is open, as far as it was made last. */
export function progressOf(told: Told): RunProgress {
  const { opened, job, motion } = told;
  const ran = job && (job.command ?? job.file);
  const name = opened?.name ?? ran ?? "No file is open";
  if (isUnderWay(job)) {
    const known = job.seconds > 0;
    return {
      name: isOpenFile(told) ? name : (ran ?? name),
      part: known ? motion.progress : undefined,
      words: "left",
      seconds: known ? motion.remaining : undefined,
      spent: `so far ${durationText(motion.elapsed)}`,
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
    spent: opened?.ran?.seconds ? `took ${durationText(opened.ran.seconds)}` : undefined,
  };
}
