/**
 * The server's clock, as this page reckons it from its pings.
 *
 * A ping is sent, answered and heard one after the other: when it was heard, the server's clock was between what
 * the answer says and that plus the way there and back. Every ping narrows that; a drift of the two clocks widens it.
 */

/** Two clocks go apart by so much from ping to ping at most, milliseconds. */
const driftMs = 0.2;

export class ServerClock {
  #lowMs = Number.NEGATIVE_INFINITY;
  #highMs = Number.POSITIVE_INFINITY;

  /** A ping was answered: both times of this page's clock, and the server's between them, milliseconds. */
  heard(sentMs: number, gotMs: number, serverMs: number): void {
    const [low, high] = [serverMs - gotMs, serverMs - sentMs];
    const [lowMs, highMs] = [
      Math.max(this.#lowMs - driftMs, low),
      Math.min(this.#highMs + driftMs, high),
    ];
    // A clock that was set, or slept: what was known of it is of no use.
    [this.#lowMs, this.#highMs] = lowMs <= highMs ? [lowMs, highMs] : [low, high];
  }

  /** Lead of the server's clock over this page's, milliseconds; nothing before the first ping. */
  get aheadMs(): number | null {
    return Number.isFinite(this.#lowMs) ? (this.#lowMs + this.#highMs) / 2 : null;
  }
}
