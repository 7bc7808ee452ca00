/** Brings files of the part folder to this computer. */

import { fileAddress } from "./http";

/** Hands a file to the browser, which keeps it where it keeps what it downloads. */
export function download(name: string): void {
  const way = document.createElement("a");
  way.href = fileAddress(name);
  way.download = name.split("/").at(-1) ?? name;
  way.click();
}
