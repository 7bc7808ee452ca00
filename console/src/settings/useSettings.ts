import { useSnapshot } from "../app/context";
import { useFetched } from "../app/useFetched";
import type { SettingArea } from "../wire/messages";

const none: readonly SettingArea[] = [];

/** The settings, read anew when one of them changed. */
export const useSettings = (): readonly SettingArea[] =>
  useFetched("/api/settings", none, useSnapshot("settings"));
