/** Sends files of this computer into the part folder, as `kerf send` does: with a checksum, to a machine that stands. */

import type { Problem } from "../wire/messages";
import { t } from "../words/words";
import { crc32Of } from "./crc32";
import { fileAddress, problemOf } from "./http";

/** Longest file that the server takes over the network, bytes. */
export const mostBytes = 128 << 20;

/** A server that takes or says nothing for so long is lost, milliseconds. */
const lostMs = 8000;

export interface Sending {
  /** The hash of the file that may be replaced. */
  readonly replaces: string | null;
  /** Hears how many bytes are sent. */
  readonly onSent: (bytes: number) => void;
  /** Ends it. */
  readonly signal: AbortSignal;
}

/** Sends a file, whole or not at all; gives why nothing was written. */
export async function sendFile(
  name: string,
  file: Blob,
  sending: Sending,
): Promise<Problem | null> {
  const sum = await crc32Of(file).catch(() => null);
  if (sum === null)
    return { why: "file", text: t("this computer cannot read it: is it a folder?") };
  if (sending.signal.aborted) return stopped;
  return put(name, file, sum.toString(16).padStart(8, "0"), sending);
}

const stopped: Problem = { why: "file", text: "stopped" };
const lost: Problem = { why: "server", text: t("the server does not answer: send it again") };

/** Not `fetch`, which does not tell how far it is. */
function put(name: string, file: Blob, sum: string, sending: Sending): Promise<Problem | null> {
  const { replaces, onSent, signal } = sending;
  const request = new XMLHttpRequest();
  request.open("PUT", fileAddress(name));
  request.setRequestHeader("content-type", "application/octet-stream");
  request.setRequestHeader("kerf-crc32", sum);
  if (replaces) request.setRequestHeader("if-match", `"${replaces}"`);
  const abort = () => request.abort();
  let watch = setTimeout(abort, lostMs);
  request.upload.onprogress = ({ loaded }) => {
    clearTimeout(watch);
    watch = setTimeout(abort, lostMs);
    onSent(loaded);
  };
  signal.addEventListener("abort", abort);
  return new Promise<Problem | null>((done) => {
    request.onload = () =>
      done(request.status === 200 ? null : problemOf(request.responseText, request.statusText));
    request.onerror = () => done(lost);
    request.onabort = () => done(signal.aborted ? stopped : lost);
    request.send(file);
  }).finally(() => {
    clearTimeout(watch);
    signal.removeEventListener("abort", abort);
  });
}
