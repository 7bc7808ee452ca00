/** Sentences of the server in the language of the page, as far as its table has them; the others stay as they are said. */

import { drawingSentences } from "./german/drawingSentences";
import { findingSentences } from "./german/findings/sentences";
import { serverSentences } from "./german/server";
import { translator } from "./translator";
import { language } from "./words";

const translate = translator({ ...serverSentences, ...findingSentences, ...drawingSentences });

/** A sentence of the server in German. */
export const inGerman = (text: string): string => translate(text) ?? text;

/** A sentence of the server in the language of the page. */
export const serverWords = (text: string): string => (language === "de" ? inGerman(text) : text);
