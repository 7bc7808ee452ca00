import { useEffect, useState } from "react";
import { fileAddress, getBytes } from "../link/http";
import { indexLines, type LineIndex } from "./lineIndex";

/** The lines of a file of the part folder; read again when its hash changes. */
export function useLines(name: string, hash: string): LineIndex | null {
  const [lines, setLines] = useState<LineIndex | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the hash tells that the file is another
  useEffect(() => {
    const abort = new AbortController();
    setLines(null);
    getBytes(fileAddress(name), abort.signal)
      .then((bytes) => indexLines(new Uint8Array(bytes)))
      .then((index) => !abort.signal.aborted && setLines(index))
      .catch(() => undefined);
    return () => abort.abort();
  }, [name, hash]);
  return lines;
}
