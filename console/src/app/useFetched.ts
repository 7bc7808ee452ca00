import { useEffect, useState } from "react";
import { getJson } from "../link/http";
import { useHands } from "./context";

/**
 * The newest JSON answer of an address, `first` before it came; asked anew when `again` is another value. An answer to an
 * older question never takes the place of a newer one. Nothing is asked of `null`.
 */
export function useFetched<T>(address: string | null, first: T, again: unknown = null): T {
  const { screen } = useHands();
  const [answer, setAnswer] = useState(first);
  // biome-ignore lint/correctness/useExhaustiveDependencies: asks anew when what the answer hangs on changed
  useEffect(() => {
    if (address === null) return;
    const gone = new AbortController();
    getJson<T>(address, gone.signal).then(
      (found) => gone.signal.aborted || setAnswer(found),
      (error: Error) => gone.signal.aborted || screen.tell(error.message),
    );
    return () => gone.abort();
  }, [address, again, screen]);
  return answer;
}
