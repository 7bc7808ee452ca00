/** The drawing as the server has it, read again when it changed. */

import { useEffect, useState } from "react";
import { useHands, useSnapshot } from "../app/context";
import { getJson } from "../link/http";
import type { ShapeList, ToolPaths } from "../wire/messages";
import {
  type Loaded,
  loadedOf,
  type Machined,
  machinedOf,
  nothingLoaded,
  notMachined,
} from "./scene";

/** The shapes that are shown; `fresh` while no newer ones are being read. */
export function useShapes(): { loaded: Loaded; fresh: boolean } {
  const revision = useSnapshot("drawing")?.revision;
  const { screen } = useHands();
  const [loaded, setLoaded] = useState(nothingLoaded);
  const [unread, setUnread] = useState(-1);
  useEffect(() => {
    if (revision === undefined) return setLoaded(nothingLoaded);
    const gone = new AbortController();
    getJson<ShapeList>("/api/drawing/shapes", gone.signal)
      .then((list) => setLoaded(loadedOf(list)))
      .catch((error: Error) => {
        if (gone.signal.aborted) return;
        setUnread(revision);
        screen.tell(error.message);
      });
    return () => gone.abort();
  }, [revision, screen]);
  const fresh = revision === undefined || loaded.revision >= revision || unread === revision;
  return { loaded, fresh };
}

/** Fetches the tool paths of the drawing as it is machined, where they are wanted. */
export function useMachined(wanted: boolean): Machined {
  const revision = useSnapshot("drawing")?.revision;
  const setup = useSnapshot("setup");
  const [machined, setMachined] = useState(notMachined);
  // biome-ignore lint/correctness/useExhaustiveDependencies: settings change what is made of it
  useEffect(() => {
    if (!wanted || revision === undefined) return setMachined(notMachined);
    const gone = new AbortController();
    getJson<ToolPaths>("/api/drawing/paths", gone.signal)
      .then((paths) => setMachined(machinedOf(paths)))
      .catch(
        (error: Error) =>
          gone.signal.aborted || setMachined({ ...notMachined, notes: [error.message] }),
      );
    return () => gone.abort();
  }, [wanted, revision, setup]);
  return machined;
}
