/** The drawing as the server has it, read again when it changed. */

import { useEffect, useState } from "react";
import { useHands, useSnapshot } from "../app/context";
import { getJson } from "../link/http";
import type { ShapeList } from "../wire/messages";
import { type Shape, shapeOf } from "./geometry/shape";
import { type Loaded, loadedOf, nothingLoaded } from "./scene";

export function useShapes(): Loaded {
  const revision = useSnapshot("drawing")?.revision;
  const { screen } = useHands();
  const [loaded, setLoaded] = useState(nothingLoaded);
  useEffect(() => {
    if (revision === undefined) return setLoaded(nothingLoaded);
    const gone = new AbortController();
    getJson<ShapeList>("/api/drawing/shapes", gone.signal)
      .then((list) => setLoaded(loadedOf(list)))
      .catch((error: Error) => gone.signal.aborted || screen.tell(error.message));
    return () => gone.abort();
  }, [revision, screen]);
  return loaded;
}

/** The tool paths that the drawing would give, and what was noticed on the way. */
export interface Paths {
  readonly shapes: readonly Shape[];
  readonly notes: readonly string[];
}

const noPaths: Paths = { shapes: [], notes: [] };

export function useToolPaths(wanted: boolean): Paths {
  const revision = useSnapshot("drawing")?.revision;
  const [paths, setPaths] = useState(noPaths);
  useEffect(() => {
    if (!wanted || revision === undefined) return setPaths(noPaths);
    const gone = new AbortController();
    getJson<ShapeList>("/api/drawing/paths", gone.signal)
      .then(({ shapes, notes }) => setPaths({ shapes: shapes.map(shapeOf), notes }))
      .catch(
        (error: Error) => gone.signal.aborted || setPaths({ shapes: [], notes: [error.message] }),
      );
    return () => gone.abort();
  }, [wanted, revision]);
  return paths;
}
