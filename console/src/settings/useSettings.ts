import { useEffect, useState } from "react";
import { useHands, useSnapshot } from "../app/context";
import { getJson } from "../link/http";
import type { SettingArea } from "../wire/messages";

/** The settings, read anew when one of them changed. */
export function useSettings(): readonly SettingArea[] {
  const changes = useSnapshot("settings");
  const { screen } = useHands();
  const [areas, setAreas] = useState<readonly SettingArea[]>([]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: read anew when settings changed
  useEffect(() => {
    getJson<SettingArea[]>("/api/settings").then(setAreas, (error: Error) =>
      screen.tell(error.message),
    );
  }, [changes, screen]);
  return areas;
}
