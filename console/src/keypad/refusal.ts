/** Tells why the tool cannot be moved by hand. */

import type { Shown } from "../link/shown";
import { t } from "../words/words";

export const busy = t("The machine is busy.");
export const filesOnly = t("Kerf was started for files only: there is no keypad.");

/** The keypad works connected, armed and not in preview. */
export function refusal({ status, snapshot, who }: Shown): string | undefined {
  if (status !== "open" || !snapshot) return t("There is no link to the machine.");
  const { state, armed, mode } = snapshot.machine;
  if (snapshot.start?.display === 9) return filesOnly;
  if (mode === "preview") return t("Nothing moves in preview: switch to move mode (SM).");
  const { lease } = snapshot;
  if (lease && lease.client !== who?.client) return t("Somebody else drives: take control first.");
  if (!armed) return t("Arm the machine first.");
  const kind = snapshot.asked?.kind ?? "";
  const inFile =
    (state === "asking" && ["keypad", "paused", "pause", "msgbox"].includes(kind)) ||
    (state === "stopped" && ["hold", "paused"].includes(kind));
  if (state === "idle" || state === "jogging" || inFile) return undefined;
  return busy;
}
