/** State of the server as the page knows it: the last snapshot and the quality of the link. */

import type { Snapshot, Who } from "../wire/messages";

/** `opening` before the first snapshot, `lost` when there was one and the socket is gone. */
export type LinkStatus = "opening" | "open" | "lost";

export interface Shown {
  readonly status: LinkStatus;
  readonly who: Who | null;
  /** Nothing before the first one arrived; the last one while the link is lost. */
  readonly snapshot: Snapshot | null;
  /** The wait of this page in words, when it takes longer than a moment. */
  readonly waitsFor: string | null;
  /** Duration of the last ping, milliseconds. */
  readonly roundTripMs: number | null;
  /** Lead of the server's clock over this page's, milliseconds. */
  readonly aheadMs: number | null;
}

export const nothingShown: Shown = {
  status: "opening",
  who: null,
  snapshot: null,
  waitsFor: null,
  roundTripMs: null,
  aheadMs: null,
};

/** The server's clock now, milliseconds; nothing before it was measured. */
export const serverClockMs = ({ aheadMs }: Shown): number | null =>
  aheadMs === null ? null : performance.now() + aheadMs;

/** The number of the lease when this page drives. */
export function leaseOf({ who, snapshot }: Shown): number | undefined {
  const lease = snapshot?.lease;
  return lease && who && lease.client === who.client ? lease.number : undefined;
}
