import { useSnapshot } from "../app/context";
import { useFetched } from "../app/useFetched";
import type { FileInfo } from "../wire/messages";

const none: readonly FileInfo[] = [];

/** The files of a folder, or those in any folder that a word is looked for by; read anew when they change. */
export function useFiles(folder: string, word = ""): readonly FileInfo[] {
  const query = word === "" ? { folder } : { find: word };
  return useFetched(`/api/files?${new URLSearchParams(query)}`, none, useSnapshot("files"));
}
