/** Texts of the sheet that wires a board. */

export const wiring: Readonly<Record<string, string>> = {
  "Wire a board": "Eine Platine verdrahten",
  "A board with Klipper's firmware becomes the controller of this machine. Motors turn 1 mm: have their shafts free, the spindle unplugged, and a hand at the switch of the supply. STOP ends it at once.":
    "Eine Platine mit der Firmware von Klipper wird die Steuerung dieser Maschine. Motoren drehen sich um 1 mm: ihre Wellen sind frei, die Spindel ist ausgesteckt, eine Hand liegt am Schalter der Versorgung. STOPP beendet es sofort.",
  "Port of the board": "Anschluss der Platine",
  "Board that is sold": "Platine aus dem Handel",
  "Its pins are known: skr-pico, octopus-1.1 … kerf machine boards lists them.":
    "Ihre Anschlüsse sind bekannt: skr-pico, octopus-1.1 … kerf machine boards nennt sie.",
  "Another one: its pins are asked for": "Eine andere: nach ihren Anschlüssen wird gefragt",
  "Ports of this computer": "Anschlüsse dieses Rechners",
  "Look for boards": "Platinen suchen",
  "Ports are looked at …": "Anschlüsse werden geprüft …",
  "Looking opens each port for a moment: a device that begins anew when its port is opened does so.":
    "Die Suche öffnet jeden Anschluss für einen Moment: ein Gerät, das dabei neu beginnt, tut es.",
  "{0}, firmware {1}": "{0}, Firmware {1}",
  "shut down: reset it": "abgeschaltet: zurücksetzen",
  "wired since it was powered: reset it for other pins":
    "seit dem Einschalten verdrahtet: für andere Anschlüsse zurücksetzen",
  "Switches now": "Schalter jetzt",
  "Home switch of {0}": "Referenzschalter von {0}",
  pressed: "gedrückt",
  "File of the machine": "Datei der Maschine",
  Begin: "Beginnen",
  Question: "Frage",
  Pins: "Anschlüsse",
  Amperes: "Ampere",
  "The board is at work …": "Die Platine arbeitet …",
  "End without writing": "Ohne Schreiben beenden",
  "As the board names them: gpio0 or PA3. ! turns a level round, ^ pulls an input up.":
    "Wie die Platine sie nennt: gpio0 oder PA3. ! dreht einen Pegel um, ^ zieht einen Eingang hoch.",
  "Motor {0}: its pins of step and direction":
    "Motor {0}: seine Anschlüsse für Schritt und Richtung",
  "Second motor of {0}: its pins of step and direction":
    "Zweiter Motor von {0}: seine Anschlüsse für Schritt und Richtung",
  "Home switch of {0}: its pin; - for none":
    "Referenzschalter von {0}: sein Anschluss; - für keinen",
  "Home switch of the second motor of {0}: its pin; - for none of its own":
    "Referenzschalter des zweiten Motors von {0}: sein Anschluss; - für keinen eigenen",
  "Pins that give the motors their current; - for none":
    "Anschlüsse, die den Motoren ihren Strom geben; - für keine",
  "Outputs by number, with their pins: 1 gpio20, 2 gpio21":
    "Ausgänge nach Nummer, mit ihren Anschlüssen: 1 gpio20, 2 gpio21",
  "Inputs by number, with their pins: 1 ^gpio22; - for none":
    "Eingänge nach Nummer, mit ihren Anschlüssen: 1 ^gpio22; - für keine",
  "Is there a torch whose height is controlled?": "Gibt es einen Brenner mit Höhenregelung?",
  "Pin that measures the voltage of its arc, divided; - for none":
    "Anschluss, der die geteilte Spannung des Lichtbogens misst; - für keinen",
  "Pins of the two switches of its head, too high and too low; - for none":
    "Anschlüsse der zwei Schalter des Kopfes, zu hoch und zu tief; - für keine",
  "Current of motor {0} while it turns, amperes": "Strom von Motor {0}, während er dreht, Ampere",
  "What is printed on the motor, or less.": "Was auf dem Motor steht, oder weniger.",
  "Has an axis two motors, or is there a rotary axis?":
    "Hat eine Achse zwei Motoren, oder gibt es eine Drehachse?",
  "{0} goes 1 {1} towards plus, and back. Look at it.":
    "{0} fährt 1 {1} nach Plus und zurück. Hinsehen.",
  "Which way did {0} go?": "In welche Richtung ist {0} gefahren?",
  "Turn it": "Drehen",
  "Switch it on": "Einschalten",
  "It moved right": "In die richtige",
  "It moved the wrong way": "In die falsche",
  "It did not move": "Gar nicht",
  "It moved so far": "So weit ist sie gefahren",
  "Measured, where it was another way: the steps per mm follow.":
    "Gemessen, wo es ein anderer Weg war: die Schritte je mm folgen daraus.",
  "{0} goes 1 mm with both motors. Look at them.": "{0} fährt 1 mm mit beiden Motoren. Hinsehen.",
  "Did both go the same way?": "Sind beide in dieselbe Richtung gefahren?",
  "The same way": "In dieselbe",
  "Against each other": "Gegeneinander",
  "{0}: leave its home switch alone.": "{0}: den Referenzschalter nicht berühren.",
  "{0}: press its home switch, and hold it.": "{0}: den Referenzschalter drücken und halten.",
  "Nothing changed: look at its pin and its wires.":
    "Nichts hat sich geändert: Anschluss und Leitungen prüfen.",
  "Look again": "Noch einmal ansehen",
  "Leave it": "Lassen",
  "Output {0} goes on for a second.": "Ausgang {0} geht für eine Sekunde an.",
  "Leave it out": "Auslassen",
  "Did it go on?": "Ist er angegangen?",
  "It did": "Ja",
  "It did not go on": "Nein",
  "{0}: try its speed, 20 mm there and back, more each time?":
    "{0}: die Geschwindigkeit erproben, 20 mm hin und zurück, jedes Mal mehr?",
  "{0}: try its acceleration, 20 mm there and back, more each time?":
    "{0}: die Beschleunigung erproben, 20 mm hin und zurück, jedes Mal mehr?",
  "Leave it as it is": "So lassen",
  Try: "Erproben",
  "{0} at {1} {2}/s": "{0} mit {1} {2}/s",
  "{0} at {1} {2}/s²": "{0} mit {1} {2}/s²",
  "It came back to its place": "Sie kam an ihren Ort zurück",
  "It did not": "Sie kam nicht zurück",
};
