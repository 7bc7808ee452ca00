/** Notifications of the browser: somebody is needed, a run is done or has failed. */

import type { Snapshot } from "../wire/messages";
import { askedWords } from "../words/asked";
import { t } from "../words/words";

const key = "kerf.notify";

/** True if this browser shows them. */
export const notifies = (): boolean =>
  localStorage.getItem(key) === "yes" &&
  typeof Notification !== "undefined" &&
  Notification.permission === "granted";

/** Asks the person to allow them; tells whether that was done. */
export async function beginNotifying(): Promise<boolean> {
  if (typeof Notification === "undefined") return false;
  const allowed = (await Notification.requestPermission()) === "granted";
  localStorage.setItem(key, allowed ? "yes" : "no");
  return allowed;
}

export const endNotifying = (): void => localStorage.setItem(key, "no");

type Told = Pick<Snapshot, "job" | "asked">;

/** Tells in a sentence the change for which somebody is called; nothing where there is none. */
export function newsOf(before: Told, { job, asked }: Told): string | undefined {
  if (!job || job.command !== null || job.file === "") return undefined;
  if (asked && asked.number !== before.asked?.number)
    return t("{0} needs you: {1}", job.file, askedWords(asked).text);
  const over = before.job?.run === job.run && before.job.ended !== null;
  if (job.ended === null || over) return undefined;
  return job.ended === "ok" || job.ended === "ended"
    ? t("{0} is done", job.file)
    : t("{0} failed: {1}", job.file, job.ended);
}
