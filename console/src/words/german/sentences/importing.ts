/** Notes from reading files of other programs: DXF, SVG, HPGL, RSG, pictures, in German. */

export const importingSentences: Readonly<Record<string, string>> = {
  "cannot write {0}: {1}": "{0} lässt sich nicht schreiben: {1}",
  "{0} was not converted: {1}": "{0} wurde nicht umgewandelt: {1}",
  "line {0}: {1}": "Zeile {0}: {1}",
  ", white deepest": ", Weiß am tiefsten",
  ", black deepest": ", Schwarz am tiefsten",
  "{0} is no drawing": "{0} ist keine Zeichnung",
  "nothing is drawn in it": "nichts ist darin gezeichnet",
  "{0} x {1} dots on {2} x {3} mm": "{0} × {1} Bildpunkte auf {2} × {3} mm",
  "create the tool path first": "zuerst die Werkzeugwege machen",
  "tool path made with other smoothing values: the factor was {0} and is {1} now; make it anew from the drawing":
    "die Werkzeugwege wurden mit anderer Glättung gemacht: der Faktor war {0} und ist jetzt {1}; sie aus der Zeichnung neu machen",
  "ELLIPSE without a size: left out": "ELLIPSE ohne Größe: ausgelassen",
  "SPLINE with fewer than two different points: left out":
    "SPLINE mit weniger als zwei verschiedenen Punkten: ausgelassen",
  "SPLINE given only by points it goes through: drawn as the cubic spline through them":
    "SPLINE, die nur die Punkte nennt, durch die sie geht: als kubische Spline durch sie gezeichnet",
  "SPLINE: {0}: left out": "SPLINE: {0}: ausgelassen",
  "SPLINE: `{0}` is no number: left out": "SPLINE: `{0}` ist keine Zahl: ausgelassen",
  "{0} without the value of group code {1}: left out":
    "{0} ohne den Wert des Gruppencodes {1}: ausgelassen",
  ": left out": ": ausgelassen",
  ": taken for 0": ": als 0 genommen",
  "{0}: `{1}` is no number (group code {2})": "{0}: `{1}` ist keine Zahl (Gruppencode {2})",
  "the section before this one has no ENDSEC": "der Abschnitt davor hat kein ENDSEC",
  "the file breaks off within a section: what came after this line is lost":
    "die Datei bricht in einem Abschnitt ab: was nach dieser Zeile kam, ist verloren",
  "the file ends without EOF: something may be missing":
    "die Datei endet ohne EOF: vielleicht fehlt etwas",
  "the file is empty": "die Datei ist leer",
  "the file is no DXF": "die Datei ist kein DXF",
  "drawn in {0}: scaled by {1}": "gezeichnet in {0}: mit {1} vervielfacht",
  "(paper space)": "(Papierbereich)",
  "LINE without length: left out": "LINE ohne Länge: ausgelassen",
  "{0} of radius {1}: left out": "{0} mit Radius {1}: ausgelassen",
  "give it and the blocks within it fewer rows and columns, or draw the shapes without blocks":
    "ihm und den Blöcken darin weniger Zeilen und Spalten geben, oder die Formen ohne Blöcke zeichnen",
  "`{0}` is no entity that DXF has: left out": "`{0}` ist kein Element von DXF: ausgelassen",
  "{0}: {1}: left out": "{0}: {1}: ausgelassen",
  "{0} without length: left out": "{0} ohne Länge: ausgelassen",
  "block {0} is placed within itself, or too deep: left out":
    "der Block {0} steht in sich selbst, oder zu tief: ausgelassen",
  "LWPOLYLINE: `{0}` is no number": "LWPOLYLINE: `{0}` ist keine Zahl",
  "POLYLINE without SEQEND: it may be longer": "POLYLINE ohne SEQEND: vielleicht ist sie länger",
  "POLYLINE (mesh)": "POLYLINE (Netz)",
  "{0} with a broken vertex: left out, since its form is not known":
    "{0} mit einem kaputten Punkt: ausgelassen, denn ihre Form ist nicht bekannt",
  "{0}: segments without length left out: {1}, the first at {2}, {3}":
    "{0}: Segmente ohne Länge ausgelassen: {1}, das erste bei {2}, {3}",
  "{0} with fewer than two different points: left out":
    "{0} mit weniger als zwei verschiedenen Punkten: ausgelassen",
  "the file ends within a pair of code and value":
    "die Datei endet in einem Paar aus Code und Wert",
  "`{0}` stands where a group code should: a line before it is missing, or one too many":
    "`{0}` steht, wo ein Gruppencode stehen sollte: davor fehlt eine Zeile, oder es ist eine zu viel",
  "`{0}` is no group code; the line is passed over":
    "`{0}` ist kein Gruppencode; die Zeile wird übergangen",
  "{0} {1} left out: marked as invisible (group code 60)":
    "{0} {1} ausgelassen: als unsichtbar gekennzeichnet (Gruppencode 60)",
  "{0} {1} left out: layer `{2}` is {3} in the drawing":
    "{0} {1} ausgelassen: die Ebene `{2}` ist in der Zeichnung {3}",
  "{0} comes to more than {1} beyond those that the file writes: nothing of the drawing is read; {2}":
    "{0} ergibt mehr als {1} über die hinaus, die in der Datei stehen: nichts der Zeichnung wird gelesen; {2}",
  "and {0} more of the same": "und {0} weitere derselben Art",
  "nothing is drawn: no move with the pen down":
    "nichts ist gezeichnet: keine Bewegung mit abgesenktem Stift",
  "{0}: left out": "{0}: ausgelassen",
  "pen {0}": "Stift {0}",
  "SC without a size: the scale stays as it was": "SC ohne Größe: der Maßstab bleibt, wie er war",
  "X and Y have different scales: arcs become chords of 5 degrees":
    "X und Y haben verschiedene Maßstäbe: Bögen werden zu Sehnen von 5 Grad",
  "numbers are missing: the instruction is left out":
    "Zahlen fehlen: die Anweisung wird ausgelassen",
  "cut at Z {0} mm": "geschnitten bei Z {0} mm",
  "written by a later Kerf (version {0})": "von einem späteren Kerf geschrieben (Fassung {0})",
  "its own data cannot be read ({0})": "ihre eigenen Daten lassen sich nicht lesen ({0})",
  "{0}: read as a plain drawing, groups and arrays are lost":
    "{0}: als einfache Zeichnung gelesen, Ebenen und Anordnungen sind verloren",
  "shape {0}: its own data cannot be read, it is in group black":
    "Form {0}: ihre eigenen Daten lassen sich nicht lesen, sie ist in der schwarzen Ebene",
  "`{0}` of a page whose size is not told": "`{0}` einer Seite, deren Größe nicht genannt ist",
  "`{0}` is no length that Kerf reads": "`{0}` ist keine Länge, die Kerf liest",
  "the file is no SVG: {0}": "die Datei ist kein SVG: {0}",
  "the file is no SVG: it does not begin with <svg>":
    "die Datei ist kein SVG: sie beginnt nicht mit <svg>",
  "the transform of the page is passed over": "die Abbildung der ganzen Seite wird übergangen",
  "no width in mm or inches: 96 units to the inch":
    "keine Breite in mm oder Zoll: 96 Einheiten je Zoll",
  "elements within elements, more than {0}, or one within itself: left out":
    "Elemente in Elementen, mehr als {0}, oder eines in sich selbst: ausgelassen",
  "use it fewer times, or draw the shapes without <use>":
    "es seltener verwenden, oder die Formen ohne <use> zeichnen",
  "<{0}>{1} is hidden ({2}): left out": "<{0}>{1} ist verborgen ({2}): ausgelassen",
  "{0}: <{1}> is left out": "{0}: <{1}> wird ausgelassen",
  "<switch>: nothing in it is for readers like this one: left out":
    "<switch>: nichts darin ist für Leser wie diesen: ausgelassen",
  "<switch>: drawn is what line {0} has; other ways left out: {1}":
    "<switch>: gezeichnet wird, was Zeile {0} hat; andere Wege ausgelassen: {1}",
  "<use> of `{0}`, which is not there": "<use> von `{0}`, das es nicht gibt",
  "{0}: the rest is left out": "{0}: der Rest wird ausgelassen",
  "<{0}>: segments without length left out: {1}": "<{0}>: Segmente ohne Länge ausgelassen: {1}",
  "<{0}> has neither fill nor stroke and cannot be seen: drawn all the same":
    "<{0}> hat weder Füllung noch Strich und ist nicht zu sehen: trotzdem gezeichnet",
  "a path without length: left out": "ein Pfad ohne Länge: ausgelassen",
  "a style sheet in another file is not read":
    "ein Stylesheet in einer anderen Datei wird nicht gelesen",
  "more than {0} rules of style: the rest is not read":
    "mehr als {0} Stilregeln: der Rest wird nicht gelesen",
  "<style> of type `{0}` is not read": "<style> der Art `{0}` wird nicht gelesen",
  "a rule of style without its end is not read": "eine Stilregel ohne Ende wird nicht gelesen",
  "the selector `{0}` is not read": "der Selektor `{0}` wird nicht gelesen",
  "the rules of `@{0}` are not read": "die Regeln von `@{0}` werden nicht gelesen",
  "the file is compressed (.svgz): unpack it, or save it as plain SVG":
    "die Datei ist gepackt (.svgz): sie entpacken, oder als einfaches SVG speichern",
  "the style `{0}` is not read; write it as a transform":
    "der Stil `{0}` wird nicht gelesen; ihn als transform schreiben",
  "a transform-origin in the element's own box is not read":
    "ein transform-origin im Kasten des Elements wird nicht gelesen",
  "the style `transform: {0}` is not read": "der Stil `transform: {0}` wird nicht gelesen",
  "<text> is left out: turn it into paths in the program that drew it":
    "<text> wird ausgelassen: ihn im Zeichenprogramm in Pfade umwandeln",
  "<image> is left out: a picture has no outline; trace it, or cut it as a relief":
    "<image> wird ausgelassen: ein Bild hat keinen Umriss; es nachzeichnen, oder als Relief schneiden",
  "<foreignObject> is left out: what it holds is not SVG":
    "<foreignObject> wird ausgelassen: was es enthält, ist kein SVG",
  "{0} is not applied: what it would hide is drawn too":
    "{0} wirkt nicht: was es verbergen würde, wird auch gezeichnet",
  "markers (arrow heads) are left out": "Marken (Pfeilspitzen) werden ausgelassen",
  "the pattern of the fill is left out": "das Muster der Füllung wird ausgelassen",
  "a dashed line is drawn whole": "eine gestrichelte Linie wird durchgezogen",
  "groups and arrays will not be saved; .rsg keeps them":
    "Ebenen und Anordnungen werden nicht gespeichert; .rsg behält sie",
  "the picture cannot be read: {0}": "das Bild lässt sich nicht lesen: {0}",
  "{0} x {1} dots: 40 million at the most; make the picture smaller":
    "{0} × {1} Bildpunkte: höchstens 40 Millionen; das Bild verkleinern",
  "INSERT of block `{0}`": "INSERT des Blocks `{0}`",
  "INSERT of block `{0}`, which the file does not have: left out":
    "INSERT des Blocks `{0}`, den die Datei nicht hat: ausgelassen",
  "INSERT scaled to nothing: left out": "INSERT, auf nichts verkleinert: ausgelassen",
  "<use> of `{0}`": "<use> von `{0}`",
  "skipped: {0}": "übergangen: {0}",
  "layers: {0}": "Ebenen: {0}",
  inches: "Zoll",
  feet: "Fuß",
  millimetres: "Millimeter",
  centimetres: "Zentimeter",
  metres: "Meter",
  decimetres: "Dezimeter",
  micrometres: "Mikrometer",
  yards: "Yard",
};
