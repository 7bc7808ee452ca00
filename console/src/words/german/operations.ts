/** The operations of drawings in German: their names, what they do, the labels of their values, their words. */

import { type SettingText, said } from "./settingText";

const arranging: Readonly<Record<string, SettingText>> = {
  select: said("Auswählen", "wählt die Formen, auf die die nächsten Operationen wirken"),
  move: said(
    "Verschieben",
    "verschiebt die gewählten Formen um einen Abstand oder von einem Bezugspunkt zu einem anderen",
  ),
  copy: said("Kopieren", "fügt verschobene Kopien der gewählten Formen hinzu"),
  rotate: said(
    "Drehen",
    "dreht die gewählten Formen gegen den Uhrzeigersinn, um den Ursprung, wenn nichts anderes gesagt ist; »bis« dreht sie so, dass die Linie zwischen zwei Punkten den Winkel erhält",
  ),
  scale: said(
    "Skalieren",
    "macht die gewählten Formen größer; 25.4 macht Millimeter aus Zoll; »bis« skaliert so, dass die Linie zwischen zwei Punkten die Länge erhält",
  ),
  mirror: said(
    "Spiegeln",
    "spiegelt die gewählten Formen an einer Linie; geschlossene behalten ihre Schnittrichtung, außer mit »roh«",
  ),
  erase: said("Löschen", "entfernt die gewählten Formen"),
  array: said(
    "Vervielfachen",
    "fügt die gewählten Formen noch einmal in Zeilen und Spalten oder um eine Mitte hinzu; Block und Auftrag wiederholen die ganze Zeichnung, wenn die Bahnen entstehen",
  ),
  justify: said(
    "Ausrichten",
    "schiebt die Zeichnung an den Ursprung; mit ihren 3D-Formen unter die Oberfläche oder auf den Grund",
  ),
  rotate90: said("Vierteldrehung", "dreht die Zeichnung um ein Viertel und richtet sie links aus"),
  "mirror-drawing": said(
    "Zeichnung spiegeln",
    "spiegelt die Zeichnung von links nach rechts und richtet sie links aus",
  ),
  origin: said(
    "Ursprung",
    "macht einen Ort zum Ursprung, oder gibt den zurück, mit dem sie gelesen wurde",
  ),
};

const shaping: Readonly<Record<string, SettingText>> = {
  fillet: said("Abrunden", "rundet die Ecken der gewählten Formen, oder die nächste an einem Ort"),
  chamfer: said(
    "Abschrägen",
    "schneidet die Ecken der gewählten Formen ab, oder die nächste an einem Ort",
  ),
  offset: said(
    "Versetzen",
    "ersetzt die gewählten Formen durch Bahnen rechts der Laufrichtung, negativ links",
  ),
  join: said(
    "Verbinden",
    "verbindet die gewählten offenen Formen an nahen Enden, mit einer Linie oder in einem Punkt",
  ),
  break: said("Trennen", "öffnet dort eine geschlossene Form, macht zwei aus einer offenen"),
  trim: said(
    "Stutzen",
    "nimmt dort das Stück einer Form heraus, zwischen den Treffpunkten mit den gewählten",
  ),
  bulge: said("Wölben", "gibt dem Stück dort eine andere Wölbung; 0 ist eine Linie"),
  radius: said("Radius", "gibt dem Stück dort einen anderen Radius"),
  vertex: said("Punkt verschieben", "verschiebt den Punkt, der einem Ort am nächsten liegt"),
  stretch: said(
    "Strecken",
    "verschiebt die Punkte der gewählten Formen in einem Fenster oder nahe bei Orten",
  ),
  "delete-vertices": said(
    "Punkte löschen",
    "nimmt die Punkte nahe bei Orten aus einer flachen Form",
  ),
  circle: said("Kreis", "fügt einen Kreis hinzu"),
  rect: said("Rechteck", "fügt ein Rechteck hinzu, das an der ersten Ecke beginnt"),
  point: said("Bohrpunkt", "fügt einen Ort zum Bohren hinzu"),
  line: said(
    "Linie",
    "fügt Linien hinzu, »schließen« schließt sie; mit einer Wölbung ist das Stück dahinter ein Bogen, X,Y allein beginnt eine Linie",
  ),
  line3d: said(
    "Linie in 3D",
    "fügt gerade Linien hinzu, mit der Höhe jedes Punkts über der Oberfläche; »schließen« schließt sie",
  ),
};

const cutting: Readonly<Record<string, SettingText>> = {
  reverse: said("Umkehren", "kehrt die Schnittrichtung der gewählten Formen um"),
  directions: said(
    "Richtungen",
    "lässt äußere Formen gegen den Uhrzeigersinn laufen und die darin mit ihm",
  ),
  start: said("Anfang", "lässt den Schnitt einer Form an ihrer nächsten Stelle beginnen"),
  pause: said("Pause", "lässt die Maschine vor den gewählten Formen halten"),
  group: said("Ebene", "legt die gewählten Formen in eine Ebene"),
  "copy-to": said("Kopieren in", "fügt Kopien der gewählten Formen in einer Ebene hinzu"),
  set: said("Einstellen", "ändert, wie eine Ebene geschnitten wird; Millimeter, mm/min, Grad"),
  engrave: said(
    "Gravieren",
    "fügt Bahnen hinzu, die die Flächen der gewählten oder aller Formen mit diesem Durchmesser räumen, Löcher ausgenommen, so tief unter der Oberfläche; die Bahnen kommen in eine Ebene, die sie schneidet, wie sie sind, die Umrisse in eine, die aus ist, wenn sie nicht auch geschnitten werden sollen",
  ),
  pocket: said(
    "Tasche",
    "wie Gravieren, im Gleichlauf andersherum, mit »nach außen« von der Mitte zur Wand; mit »Zickzack« in Linien unter einem Winkel und danach an den Wänden entlang, wo so viel zum Schlichten bleibt",
  ),
  sequence: said(
    "Reihenfolge",
    "ändert, in welcher Folge Formen geschnitten werden; »Weg« sucht die kürzeste Zeit zwischen den Schnitten, mit »Anfänge« auch, wo geschlossene Formen beginnen",
  ),
  pick: said(
    "Reihenfolge wählen",
    "beginnt eine neue Folge, Form für Form oder Ebene für Ebene, oder setzt sie fort; nimmt man eine Form einer gewählten Ebene weg, geht die Ebene zurück; Reihenfolge mit »gewählt« stellt Gewähltes voran",
  ),
  clip: said("In die Zwischenablage", "legt Kopien der gewählten Formen in die Zwischenablage"),
  "load-clipboard": said(
    "Zwischenablage laden",
    "legt die Formen einer Datei .dxf, .svg, .rsg oder .rsm in die Zwischenablage; die Zeichnung bleibt, wie sie ist",
  ),
  "clear-clipboard": said("Zwischenablage leeren", "leert die Zwischenablage"),
  paste: said(
    "Einfügen",
    "fügt die Formen der Zwischenablage ein, links unten an den Ort; »absolut«: ihren Ursprung",
  ),
  comment: said("Kommentar", "setzt die Kommentare der Zeichnung, Zeilen mit | getrennt"),
};

export const operationTexts: Readonly<Record<string, SettingText>> = {
  ...arranging,
  ...shaping,
  ...cutting,
};

/** Words before the values of operations, as the labels of their fields. */
export const operationLabels: Readonly<Record<string, string>> = {
  About: "Um",
  Absolute: "Absolut",
  Accel: "Beschleunigung",
  All: "Alle",
  At: "Bei",
  Auto: "Selbsttätig",
  Bottom: "Unten",
  By: "Um",
  Cad: "Wie gezeichnet",
  Climb: "Gleichlauf",
  Close: "Schließen",
  Crossing: "Kreuzend",
  "Cut outlines": "Umrisse schneiden",
  Cut: "Schnitt",
  Cutter: "Fräser",
  Depth: "Tiefe",
  Double: "Doppelt",
  Finish: "Schlichten",
  From: "Von",
  Gap: "Lücke",
  Layer: "Ebene",
  Layers: "Ebenen",
  Height: "Höhe",
  Keep: "Behalten",
  "Lead in": "Anfahrt",
  "Lead out": "Abfahrt",
  Left: "Links",
  Level: "Höhe",
  Lift: "Heben",
  None: "Keine",
  Of: "Von",
  Offset: "Versatz",
  On: "Ein",
  Order: "Folge",
  Outward: "Nach außen",
  Overlap: "Überlappung",
  Pass: "Durchgang",
  Picked: "Gewählt",
  Plunge: "Eintauchen",
  Raw: "Roh",
  Rect: "Rechteck",
  Remove: "Wegnehmen",
  Reverse: "Umgekehrt",
  Rough: "Schruppen",
  Round: "Rund",
  Size: "Größe",
  Spacing: "Abstand",
  Speed: "Geschwindigkeit",
  Start: "Anfang",
  Starts: "Anfänge",
  Surface: "Oberfläche",
  Tab: "Steg",
  To: "Bis",
  "Tool change": "Werkzeugwechsel",
  Tool: "Werkzeug",
  Travel: "Weg",
  Traversal: "Höhe der Wege",
  Tries: "Versuche",
  Window: "Fenster",
  Zigzag: "Zickzack",
  Angle: "Winkel",
  Distance: "Abstand",
  Factor: "Faktor",
  Length: "Länge",
  "Mm/s": "mm/s",
  "Mm/s2": "mm/s²",
  Radius: "Radius",
  S: "Sekunden",
};

/** Words that a value of an operation may be. */
export const operationWords: Readonly<Record<string, string>> = {
  "3d": "3D",
  add: "dazu",
  all: "alle",
  auto: "selbsttätig",
  bl: "unten links",
  br: "unten rechts",
  tl: "oben links",
  tr: "oben rechts",
  block: "Block",
  job: "Auftrag",
  row: "Zeile",
  column: "Spalte",
  "row-snake": "Zeilen hin und her",
  "column-snake": "Spalten hin und her",
  keep: "behalten",
  max: "größte",
  merge: "in einem Punkt",
  none: "keine",
  off: "aus",
  on: "ein",
  remove: "weg",
  thru: "durch",
  through: "durch",
};

/** The colours by which layers are called. */
export const colours: Readonly<Record<string, string>> = {
  black: "Schwarz",
  blue: "Blau",
  green: "Grün",
  cyan: "Cyan",
  red: "Rot",
  magenta: "Magenta",
  brown: "Braun",
  white: "Weiß",
};
