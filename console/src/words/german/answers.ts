/** Buttons and titles of questions that Kerf asks by itself, in German. */

export const answerButtons: Readonly<Record<string, string>> = {
  OK: "OK",
  Cancel: "Abbrechen",
  Abort: "Aufgeben",
  Retry: "Noch einmal",
  Ignore: "Übergehen",
  Yes: "Ja",
  No: "Nein",
  Continue: "Weiter",
  End: "Ende",
  Resume: "Fortsetzen",
  Quit: "Beenden",
  Step: "Schritt",
  Run: "Durchlaufen",
};

export const questionTitles: Readonly<Record<string, string>> = {
  Location: "Ort",
  Homing: "Referenzieren",
  Resume: "Fortsetzen",
  Stopped: "Angehalten",
  Limits: "Grenzen",
  Job: "Auftrag",
};
