/** Brings files of the part folder to this computer. */

import { fileAddress } from "./http";

/** Hands a file to the browser, which keeps it where it keeps what it downloads. */
export function download(name: string): void {
  const way = document.createElement("a");
  way.href = fileAddress(name);
  way.download = name.split("/").at(-1) ?? name;
  way.click();
}

/** Hands a text to the browser as a file. */
export function downloadText(name: string, text: string): void {
  const way = document.createElement("a");
  way.href = `data:text/plain;charset=utf-8,${encodeURIComponent(text)}`;
  way.download = name;
  way.click();
}
