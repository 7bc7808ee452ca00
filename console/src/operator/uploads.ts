/** Files of this computer on their way into the part folder, one after the other, by the rules of `kerf send`. */

import { type Question, written } from "../actions/replace";
import { createStore } from "../app/store";
import { mostBytes, type Sending } from "../link/send";
import type { FileAbout, Problem } from "../wire/messages";
import { t } from "../words/words";
import { aboutText, sizeText } from "./fileWords";

/** Progress of a file on its way. */
export type Stage =
  | { readonly is: "waits" | "held" | "done" | "left" | "stopped" }
  | { readonly is: "sends"; readonly sent: number }
  | { readonly is: "asks"; readonly about: FileAbout; readonly answer: (yes: boolean) => void }
  | { readonly is: "failed"; readonly text: string };

export interface Upload {
  readonly id: number;
  /** As the part folder has it. */
  readonly name: string;
  readonly bytes: number;
  readonly stage: Stage;
  /** It was held while the machine moved: nobody waits for it any more. */
  readonly late: boolean;
}

/** While the machine moves it is looked so often whether it stands, milliseconds. */
const againMs = 1000;

const over: readonly Stage["is"][] = ["done", "left", "stopped", "failed"];

/** Tells whether a file has come, was left, stopped or refused. */
export const isOver = ({ stage }: Upload): boolean => over.includes(stage.is);

/** Progress of a file, in words that follow its name. */
export function stageText(
  { stage, bytes }: Upload,
  words = (text: string): string => text,
): string {
  switch (stage.is) {
    case "waits":
      return t("waits for the one before it");
    case "held":
      return t("held: the machine moves, and files are taken when it stands");
    case "sends":
      return t("{0} of {1} are sent", sizeText(stage.sent), sizeText(bytes));
    case "asks":
      return t("is there already: {0}. Replace it?", aboutText(stage.about));
    case "done":
      return t("is in the part folder, {0}", sizeText(bytes));
    case "left":
      return t("is not sent: the file that is there is as it was");
    case "stopped":
      return t("stopped: nothing is kept of a file that has not come whole");
    case "failed":
      return t("is not sent: {0}", words(stage.text));
  }
}

/** Reason for which a file is not tried; `null` where it is. */
const tooLarge = (bytes: number): string | null =>
  bytes > mostBytes
    ? t("it has {0} MB, and {1} MB is the most", Math.ceil(bytes / 2 ** 20), mostBytes >> 20)
    : null;

/** Services that uploads need of their page. */
export interface Ways {
  readonly send: (name: string, file: Blob, sending: Sending) => Promise<Problem | null>;
  /** Tells whether the machine moves, as far as the page knows. */
  readonly moves: () => boolean;
}

/** Sends files in the order in which they were chosen. */
export class Uploads {
  readonly list = createStore<readonly Upload[]>([]);
  readonly #ways: Ways;
  readonly #stops = new Map<number, AbortController>();
  #last = 0;
  #before: Promise<void> = Promise.resolve();

  constructor(ways: Ways) {
    this.#ways = ways;
  }

  /** Sends files into a folder below the part folder, behind those that are on their way. */
  add(folder: string, files: readonly File[]): void {
    for (const file of files) {
      const id = ++this.#last;
      const name = folder === "" ? file.name : `${folder}/${file.name}`;
      const text = tooLarge(file.size);
      const stage: Stage = text === null ? { is: "waits" } : { is: "failed", text };
      this.list.update((all) => [...all, { id, name, bytes: file.size, stage, late: false }]);
      if (text === null) this.#queue(id, name, file);
    }
  }

  /** Ends one that is not over: nothing of it is written. */
  stop(id: number): void {
    const upload = this.list.get().find((one) => one.id === id);
    if (!upload || isOver(upload)) return;
    this.#stops.get(id)?.abort();
    if (upload.stage.is === "asks") upload.stage.answer(false);
    this.#tell(id, { is: "stopped" });
  }

  /** Ends all that are not over; gives their names. */
  close(): string[] {
    const unfinished = this.list.get().filter((one) => !isOver(one));
    for (const { id } of unfinished) this.stop(id);
    return unfinished.map(({ name }) => name);
  }

  #queue(id: number, name: string, file: File): void {
    const stop = new AbortController();
    this.#stops.set(id, stop);
    this.#before = this.#before.then(async () => {
      if (stop.signal.aborted) return;
      const attempt = (replaces: string | null) => this.#attempt(id, file, name, replaces);
      const end = await written(name, attempt, this.#question(id)).catch((error: Error) => error);
      if (end === "written") this.#tell(id, { is: "done" });
      else if (end === "left") this.#tell(id, { is: "left" });
      else this.#tell(id, { is: "failed", text: "text" in end ? end.text : end.message });
    });
  }

  /** Sends it, again and again while the machine moves. */
  async #attempt(
    id: number,
    file: File,
    name: string,
    replaces: string | null,
  ): Promise<Problem | null> {
    const signal = this.#stops.get(id)?.signal ?? AbortSignal.abort();
    const onSent = (sent: number) => this.#tell(id, { is: "sends", sent });
    for (;;) {
      if (!this.#ways.moves()) {
        onSent(0);
        const problem = await this.#ways.send(name, file, { replaces, onSent, signal });
        if (problem?.why !== "state" || signal.aborted) return problem;
      }
      this.#tell(id, { is: "held" });
      await new Promise((resolve) => setTimeout(resolve, againMs));
      if (signal.aborted) return { why: "state", text: "stopped" };
    }
  }

  #question(id: number): Question {
    return (about) =>
      new Promise((answer) => {
        if (this.#stops.get(id)?.signal.aborted) answer(false);
        else this.#tell(id, { is: "asks", about, answer });
      });
  }

  /** Tells how far one is; what is over stays so. */
  #tell(id: number, stage: Stage): void {
    const is = (one: Upload) => ({ ...one, stage, late: one.late || stage.is === "held" });
    this.list.update((all) => all.map((one) => (one.id === id && !isOver(one) ? is(one) : one)));
  }
}
