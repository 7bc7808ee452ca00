import { useEffect, useState } from "react";
import { useHands, useSnapshot } from "../app/context";
import { getJson } from "../link/http";
import type { FileInfo } from "../wire/messages";

/** The files of a folder, or those in any folder that a word is looked for by; read anew when they change. */
export function useFiles(folder: string, word = ""): readonly FileInfo[] {
  const changes = useSnapshot("files");
  const { screen } = useHands();
  const [files, setFiles] = useState<readonly FileInfo[]>([]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: reads again when files changed
  useEffect(() => {
    const query = word === "" ? { folder } : { find: word };
    const abort = new AbortController();
    getJson<FileInfo[]>(`/api/files?${new URLSearchParams(query)}`, abort.signal).then(
      setFiles,
      (error: Error) => abort.signal.aborted || screen.tell(error.message),
    );
    return () => abort.abort();
  }, [changes, folder, word, screen]);
  return files;
}
