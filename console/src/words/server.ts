/** Sentences of the server in the language of the page; a test holds the German ones to what its crates say. */

import { sentences } from "./german/sentences/sentences";
import { translator } from "./translator";
import { language } from "./words";

const translate = translator(sentences);

/** A sentence of the server in German; what a program or a person wrote stays as it is. */
export const inGerman = (text: string): string => translate(text) ?? text;

/** A sentence of the server in the language of the page. */
export const serverWords = (text: string): string => (language === "de" ? inGerman(text) : text);
