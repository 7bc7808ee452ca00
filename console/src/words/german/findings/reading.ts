/** Findings about the text of a part file in OpenSBP, in German. */

import { type FindingText, told } from "./finding";

const unreadable: Readonly<Record<string, FindingText>> = {
  S001: told(
    "Keine Textdatei",
    "Ein Programm ist reiner Text. Die Datei in dem Programm öffnen, das sie schrieb, und als Text speichern.",
  ),
  S002: told(
    "Unbekannter Befehl",
    "Die Zeile beginnt mit keinem Befehl von OpenSBP, oder Befehl und erster Wert stehen ohne Komma beisammen.",
  ),
  S003: told(
    "Unbekannte Anweisung",
    "Ein Befehl, eine Zuweisung, eine Marke oder eine Anweisung gehört hierher. ELSE, WHILE und FOR gibt es nicht: IF ... THEN GOTO.",
  ),
  S004: told(
    "Die Zeile lässt sich nicht lesen",
    "Ein Teil der Zeile passt nicht zu dem, was hier stehen kann.",
  ),
  S005: told(
    "Ein Anführungszeichen fehlt",
    "Text in doppelten Anführungszeichen endet in derselben Zeile.",
  ),
  S006: told("Eine Klammer ist offen", "Zu jeder ( gehört eine ) in derselben Zeile."),
  S007: told(
    "Der Ausdruck lässt sich nicht lesen",
    "Ein Rechenzeichen oder ein Wert fehlt, oder ein Zeichen gehört nicht hinein.",
  ),
  S008: told(
    "Unbekannte Funktion",
    "Funktionen: SQR ABS INT FIX SGN EXP LOG SIN COS TAN ATN RND ASIN ACOS ATAN SQRT ROUND FLOOR CEIL PI. Winkel sind Radiant.",
  ),
  S009: told("Zu viele Werte", "Der Befehl nimmt weniger Werte, als die Zeile nennt."),
  S010: told("Ein nötiger Wert fehlt", "Dieser Wert hat keine Vorgabe: ihn angeben."),
  S011: told(
    "Zeichen im Namen einer Variablen nicht erlaubt",
    "Eine Variable ist & mit Buchstaben, Ziffern und Unterstrichen dahinter.",
  ),
  S012: told("THEN fehlt", "IF braucht sein THEN in derselben Zeile: IF &a > 1 THEN GOTO Fertig."),
  S013: told("Mehr als ein Befehl in der Zeile", "Jede Zeile hat einen Befehl: neu umbrechen."),
  S014: told(
    "Systemvariablen lassen sich nur lesen",
    "Befehle mit V ändern die Maschine: VA Orte, VS Geschwindigkeiten.",
  ),
  S015: told(
    "Die Zeile ist zu lang",
    "Zeilen mit mehr als einer Million Zeichen werden abgelehnt.",
  ),
};

const doubtful: Readonly<Record<string, FindingText>> = {
  W001: told(
    "Eine Marke steht mehrmals da",
    "Sprünge gehen zur ersten; den anderen einen eigenen Namen geben.",
  ),
  W002: told(
    "Sprung zu einer Marke, die es nicht gibt",
    "Wird der Sprung ausgeführt, ist er ein Fehler.",
  ),
  W003: told(
    "Angenommen, aber zweifelhaft geschrieben",
    "Alte Programme nahmen es an, darum auch Kerf. Besser die übliche Schreibweise.",
  ),
  W004: told(
    "Systemvariable ohne Bedeutung",
    "Diese Nummer bedeutet nichts; sie ergibt leeren Text.",
  ),
  W005: told(
    "Die Einheit wird nicht geprüft",
    "Das Programm prüft %(25) nicht: auf einer Maschine mit der anderen Einheit schneidet es in falscher Größe.",
  ),
  W006: told(
    "Eilgang unter der Oberfläche",
    "Unter Z 0 kann ein Eilgang durch das Material laufen: vorher Z heben.",
  ),
  W007: told(
    "Schnitt mit stehender Spindel",
    "Das Programm schneidet, schaltet die Spindel aber nie ein (C6, SO,1,1).",
  ),
  W008: told(
    "Einheiten passen nicht zusammen",
    "Das Programm sagt, es sei in der anderen Einheit geschrieben als eingestellt.",
  ),
  W009: told(
    "Ein Zähler mit Bruch wird auf Gleichheit geprüft",
    "Wiederholt addierte Brüche treffen einen Wert selten genau: mit < oder > prüfen.",
  ),
  W010: told(
    "Eine Schleife ohne Bewegung",
    "Das Programm springt zurück, ohne zu fahren, zu warten oder zu fragen.",
  ),
  W011: told(
    "Werte in der Reihenfolge einer älteren Fassung",
    "Programme für ältere Fassungen nannten diese Werte in anderer Folge.",
  ),
  W012: told(
    "Ein Eintauchen, das hebt",
    "Der Wert führt das Werkzeug nach oben. Eintauchen ist negativ, wenn VC nichts anderes sagt.",
  ),
  W013: told("Text, der nicht gelesen wird", "Der Rest der Zeile wird übergangen."),
  W014: told("Ungewöhnlicher Wert", "Der Wert ist erlaubt, nützt aber wenig oder ist gewagt."),
  W015: told("Eine Fahrt ohne Ziel", "Der Befehl nennt keinen Ort."),
  W016: told(
    "In einem anderen Dialekt bedeutet es etwas anderes",
    "Andere Programme lesen diese Zeile anders.",
  ),
  W017: told(
    "Ein Befehl, der in einem Programm nichts tut",
    "Hilfe und andere Seiten öffnen sich nur für den, der tippt. Das Programm läuft weiter.",
  ),
  W018: told(
    "Eine Zeile, die nie erreicht wird",
    "Die Zeile davor endet oder springt weg, und keine Marke steht dazwischen.",
  ),
  W019: told(
    "Eine Variable, der das Programm keinen Wert gibt",
    "Es geht nur, wenn ein anderes Programm sie vorher gesetzt hat.",
  ),
  W020: told(
    "Ein Klang, den es nicht gibt",
    "PLAY nennt eine Datei, die nirgends liegt. Das Programm läuft ohne sie weiter.",
  ),
  W021: told(
    "Werte, die nicht bleiben",
    "Die Einstellungen sind durch ein Passwort geschützt: am Ende des Programms sind sie wie zuvor.",
  ),
  W022: told("Die Datei ist leer", "Sie dort noch einmal speichern, wo sie gemacht wurde."),
  W023: told(
    "0 steht für eine Antwort",
    "Das Programm fragt nach einem Wert. Für das Ansehen lassen sich Beispielantworten eingeben; ein Lauf fragt trotzdem.",
  ),
};

export const readingFindings: Readonly<Record<string, FindingText>> = {
  ...unreadable,
  ...doubtful,
};
