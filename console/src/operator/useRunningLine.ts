import { useCallback } from "react";
import { useShown } from "../app/context";
import type { Shown } from "../link/shown";
import { toolLine } from "./toolLine";

/** The line of a file at which the tool is; 0 when it is in none of this file. */
export function useRunningLine(file: string | undefined): number {
  return useShown(useCallback((shown: Shown) => lineIn(shown, file), [file]));
}

function lineIn({ snapshot }: Shown, file: string | undefined): number {
  const tool = snapshot && toolLine(snapshot);
  return tool && tool.file === file ? tool.line : 0;
}
