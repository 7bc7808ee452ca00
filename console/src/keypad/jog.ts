/**
 * The dead man's handle of the keypad.
 *
 * The server makes the motion and ramps it down unless this hand keeps renewing it; here is only
 * what the hand does: begin, renew, end, each with the server's clock, so that a sign that a link kept back
 * is known to be old. Everything that could mean "let go" ends a jog: key or
 * pointer up, a lost focus, a hidden page, a link that became slow.
 */

import type { AxisValue } from "../units/quantity";
import type { Act, Reply } from "../wire/messages";
import { t } from "../words/words";
import type { Direction } from "./keys";

type Jog = Extract<Act, { do: "jogStart" | "jogRenew" | "jogStop" | "key" }>;

/** Begins a jog, under this number of the lease and of the jog, at this time of the server. */
type Begin = (lease: number, seq: number, clockMs: number) => Jog;

/** Jogs of this page so far: its hands never use a number twice. */
let jogs = 0;

/** Interval at which a jog is renewed, milliseconds; the machine goes on until the newest sign is 250 old. */
export const renewEveryMs = 50;

export interface JogWish {
  readonly direction: Direction;
  /** Share of the jog speed, 0 … 1. */
  readonly speedShare: number;
  /** As long as it is held when nothing. */
  readonly distance: AxisValue | null;
}

export class JogHand {
  readonly #ask: (act: Jog) => Promise<Reply>;
  readonly #lease: () => number | undefined;
  readonly #clock: () => number | null;
  readonly #refused: (why: string) => void;
  #seq = 0;
  #renewing: ReturnType<typeof setInterval> | undefined;
  #again: ReturnType<typeof setTimeout> | undefined;

  constructor(
    ask: (act: Jog) => Promise<Reply>,
    lease: () => number | undefined,
    clock: () => number | null,
    refused: (why: string) => void,
  ) {
    this.#ask = ask;
    this.#lease = lease;
    this.#clock = clock;
    this.#refused = refused;
  }

  /** Begins, or changes what is held. */
  hold({ direction: [x, y, z, a, b, c], speedShare, distance }: JogWish): void {
    this.#hold((lease, seq, clockMs) => ({
      do: "jogStart",
      lease,
      seq,
      clockMs,
      direction: [x, y, z, a, b, c],
      speedShare,
      distance,
    }));
  }

  /** Presses a key of the hand console, which may move the tool until it is let go. */
  press(key: string): void {
    this.#hold((lease, seq, clockMs) => ({ do: "key", lease, seq, clockMs, key }));
  }

  #hold(begin: Begin): void {
    this.release();
    void this.#begin(begin);
  }

  /** Lets go; harmless when nothing is held. */
  release(): void {
    clearTimeout(this.#again);
    if (this.#renewing === undefined) return;
    this.#rest();
    void this.#ask({ do: "jogStop", seq: this.#seq });
  }

  #rest(): void {
    clearInterval(this.#renewing);
    this.#renewing = undefined;
  }

  #renew(lease: number, seq: number): void {
    const clockMs = this.#clock();
    if (clockMs !== null) void this.#ask({ do: "jogRenew", lease, seq, clockMs });
  }

  async #begin(begin: Begin): Promise<void> {
    const lease = this.#lease();
    if (lease === undefined) return;
    const clockMs = this.#clock();
    if (clockMs === null) {
      this.#refused(t("The link is being measured: press the key again in a moment."));
      return;
    }
    jogs += 1;
    const seq = jogs;
    this.#seq = seq;
    this.#renewing = setInterval(() => this.#renew(lease, seq), renewEveryMs);
    const { problem } = await this.#ask(begin(lease, seq, clockMs));
    if (!problem || seq !== this.#seq || this.#renewing === undefined) return;
    this.#rest();
    // The jog before still ramps down: begins as soon as it is over, if the key is still held.
    if (problem.why === "state")
      this.#again = setTimeout(() => void this.#begin(begin), renewEveryMs);
    else this.#refused(problem.text);
  }
}
