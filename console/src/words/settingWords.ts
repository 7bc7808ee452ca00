/** Words that a setting may be, in the language of the page. */

import { settingWords } from "./german/settingWords";
import { language } from "./words";

export const settingWord = (word: string): string =>
  language === "de" ? (settingWords[word] ?? word) : word;
