/** The version of Kerf that this page was built with, and that of the server. */

import type { Shown } from "./shown";

declare const __KERF_VERSION__: string;

export const version = __KERF_VERSION__;

/** The version of the server where it is another than the page's: neither knows what the other means. */
export function otherVersion({ snapshot }: Shown): string | undefined {
  const kerf = snapshot?.kerf;
  return kerf === version ? undefined : kerf;
}
