/**
 * STOP's own way: a second socket, to a port and a thread of the server that do nothing else.
 *
 * What only stops is sent on both ways with the same number, and counts once. Where this way cannot be reached
 * (a firewall, an older server) the main one is left.
 */

import type { Act, Reply, Request, ToPage } from "../wire/messages";

const firstRetryMs = 500;
const lastRetryMs = 8000;

/** Tells whether an act does nothing but stop: it is sent on both ways. */
export const onlyStops = (act: Act): boolean =>
  act.do === "stop" || act.do === "hold" || act.do === "disarm" || act.do === "jogStop";

/** The address of STOP's own way, for a page with this number on the main socket. */
export function stopAddress(main: string, port: number, client: number): string {
  const url = new URL(main);
  url.port = `${port}`;
  url.pathname = "/stop";
  url.search = `?client=${client}`;
  return url.href;
}

export class StopWay {
  readonly #heard: (reply: Reply) => void;
  #address: string | undefined;
  #socket: WebSocket | undefined;
  #retryMs = firstRetryMs;
  #retry: ReturnType<typeof setTimeout> | undefined;

  /** Tells what is heard on it. */
  constructor(heard: (reply: Reply) => void) {
    this.#heard = heard;
  }

  /** Leads there from now on; nowhere without an address. */
  lead(address: string | undefined): void {
    if (address === this.#address) return;
    this.#address = address;
    clearTimeout(this.#retry);
    const before = this.#socket;
    this.#socket = undefined;
    before?.close();
    this.#retryMs = firstRetryMs;
    if (address !== undefined) this.#open(address);
  }

  /** Presses; tells whether this way was open. */
  press(request: Request): boolean {
    if (this.#socket?.readyState !== WebSocket.OPEN) return false;
    this.#socket.send(JSON.stringify(request));
    return true;
  }

  #open(address: string): void {
    const socket = new WebSocket(address);
    this.#socket = socket;
    socket.addEventListener("open", () => {
      this.#retryMs = firstRetryMs;
    });
    socket.addEventListener("message", ({ data }) => this.#hear(String(data)));
    socket.addEventListener("close", () => {
      if (this.#socket !== socket) return;
      this.#retry = setTimeout(() => this.#open(address), this.#retryMs);
      this.#retryMs = Math.min(this.#retryMs * 2, lastRetryMs);
    });
  }

  #hear(text: string): void {
    const told = JSON.parse(text) as ToPage;
    if (told.tell === "reply") this.#heard(told);
  }
}
