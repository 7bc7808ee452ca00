/** The one line that every place of the page shows: that of the move the tool makes. */

import type { Snapshot } from "../wire/messages";

export interface ToolLine {
  /** As the part folder has it; empty for lines that somebody typed. */
  readonly file: string;
  /** 0 where no line stands for what is made. */
  readonly line: number;
}

type Told = Pick<Snapshot, "job" | "asked" | "motion">;

/**
 * Line of the program at which the tool is: the question it waits with, else the move that it makes or made
 * last. Before the first move the line that is read. Nothing while no program runs.
 */
export function toolLine({ job, asked, motion }: Told): ToolLine | null {
  if (!job || job.ended !== null) return null;
  if (asked && asked.line > 0) return { file: asked.file, line: asked.line };
  if (motion.line > 0 && job.toolFile !== "") return { file: job.toolFile, line: motion.line };
  return job.calls.at(-1) ?? null;
}

/**
 * The files that are open round the tool, the outermost first, each with the line that called the next; the last has
 * that of the tool. A file that is read further already has no line.
 */
export function filesOfTool(told: Told): ToolLine[] {
  const tool = toolLine(told);
  if (!tool) return [];
  const calls = told.job?.calls ?? [];
  const at = calls.map(({ file }) => file).lastIndexOf(tool.file);
  if (at >= 0) return [...calls.slice(0, at), tool];
  return [...calls.slice(0, 1).map(({ file }) => ({ file, line: 0 })), tool];
}
