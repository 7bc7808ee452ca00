/** Requests that wait for their replies. */

import type { Act, Reply, Request } from "../wire/messages";
import { t } from "../words/words";

/** The reply that stands for a link that broke before the server's came. */
const lostReply = (id: number): Reply => ({
  id,
  problem: {
    why: "server",
    text: t("The link to the machine is lost; nobody knows whether this was done."),
  },
  notes: [],
});

export class Requests {
  #next = 1;
  readonly #waiting = new Map<number, (reply: Reply) => void>();

  /** A request to send, and what will become of it. */
  make(act: Act): { request: Request; reply: Promise<Reply> } {
    const request = { id: this.#next++, act };
    const reply = new Promise<Reply>((resolve) => this.#waiting.set(request.id, resolve));
    return { request, reply };
  }

  answered(reply: Reply): void {
    this.#waiting.get(reply.id)?.(reply);
    this.#waiting.delete(reply.id);
  }

  /** The link is gone: nothing that waits is ever sent again. */
  lost(): void {
    for (const [id, resolve] of this.#waiting) resolve(lostReply(id));
    this.#waiting.clear();
  }
}
