/** Texts of the warm-up of the spindle. */

export const warmUp: Readonly<Record<string, string>> = {
  "Spindle warm-up: steps of speed and time": "Spindel warm laufen lassen: Drehzahlen und Zeiten",
  "Spindle warm-up": "Spindel warm laufen lassen",
  "End the warm-up": "Warmlauf beenden",
  "Start the warm-up": "Warmlauf beginnen",
  "Each step has a number of percent and minutes.":
    "Jeder Schritt hat eine Zahl für Prozent und für Minuten.",
  "The spindle turns where the machine stands, in these steps. STOP ends it with the spindle off. Nothing touches the tool, and everybody is clear of it?":
    "Die Spindel dreht, wo die Maschine steht, in diesen Schritten. STOPP beendet es mit abgeschalteter Spindel. Berührt nichts das Werkzeug, und ist niemand in seiner Nähe?",
  "Step {0}, speed": "Schritt {0}, Drehzahl",
  "Step {0}, time": "Schritt {0}, Zeit",
  "Take step {0} away": "Schritt {0} wegnehmen",
  "Add a step": "Schritt dazu",
  "They are kept.": "Sie sind gespeichert.",
  "Keep these steps": "Diese Schritte behalten",
  "{0} min in all": "{0} min zusammen",
  "The last file ran less than an hour ago.": "Die letzte Datei lief vor weniger als einer Stunde.",
  "The last file ran {0} h ago.": "Die letzte Datei lief vor {0} h.",
};
