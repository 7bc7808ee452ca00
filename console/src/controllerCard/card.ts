/** The card of a controller in words: what is done on it, what it holds, how far a file of it is. */

import { durationText } from "../app/units";
import { sizeText } from "../operator/fileWords";
import type { CardFile, CardTask, CurrentRun, Motion } from "../wire/messages";
import { t } from "../words/words";

/** Files of the part folder that go on a card: G-code as it is, part files and jobs as G-code. */
export const goesOnCard = (name: string): boolean => /\.(sbp|rsm|nc|tap|ngc|gcode)$/i.test(name);

const doing: Readonly<Record<CardTask["kind"], string>> = {
  list: t("The files are listed."),
  look: t("{0} is read back and looked through."),
  upload: t("{0} is looked through and put on the card."),
  run: t("{0} is begun."),
  delete: t("{0} is deleted."),
  keep: t("{0} is copied into the part folder."),
};

/** Words for the task on the card, with the bytes that are there. */
export function taskText({ kind, name, done, all }: CardTask): string {
  const words = doing[kind].replace("{0}", name);
  if (done === 0) return words;
  const bytes = all > 0 ? t("{0} of {1}", sizeText(done), sizeText(all)) : sizeText(done);
  return `${words} ${bytes}`;
}

/** `3 files, 12 kB in all`. */
export function filesText(files: readonly CardFile[]): string {
  const bytes = sizeText(files.reduce((sum, file) => sum + file.bytes, 0));
  return files.length === 1
    ? t("1 file, {0}. The controller does not tell what room is left.", bytes)
    : t(
        "{0} files, {1} in all. The controller does not tell what room is left.",
        files.length,
        bytes,
      );
}

/** The time that the controller is estimated to take for a file; a dash where its text is not known. */
export const timeOf = ({ looked }: CardFile): string =>
  looked ? t("about {0}", durationText(looked.seconds)) : "–";

/** `12 % is done, about 3:04 left`; of a file whose time is not known, the share of the bytes that the controller has read. */
export function runText({ seconds }: CurrentRun, { progress, remaining }: Motion): string {
  const percent = Math.floor(progress * 100);
  return seconds > 0
    ? t("{0} % is done, about {1} left", percent, durationText(remaining))
    : t("{0} % of it is read; the time left is unknown: its text was not looked through", percent);
}
