/** The commands of OpenSBP in the language of the page: their names, what they do, and their values. */

import type { CommandEntry, Completion, Parameter } from "../wire/messages";
import { commandDocs } from "./german/commands/docs";
import { commandNames } from "./german/commands/names";
import { parameterDocs } from "./german/commands/parameterDocs";
import { bounds, choices, parameterNames } from "./german/commands/parameters";
import { type Translate, translator } from "./translator";
import { language } from "./words";

const nameOf = translator(commandNames);
const parameterOf = translator(parameterNames);
const boundOf = translator(bounds);
const docOf = translator(parameterDocs);

const said = (translate: Translate, text: string): string => translate(text) ?? text;

/** A value keeps its English name, by which sheets know it. */
const parameterInGerman = (parameter: Parameter): Parameter => ({
  ...parameter,
  doc: said(docOf, parameter.doc),
  bound: said(boundOf, parameter.bound),
});

/** A command in German; one that a shop has added keeps its own words. */
export function commandInGerman(entry: CommandEntry): CommandEntry {
  const name = nameOf(entry.name);
  if (name === undefined) return entry;
  const doc = commandDocs[entry.letters] ?? entry.doc;
  return { ...entry, name, doc, parameters: entry.parameters.map(parameterInGerman) };
}

/** The commands in the language of the page. */
export const commandWords = (table: readonly CommandEntry[]): readonly CommandEntry[] =>
  language === "de" ? table.map(commandInGerman) : table;

/** The name of a value of commands in the language of the page. */
export const parameterWords = (name: string): string =>
  language === "de" ? said(parameterOf, name) : name;

/** A word that a value may be, in the language of the page. */
export const choiceWords = (word: string): string =>
  language === "de" ? (choices[word] ?? word) : word;

/** Explanation of a word of a text by the server: a command's letters and name, its values, its effect. */
export function hoverWords(text: string): string {
  const [, letters = "", name = "", values = ""] = /^(\w\w): ([^\n]*)\n([^\n]*)\n/.exec(text) ?? [];
  const doc = commandDocs[letters];
  if (language !== "de" || doc === undefined) return text;
  const names = values.split(", ").map((value) => said(parameterOf, value));
  return `${letters}: ${said(nameOf, name)}\n${names.join(", ")}\n${doc}`;
}

/** Completions that the server offers, in the language of the page. */
export function offerWords({ label, kind, detail, doc }: Completion): Completion {
  if (language !== "de" || kind !== "command") return { label, kind, detail, doc };
  return { label, kind, detail: said(nameOf, detail), doc: commandDocs[label] ?? doc };
}

/** Texts of a command without German words. */
export const untold = ({ letters, name, parameters }: CommandEntry): string[] => {
  const words = parameters.flatMap(({ kind }) => (kind.is === "choice" ? kind.words : []));
  return [
    ...(nameOf(name) && commandDocs[letters] ? [] : [`${letters} ${name}`]),
    ...parameters.map((one) => one.name).filter((one) => !parameterOf(one)),
    ...parameters.map(({ doc }) => doc).filter((doc) => doc !== "" && !docOf(doc)),
    ...parameters.map(({ bound }) => bound).filter((one) => /[a-z]/.test(one) && !boundOf(one)),
    ...words.filter((word) => /[a-z]{3}/.test(word) && !choices[word] && !units.includes(word)),
  ];
};

/** Kinds of files that are chosen by their endings. */
const units = ["sbp"];
