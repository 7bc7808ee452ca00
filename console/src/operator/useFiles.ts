import { useEffect, useState } from "react";
import { useHands, useSnapshot } from "../app/context";
import { getJson } from "../link/http";
import type { FileInfo } from "../wire/messages";

/** The files of a folder, read anew when they change. */
export function useFiles(folder: string): readonly FileInfo[] {
  const changes = useSnapshot("files");
  const { screen } = useHands();
  const [files, setFiles] = useState<readonly FileInfo[]>([]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: reads again when files changed
  useEffect(() => {
    const address = `/api/files?folder=${encodeURIComponent(folder)}`;
    getJson<FileInfo[]>(address).then(setFiles, (error: Error) => screen.tell(error.message));
  }, [changes, folder, screen]);
  return files;
}
