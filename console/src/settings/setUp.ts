/** `true` once somebody was led through the settings of this machine, or did not want to be. The server keeps it. */

import { getJson, putText } from "../link/http";
import type { NamedValue, SettingArea } from "../wire/messages";

const key = "uMachineSetUp";

/** Tells whether every setting is as it comes. */
export const isFresh = (areas: readonly SettingArea[]): boolean =>
  areas.every(({ settings }) => settings.every((entry) => entry.value === entry.default));

/** Tells whether nobody has set anything, and nobody was asked. */
export async function isNewMachine(): Promise<boolean> {
  const values = await getJson<NamedValue[]>("/api/registry");
  if (values.some(({ name }) => name === key)) return false;
  return isFresh(await getJson<SettingArea[]>("/api/settings"));
}

/** Nobody is asked again. */
export const keepSetUp = (): Promise<void> => putText(`/api/registry/${key}`, "done");
