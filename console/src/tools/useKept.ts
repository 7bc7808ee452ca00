import { useShown, useSnapshot } from "../app/context";
import { useFetched } from "../app/useFetched";

/** A list that the server keeps, read anew when files change and when a run begins or ends. */
export function useKept<T>(address: string): readonly T[] | null {
  const files = useSnapshot("files");
  const run = useShown(({ snapshot }) => `${snapshot?.job?.run} ${snapshot?.job?.ended}`);
  return useFetched<readonly T[] | null>(address, null, `${files} ${run}`);
}
