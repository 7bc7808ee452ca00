/** The frame of a job: the tool goes round its bounds, at the height where it is. */

import { numberText } from "../app/units";
import { getJson } from "../link/http";
import { difference, type Mm } from "../units/quantity";
import type { PreviewInfo, Units } from "../wire/messages";
import { t } from "../words/words";
import type { Action, World } from "./action";
import { drive } from "./ask";
import { unlessReady } from "./machine";

/** Least height of the tool over the surface and the cuts, mm: the tool goes round at jog speed. */
const clearMm = 1;

/** The lines of OpenSBP that go round the cuts of a preview; nothing where it cuts nothing. */
export function frameLines(info: PreviewInfo, units: Units): string | undefined {
  if (!info.bounds) return undefined;
  const [low, high] = info.bounds;
  const at = (place: readonly [Mm, Mm, Mm], n: 0 | 1) =>
    numberText(difference(place[n], info.zero[n]), units, 4);
  const [x0, y0, x1, y1] = [at(low, 0), at(low, 1), at(high, 0), at(high, 1)];
  const corners = [`${x0},${y0}`, `${x1},${y0}`, `${x1},${y1}`, `${x0},${y1}`, `${x0},${y0}`];
  const round = corners.map((corner) => `J2,${corner}`);
  return [...(units.absolute ? [] : ["SA"]), ...round, ...(units.absolute ? [] : ["SR"])].join(
    "\n",
  );
}

/** The reason for which the tool may not go round at its height; nothing when it may. */
export function tooLow(z: Mm, info: PreviewInfo): string | undefined {
  const top = Math.max(0, (info.bounds?.[1][2] ?? 0) - info.zero[2]);
  return z >= top + clearMm
    ? undefined
    : t("Raise the tool above the work first: it goes round at this height.");
}

/** Shows where the open file cuts, before it does. */
export const frameJob: Action = {
  id: "job.frame",
  title: t("Frame the job: go round its bounds at this height"),
  section: "job",
  refused: (world) => {
    const opened = world.shown.snapshot?.opened;
    if (opened?.preview.state !== "ready" || opened.broken) return t("No file is open that cuts.");
    return unlessReady(world);
  },
  run: (world) => void frame(world),
};

async function frame(world: World): Promise<void> {
  const { snapshot } = world.shown;
  if (snapshot?.opened?.preview.state !== "ready") return;
  const { screen } = world;
  try {
    const key = encodeURIComponent(snapshot.opened.preview.key);
    const info = await getJson<PreviewInfo>(`/api/preview/${key}`);
    const line = frameLines(info, snapshot.units);
    if (line === undefined) return screen.tell(t("It cuts nothing."));
    const why = tooLow(snapshot.motion.at.working[2], info);
    if (why !== undefined) return screen.tell(why);
    await drive(world, { do: "command", line });
  } catch (error) {
    screen.tell((error as Error).message);
  }
}
