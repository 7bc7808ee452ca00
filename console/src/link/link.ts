/**
 * The socket to the server: a snapshot, then changes; requests and their replies. What only stops goes over a second
 * one as well (stopway.ts).
 *
 * A lost socket is opened anew; what was asked meanwhile is refused at once, never kept and sent
 * later: a command that arrives late is worse than one that does not arrive.
 */

import { createStore, type Store } from "../app/store";
import type { Act, Reply, ToPage } from "../wire/messages";
import { fold } from "./fold";
import { longWork } from "./longWork";
import { Requests } from "./requests";
import { ServerClock } from "./server-clock";
import { nothingShown, type Shown } from "./shown";
import { onlyStops, StopWay, stopAddress } from "./stopway";

export interface Link {
  readonly shown: Store<Shown>;
  /** Asks the server; a refusal is a reply with a problem, never an exception. */
  ask(act: Act): Promise<Reply>;
  close(): void;
}

/** A wait that is shorter is not told. */
const tellsWaitAfterMs = 500;
const pingEveryMs = 1000;
const firstRetryMs = 250;
const lastRetryMs = 4000;

class SocketLink implements Link {
  readonly shown = createStore<Shown>(nothingShown);
  readonly #address: string;
  readonly #requests = new Requests();
  readonly #stopWay = new StopWay((reply) => this.#requests.answered(reply));
  #socket: WebSocket | undefined;
  #clock = new ServerClock();
  #retryMs = firstRetryMs;
  #closed = false;
  #waits = 0;
  readonly #pings: ReturnType<typeof setInterval>;

  constructor(address: string) {
    this.#address = address;
    this.#pings = setInterval(() => void this.#ping(), pingEveryMs);
    this.#open();
  }

  ask(act: Act): Promise<Reply> {
    const { request, reply } = this.#requests.make(act);
    const pressed = onlyStops(act) && this.#stopWay.press(request);
    if (this.#socket?.readyState === WebSocket.OPEN) this.#socket.send(JSON.stringify(request));
    else if (!pressed) this.#requests.lost();
    this.#tellsWait(act, reply);
    return reply;
  }

  close(): void {
    this.#closed = true;
    clearInterval(this.#pings);
    this.#stopWay.lead(undefined);
    this.#socket?.close();
  }

  /** Tells that the page waits, where an act may take long and does. */
  #tellsWait(act: Act, reply: Promise<Reply>): void {
    const waitsFor = longWork(act);
    if (waitsFor === null) return;
    const told = setTimeout(
      () => this.shown.update((now) => ({ ...now, waitsFor })),
      tellsWaitAfterMs,
    );
    const waits = ++this.#waits;
    void reply.then(() => {
      clearTimeout(told);
      // What was asked for again is waited for still.
      if (waits === this.#waits) this.shown.update((now) => ({ ...now, waitsFor: null }));
    });
  }

  #open(): void {
    const socket = new WebSocket(this.#address);
    this.#socket = socket;
    socket.addEventListener("message", ({ data }) => {
      try {
        this.#hear(JSON.parse(String(data)));
      } catch (error) {
        // What is shown would be old from here on: a new snapshot is fetched.
        reportError(error);
        socket.close();
      }
    });
    socket.addEventListener("close", () => this.#lose());
  }

  #hear(told: ToPage): void {
    switch (told.tell) {
      case "snapshot":
        this.#retryMs = firstRetryMs;
        this.#leadStop(told.snapshot.stopPort, told.who.client);
        this.shown.update((now) => ({
          ...now,
          status: "open",
          who: told.who,
          snapshot: told.snapshot,
        }));
        void this.#ping();
        break;
      case "changes":
        this.shown.update((now) =>
          now.snapshot ? { ...now, snapshot: told.changes.reduce(fold, now.snapshot) } : now,
        );
        break;
      case "reply":
        this.#requests.answered(told);
    }
  }

  /** STOP's own way belongs to this page's number; it stays open while the main socket is lost. */
  #leadStop(port: number, client: number): void {
    this.#stopWay.lead(port > 0 ? stopAddress(this.#address, port, client) : undefined);
  }

  #lose(): void {
    this.#requests.lost();
    this.shown.update((now) => ({
      ...now,
      status: now.snapshot ? "lost" : "opening",
      roundTripMs: null,
      aheadMs: null,
    }));
    this.#clock = new ServerClock();
    if (this.#closed) return;
    setTimeout(() => this.#open(), this.#retryMs);
    this.#retryMs = Math.min(this.#retryMs * 2, lastRetryMs);
  }

  async #ping(): Promise<void> {
    if (this.#socket?.readyState !== WebSocket.OPEN) return;
    const sent = performance.now();
    const reply = await this.ask({ do: "ping" });
    if (reply.problem) return;
    const got = performance.now();
    if (reply.clockMs !== undefined) this.#clock.heard(sent, got, reply.clockMs);
    const { aheadMs } = this.#clock;
    this.shown.update((now) => ({ ...now, roundTripMs: got - sent, aheadMs }));
  }
}

/** Opens the link to a server. */
export const openLink = (address: string): Link => new SocketLink(address);

/** The address of the socket of the server this page came from. */
export const socketAddress = ({ protocol, host }: Location): string =>
  `${protocol === "https:" ? "wss" : "ws"}://${host}/ws`;
