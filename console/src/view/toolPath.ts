/**
 * A tool path as it arrives: coarse, so that there is a picture at once. All of it is the painter's, who
 * fetches it; what is here is drawn while the picture moves, and places are looked up in it.
 */

import { createStore, type Store } from "../app/store";
import { getBytes, getJson, Outdated } from "../link/http";
import type { Detail, PreviewInfo } from "../wire/messages";
import { type Piece, readPiece } from "./piece";

/** Segments that are drawn many times a second on any computer. */
const swift = 40_000;

export interface ToolPath {
  readonly info: PreviewInfo;
  /** Pieces that are drawn while the picture moves. */
  readonly coarse: readonly Piece[];
  /** Address of the whole path; nothing when the coarse one is all there is. */
  readonly whole: string | null;
}

/** The finest level that is still swift; the coarsest when none is. */
export function coarseLevel(details: readonly Detail[]): number {
  const swiftOnes = details.findIndex(({ segments }) => segments <= swift);
  return swiftOnes >= 0 ? swiftOnes : details.length - 1;
}

export interface Loading {
  readonly path: Store<ToolPath | null>;
  cancel(): void;
}

/** Loads the tool path of a preview. */
export function loadToolPath(key: string): Loading {
  const path = createStore<ToolPath | null>(null);
  const abort = new AbortController();
  load(key, path, abort.signal).catch((error: unknown) => {
    if (!abort.signal.aborted && !(error instanceof Outdated)) throw error;
  });
  return { path, cancel: () => abort.abort() };
}

async function load(key: string, path: Store<ToolPath | null>, signal: AbortSignal): Promise<void> {
  const root = `/api/preview/${encodeURIComponent(key)}`;
  const info = await getJson<PreviewInfo>(root, signal);
  const level = coarseLevel(info.details);
  const coarse: Piece[] = [];
  for await (const piece of piecesOf(root, info, level, signal)) coarse.push(piece);
  path.set({ info, coarse, whole: level === 0 ? null : root });
}

async function* piecesOf(root: string, info: PreviewInfo, level: number, signal: AbortSignal) {
  const pieces = info.details[level]?.pieces ?? 0;
  for (let n = 0; n < pieces; n += 1) {
    const bytes = await getBytes(`${root}/${level}/${n}`, signal);
    if (bytes.byteLength === 0) throw new Outdated();
    yield readPiece(bytes);
  }
}
