/** What is typed and not saved goes to the server soon after it was typed. */

import { endDraft, keepDraft } from "../link/http";
import type { TextDraft } from "../wire/messages";

/** So long after something was typed it goes; with the way to the disk that stays below half a second. */
const waitMs = 200;

/** After a refusal it is tried again so much later. */
const againMs = 1000;

/** So long another file waits for what was typed into the one before. */
const patienceMs = 1500;

/** What may be sent while a page goes has to be short, bytes. */
const mostAtEnd = 60_000;

export class DraftKeeper {
  readonly #tell: (text: string) => void;
  /** What is still to be done for each file: the draft to be kept, or nothing where it has ended. */
  readonly #wanted = new Map<string, TextDraft | null>();
  #works: Promise<void> | null = null;
  #told = false;

  constructor(tell: (text: string) => void) {
    this.#tell = tell;
  }

  keep(draft: TextDraft): void {
    this.#wanted.set(draft.name, draft);
    this.#works ??= this.#work(waitMs);
  }

  end(name: string): void {
    this.#wanted.set(name, null);
    this.#works ??= this.#work(0);
  }

  /** Waits until the server has all that was typed so far; not for ever, where it refuses. */
  settled(): Promise<void> {
    return Promise.race([this.#rest(), pause(patienceMs)]);
  }

  /** What was typed into a file and is not at the server yet. */
  waiting(name: string): TextDraft | undefined {
    return this.#wanted.get(name) ?? undefined;
  }

  async #rest(): Promise<void> {
    while (this.#works) await this.#works;
  }

  /** The page goes: what was typed last goes out at once, where it is short. */
  leave(): void {
    for (const draft of this.#wanted.values())
      if (draft && draft.text.length < mostAtEnd)
        void keepDraft(draft, true).catch(() => undefined);
  }

  /** One after the other, so that what was typed last is what stays. */
  async #work(delayMs: number): Promise<void> {
    await pause(delayMs);
    for (const [name, draft] of this.#wanted) {
      if (!(await this.#send(name, draft))) await pause(againMs);
      else if (this.#wanted.get(name) === draft) this.#wanted.delete(name);
    }
    this.#works = this.#wanted.size > 0 ? this.#work(waitMs) : null;
  }

  async #send(name: string, draft: TextDraft | null): Promise<boolean> {
    try {
      await (draft ? keepDraft(draft) : endDraft(name));
      this.#told = false;
      return true;
    } catch (error) {
      if (!this.#told) this.#tell(`What is typed is not kept by the server: ${String(error)}`);
      this.#told = true;
      return false;
    }
  }
}

const pause = (ms: number) => new Promise<void>((resolve) => setTimeout(resolve, ms));

const shownKey = "kerf.edited";

/** What this page edited last, and which file was open then: a reload goes on with it. */
interface LastEdited {
  readonly name: string;
  readonly opened: string;
}

export const rememberEdited = (last: LastEdited): void =>
  sessionStorage.setItem(shownKey, JSON.stringify(last));

export function lastEdited(): LastEdited | null {
  const kept = sessionStorage.getItem(shownKey);
  return kept ? (JSON.parse(kept) as LastEdited) : null;
}
