/** Texts of the editor in German, by their English ones. */
export const files: Readonly<Record<string, string>> = {
  program: "Programm",
  job: "Auftrag",
  drawing: "Zeichnung",
  text: "Text",
  failed: "fehlgeschlagen",
  stopped: "angehalten",
  "cut short": "abgebrochen",
  ", another text": ", ein anderer Text",
  "A click beside a line number, or F9, sets a breakpoint.":
    "Ein Klick neben eine Zeilennummer oder F9 setzt einen Haltepunkt.",
  "Also not saved:{0}": "Auch nicht gesichert:{0}",
  "Another page types into {0} too. Both texts are kept; the other one is listed as not saved.":
    "Eine andere Seite schreibt auch in {0}. Beide Texte bleiben; der andere steht als nicht gesichert in der Liste.",
  "Breakpoints: {0}": "Haltepunkte: {0}",
  "Checking…": "Wird geprüft…",
  Debugger: "Debugger",
  "Done, go on": "Fertig, weiter",
  "Drop changes": "Änderungen verwerfen",
  "Drop changes…": "Änderungen verwerfen…",
  "Drop the changes of {0}?": "Änderungen von {0} verwerfen?",
  "Go line by line": "Zeile für Zeile",
  "Name in the part folder": "Name im Ordner",
  "New file": "Neue Datei",
  "No mistakes found.": "Keine Fehler gefunden.",
  "Not checked: {0}.": "Nicht geprüft: {0}.",
  "Nothing was changed.": "Nichts wurde geändert.",
  "Save as…": "Sichern als…",
  "Save before running: what runs is the file.":
    "Vor dem Starten sichern: was läuft, ist die Datei.",
  "Save the new file first, or drop its changes.":
    "Erst die neue Datei sichern, oder ihre Änderungen verwerfen.",
  "Text of {0}": "Text von {0}",
  "The program waits": "Das Programm wartet",
  "The program waits while you edit": "Das Programm wartet, während du schreibst",
  "To the editor": "In den Editor",
  "What is typed is not kept by the server: {0}":
    "Was geschrieben wird, behält der Server nicht: {0}",
  "What was typed since it was saved is lost.":
    "Was seit dem Sichern geschrieben wurde, geht verloren.",
  "a new file": "eine neue Datei",
  "part.sbp": "teil.sbp",
  "the new file": "die neue Datei",
  "{0} of {1}": "{0} von {1}",
  "{0} was changed on the disk since this text was typed: Save asks before it is replaced.":
    "{0} wurde auf der Platte geändert, seit dieser Text geschrieben wurde: Sichern fragt, bevor sie ersetzt wird.",
  "· not saved": "· nicht gesichert",
  "Each line was checked by itself. Not checked: jumps, variables and units.":
    "Jede Zeile wurde für sich geprüft. Nicht geprüft: Sprünge, Variablen und Einheiten.",
  "Not checked yet: {0} % of the text.": "Noch nicht geprüft: {0} % des Textes.",
  "… and {0} more": "… und {0} weitere",
};
