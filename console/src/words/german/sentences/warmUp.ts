/** Sentences of the warm-up of the spindle. */

export const warmUpSentences: Readonly<Record<string, string>> = {
  "The usual steps are 25:2, 50:2, 75:2, 100:2.":
    "Die üblichen Schritte sind 25:2, 50:2, 75:2, 100:2.",
  "it has no spindle: {0}": "sie hat keine Spindel: {0}",
  "a warm-up has {0} steps at most": "ein Warmlauf hat höchstens {0} Schritte",
  "'{0}' is no step of a warm-up: give percent of the spindle's greatest speed, 1 to 100, and minutes, up to 120: 25:2, 50:2":
    "'{0}' ist kein Schritt eines Warmlaufs: Prozent der größten Drehzahl der Spindel, 1 bis 100, und Minuten, bis 120: 25:2, 50:2",
  "this spindle's speed is set by hand: it is on for {0} min":
    "die Drehzahl dieser Spindel wird von Hand eingestellt: sie ist {0} min an",
  "warm-up, step {0} of {1}: {2} rpm for {3} min, {4} min left":
    "Warmlauf, Schritt {0} von {1}: {2} U/min für {3} min, noch {4} min",
};
