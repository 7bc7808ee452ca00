/** Sentences of findings in German, where a code and the values alone do not say enough. */

export const findingSentences: Readonly<Record<string, string>> = {
  "{0} would reach {1}, the table limit is {2} (table base coordinates)":
    "{0} käme nach {1}, die Tischgrenze ist {2} (Koordinaten des Tisches)",
  "Out of bounds: {0} would reach {1}, it ends at {2} (from home)":
    "Außerhalb: {0} käme nach {1} und endet bei {2} (vom Referenzpunkt)",
  "{0} takes {1}, this is one too many": "{0} nimmt {1}; das ist einer zu viel",
  "no values": "keine Werte",
  "1 value": "1 Wert",
  "{0} values": "{0} Werte",
  "there is no label {0}": "Die Marke {0} gibt es nicht",
  "unknown command or missing separator: {0}": "Unbekannter Befehl, oder ein Komma fehlt: {0}",
  "nobody answers '{0}' here: 0 is taken": "Niemand antwortet hier auf »{0}«: 0 gilt",
  "file #{0} is already open": "Die Datei #{0} ist schon offen",
  "variable &{0} has no value": "Die Variable &{0} hat keinen Wert",
  "{0} has no value": "{0} hat keinen Wert",
  "{0} has no result for {1}": "{0} hat für {1} kein Ergebnis",
  "the calculation has no finite result": "Die Rechnung hat kein endliches Ergebnis",
  "The spindle is about to start.": "Die Spindel läuft gleich an.",
  "Set spindle {0} to {1} rpm.": "Die Spindel {0} auf {1} U/min stellen.",
  "Continue?": "Weiter?",
};
