/** Reads the machine's display settings (VD) that concern this page. */

import { useMemo } from "react";
import { type Mm, mm } from "../units/quantity";
import type { SettingArea } from "../wire/messages";
import { useSnapshot } from "./context";
import { useFetched } from "./useFetched";

export interface DisplaySettings {
  /** Comments of files are shown in the message screen (7). */
  readonly comments: boolean;
  /** The distance that the keypad moves, mm (8). */
  readonly fixedMm: Mm;
  /** Place and size of the message screen, pixels (12 to 15). */
  readonly message: readonly [number, number, number, number];
  /** Device that moves the tool at the keypad (9): 0 this page, 1 a pendant on the inputs, 2 another program. */
  readonly remote: number;
  /** A simplified picture shows how far the file is (17). */
  readonly progress: boolean;
  /** The material that is cut is shown (VP). */
  readonly simulate: boolean;
  /** Jogs are drawn (VP). */
  readonly jogs: boolean;
  /** EASY, else FULL (18). */
  readonly easy: boolean;
}

/** Fifteen twips are a pixel. */
export const twips = 15;

/** The values of a list as it is written in a configuration. */
const numbersIn = (text: string): number[] =>
  text
    .replace(/[[\]]/g, "")
    .split(",")
    .map((part) => Number(part));

export function readDisplay(areas: readonly SettingArea[]): DisplaySettings {
  const all = areas.flatMap(({ settings }) => settings);
  const value = (key: string) => all.find((entry) => entry.key === key)?.value ?? "";
  const [x = 0, y = 0, width = 8800, height = 4600] = numbersIn(value("display.message_twips"));
  return {
    comments: value("display.comments") === "true",
    fixedMm: mm(Number(value("display.keypad_fixed_mm")) || 2.54),
    message: [x / twips, y / twips, width / twips, height / twips],
    remote: Number(value("display.keypad_remote")) || 0,
    progress: value("display.progress") === "true",
    simulate: value("view.simulate") === "true",
    jogs: value("view.show_jogs") !== "false",
    easy: value("display.easy") !== "false",
  };
}

/** The display settings, read anew when settings change; nothing before they came. */
export function useDisplay(): DisplaySettings | null {
  const changes = useSnapshot("settings");
  const address = changes === undefined ? null : "/api/settings";
  const areas = useFetched<SettingArea[] | null>(address, null, changes);
  return useMemo(() => areas && readDisplay(areas), [areas]);
}
