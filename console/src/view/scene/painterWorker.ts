/** The painter's own thread: hears orders of the page, fetches the whole path, tells when it is drawn. */

import { getBytes } from "../../link/http";
import { readPiece } from "../piece";
import type { CoarsePath, Order, Told } from "./orders";
import { PathPainter } from "./PathPainter";

let painter: PathPainter | undefined;
let path: CoarsePath | null = null;
let fetching = new AbortController();
let [pictures, whole] = [0, false];

/** A picture is done. */
function drawn(): void {
  pictures += 1;
  postMessage({ pictures, whole, bared: painter?.bared ?? null } satisfies Told);
}

/** Fetches the whole path, piece by piece, and draws it when all is there. */
async function fetchWhole(address: string, pieces: number, signal: AbortSignal): Promise<void> {
  for (let n = 0; n < pieces; n += 1) {
    const bytes = await getBytes(`${address}/0/${n}`, signal);
    // Nothing comes of a path in whose place there is another.
    if (signal.aborted || bytes.byteLength === 0) return;
    painter?.add(readPiece(bytes));
  }
  whole = true;
  painter?.whole();
}

function show(next: CoarsePath | null, address: string | null): void {
  fetching.abort();
  fetching = new AbortController();
  const { signal } = fetching;
  path = next;
  whole = next !== null && address === null;
  painter?.show(next);
  if (!next || address === null) return;
  fetchWhole(address, next.info.details[0]?.pieces ?? 0, signal).catch((error: unknown) => {
    if (!signal.aborted) throw error;
  });
}

addEventListener("message", ({ data }: MessageEvent<Order>) => {
  switch (data.do) {
    case "begin":
      painter = new PathPainter(data.canvas, data.ratio, data.palette, drawn);
      break;
    case "paint":
      painter?.paint(data.palette);
      break;
    case "show":
      show(data.path, data.whole);
      break;
    case "now":
      if (painter) painter.now = data.seconds;
      break;
    case "look":
      painter?.look(data.camera, data.size);
      break;
    case "jogs":
      if (painter) painter.jogs = data.drawn;
      break;
    case "simulate":
      painter?.simulate(data.on ? path : null);
  }
});
