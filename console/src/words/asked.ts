/** Questions in the language of the page: Kerf's own are translated, what a program wrote stays as it is. */

import type { Asked } from "../wire/messages";
import { answerButtons, questionTitles } from "./german/answers";
import { inGerman } from "./server";
import { language } from "./words";

/** Kinds whose words are a program's own. */
const ofPrograms = ["input", "msgbox", "pause"];

/** The text of a pause above which no comment stands. */
const bare = "Continue?";

/** True where a program asks in its own words. Kerf asks of the place and of homing in a box too; its titles tell it. */
export const isOfProgram = ({
  kind,
  title,
  text,
}: Pick<Asked, "kind" | "title" | "text">): boolean =>
  ofPrograms.includes(kind) && questionTitles[title] === undefined && text !== bare;

/** The words on a button; what is answered stays English. */
export const buttonInGerman = (word: string): string => answerButtons[word] ?? word;

/** A question in German. */
export const askedInGerman = (asked: Asked): Asked =>
  isOfProgram(asked)
    ? asked
    : {
        ...asked,
        text: inGerman(asked.text),
        title: questionTitles[asked.title] ?? asked.title,
      };

export const askedWords = (asked: Asked): Asked =>
  language === "de" ? askedInGerman(asked) : asked;

export const buttonWords = (word: string): string =>
  language === "de" ? buttonInGerman(word) : word;
