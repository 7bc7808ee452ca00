/** Sentences of the server about drawings, in German; a test looks that the server says each of them. */

export const drawingSentences: Readonly<Record<string, string>> = {
  "no shapes selected: choose some with `select` first":
    "Keine Form ist gewählt: zuerst welche auswählen.",
  "there is no shape {0}: the drawing has {1}":
    "Die Form {0} gibt es nicht: die Zeichnung hat {1}.",
  "shape {0} is named twice": "Die Form {0} ist zweimal genannt.",
  "shape {0} is not picked": "Die Form {0} ist nicht gewählt.",
  "{0} are the same place": "{0} sind derselbe Ort.",
  "the two points of the mirror line": "Die zwei Punkte der Spiegellinie",
  "all points of the line": "Alle Punkte der Linie",
  "nothing was picked: choose shapes or groups with `pick` first":
    "Nichts ist gewählt: zuerst Formen oder Ebenen für die Reihenfolge wählen.",
  "{0} was not read: files cannot be loaded from here":
    "{0} wurde nicht gelesen: von hier lassen sich keine Dateien laden.",
  "clipboard empty: copy shapes to it with `clip`, or a file with `load-clipboard`, first":
    "Die Zwischenablage ist leer: zuerst Formen oder eine Datei hineinlegen.",
  "all eight groups have shapes: say with group= which one the paths belong to":
    "Alle acht Ebenen haben Formen: sagen, zu welcher die Bahnen gehören.",
  "group {0} has shapes and an offset, rough pass, double line, tag or lead: paths that clear an area need a group without; choose another one with group=":
    "Die Ebene {0} hat Formen und einen Versatz, Schruppen, Doppellinie, Stege oder Anläufe: Bahnen, die eine Fläche räumen, brauchen eine Ebene ohne; eine andere wählen.",
  "group {0} has shapes that are cut through the sheet: say depth=thru where the area is to fall out, or choose another group with group= and say how deep with depth=2":
    "Die Ebene {0} hat Formen, die durch das Blech gehen: als Tiefe »durch« sagen, wenn die Fläche herausfallen soll, oder eine andere Ebene und die Tiefe.",
  "group {0} has shapes of another height: choose another group with group=, or change the height of all its shapes first":
    "Die Ebene {0} hat Formen anderer Höhe: eine andere wählen oder zuerst die Höhe aller ihrer Formen ändern.",
  "all eight groups have shapes and are on: none is left for the outlines, which are not to be cut; say cut-outlines to cut them too, or switch a group off":
    "Alle acht Ebenen haben Formen und sind ein: für die Umrisse, die nicht geschnitten werden, bleibt keine. Umrisse auch schneiden, oder eine Ebene ausschalten.",
  "nothing to {0}": "Nichts zum Zurücknehmen oder Wiederholen.",
  "shape {0}{1}: {2}": "Form {0}{1}: {2}",
  " at {0},{1}": " bei {0},{1}",
  "group {0}: {1}": "Ebene {0}: {1}",
  "{0} is {1}: it must be {2}": "{0} ist {1}: erlaubt ist {2}.",
  "{0} is missing": "{0} fehlt.",
  "1 or more": "1 oder mehr",
  "above 0": "über 0",
  "other than 0": "nicht 0",
};
