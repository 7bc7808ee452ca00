/** Texts of any length, read for the editor. */

import type { Text } from "@codemirror/state";
import { Refused } from "../link/http";
import { type LineEnd, textOf } from "./storedText";
import type { Answer } from "./textWorker";

/** The content of a file. */
export interface Content {
  readonly text: Text;
  /** The end of its lines. */
  readonly ends: LineEnd;
  /** The hash of the content. */
  readonly hash: string;
}

/** Reads the text at an address, beside the page. */
export async function readText(address: string): Promise<Content> {
  const answer = await answerOf(address);
  if ("problem" in answer) throw new Refused(answer.problem, answer.status);
  const { stored, hash } = answer;
  return { text: textOf(stored), ends: stored.ends, hash };
}

function answerOf(address: string): Promise<Answer> {
  const worker = new Worker(new URL("./textWorker.ts", import.meta.url), { type: "module" });
  const answer = new Promise<Answer>((resolve, reject) => {
    worker.addEventListener("message", ({ data }: MessageEvent<Answer>) => resolve(data));
    worker.addEventListener("error", ({ message }) => reject(new Error(message)));
    worker.postMessage(address);
  });
  return answer.finally(() => worker.terminate());
}
