/** Sentences of the card of a controller. */

export const cardSentences: Readonly<Record<string, string>> = {
  "it runs a file from its own card: STOP ends it":
    "sie führt eine Datei von ihrer eigenen Karte aus: STOP beendet sie",
  "it runs a file from its own card, and Kerf leaves it alone: kerf machine card follow tells of it":
    "sie führt eine Datei von ihrer eigenen Karte aus, und Kerf lässt sie in Ruhe: kerf machine card follow nennt, wie weit sie ist",
  "the controller runs {0} from its own card":
    "die Steuerung führt {0} von ihrer eigenen Karte aus",
  "wait for its end, or press STOP": "das Ende abwarten, oder STOP drücken",
  "{0} ran from the controller's card, and was stopped":
    "{0} lief von der Karte der Steuerung und wurde gestoppt",
  "it says nothing of its card": "sie sagt nichts von ihrer Karte",
  "it was stopped": "es wurde gestoppt",
  "{0}; {1} runs on from its card": "{0}; {1} läuft von ihrer Karte weiter",
  "{0} does not say that it has stopped: press its emergency stop and look at it":
    "{0} sagt nicht, dass sie steht: ihren Not-Halt drücken und nachsehen",
  "a board with step queues has no card of its own":
    "eine Platine mit Schritt-Warteschlangen hat keine eigene Karte",
  "the controller was reset": "die Steuerung wurde zurückgesetzt",
  "'{0}' is no name for its card: 1 to {1} characters":
    "'{0}' ist kein Name für ihre Karte: 1 bis {1} Zeichen",
  "'{0}' is no name for its card: it takes no {1} in one":
    "'{0}' ist kein Name für ihre Karte: sie nimmt kein {1} darin",
  "its firmware takes no files on this line: build it with YMODEM, or put the file on the card in this computer":
    "ihre Firmware nimmt auf dieser Leitung keine Dateien: sie mit YMODEM bauen, oder die Datei in diesem Rechner auf die Karte schreiben",
  "{0} bytes of a file": "{0} Bytes einer Datei",
  "{0} is empty": "{0} ist leer",
  "line {0} of the file was refused: {1}": "Zeile {0} der Datei wurde abgelehnt: {1}",
  "there is no card in it, or none that it can read":
    "es steckt keine Karte darin, oder keine, die sie lesen kann",
  "its firmware has no card ($I tells no SD): build it with one":
    "ihre Firmware hat keine Karte ($I nennt kein SD): sie mit einer bauen",
  "its firmware has no card ($I tells no S)": "ihre Firmware hat keine Karte ($I nennt kein S)",
  "grbl 1.1 has no card: grblHAL and FluidNC have one":
    "grbl 1.1 hat keine Karte: grblHAL und FluidNC haben eine",
  "the controller has given it up: its card may be full, missing or locked":
    "die Steuerung hat es aufgegeben: ihre Karte ist vielleicht voll, fehlt oder ist gesperrt",
  "the controller does not answer": "die Steuerung antwortet nicht",
  "too much was spoiled on its way: look at the cable":
    "zu viel ging auf dem Weg verloren: das Kabel prüfen",
  "{0} is no part file: .nc .tap .ngc .gcode .sbp and .rsm go on a card":
    "{0} ist keine Teiledatei: .nc .tap .ngc .gcode .sbp und .rsm gehen auf eine Karte",
  "it was given up before it was done": "es wurde aufgegeben, bevor es fertig war",
  "this machine has no controller with a card":
    "diese Maschine hat keine Steuerung mit einer Karte",
  "something is done on the card already: wait for its end, or cancel it":
    "auf der Karte geschieht schon etwas: das Ende abwarten, oder es abbrechen",
  "the file was not looked through: look through it first":
    "die Datei wurde nicht durchgesehen: sie zuerst durchsehen",
  "{0} more are wrong in the same file": "{0} weitere in derselben Datei",
  "Kerf ends": "Kerf endet",
  "{0} is on the card already": "{0} ist schon auf der Karte",
  "{0} is in the part folder already": "{0} ist schon im Teileordner",
  "the controller has not told its limits yet": "die Steuerung hat ihre Grenzen noch nicht genannt",
  "the line to the controller is lost and is opened again; the file goes on without it":
    "die Leitung zur Steuerung ist abgerissen und wird wieder geöffnet; die Datei geht ohne sie weiter",
  "there is no controller that has a card": "es gibt keine Steuerung, die eine Karte hat",
  "{0} from the card has ended: {1}": "{0} von der Karte hat geendet: {1}",
  "where it stands cannot be kept: {0}": "wo sie steht, lässt sich nicht aufheben: {0}",
  "{0} runs {1} from its own card: it is followed":
    "{0} führt {1} von ihrer eigenen Karte aus: das wird verfolgt",
  "{0}; the controller passed over it": "{0}; die Steuerung überging sie",
  "there is no file {0} on its card": "auf ihrer Karte ist keine Datei {0}",
  "the controller ended it before all of it was there":
    "die Steuerung brach ab, bevor alles da war",
  "the controller refused it: error {0}": "die Steuerung lehnte es ab: Fehler {0}",
  "{0} of {1} bytes have come there": "{0} von {1} Bytes sind dort angekommen",
  "it cannot open the file: its card is missing or locked, or the folder is not there":
    "sie kann die Datei nicht öffnen: ihre Karte fehlt oder ist gesperrt, oder den Ordner gibt es nicht",
  "its card is full": "ihre Karte ist voll",
  "{0} cannot be said in G-code": "{0} lässt sich nicht in G-Code sagen",
};
