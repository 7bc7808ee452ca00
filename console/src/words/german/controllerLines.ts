/** Texts of what is sent to a controller and what it answers. */

export const controllerLines: Readonly<Record<string, string>> = {
  "Console of the controller: what is sent and answered":
    "Konsole der Steuerung: was gesendet und geantwortet wird",
  "Console of the controller": "Konsole der Steuerung",
  "Lines that are shown": "Gezeigte Zeilen",
  "Both ways": "Beide Wege",
  Sent: "Gesendet",
  Send: "Senden",
  Errors: "Fehler",
  Connection: "Verbindung",
  Answered: "Geantwortet",
  "Status reports and ok": "Zustandsmeldungen und ok",
  "Save to a file": "In eine Datei sichern",
  "text of a line": "Text einer Zeile",
  "{0} older lines are gone.": "{0} ältere Zeilen sind nicht mehr da.",
  "Sent and answered": "Gesendet und geantwortet",
  "$I asks the controller, $120=500 sets it, MX,2 moves":
    "$I fragt die Steuerung, $120=500 stellt sie ein, MX,2 fährt",
};
