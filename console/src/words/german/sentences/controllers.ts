/** Sentences about controllers and the lines to them, in German. */

export const controllersSentences: Readonly<Record<string, string>> = {
  "{0} has not been driven before, or was moved or switched off since: the machine is believed to stand at {1}, {2}, {3}, where the last run ended; stop and set its location where that is wrong":
    "{0} wurde noch nie gesteuert, oder seither bewegt oder ausgeschaltet: die Maschine wird bei {1}, {2}, {3} angenommen, wo der letzte Lauf endete; anhalten und ihren Ort setzen, wenn das falsch ist",
  "the last run on {0} has no end: Kerf was killed, or the power failed. What still moved is stopped; the machine is believed to stand at {1}, {2}, {3}":
    "Der letzte Lauf an {0} hat kein Ende: Kerf wurde beendet, oder der Strom fiel aus. Was sich noch bewegte, ist angehalten; die Maschine wird bei {1}, {2}, {3} angenommen",
  "name the command that loads it: kerf set options.firmware='avrdude … -P {0} …'":
    "den Befehl nennen, der sie lädt: kerf set options.firmware='avrdude … -P {0} …'",
  "{0}: ${1} is {2} while Kerf drives it, {3} again afterwards":
    "{0}: ${1} ist {2}, solange Kerf sie steuert, danach wieder {3}",
  "{0}: left on by the last command: output {1}": "{0}: vom letzten Befehl noch an: Ausgang {1}",
  "{0} stands at {1} and not at {2} of the machine, as the controller tells; zero points are where they were":
    "{0} steht nach Angabe der Steuerung bei {1} und nicht bei {2} der Maschine; die Nullpunkte sind, wo sie waren",
  "{0} does not answer: is it switched on, is this its port, and its rate?":
    "{0} antwortet nicht: eingeschaltet, richtiger Anschluss, richtige Rate?",
  "get home": "den Referenzpunkt finden",
  "{0} was stopped before it could {1}": "{0} wurde angehalten, bevor sie dies tat: {1}",
  "{0} did not {1}": "{0} tat dies nicht: {1}",
  "look at its firmware": "die Firmware prüfen",
  "{0} does not answer any more": "{0} antwortet nicht mehr",
  "what it had in its buffer it may have made; look at its cable and its power":
    "was im Puffer war, kann ausgeführt sein; Kabel und Strom prüfen",
  "its place may be lost: home it, or set the location, before the next file":
    "der Ort kann verloren sein: vor der nächsten Datei referenzieren oder den Ort setzen",
  "nothing moves any more; outputs are off": "nichts bewegt sich mehr; die Ausgänge sind aus",
  "; the machine stands at {0}, {1}, {2}": "; die Maschine steht bei {0}, {1}, {2}",
  "{0} does not say that it has stopped": "{0} sagt nicht, dass sie steht",
  "press its emergency stop and look at it": "den Not-Halt drücken und nachsehen",
  "{0} does not say that it is held": "{0} sagt nicht, dass sie gehalten ist",
  "{0} has no {1}": "{0} hat kein {1}",
  "{0} was stopped before it had made its last moves":
    "{0} wurde angehalten, bevor die letzten Bewegungen gemacht waren",
  "it was held at the controller: look why before the next file":
    "an der Steuerung wurde gehalten: vor der nächsten Datei nachsehen, warum",
  "its line is gone: it is opened again when it is back":
    "die Verbindung ist fort: sie wird wieder geöffnet, sobald sie da ist",
  "{0} has not kept count of where it stands: a run is taken up at the very place, and nobody knows it":
    "{0} weiß nicht mehr, wo sie steht: ein Lauf wird genau an seinem Ort fortgesetzt, und den kennt niemand",
  "{0} keeps no zero points: Kerf keeps its own (ZX, VA)":
    "{0} hat keine Nullpunkte: Kerf hat eigene (ZX, VA)",
  "has no axis {0}": "hat keine Achse {0}",
  "change the file, or where its zero lies": "die Datei ändern, oder wo ihr Nullpunkt liegt",
  "ends at {0} {1} … {2}: {3} would go to {4}, its own places":
    "endet bei {0} {1} … {2}: {3} käme nach {4}, in eigenen Koordinaten",
  "has no output for a torch or a beam: it drives machines with a spindle":
    "hat keinen Ausgang für Brenner oder Strahl: sie steuert Maschinen mit einer Spindel",
  "slow {0}": "{0} langsamer",
  "moves {0} at {1} mm/s at most, the program asks for {2}":
    "bewegt {0} mit höchstens {1} mm/s, das Programm verlangt {2}",
  "has no spindle: {0}": "hat keine Spindel: {0}",
  "has no output {0}, but {1}": "hat keinen Ausgang {0}, aber {1}",
  "has no output {0} ({1}): it is left out": "hat keinen Ausgang {0} ({1}): er wird ausgelassen",
  "{0}: it is left out": "{0}: es wird ausgelassen",
  "has no axis that moves by itself (MI), and no torch that moves Z (VH)":
    "hat keine Achse, die sich allein bewegt (MI), und keinen Brenner, der Z bewegt (VH)",
  "has no height control by readings": "hat keine Höhenregelung nach Messwerten",
  "has no height control by two switches, inputs 17 (zhigh) and 20 (zlow)":
    "hat keine Höhenregelung nach zwei Schaltern, Eingängen 17 (zhigh) und 20 (zlow)",
  "output that switches within a move (VC)": "Ausgang, der in einer Bewegung schaltet (VC)",
  "PWM output": "PWM-Ausgang",
  "intensity output": "Ausgang für die Leistung",
  "spindle that turns the other way": "Spindel, die andersherum dreht",
  "laser whose power follows the speed": "Laser, dessen Leistung der Geschwindigkeit folgt",
  "the cable was pulled": "das Kabel wurde gezogen",
  "look at its cable and its power": "Kabel und Strom prüfen",
  "{0} does not change its zero point {1} so, or is at work":
    "{0} ändert den Nullpunkt {1} so nicht, oder ist an der Arbeit",
  "{0} has not said that its zero point {1} is written":
    "{0} hat nicht gesagt, dass der Nullpunkt {1} geschrieben ist",
  "no machine can do this": "das kann keine Maschine",
  "it did not understand a line; the cable may be bad":
    "sie verstand eine Zeile nicht; vielleicht ist das Kabel schlecht",
  "it does not know this $ command": "sie kennt diesen $-Befehl nicht",
  "homing is not enabled in it: set $22=1, or do not home":
    "das Referenzieren ist in ihr ausgeschaltet: $22=1 setzen, oder nicht referenzieren",
  "its step pulse is too short: look at $0": "ihr Schrittpuls ist zu kurz: $0 prüfen",
  "its settings were lost and are the usual ones again: look at them before anything moves":
    "ihre Einstellungen gingen verloren und sind wieder die üblichen: sie prüfen, bevor sich etwas bewegt",
  "it is busy with something else": "sie ist mit etwas anderem beschäftigt",
  "it is locked by an alarm": "ein Alarm sperrt sie",
  "soft limits need homing: set $22=1 or $20=0":
    "weiche Grenzen brauchen das Referenzieren: $22=1 oder $20=0 setzen",
  "the line is too long for it; the cable may be bad":
    "die Zeile ist zu lang für sie; vielleicht ist das Kabel schlecht",
  "its door is open": "ihre Tür ist offen",
  "the place lies outside its travel ($130, $131, $132)":
    "der Ort liegt außerhalb ihrer Wege ($130, $131, $132)",
  "it does not have this command": "sie hat diesen Befehl nicht",
  "its laser mode has no PWM output": "ihr Laserbetrieb hat keinen PWM-Ausgang",
  "no feed was given": "kein Vorschub wurde genannt",
  "it cannot make this arc": "sie kann diesen Bogen nicht fahren",
  "it does not have this output": "sie hat diesen Ausgang nicht",
  "see the list of error codes of its firmware":
    "die Liste der Fehlernummern ihrer Firmware ansehen",
  "a limit switch was hit; its place is lost: home it before anything moves":
    "ein Endschalter sprach an; ihr Ort ist verloren: referenzieren, bevor sich etwas bewegt",
  "the place lies outside its travel ($130, $131, $132); it stands where it was":
    "der Ort liegt außerhalb ihrer Wege ($130, $131, $132); sie steht, wo sie stand",
  "it was reset while it moved; its place is lost: home it before anything moves":
    "sie wurde in der Bewegung zurückgesetzt; ihr Ort ist verloren: referenzieren, bevor sich etwas bewegt",
  "probing failed": "das Antasten misslang",
  "homing was interrupted by a reset": "ein Zurücksetzen unterbrach das Referenzieren",
  "homing was interrupted by the door": "die Tür unterbrach das Referenzieren",
  "homing did not leave the limit switch: look at $27 and the wires of the switches":
    "beim Referenzieren kam sie nicht vom Schalter frei: $27 und die Leitungen der Schalter prüfen",
  "homing did not find the limit switch: look at $130 and the wires of the switches":
    "beim Referenzieren fand sie den Schalter nicht: $130 und die Leitungen der Schalter prüfen",
  "the emergency stop is pressed": "der Not-Halt ist gedrückt",
  "it wants to be homed before anything moves":
    "sie will referenziert werden, bevor sich etwas bewegt",
  "the spindle did not reach its speed": "die Spindel erreichte ihre Drehzahl nicht",
  "see the list of alarm codes of its firmware":
    "die Liste der Alarmnummern ihrer Firmware ansehen",
  "its axes are not X Y Z A B C in this order: build its firmware so":
    "ihre Achsen sind nicht X Y Z A B C in dieser Folge: ihre Firmware so bauen",
  "it does not tell its settings ($$)": "sie nennt ihre Einstellungen nicht ($$)",
  "it does not tell the steps of its axes: look at $100, $101, $102":
    "sie nennt die Schritte ihrer Achsen nicht: $100, $101, $102 prüfen",
  "it tells places in inches, which turning axes do not have: set $13=0":
    "sie nennt Orte in Zoll, die Drehachsen nicht haben: $13=0 setzen",
  "it is set to be a lathe, where X is a diameter: set $32=0":
    "sie ist als Drehbank eingestellt, wo X ein Durchmesser ist: $32=0 setzen",
  "it scales what it is told: send it G50":
    "sie verkleinert oder vergrößert, was ihr gesagt wird: ihr G50 senden",
  "its laser mode is on, and a beam would burn along every jog: set $32=0":
    "ihr Laserbetrieb ist an, der Strahl würde bei jedem Eilgang brennen: $32=0 setzen",
  "its spindle has no speed: look at $30": "ihre Spindel hat keine Drehzahl: $30 prüfen",
  "home it first (--home)": "zuerst referenzieren",
  "look why, set its location, and unlock it (--unlock)":
    "nachsehen, warum, den Ort setzen und sie entsperren",
  "it does not answer a line": "sie beantwortet eine Zeile nicht",
  "it was reset meanwhile": "sie wurde inzwischen zurückgesetzt",
  "it was at something that is not begun twice":
    "sie war bei etwas, das nicht zweimal begonnen wird",
  "it stands at the end of none of the moves that were sent":
    "sie steht am Ende keiner der gesendeten Bewegungen",
  "it stands where several of the moves that were sent end":
    "sie steht, wo mehrere der gesendeten Bewegungen enden",
  "it stopped by itself": "sie hielt von selbst an",
  "it does not tell its buffers: set $10=3, or $10=511 in grblHAL":
    "sie nennt ihre Puffer nicht: $10=3 setzen, bei grblHAL $10=511",
  "it has left its path": "sie hat die Bahn verlassen",
  "it stands elsewhere than it was told to": "sie steht woanders, als ihr gesagt wurde",
  "an answer did not come through: look at the cable":
    "eine Antwort kam nicht durch: das Kabel prüfen",
  "it has no output 4: grbl has 1 (spindle), 2 (flood) and 3 (mist)":
    "sie hat keinen Ausgang 4: grbl hat 1 (Spindel), 2 (Kühlung) und 3 (Nebel)",
  "it does not have this output: grbl has 1 (spindle), 2 (flood) and 3 (mist)":
    "sie hat diesen Ausgang nicht: grbl hat 1 (Spindel), 2 (Kühlung) und 3 (Nebel)",
  "it does not have an axis that moves": "sie hat keine Achse, die sich bewegt",
  "it is held: its own button has it go on":
    "sie ist gehalten: ihr eigener Knopf lässt sie weitermachen",
  "its door was open: its own button has it go on":
    "ihre Tür war offen: ihr eigener Knopf lässt sie weitermachen",
  "its spindle comes up again": "ihre Spindel läuft wieder hoch",
  "it waits for a tool: it makes jogs alone until the tool is in":
    "sie wartet auf ein Werkzeug: bis es eingesetzt ist, fährt sie nur von Hand",
  "the controller of this machine keeps no steps of this axis":
    "die Steuerung dieser Maschine speichert keine Schritte dieser Achse",
  "steps of a millimetre are a number above 0": "Schritte je Millimeter sind eine Zahl über 0",
  "there is no controller that keeps settings by number":
    "keine Steuerung speichert Einstellungen nach Nummern",
  "settings of the controller are written one at a time":
    "Einstellungen der Steuerung werden einzeln geschrieben",
  "${0} is a setting of a controller of grbl's family, and this machine has none by number":
    "${0} ist eine Einstellung einer Steuerung der grbl-Familie, und diese Maschine hat keine nach Nummern",
  "${0} is a setting of the controller: write it by itself, beside no other lines":
    "${0} ist eine Einstellung der Steuerung: sie wird allein geschrieben, neben keinen anderen Zeilen",
  "the controller keeps ${0}={1} now, and kept {2} before":
    "die Steuerung speichert jetzt ${0}={1}, vorher {2}",
  "the controller keeps {0} steps a millimetre of {1} now: it counts anew where {2} stands, so home it or set its location":
    "die Steuerung speichert jetzt {0} Schritte je Millimeter von {1}: sie zählt neu, wo {2} steht, also referenzieren oder den Ort setzen",
  "{0} keeps no settings by number: they are in its machine's file (steps.per_unit)":
    "{0} speichert keine Einstellungen nach Nummern: sie stehen in der Maschinendatei (steps.per_unit)",
  "Z zero goes up by {0} mm with the length of the tool in the spindle":
    "Z-Null geht mit der Länge des Werkzeugs in der Spindel um {0} mm nach oben",
  "Z zero stays: it was set since the change of tools, with the tool in the spindle":
    "Z-Null bleibt: sie wurde seit dem Werkzeugwechsel mit dem Werkzeug in der Spindel gesetzt",
  "it is at work, or takes no orders": "sie arbeitet gerade oder nimmt keine Befehle an",
  "it has no setting ${0}": "sie hat keine Einstellung ${0}",
  "a value holds no control character, and no ?, ! or ~: the controller obeys them wherever they come":
    "ein Wert enthält kein Steuerzeichen und kein ?, ! oder ~: die Steuerung befolgt sie, wo immer sie stehen",
  "$10 is kept as Kerf needs it to follow the controller":
    "$10 bleibt, wie Kerf es braucht, um der Steuerung zu folgen",
  "it has not said that ${0} is written": "sie hat das Schreiben von ${0} nicht bestätigt",
  "it keeps ${0}={1}, and not the {2} that was written":
    "sie speichert ${0}={1} statt der geschriebenen {2}",
  "has no PWM channel {0}, but {1}": "hat keinen PWM-Kanal {0}, aber {1}",
  "it checks lines in place of making them: send it $C":
    "sie prüft Zeilen, statt sie auszuführen: ihr $C senden",
  "it sleeps: reset it, and home it or set its location":
    "sie schläft: sie zurücksetzen, dann referenzieren oder den Ort setzen",
  "it did not say what it is": "sie sagte nicht, was sie ist",
  "it cannot do this as it stands": "so, wie sie steht, kann sie das nicht",
  "it is held at its own panel": "sie ist an ihrem eigenen Pult gehalten",
  "it is at work for somebody at its own panel": "sie arbeitet für jemanden an ihrem eigenen Pult",
  "its emergency stop is pressed: release it, then switch it on at its panel, or unlock it (--unlock)":
    "ihr Not-Halt ist gedrückt: ihn lösen, dann an ihrem Pult einschalten oder sie entsperren",
  "LinuxCNC has ended: start it again": "LinuxCNC ist beendet: es wieder starten",
  "it is switched off: switch it on at its panel, or unlock it (--unlock)":
    "sie ist ausgeschaltet: an ihrem Pult einschalten oder sie entsperren",
  "it stands elsewhere than it was told to: somebody stopped it at its panel":
    "sie steht woanders, als ihr gesagt wurde: jemand hielt sie an ihrem Pult an",
  "LinuxCNC was stopped by its bridge where it was, its outputs off":
    "die Brücke hielt LinuxCNC an, wo es war, die Ausgänge sind aus",
  "Kerf has LinuxCNC make chords, no arcs": "Kerf lässt LinuxCNC Sehnen fahren, keine Bögen",
  "its bridge is of another version of Kerf: start the one of this version":
    "die Brücke gehört zu einer anderen Fassung von Kerf: die dieser Fassung starten",
  "the Python module of LinuxCNC is not there: is LinuxCNC installed?":
    "das Python-Modul von LinuxCNC fehlt: ist LinuxCNC installiert?",
  "LinuxCNC does not run there: start it first": "dort läuft kein LinuxCNC: es zuerst starten",
  "it has no axes X, Y and Z: Kerf drives no lathe":
    "sie hat keine Achsen X, Y und Z: Kerf steuert keine Drehbank",
  "its joints are not its axes: Kerf drives trivial kinematics only":
    "ihre Gelenke sind nicht ihre Achsen: Kerf steuert nur einfache Kinematik",
  "'{0}' is no rate in baud, as 115200 is": "»{0}« ist keine Rate in Baud, wie 115200 eine ist",
  "no such program runs on this system": "auf diesem System läuft kein solches Programm",
  "'{0}' is no port of the network, as 23 is": "»{0}« ist kein Anschluss im Netz, wie 23 einer ist",
  'the serial port {0} may not be opened: add yourself to its group (often "dialout") and log in again':
    "der serielle Anschluss {0} darf nicht geöffnet werden: den Benutzer in dessen Gruppe aufnehmen (oft »dialout«) und neu anmelden",
  "{0} cannot be reached ({1}): is it switched on, in this network, and is this its address?":
    "{0} ist nicht zu erreichen ({1}): eingeschaltet, in diesem Netz, richtige Adresse?",
  "it was cut": "sie wurde getrennt",
  "it does not answer": "sie antwortet nicht",
  "there is no serial port {0}: is it plugged in, and is this its name?":
    "den seriellen Anschluss {0} gibt es nicht: ist er eingesteckt, ist das sein Name?",
  "the serial port {0} is used by another program: close that first":
    "ein anderes Programm verwendet den seriellen Anschluss {0}: es zuerst schließen",
  "the serial port {0} cannot be opened at {1} baud: {2}":
    "der serielle Anschluss {0} lässt sich nicht mit {1} Baud öffnen: {2}",
  "the serial port {0} is gone ({1}): is its cable still plugged in?":
    "der serielle Anschluss {0} ist fort ({1}): steckt das Kabel noch?",
  "the connection to {0} is gone ({1}): is it switched on, and the network up?":
    "die Verbindung zu {0} ist fort ({1}): ist sie eingeschaltet, geht das Netz?",
  "the line of the controller is closed": "die Verbindung zur Steuerung ist geschlossen",
};
