/** Actions on the job that is open. */

import type { World } from "../actions/action";
import { ask } from "../actions/ask";
import { mayReplace } from "../actions/replace";
import { drawingWords } from "../app/drawingWords";
import type { JobChoice } from "../wire/messages";
import { t } from "../words/words";

/** Cuts the job otherwise; nothing while one runs. */
export async function choose(world: World, change: Partial<JobChoice>): Promise<boolean> {
  const snapshot = world.shown.snapshot;
  if (snapshot?.opened?.kind !== "job") return false;
  if (!["idle", "alarm"].includes(snapshot.machine.state)) {
    world.screen.tell(t("A job runs: its first path is chosen before it starts."));
    return false;
  }
  return ask(world, { do: "choose", choice: { ...snapshot.opened.choice, ...change } });
}

/** Begins with this path; with the first one as the file has it. */
export const chooseStart = (world: World, start: number | null): Promise<boolean> =>
  choose(world, { start });

/** Makes the tool path of a drawing and goes to it; nothing for the drawing on the sheet. */
export async function machine(world: World, drawing: string | null): Promise<void> {
  const { problem, notes } = await world.link.ask({ do: "machine", drawing, anew: false });
  for (const note of notes) world.screen.tell(drawingWords(note));
  if (!problem) return world.screen.go("/");
  if (problem.why === "changed") {
    return world.screen.open({ kind: "confirm", action: "job.anew" });
  }
  if (problem.why !== "replaces") return world.screen.tell(drawingWords(problem.text));
  const name = jobName(drawing ?? world.shown.snapshot?.drawing?.name ?? "drawing");
  if (!(await mayReplace(world, name))) return;
  const again = await world.link.ask({ do: "machine", drawing, anew: true });
  for (const note of again.notes) world.screen.tell(drawingWords(note));
  if (again.problem) world.screen.tell(drawingWords(again.problem.text));
  else world.screen.go("/");
}

/** The job of a drawing lies beside it. */
const jobName = (drawing: string): string => `${drawing.replace(/\.[^./]*$/, "")}.rsm`;
