import { useEffect, useState } from "react";
import { useHands, useShown, useSnapshot } from "../app/context";
import { getJson } from "../link/http";

/** A list that the server keeps, read anew when files change and when a run begins or ends. */
export function useKept<T>(address: string): readonly T[] | null {
  const { screen } = useHands();
  const files = useSnapshot("files");
  const run = useShown(({ snapshot }) => `${snapshot?.job?.run} ${snapshot?.job?.ended}`);
  const [list, setList] = useState<readonly T[] | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: reads again when something happened
  useEffect(() => {
    const abort = new AbortController();
    getJson<readonly T[]>(address, abort.signal).then(
      setList,
      (error: Error) => abort.signal.aborted || screen.tell(error.message),
    );
    return () => abort.abort();
  }, [address, files, run, screen]);
  return list;
}
