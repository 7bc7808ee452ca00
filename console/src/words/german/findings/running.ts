/** Findings while a program runs, about its files and about its conversion, in German. */

import { type FindingText, told } from "./finding";

const running: Readonly<Record<string, FindingText>> = {
  R001: told(
    "Die Variable hat keinen Wert",
    "Ihr vor dieser Zeile einen Wert geben. Als Text ist sie leer.",
  ),
  R002: told("Eine Zahl wird erwartet", "Der Wert ist Text und keine Zahl."),
  R003: told("Division durch null", "Den Teiler vorher mit IF prüfen oder am Anfang setzen."),
  R004: told(
    "Die Rechnung hat kein Ergebnis",
    "Die Wurzel einer negativen Zahl, der Logarithmus von null oder ein viel zu großer Wert.",
  ),
  R005: told(
    "Die Marke gibt es nicht",
    "GOTO und GOSUB springen zu Marken derselben Datei: ein Name allein in der Zeile, mit Doppelpunkt.",
  ),
  R006: told(
    "RETURN ohne GOSUB",
    "RETURN geht hinter das letzte GOSUB dieser Datei. Vor das erste Unterprogramm gehört END.",
  ),
  R007: told(
    "Zu tief verschachtelt",
    "Höchstens acht Dateien sind ineinander offen. Ruft sich ein Unterprogramm ohne Ende selbst?",
  ),
  R008: told("Diese Systemvariable gibt es nicht", "Sie sind von 1 bis 161 nummeriert."),
  R009: told("Wert außerhalb der Grenzen", "Der Befehl nimmt diesen Wert nicht an."),
  R010: told("Falsche Art von Wert", "Der Befehl erwartet hier eine andere Art von Wert."),
  R011: told("Die Achse ist nicht in Gebrauch", "VD sagt, wie viele Achsen es gibt."),
  R012: told("Nur in Programmen", "Diese Anweisung hat nur in einem Programm einen Sinn."),
  R013: told(
    "Die Form lässt sich nicht schneiden",
    "Die Werte ergeben keine Form: ein Fräser größer als das Loch, ein Ende neben dem Kreis.",
  ),
  R014: told(
    "Zu viele Zeilen ausgeführt oder zu viele Bewegungen angesehen",
    "Läuft eine Schleife ohne Ende? Die Maschine führt ein solches Programm aus, bis sie angehalten wird.",
  ),
  R015: told("Vom Bediener beendet", "Eine Frage wurde abgebrochen, oder ein Wert fehlte."),
  R016: told("Nicht eingeschaltet", "Die Einstellungen haben diese Funktion ausgeschaltet."),
  R017: told("Geht hier nicht", "Diese Maschine oder dieses Programm kann das nicht."),
  R018: told(
    "Das Ende liegt nicht auf dem Kreis",
    "Ende und Mittelpunkt ergeben zwei verschiedene Radien.",
  ),
  R019: told(
    "Gelesene, aber nicht gefahrene Bewegung",
    "Ein Fehler in einer Folge von Fahrten heißt, dass keine davon gefahren wird.",
  ),
  R020: told("Das Programm gab auf", "Ein FAIL des Programms beendete den Lauf."),
  R021: told(
    "Nichts ist aufgezeichnet",
    "RP, RR und RS brauchen Befehle, die getippt wurden, während RA galt.",
  ),
  R022: told(
    "Die Einstellungen sind geschützt",
    "Diese Zeile ändert sie: zuerst bei den Einstellungen das Passwort angeben.",
  ),
};

const files: Readonly<Record<string, FindingText>> = {
  F001: told("Datei nicht gefunden", "Gesucht wird im Ordner der Programme, groß wie klein."),
  F002: told(
    "Datei außerhalb der erlaubten Ordner",
    "Gelesen und geschrieben wird nur im Ordner der Programme und in denen, die erlaubt sind.",
  ),
  F003: told("Die Nummer der Datei ist nicht offen", "OPEN gibt einer Datei ihre Nummer."),
  F004: told("Ende der Datei", "INPUT # las über den letzten Wert hinaus."),
  F005: told("Die Datei ist nicht zu gebrauchen", "Das System hat sie abgelehnt."),
  F006: told(
    "Andere Programme sind gesperrt",
    "SHELL führt nichts aus, solange es beim Start nicht erlaubt wurde.",
  ),
  F007: told(
    "Falsche Nummer einer Datei",
    "Nummern sind 1 bis 9, jede für eine Datei zur selben Zeit.",
  ),
};

const converting: Readonly<Record<string, FindingText>> = {
  C001: told(
    "Nicht in der anderen Sprache",
    "Die andere Sprache hat keine Worte dafür; ein Kommentar in der Datei sagt, was fehlt.",
  ),
  C002: told(
    "Das Programm beginnt dort, wo das Werkzeug steht",
    "Orte zählen, als hätte es auf null gestanden: es vor dem Lauf dorthin fahren.",
  ),
  C003: told(
    "Die umgewandelte Datei führe anders",
    "Nichts wurde geschrieben. Das ist ein Fehler von Kerf: bitte mit der Datei melden.",
  ),
  C004: told(
    "Etwas lässt sich nicht behalten",
    "Das ganze Programm wurde als die Bewegungen geschrieben, die es macht.",
  ),
};

export const runningFindings: Readonly<Record<string, FindingText>> = {
  ...running,
  ...files,
  ...converting,
};
