/** Sends typed and unsaved text to the server soon after it was typed. */

import { endDraft, keepDraft } from "../link/http";
import type { TextDraft } from "../wire/messages";
import { t } from "../words/words";

/** So long after something was typed it goes; with the way to the disk that stays below half a second. */
const waitMs = 200;

/** After a refusal it is tried again so much later. */
const againMs = 1000;

/** So long another file waits for what was typed into the one before. */
const patienceMs = 1500;

/** Most bytes that may be sent while a page goes. */
const mostAtEnd = 60_000;

/** Bytes of what is told of a draft's text, about. */
const sizeOf = ({ text, edits }: TextDraft): number =>
  text.length + (edits ? JSON.stringify(edits).length : 0);

/** A page by a name that no other has. */
const newPage = (): string => `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;

const bothKept = (name: string): string =>
  t(
    "Another page types into {0} too. Both texts are kept; the other one is listed as not saved.",
    name || t("a new file"),
  );

export class DraftKeeper {
  readonly #tell: (text: string) => void;
  /** As which page each file is typed into: another one after the text of another page was shown. */
  readonly #pages = new Map<string, string>();
  /** The draft that was shown of each file, and that this page goes on from. */
  readonly #shown = new Map<string, TextDraft>();
  /** Files into which another page types too. */
  readonly #shared = new Set<string>();
  /** Called where one more is. */
  onShared: () => void = () => undefined;
  /** Work left for each file: the draft to be kept, or nothing where it has ended. */
  readonly #wanted = new Map<string, TextDraft | null>();
  #works: Promise<void> | null = null;
  #told = false;

  constructor(tell: (text: string) => void) {
    this.#tell = tell;
  }

  /** A draft is shown: what is typed from now on goes on from it. */
  shows(name: string, draft: TextDraft | undefined): void {
    if (!draft || this.isOwn(draft)) return;
    this.#pages.delete(name);
    this.#shown.set(name, draft);
    this.#shared.delete(name);
  }

  /** Set where this page typed it. */
  isOwn(draft: TextDraft): boolean {
    return draft.page !== "" && this.#pages.get(draft.name) === draft.page;
  }

  keep(typed: TextDraft): void {
    const page = this.#pages.get(typed.name) ?? newPage();
    this.#pages.set(typed.name, page);
    const draft = { ...typed, page, revision: this.#shown.get(typed.name)?.revision ?? "" };
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

  /** Draft of a file that is not at the server yet. */
  waiting(name: string): TextDraft | undefined {
    return this.#wanted.get(name) ?? undefined;
  }

  async #rest(): Promise<void> {
    while (this.#works) await this.#works;
  }

  /** The page goes: what was typed last goes out at once, where it is short. */
  leave(): void {
    for (const draft of this.#wanted.values())
      if (draft && sizeOf(draft) < mostAtEnd) void keepDraft(draft, true).catch(() => undefined);
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
      if (draft) this.#sharing(name, await keepDraft(draft));
      else await this.#end(name);
      this.#told = false;
      return true;
    } catch (error) {
      if (!this.#told) this.#tell(t("What is typed is not kept by the server: {0}", String(error)));
      this.#told = true;
      return false;
    }
  }

  /** Ends what this page typed into a file, and what it showed of it. */
  async #end(name: string): Promise<void> {
    const [page, shown] = [this.#pages.get(name), this.#shown.get(name)];
    if (page !== undefined) await endDraft(name, page);
    if (shown) await endDraft(name, shown.page, shown.revision);
    this.#shown.delete(name);
  }

  /** Tells once that another page types into a file too. */
  #sharing(name: string, shared: boolean): void {
    if (!shared) this.#shared.delete(name);
    else if (!this.#shared.has(name)) {
      this.#shared.add(name);
      this.#tell(bothKept(name));
      this.onShared();
    }
  }
}

const pause = (ms: number) => new Promise<void>((resolve) => setTimeout(resolve, ms));

const shownKey = "kerf.edited";

/** File that this page edited last, and the file that was open then: a reload goes on with it. */
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
