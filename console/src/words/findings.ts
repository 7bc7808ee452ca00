/** Findings in the language of the page: by their sentence, else by their code with the values that they name. */

import type { Finding, Message } from "../wire/messages";
import { findingTexts } from "./german/findings/findings";
import { inGerman } from "./server";
import { language } from "./words";

/** Names in a sentence: quoted words, lengths, variables, commands, axes. */
const named =
  /`[^`]+`|'[^']+'|"[^"]+"|(?<![\w.])-?\d+(?:\.\d+)?(?: (?:mm|in)\b)?|[&%#][\w()<>]+|\b[A-Z][A-Z0-9]*\b/g;

/** The first letter of a sentence is no name. */
const namesOf = (text: string): string[] => [
  ...new Set(text.replace(/^[AI] /, "").match(named) ?? []),
];

/** A finding in German; one without a code as its sentence is known. */
export function findingInGerman<Found extends Pick<Finding, "code" | "message" | "hint">>(
  finding: Found,
): Found {
  const { code, message } = finding;
  const sentence = inGerman(message);
  const known = findingTexts[code];
  if (!known) return { ...finding, message: sentence, hint: inGerman(finding.hint) };
  if (sentence !== message) return { ...finding, message: sentence, hint: known.mend };
  const names = namesOf(message).filter((name) => !known.title.includes(name));
  const said = names.length > 0 ? `${known.title}: ${names.join(", ")}` : known.title;
  return { ...finding, message: said, hint: known.mend };
}

/** A finding in the language of the page. */
export const findingWords = <Found extends Pick<Finding, "code" | "message" | "hint">>(
  finding: Found,
): Found => (language === "de" ? findingInGerman(finding) : finding);

const withHint = (text: string, hint: string): string => (hint === "" ? text : `${text} (${hint})`);

/** A message of the machine in German, by the code of its finding where it is one. */
export function messageInGerman({
  code,
  text,
  hint,
}: Pick<Message, "code" | "text" | "hint">): string {
  const found = findingInGerman({ code, message: text, hint });
  return withHint(found.message, found.hint);
}

/** A message of the machine with the way to mend it, in the language of the page. */
export const messageWords = (message: Pick<Message, "code" | "text" | "hint">): string =>
  language === "de" ? messageInGerman(message) : withHint(message.text, message.hint);
