/**
 * The dead man's handle of the keypad.
 *
 * The server makes the motion and ramps it down unless this hand keeps renewing it; here is only
 * what the hand does: begin, renew, end. Everything that could mean "let go" ends a jog: key or
 * pointer up, a lost focus, a hidden page, a link that became slow.
 */

import type { Act } from "../wire/messages";
import type { Direction } from "./keys";

type Jog = Extract<Act, { do: "jogStart" | "jogRenew" | "jogStop" }>;

/** How often a jog is renewed, milliseconds; the server waits 250. */
export const renewEveryMs = 70;

export interface JogWish {
  readonly direction: Direction;
  /** Share of the jog speed, 0 … 1. */
  readonly speed: number;
  /** Mm or degrees; as long as it is held when nothing. */
  readonly distance: number | null;
}

export class JogHand {
  readonly #ask: (act: Jog) => void;
  readonly #lease: () => number | undefined;
  #seq = 0;
  #renewing: ReturnType<typeof setInterval> | undefined;

  constructor(ask: (act: Jog) => void, lease: () => number | undefined) {
    this.#ask = ask;
    this.#lease = lease;
  }

  get moves(): boolean {
    return this.#renewing !== undefined;
  }

  /** Begins, or changes what is held. Tells whether it could. */
  hold(wish: JogWish): boolean {
    this.release();
    const lease = this.#lease();
    if (lease === undefined) return false;
    this.#seq += 1;
    const seq = this.#seq;
    const { speed, distance } = wish;
    this.#ask({ do: "jogStart", lease, seq, direction: [...wish.direction], speed, distance });
    this.#renewing = setInterval(() => this.#ask({ do: "jogRenew", lease, seq }), renewEveryMs);
    return true;
  }

  /** Lets go; harmless when nothing is held. */
  release(): void {
    if (this.#renewing === undefined) return;
    clearInterval(this.#renewing);
    this.#renewing = undefined;
    this.#ask({ do: "jogStop", seq: this.#seq });
  }
}
