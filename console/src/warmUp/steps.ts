/** Steps of a warm-up: percent of the spindle's greatest speed and minutes, as the settings keep them. */

export interface Step {
  readonly percent: string;
  readonly minutes: string;
}

/** Reads steps as they are kept: `25:2, 50:2`. */
export const stepsOf = (text: string): readonly Step[] =>
  text
    .split(",")
    .filter((step) => step.trim() !== "")
    .map((step) => {
      const [percent = "", minutes = ""] = step.split(":");
      return { percent: percent.trim(), minutes: minutes.trim() };
    });

export const textOf = (steps: readonly Step[]): string =>
  steps.map(({ percent, minutes }) => `${percent.trim()}:${minutes.trim()}`).join(", ");

/** The time of all steps, minutes; nothing where one of them is no number. */
export function allMinutes(steps: readonly Step[]): number | undefined {
  const minutes = steps.reduce((all, step) => all + Number(step.minutes.trim() || "x"), 0);
  return Number.isFinite(minutes) ? Math.round(minutes * 100) / 100 : undefined;
}

/** The step with another percent or time. */
export const changed = (
  steps: readonly Step[],
  at: number,
  change: Partial<Step>,
): readonly Step[] => steps.map((step, n) => (n === at ? { ...step, ...change } : step));

/** Whole hours since the newest run of a file ended; nothing where none ended. */
export function hoursSince(
  runs: readonly { readonly begun: number; readonly seconds: number }[],
  nowS: number,
): number | undefined {
  const ends = runs.map(({ begun, seconds }) => begun + seconds);
  if (ends.length === 0) return undefined;
  return Math.max(0, Math.floor((nowS - Math.max(...ends)) / 3600));
}
