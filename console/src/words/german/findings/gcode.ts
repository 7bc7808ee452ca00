/** Findings about G-code, in German. */

import { type FindingText, told } from "./finding";

export const gcodeFindings: Readonly<Record<string, FindingText>> = {
  G001: told(
    "In einer anderen Sprache geschrieben",
    "Die Zeilen sind kein G-Code. Programme in OpenSBP enden auf .sbp, Zeichnungen auf .dxf.",
  ),
  G002: told("Unbekannter G-Code", "Diesen G-Code kennt die Sprache nicht."),
  G003: told("Unbekannter M-Code", "Diesen M-Code kennt die Sprache nicht."),
  G004: told(
    "Der Satz lässt sich nicht lesen",
    "Ein Satz besteht aus Wörtern: ein Buchstabe und eine Zahl, wie G1 X10.5. Kommentare stehen in Klammern oder hinter einem Semikolon.",
  ),
  G005: told(
    "Ein Buchstabe ohne Zahl",
    "Hinter jedem Buchstaben steht eine Zahl, ein Parameter (#5) oder ein Ausdruck in eckigen Klammern.",
  ),
  G006: told("Ein Wort steht zweimal im Satz", "Zwei Zeilen schreiben."),
  G007: told("Zwei Codes derselben Gruppe", "Sie schließen einander aus: zwei Zeilen schreiben."),
  G008: told("Ein Wort fehlt", "Der Code braucht einen Wert, den der Satz nicht nennt."),
  G009: told("Ein Wort, das nichts braucht", "Kein Code dieses Satzes nimmt es."),
  G010: told("Ein Kommentar ist offen", "Was mit ( beginnt, endet mit ) in derselben Zeile."),
  G011: told(
    "Der Ausdruck lässt sich nicht lesen",
    "Ausdrücke stehen in eckigen Klammern, wie X[#1 + 2 * SIN[30]]. Winkel sind Grad.",
  ),
  G012: told(
    "Diesen Parameter gibt es nicht",
    "Parameter gehen von 1 bis 5602; ab 5400 sind sie nur zu lesen.",
  ),
  G013: told("Der Parameter hat keinen Wert", "Ihm vorher einen Wert geben."),
  G014: told(
    "O-Wörter passen nicht zusammen",
    "Jedes sub, if, while, do und repeat hat sein Ende mit derselben Nummer in einer späteren Zeile.",
  ),
  G015: told(
    "Dieses Unterprogramm gibt es nicht",
    "Es steht weder in dieser Datei noch als eigene im Ordner der Programme.",
  ),
  G016: told("Kein Vorschub", "Eine Schnittbewegung braucht F über null; mit G93 in jedem Satz."),
  G017: told(
    "Das kann die Fräserkorrektur nicht",
    "Das Werkzeug passt nicht, wohin die Bahn führt, oder der Code geht nicht, solange korrigiert wird.",
  ),
  G018: told(
    "Das Antasten misslang",
    "Bis zum Ende der Fahrt gab es keine Berührung, oder der Taster berührte schon am Anfang.",
  ),
  G019: told("Nicht in diesem Dialekt", "Die Steuerung, die der Dialekt meint, kennt das nicht."),
  G020: told(
    "Eine Zeile für die Eingabe der Steuerung",
    "Zeilen mit $ wirken nur getippt; in einer Datei werden sie nicht ausgeführt.",
  ),
  G021: told(
    "Die Datei nennt ihre Einheit nicht",
    "Ohne G20 oder G21 gilt die Einheit der Maschine; vielleicht ist es nicht die der Datei.",
  ),
  G022: told("Leerzeichen in einer Zahl", "`X1 0` heißt X10. Fehlt ein Buchstabe?"),
  G023: told(
    "Der Bogen passt nicht zur Ebene",
    "Bögen liegen in der Ebene von G17 (I und J), G18 (I und K) oder G19 (J und K).",
  ),
  G024: told("Das Programm beendete sich selbst", "Sein Kommentar (ABORT,…) sagt den Grund."),
};
