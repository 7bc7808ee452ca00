/** Sentences of the operations on drawings, in German. */

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
    "Die Ebene {0} hat Formen und einen Versatz, Schruppen, Doppellinie, Stege, An- oder Abfahrten: Bahnen, die eine Fläche räumen, brauchen eine Ebene ohne; eine andere wählen.",
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
  "what comes of it is no shape: {0}": "was herauskommt, ist keine Form: {0}",
  "the number of shapes of the drawing": "die Zahl der Formen der Zeichnung",
  "a million at the most": "höchstens eine Million",
  "the number of vertices of the drawing": "die Zahl der Punkte der Zeichnung",
  "10 million at the most": "höchstens 10 Millionen",
  "the gap between the {0} of the {1} array is {2} mm: it must be above {3} mm, so that they do not lie on each other":
    "der Abstand der {0} in der Anordnung ({1}) ist {2} mm: er muss über {3} mm sein, damit sie nicht aufeinander liegen",
  "the number of rows": "die Zahl der Zeilen",
  "the number of columns": "die Zahl der Spalten",
  "the number of blocks": "die Zahl der Blöcke",
  "zigzag=ANGLE, which finish= needs,": "der Winkel der Zeilen, den das Schlichten braucht,",
  "cut-outlines, or tool=, depth=, overlap= or group= with its value, such as tool=5, depth=2 (millimetres below ZSurface) or depth=thru":
    "Umrisse schneiden, Werkzeug, Tiefe, Überlappung oder Ebene",
  "climb, outward, cut-outlines, or tool=, depth=, overlap=, zigzag=, finish= or group= with its value, such as tool=5, depth=2 (millimetres below ZSurface) or depth=thru":
    "Gleichlauf, von innen, Umrisse schneiden, Werkzeug, Tiefe, Überlappung, Zeilen, Schlichten oder Ebene",
  "the diameter of the tool": "der Durchmesser des Werkzeugs",
  "shape {0}: a tool of {1} mm does not fit into it":
    "Form {0}: ein Werkzeug von {1} mm passt nicht hinein",
  "group {0} was cut by a cutter of {1} mm, now of {2} mm":
    "die Ebene {0} wurde von einem Fräser von {1} mm geschnitten, jetzt von einem mit {2} mm",
  "how deep is not said: the paths of group {0} only touch ZSurface; say depth=2 or set the group's height":
    "wie tief, ist nicht gesagt: die Bahnen der Ebene {0} berühren nur ZSurface; eine Tiefe nennen, oder die Höhe der Ebene setzen",
  "{0} in group {1} now, which is off: only the area is cut; cut-outlines cuts them too":
    "{0} jetzt in der Ebene {1}, die aus ist: nur die Fläche wird geschnitten; »Umrisse schneiden« schneidet sie auch",
  "outline {0} is": "Umriss {0} ist",
  "outlines {0} and {1} more are": "die Umrisse {0} und {1} weitere sind",
  "{0} shapes of {1} are on the clipboard": "{0} von {1} Formen sind in der Zwischenablage",
  "the number of shapes": "die Zahl der Formen",
  "the number of vertices": "die Zahl der Punkte",
  "5 million at the most": "höchstens 5 Millionen",
  "the radius": "der Radius",
  "the width": "die Breite",
  "the height": "die Höhe",
  "shape {0}: a segment without length{1} is left out":
    "Form {0}: ein Segment ohne Länge{1} wird ausgelassen",
  "the length": "die Länge",
  "the distance": "der Abstand",
  "ZBottom above ZSurface": "ZBottom über ZSurface",
  "0 or below": "0 oder darunter",
  "no corner": "keine Ecke",
  "in the selected shapes": "in den gewählten Formen",
  "only flat shapes can be changed so; it is a 3D shape":
    "nur flache Formen lassen sich so ändern; dies ist eine 3D-Form",
  "nothing is left of it at {0} mm": "bei {0} mm bleibt nichts von ihr",
  "it is a point": "sie ist ein Punkt",
  "it ends there": "sie endet dort",
  "{0}: there is nothing to break": "{0}: es gibt nichts zu trennen",
  "shapes {0} and {1} cross each other: check their directions":
    "die Formen {0} und {1} kreuzen einander: ihre Richtungen prüfen",
  "shape {0}{1}: only closed flat shapes bound an area; it is left out":
    "Form {0}{1}: nur geschlossene flache Formen begrenzen eine Fläche; sie wird ausgelassen",
  "shape {0} lies on shape {1}: it is left out":
    "Form {0} liegt auf Form {1}: sie wird ausgelassen",
  "shape {0}{1} crosses itself": "Form {0}{1} kreuzt sich selbst",
  "shapes {0} and {1} cross each other: their areas are one":
    "die Formen {0} und {1} kreuzen einander: ihre Flächen sind eine",
  "an outer shape": "eine äußere Form",
  "directions not set: {0} must run {1}; use `directions auto` first, or `reverse` where a hole is taken for itself":
    "die Richtungen stimmen nicht: {0} muss {1} laufen; zuerst die Richtungen setzen, oder umkehren, wo ein Loch für sich steht",
  "travel {0}, now {1}": "Weg {0}, jetzt {1}",
  "group {0} has no shapes": "die Ebene {0} hat keine Formen",
  "it does not lie in the same shape as shape {0}":
    "sie liegt nicht in derselben Form wie Form {0}",
  "shape {0} is cut before shape {1}, which lies in it":
    "Form {0} wird vor Form {1} geschnitten, die in ihr liegt",
  "the place to begin near": "der Ort, in dessen Nähe begonnen wird",
  "the list of groups": "die Liste der Ebenen",
  "a list of groups such as red,black": "eine Liste von Ebenen wie red,black",
  "where the head comes from": "woher der Kopf kommt",
  "a setting of the search": "eine Angabe der Suche",
  "starts, speed=MM/S, accel=MM/S2, lift=S, tool-change=S or tries=N":
    "Anfänge, Geschwindigkeit, Beschleunigung, Hubzeit, Werkzeugwechsel oder Versuche",
  "a radius of {0} is less than half of the chord, {1}":
    "ein Radius von {0} ist weniger als die halbe Sehne, {1}",
  "no vertex of the selected shapes": "kein Punkt der gewählten Formen",
  "in the window": "im Fenster",
  "vertices can be deleted from flat shapes only; it is a 3D shape":
    "Punkte lassen sich nur aus flachen Formen löschen; dies ist eine 3D-Form",
  "{0} vertices would be left: too few": "{0} Punkte blieben: zu wenige",
  "it has no segments": "sie hat keine Segmente",
  "it has no vertices": "sie hat keine Punkte",
  "a point as x,y": "ein Punkt als x,y",
  "a distance as x,y": "ein Abstand als x,y",
  "the number of a shape": "die Nummer einer Form",
  "the number of a shape, from 1": "die Nummer einer Form, ab 1",
  "the list of shapes": "die Liste der Formen",
  "a list of shapes such as 1,3-5": "eine Liste von Formen wie 1,3-5",
  "at least a 10,000th of the height": "mindestens ein Zehntausendstel der Höhe",
  "0 mm or more": "0 mm oder mehr",
  "lead-in radius": "Radius der Anfahrt",
  "lead-in angle": "Winkel der Anfahrt",
  "lead-out radius": "Radius der Abfahrt",
  "lead-out angle": "Winkel der Abfahrt",
  "plunge angle": "Winkel des Eintauchens",
  "plunge radius": "Radius des Eintauchens",
  "a number other than 0": "eine Zahl außer 0",
  "group {0} is 3D now: its shapes have heights of their own":
    "die Ebene {0} ist jetzt 3D: ihre Formen haben eigene Höhen",
  "shapes with heights of their own are in group {0}, which is 3D; group {1} has flat shapes too":
    "Formen mit eigenen Höhen sind in der Ebene {0}, die 3D ist; die Ebene {1} hat auch flache Formen",
  "group {0} has flat shapes and shapes with heights of their own, which are cut flat: no group is free; empty one, put them into it and give it the height 3D":
    "die Ebene {0} hat flache Formen und solche mit eigenen Höhen, die flach geschnitten werden: keine Ebene ist frei; eine leeren, sie hineinlegen und ihr die Höhe 3D geben",
  " with 1 tool change": " mit 1 Werkzeugwechsel",
  " with {0} tool changes": " mit {0} Werkzeugwechseln",
  "the speed": "die Geschwindigkeit",
  "the acceleration": "die Beschleunigung",
  "0 or more": "0 oder mehr",
  "the time of a lift": "die Zeit eines Hubs",
  "the time of a tool change": "die Zeit eines Werkzeugwechsels",
  "{0} lines of comment: a drawing keeps 10 at the most":
    "{0} Zeilen Bemerkung: eine Zeichnung behält höchstens 10",
  "line {0} of the comment has {1} characters: 50 at the most":
    "Zeile {0} der Bemerkung hat {1} Zeichen: höchstens 50",
  "{0} {1}: nothing would change": "{0} {1}: nichts würde sich ändern",
  "`{0}` is not {1}": "»{0}« ist nicht {1}",
  "`{0}` is one word too many": "»{0}« ist ein Wort zu viel",
  "{0} is {1}: a group has the outputs 1, 2 and 3":
    "{0} ist {1}: eine Ebene hat die Ausgänge 1, 2 und 3",
  "multi-pass needs height type MM: set the height to a depth in millimetres first":
    "mehrere Durchgänge brauchen eine Höhe in Millimetern: zuerst der Höhe eine Tiefe geben",
};
