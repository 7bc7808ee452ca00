/** Reads a text for the editor beside the page. */

import { Refused, readBytes } from "../link/http";
import type { Problem } from "../wire/messages";
import { folded, type StoredText } from "./storedText";

/** A text that was read, or why it was not. */
export type Answer =
  | { readonly stored: StoredText; readonly hash: string }
  | { readonly problem: Problem; readonly status: number };

async function answerTo(address: string): Promise<Answer> {
  try {
    const { bytes, hash } = await readBytes(address);
    return { stored: folded(new Uint8Array(bytes)), hash };
  } catch (error) {
    if (error instanceof Refused) return { problem: error.problem, status: error.status };
    return { problem: { why: "server", text: String(error) }, status: 0 };
  }
}

addEventListener("message", async ({ data }: MessageEvent<string>) => {
  const answer = await answerTo(data);
  const arrays = "stored" in answer ? Object.values(answer.stored).filter(ArrayBuffer.isView) : [];
  postMessage(answer, { transfer: arrays.map(({ buffer }) => buffer as ArrayBuffer) });
});
