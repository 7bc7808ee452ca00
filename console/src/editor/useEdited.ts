/** The file in the editor, with the text that was typed into it and not saved. */

import type { ChangeSet, Text } from "@codemirror/state";
import { useEffect, useRef, useState } from "react";
import { ask } from "../actions/ask";
import { aboutFile, writing } from "../actions/replace";
import { useHands, useScreen, useShown, useSnapshot, worldOf } from "../app/context";
import type { Screen } from "../app/screen";
import { baseAddress, fileAddress, getJson, Refused, writeFile } from "../link/http";
import type { FileAbout, TextDraft } from "../wire/messages";
import { t } from "../words/words";
import {
  drafted,
  draftOf,
  type EditedFile,
  edited,
  isChanged,
  newFile,
  opened,
  saved,
  saving,
  written,
} from "./document";
import { DraftKeeper, lastEdited, rememberEdited } from "./drafts";
import { readText } from "./readText";

export interface Edited {
  readonly file: EditedFile;
  /** Grows when another text is shown than what is typed. */
  readonly shown: number;
  /** Texts that are not saved, the one in the editor left out; a new file has an empty name. */
  readonly others: readonly TextDraft[];
  /** Shows a file, or its draft; an empty name is a new one. Of several drafts that of a page, or else this page's. */
  show(name: string, page?: string): Promise<void>;
  change(text: Text, changes: ChangeSet): void;
  /** Saves under a name; tells whether it was done. */
  save(as: string): Promise<boolean>;
  /** Goes back to what the file holds. */
  drop(): Promise<void>;
}

const changedOnDisk = (name: string) =>
  t(
    "{0} was changed on the disk since this text was typed: Save asks before it is replaced.",
    name,
  );

/** Files that were asked for (FE, FN, a program) and were shown: whoever comes back finds what he edited last. */
const answered = new WeakSet<object>();

/** One for the page: what was typed just before the screen was left is still on its way. */
const keepers = new WeakMap<Screen, DraftKeeper>();

function keeperOf(screen: Screen): DraftKeeper {
  const keeper = keepers.get(screen) ?? new DraftKeeper((text) => screen.tell(text));
  keepers.set(screen, keeper);
  return keeper;
}

export function useEdited(): Edited {
  const hands = useHands();
  const { screen } = hands;
  const name = useSnapshot("opened")?.name ?? "";
  const isTold = useShown((shown) => shown.snapshot !== null);
  const asked = useScreen("edits");
  const [file, setFile] = useState<EditedFile>(newFile);
  const [drafts, setDrafts] = useState<readonly TextDraft[]>([]);
  const [shown, setShown] = useState(0);
  const [shownPage, setShownPage] = useState("");
  const keeper = keeperOf(screen);
  const turn = useRef(0);

  useEffect(() => {
    const leave = () => keeper.leave();
    addEventListener("pagehide", leave);
    return () => removeEventListener("pagehide", leave);
  }, [keeper]);

  useEffect(() => {
    const look = (all: TextDraft[]) => setDrafts(all);
    keeper.onShared = () => void getJson<TextDraft[]>("/api/texts").then(look, () => undefined);
    return () => {
      keeper.onShared = () => undefined;
    };
  }, [keeper]);

  /** Shows a file; nothing stands for the one that is open, or else the draft of late. */
  const show = async (wanted: string | null, page?: string) => {
    turn.current += 1;
    const mine = turn.current;
    await keeper.settled();
    try {
      const all = await getJson<TextDraft[]>("/api/texts");
      const chosen = wanted ?? all[0]?.name ?? "";
      const draft = chosenDraft(chosen, all, keeper, page);
      const read = await present(chosen, draft);
      if (mine !== turn.current) return;
      keeper.shows(chosen, draft);
      setDrafts(all);
      setShownPage(draft?.page ?? "");
      setFile(draft ? drafted(read, draft) : read);
      setShown(mine);
      rememberEdited({ name: chosen, opened: name });
      if (draft?.changedOnDisk) screen.tell(changedOnDisk(chosen));
    } catch (error) {
      screen.tell((error as Error).message);
    }
  };

  // biome-ignore lint/correctness/useExhaustiveDependencies: reads when another file is opened
  useEffect(() => {
    if (!isTold || (asked && !answered.has(asked))) return;
    const last = turn.current === 0 ? lastEdited() : null;
    void show(last?.opened === name ? last.name : name || null);
  }, [name, isTold]);

  const files = useSnapshot("files");
  // biome-ignore lint/correctness/useExhaustiveDependencies: looks when files of the folder change
  useEffect(() => {
    const { name: own, hash } = file;
    if (own === null || isChanged(file)) return;
    const look = (now: FileAbout) => (now.hash === hash ? undefined : show(own));
    // A file that has gone is told when it is saved or opened.
    aboutFile(own).then(look, () => undefined);
  }, [files]);

  // biome-ignore lint/correctness/useExhaustiveDependencies: reads when a program asks
  useEffect(() => {
    if (asked && !answered.has(asked)) void show(asked.name).then(() => answered.add(asked));
  }, [asked]);

  const latest = useRef(file);
  latest.current = file;
  const change = (text: Text, changes: ChangeSet) => {
    const next = edited(latest.current, text, changes);
    latest.current = next;
    setFile(next);
    if (isChanged(next)) keeper.keep(draftOf(next));
    else keeper.end(next.name ?? "");
  };
  const save = async (as: string) => {
    const own = as === file.name && file.hash ? file.hash : null;
    setFile(saving(file));
    const body = await written(file);
    const done = await writing(worldOf(hands), as, async (replaces) => {
      try {
        const hash = await writeFile(as, body, replaces ?? own);
        setFile((now) => saved(now, { name: as, text: file.text, hash }));
        return null;
      } catch (error) {
        if (error instanceof Refused) return error.problem;
        return { why: "server", text: String(error) };
      }
    });
    if (!done) return false;
    for (const ended of new Set([file.name ?? "", as])) keeper.end(ended);
    rememberEdited({ name: as, opened: asked === null ? as : name });
    // While a program waits for the editor, it stays the open file.
    if (asked === null) await ask(worldOf(hands), { do: "open", name: as });
    return true;
  };
  const drop = async () => {
    keeper.end(file.name ?? "");
    await show(file.name ?? "");
  };
  const own = (one: TextDraft) => one.page === shownPage || keeper.isOwn(one);
  const others = drafts.filter((one) => one.name !== (file.name ?? "") || !own(one));
  return { file, shown, others, show, change, save, drop };
}

/** The draft of a file that is shown: that of a page, or what this page typed, or else the newest. */
function chosenDraft(
  name: string,
  all: readonly TextDraft[],
  keeper: DraftKeeper,
  page: string | undefined,
): TextDraft | undefined {
  const of = all.filter((one) => one.name === name);
  if (page !== undefined) return of.find((one) => one.page === page);
  return keeper.waiting(name) ?? of.find((one) => keeper.isOwn(one)) ?? of[0];
}

/**
 * The file under a name as it was read: as it lies on the disk, or as it was when the draft was typed into it, where
 * that tells its edits. Of a file that has gone only its draft is left.
 */
async function present(name: string, draft: TextDraft | undefined): Promise<EditedFile> {
  const isOfBase = draft?.edits && draft.base !== "" && draft.changedOnDisk;
  if (isOfBase) return opened(name, await readText(baseAddress(draft.base)));
  if (name === "") return newFile;
  try {
    return opened(name, await readText(fileAddress(name)));
  } catch (error) {
    if (draft) return { ...newFile, name };
    throw error;
  }
}
