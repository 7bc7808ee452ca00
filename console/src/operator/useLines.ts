import { useEffect, useState } from "react";
import { fileAddress } from "../link/http";
import type { LineIndex } from "./lineIndex";

/** The lines of a file of the part folder; read again when its hash changes. */
export function useLines(name: string, hash: string): LineIndex | null {
  const [lines, setLines] = useState<LineIndex | null>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: the hash tells that the file is another
  useEffect(() => {
    setLines(null);
    const worker = new Worker(new URL("./linesWorker.ts", import.meta.url), { type: "module" });
    worker.addEventListener("message", ({ data }: MessageEvent<LineIndex>) => {
      setLines(data);
      worker.terminate();
    });
    worker.postMessage(fileAddress(name));
    return () => worker.terminate();
  }, [name, hash]);
  return lines;
}
