/** Sentences of a machine while something runs on it, in German. */

export const runningSentences: Readonly<Record<string, string>> = {
  "a motor has stalled": "ein Motor blieb stehen",
  "not connected": "nicht verbunden",
  "emergency stop": "Not-Halt",
  "Out of bounds: {0} ends at {1}{2}": "Außerhalb: {0} endet bei {1}{2}",
  "release it: nothing moves before": "ihn lösen: vorher bewegt sich nichts",
  "stopped after {0} commands: what comes after them was not looked at":
    "Nach {0} Befehlen angehalten: was dahinter kommt, wurde nicht angesehen",
  "is there a loop that never ends? A machine runs it until it is stopped; --max-lines looks further":
    "Läuft eine Schleife ohne Ende? Eine Maschine führt sie aus, bis sie angehalten wird; --max-lines sieht weiter",
  "height control is on (height.on), and no sheet lies on the simulated table":
    "die Höhenregelung ist an (height.on), und auf dem simulierten Tisch liegt kein Blech",
  "planned over a flat sheet, the tool cutting at ZSurface; --sheet lays another":
    "geplant über einem flachen Blech, das Werkzeug schneidet bei ZSurface; --sheet legt ein anderes auf",
  "the job pauses where the sensor is needed first; --sheet lays one, height.on = false does without":
    "der Auftrag pausiert, wo der Fühler zuerst nötig ist; --sheet legt eines auf, height.on = false geht ohne",
  "a job is not nudged: move its origin":
    "Ein Auftrag wird nicht gerückt: seinen Ursprung verschieben.",
  "nothing is nudged while commands are only drawn":
    "Nichts wird gerückt, solange Befehle nur gezeichnet werden.",
  ", output {0} comes on again": ", Ausgang {0} geht wieder an",
  ", outputs {0} come on again": ", die Ausgänge {0} gehen wieder an",
  "the tool rises": "das Werkzeug hebt sich",
  "the program waits no longer": "das Programm wartet nicht länger",
  "{0}. When it is released, Resume: {1}{2}, and goes on":
    "{0}. Ist es gelöst, Fortsetzen: {1}{2}, und es geht weiter",
  "the controller has homed its axes": "die Steuerung hat ihre Achsen referenziert",
  "nothing moves on; look at the switch on input {0} (homing), and at the length of the axis (axis.length)":
    "nichts fährt weiter; den Schalter an Eingang {0} (homing) und die Länge der Achse (axis.length) prüfen",
  "a height map is in force, and the job's height control (height.on) finds the surface itself":
    "eine Höhenkarte ist in Kraft, und die Höhenregelung des Auftrags (height.on) findet die Oberfläche selbst",
  "Z follows the height map in force": "Z folgt der Höhenkarte, die in Kraft ist",
  "kerf map off takes it off": "kerf map off nimmt sie ab",
  "the cut leaves the height map, which holds from X {0} Y {1} to X {2} Y {3}":
    "der Schnitt verlässt die Höhenkarte, die von X {0} Y {1} bis X {2} Y {3} gilt",
  "probe a larger grid, or take the map off: kerf map off":
    "ein größeres Raster tasten, oder die Karte abnehmen",
  "Out of bounds: {0} would reach {1} from home; its length (axes.length) bounds it, and Z bottom (zpos.bottom_mm)":
    "Außerhalb: {0} käme nach {1} vom Referenzpunkt; die Länge der Achse (axes.length) begrenzt sie, und der tiefste Ort von Z (zpos.bottom_mm)",
  "nudge {0} {1}": "rücken {0} {1}",
  "nothing is kept": "nichts wird aufgehoben",
  "while an input is watched the speed stays: it changes at the next stand":
    "Solange ein Eingang beobachtet wird, bleibt die Geschwindigkeit: beim nächsten Halt ändert sie sich.",
  "stop input {0} is active: nothing moves before it is released":
    "Halteingang {0} ist aktiv: bis er gelöst ist, bewegt sich nichts",
  "{0} must be homed first": "{0} zuerst referenzieren",
  "Position unverified: {0}.": "Der Ort ist nicht sicher: {0}.",
  "{0} Home now? Continue, if the location is right as it is.":
    "{0} Jetzt referenzieren? Weiter, wenn der Ort stimmt.",
  "{0} Continue, if the location is right; else zero it first.":
    "{0} Weiter, wenn der Ort stimmt; sonst zuerst nullen.",
  "Not homed: {0}. Home now? No runs without.":
    "Nicht referenziert: {0}. Jetzt referenzieren? Ohne läuft nichts.",
  "taken up before the first move": "vor der ersten Bewegung fortgesetzt",
  "taken up behind line {0} of {1}": "hinter Zeile {0} von {1} fortgesetzt",
  "No output comes on": "Kein Ausgang geht an",
  "Output {0} comes on": "Ausgang {0} geht an",
  "Outputs {0} come on": "Die Ausgänge {0} gehen an",
  "{0}, the tool goes back to where the cut ended. Is everything ready?":
    "{0}, das Werkzeug kehrt dorthin zurück, wo der Schnitt endete. Ist alles bereit?",
  "the run goes on, but is not on record: {0}":
    "Der Lauf geht weiter, wird aber nicht aufgezeichnet: {0}",
  "the state of the program cannot be saved: {0}":
    "Der Zustand des Programms lässt sich nicht aufheben: {0}",
  "1 move was": "1 Bewegung wurde",
  "{0} moves were": "{0} Bewegungen wurden",
  "{0} read but not made, because of the error in the same stack":
    "{0} gelesen, aber nicht gefahren, wegen des Fehlers in derselben Folge",
  "nothing of a stack moves when it cannot be read to its end":
    "nichts einer Folge bewegt sich, wenn sie sich nicht zu Ende lesen lässt",
  "{0} would go to {1}: nothing is that long": "{0} käme nach {1}: so lang ist nichts",
  "not homed: {0}": "nicht referenziert: {0}",
  "enclosure open": "die Haube ist offen",
  "the machine is not connected ({0}): nothing moves":
    "Die Maschine ist nicht verbunden ({0}): nichts bewegt sich",
  "look at its cable, its power and its port (VI); SP shows the file in preview meanwhile":
    "Kabel, Strom und Anschluss (VI) prüfen; SP zeigt die Datei inzwischen als Vorschau",
  "home the machine, or set its locations, before anything is cut":
    "die Maschine referenzieren oder ihre Orte setzen, bevor geschnitten wird",
  "release it; the location is known, and the run can be taken up":
    "ihn lösen; der Ort ist bekannt, der Lauf lässt sich fortsetzen",
  "limit input {0} is active before anything moves":
    "Endschalter {0} ist aktiv, bevor sich etwas bewegt",
  "release it: nothing moves and nothing turns before":
    "ihn lösen: vorher bewegt sich und dreht sich nichts",
  "stop input {0} is active: stop circuit open, nothing may move":
    "Halteingang {0} ist aktiv: Haltekreis offen, nichts darf sich bewegen",
  "the log of {0} cannot be written: {1}": "Das Protokoll von {0} lässt sich nicht schreiben: {1}",
  "{0} would leave the table limits": "{0} verließe die Tischgrenzen",
  "give NUMBER@SECONDS=STATE, as 3@2.5=1": "NUMMER@SEKUNDEN=ZUSTAND angeben, wie 3@2.5=1",
  "the time is a number of seconds, 0 or more": "die Zeit ist eine Zahl in Sekunden, 0 oder mehr",
  "the state is 0 or 1": "der Zustand ist 0 oder 1",
  "inputs are numbered 1 to 12, or named, as arc, estop, cable or stall":
    "Eingänge haben Nummern von 1 bis 12 oder Namen wie arc, estop, cable oder stall",
  "a job runs: outputs belong to it until it is over":
    "Ein Auftrag läuft: bis er vorbei ist, gehören ihm die Ausgänge.",
  "one command of two letters expected, not '{0}'":
    "ein Befehl aus zwei Buchstaben wird erwartet, nicht »{0}«",
  "error in line {0}": "Fehler in Zeile {0}",
  "external programs are disabled; --allow-shell lets a run start them":
    "fremde Programme sind ausgeschaltet; --allow-shell lässt einen Lauf sie starten",
  "cannot start '{0}': {1}": "»{0}« lässt sich nicht starten: {1}",
  "cannot be started: {0}": "lässt sich nicht starten: {0}",
  "{0} was written": "{0} wurde geschrieben",
  "no firmware on the simulated machine": "die simulierte Maschine hat keine Firmware",
  "there is no folder of custom cuts": "es gibt keinen Ordner eigener Schnitte",
  "there is no font {0} on this computer; there are {1}{2}":
    "die Schrift {0} gibt es auf diesem Rechner nicht; es gibt {1}{2}",
  "failed: {0}": "misslungen: {0}",
};
