/** Takes changes over into the snapshot, as `Snapshot::apply` of the server's wire crate does. */

import type { Change, Snapshot } from "../wire/messages";

const mostPrinted = 1000;
const mostMessages = 200;

/** Adds to a list that does not grow for ever. */
const keepLast = <T>(list: readonly T[], more: readonly T[], most: number): T[] =>
  [...list, ...more].slice(-most);

/** The snapshot after a change; sections that did not change stay the same objects. */
export const fold = (now: Snapshot, change: Change): Snapshot => ({
  ...changed(now, change),
  // As the number of 32 bits that it is.
  revision: (now.revision + 1) >>> 0,
});

function changed(now: Snapshot, change: Change): Snapshot {
  switch (change.change) {
    case "printed":
      return { ...now, printed: keepLast(now.printed, change.lines, mostPrinted) };
    case "clearPrinted":
      return { ...now, printed: [] };
    case "messages":
      return { ...now, messages: keepLast(now.messages, change.messages, mostMessages) };
    default: {
      const { change: _, ...section } = change;
      return { ...now, ...section };
    }
  }
}
