/** Finds the lines of a file beside the page. */

import { getBytes } from "../link/http";
import { indexLines } from "./lineIndex";

addEventListener("message", async ({ data }: MessageEvent<string>) => {
  const { bytes, starts } = await indexLines(new Uint8Array(await getBytes(data)));
  postMessage({ bytes, starts }, { transfer: [bytes.buffer, starts.buffer] });
});
