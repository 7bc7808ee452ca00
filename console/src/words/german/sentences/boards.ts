/** Sentences about boards with step queues and their motor drivers, in German. */

export const boardsSentences: Readonly<Record<string, string>> = {
  "has no {0}": "hat kein {0}",
  "no axis has a home switch (homing.x.fitted, board.home_x): set its location by hand":
    "keine Achse hat einen Referenzschalter (homing.x.fitted, board.home_x): den Ort von Hand setzen",
  "the program of a board with step queues is loaded by its own tools":
    "das Programm einer Platine wird mit ihren eigenen Werkzeugen geladen",
  "{0}: the last run was cut short; the board has gone on counting, so the machine stands at {1}":
    "{0}: der letzte Lauf wurde abgebrochen; die Platine zählte weiter, also steht die Maschine bei {1}",
  "the board was switched off, or has not been driven before":
    "die Platine war ausgeschaltet oder wurde noch nie gesteuert",
  "{0}: {1}: the machine is believed to stand at {2}; stop and set its location where that is wrong":
    "{0}: {1}: die Maschine wird bei {2} angenommen; anhalten und ihren Ort setzen, wenn das falsch ist",
  '{0}: "{1}" is no driver that is known: {2}': "{0}: »{1}« ist kein bekannter Treiber: {2}",
  "{0}: {1} is no address": "{0}: {1} ist keine Adresse",
  '{0} = "{1}": name its pins: {2}': "{0} = »{1}«: die Anschlüsse nennen: {2}",
  "{0}: {1} (drivers.current_a, ohms, microsteps, stall)":
    "{0}: {1} (drivers.current_a, ohms, microsteps, stall)",
  "{0}: a driver has an address from 0 to 3, not {1}":
    "{0}: ein Treiber hat eine Adresse von 0 bis 3, nicht {1}",
  "{0}: motor {1} has address {2} on that wire already":
    "{0}: Motor {1} hat an dieser Leitung schon die Adresse {2}",
  'drivers.spi: name MISO, MOSI and SCK: "PA6 PA7 PA5"':
    'drivers.spi: MISO, MOSI und SCK nennen: "PA6 PA7 PA5"',
  "{0} input {1} stopped it at once, in the board":
    "{0} {1}: der Eingang hielt sie sofort an, in der Platine",
  "release it; its counts are known, though a heavy machine may have slipped: the run can be taken up":
    "ihn lösen; gezählt ist richtig, eine schwere Maschine kann aber gerutscht sein: der Lauf lässt sich fortsetzen",
  "an input stopped it at once": "ein Eingang hielt sie sofort an",
  "{0} stands beside its home: it was late":
    "{0} steht neben dem Referenzpunkt: der Rechner war zu spät",
  " with motor {0} alone": " mit Motor {0} allein",
  ": its switch stays on": ": der Schalter bleibt an",
  ": it was stopped": ": angehalten",
  "{0} home not found{1}{2}": "{0}: Referenzpunkt nicht gefunden{1}{2}",
  "no board answers: is this its port and its rate?":
    "keine Platine antwortet: richtiger Anschluss und richtige Rate?",
  "its port is closed": "der Anschluss ist geschlossen",
  "the computer stalled for": "der Rechner stockte für",
  "the computer stalls no longer than": "der Rechner stockt nicht länger als",
  "{0}: {1} {2} ms; motion is sent {3} ms ahead from now on, and a hold begins as much later":
    "{0}: {1} {2} ms; Bewegung wird ab jetzt {3} ms voraus gesendet, und ein Halt beginnt so viel später",
  "nothing moves any more": "nichts bewegt sich mehr",
  "the board has shut down: {0}": "die Platine hat sich abgeschaltet: {0}",
  "its motors stand and its outputs are off; look why, then connect again":
    "ihre Motoren stehen, ihre Ausgänge sind aus; nachsehen, warum, dann neu verbinden",
  "its place may be lost: home it first": "der Ort kann verloren sein: zuerst referenzieren",
  "{0}: the driver of motor {1}: {2}": "{0}: der Treiber von Motor {1}: {2}",
  "the driver of motor {0}: {1}": "der Treiber von Motor {0}: {1}",
  "an input stopped the machine, and the run was past that place already":
    "ein Eingang hielt die Maschine an, und der Lauf war schon hinter dieser Stelle",
  "its place is known: begin again at this line":
    "der Ort ist bekannt: bei dieser Zeile wieder beginnen",
  "the computer was too late with its steps: the board has stopped at once":
    "der Rechner kam mit den Schritten zu spät: die Platine hielt sofort an",
  "its counts are known, but a heavy machine may have slipped: home it":
    "gezählt ist richtig, eine schwere Maschine kann aber gerutscht sein: referenzieren",
  "has no motor of axis {0}": "hat keinen Motor der Achse {0}",
  "the computer was late: the machine has slowed down on the path and stands":
    "der Rechner kam zu spät: die Maschine bremste auf der Bahn und steht",
  "it does not say that it has stopped": "sie sagt nicht, dass sie steht",
  "press its emergency stop": "den Not-Halt drücken",
  "it was stopped before it had made its last moves":
    "sie wurde angehalten, bevor die letzten Bewegungen gemacht waren",
  "look why it was held": "nachsehen, warum sie gehalten wurde",
  '{0}: "{1}" is no name with its port: tools /dev/ttyACM1':
    "{0}: »{1}« ist kein Name mit Anschluss: tools /dev/ttyACM1",
  "give each board a name of its own, and none of them main":
    "jeder Platine einen eigenen Namen geben, keiner den Namen main",
  "{0}: there is a board {1} already: {2}": "{0}: eine Platine {1} gibt es schon: {2}",
  "boards {0} and {1} hang on one port, {2}":
    "die Platinen {0} und {1} hängen an einem Anschluss, {2}",
  "boards {0} and {1} have one serial number, {2}: they would be mixed up when they are plugged in anew; flash one with another number, or take a board of another kind":
    "die Platinen {0} und {1} haben dieselbe Seriennummer, {2}: nach dem Umstecken würden sie verwechselt; einer eine andere Nummer geben, oder eine andere Art nehmen",
  '{0} = "{1}": name two pins, step and direction: "gpio0 gpio1"':
    '{0} = »{1}«: zwei Anschlüsse nennen, Schritt und Richtung: "gpio0 gpio1"',
  '{0}: "{1}" is no number with its pin, as 1 gpio20 is':
    "{0}: »{1}« ist keine Nummer mit Anschluss, wie 1 gpio20 eine ist",
  '{0}: "{1}" is no pin, as gpio17, PA3 or ^!gpio10 are':
    "{0}: »{1}« ist kein Anschluss, wie gpio17, PA3 oder ^!gpio10 welche sind",
  '{0}: "{1}" is on no board that board.others names: "{2} PORT"':
    '{0}: »{1}« ist an keiner Platine, die board.others nennt: "{2} PORT"',
  "{0}: it was stopped while it homed": "{0}: beim Referenzieren angehalten",
  "look at the switch, and at the length of the axis":
    "den Schalter und die Länge der Achse prüfen",
  "its boards stopped some steps apart, so it stands beside its path":
    "ihre Platinen hielten einige Schritte versetzt an, darum steht sie neben der Bahn",
  "{0} does not come to its place": "{0} kommt nicht an ihren Ort",
  'the machine\'s file names no pins of motors: board.x = "gpio0 gpio1", step and direction, and so on (kerf explain board)':
    'die Datei der Maschine nennt keine Anschlüsse von Motoren: board.x = "gpio0 gpio1", Schritt und Richtung, und so weiter (kerf explain board)',
  "{0}: no axis is turned by that motor (motors.x2, motors.a, …)":
    "{0}: keine Achse wird von diesem Motor gedreht (motors.x2, motors.a, …)",
  "{0}: the board has the chip {1}, and the {2} has {3}: name the board that it is (kerf machine boards), or wire it without --board":
    "{0}: die Platine hat den Chip {1}, und {2} hat {3}: die richtige Platine wählen, oder keine",
  "{0}: X, Y, Z are motors {1}; outputs 1 and up are {2}{3}":
    "{0}: X, Y, Z sind die Motoren {1}; Ausgänge ab 1 sind {2}{3}",
  "; for the speed of a spindle: {0}": "; für die Drehzahl einer Spindel: {0}",
  "Name it as the motor has it printed, or less: 0.8":
    "Wie es auf dem Motor steht, oder weniger: 0.8",
  "the board is gone": "die Platine ist fort",
  "Look at its pins, its wires and its current.": "Anschlüsse, Leitungen und Strom prüfen.",
  "Answer y, n, or a number of mm.": "Mit y, n oder einer Zahl in mm antworten.",
  "a switch is not told": "ein Schalter wird nicht gemeldet",
  "{0}: its home switch is seen": "{0}: der Referenzschalter wird gesehen",
  "{0}: its home switch is seen, turned round": "{0}: der Referenzschalter wird gesehen, umgedreht",
  "Output {0}: look at its pin in board.outputs.":
    "Ausgang {0}: den Anschluss in board.outputs prüfen.",
  "there is no setting {0}": "Die Einstellung {0} gibt es nicht",
  "{0}: no {1} was good, its own is kept: look at its current and its load":
    "{0}: keine gute Probe von {1}, es bleibt beim alten Wert: Strom und Last prüfen",
  "{0}: at most {1} {2}{3}": "{0}: höchstens {1} {2}{3}",
  "no command is longer than a frame": "kein Befehl ist länger als ein Rahmen",
  "it does not take what is written into it": "er nimmt nicht an, was in ihn geschrieben wird",
  "it is a {0}, and no {1}": "er ist ein {0} und kein {1}",
  "it is no driver that is known ({0})": "er ist kein bekannter Treiber ({0})",
  "it was reset, so its settings are gone: look at its supply, then connect again":
    "er wurde zurückgesetzt, seine Einstellungen sind fort: den Strom prüfen, dann neu verbinden",
  "it is warm: less current or more air, before it switches its motor off":
    "er ist warm: weniger Strom oder mehr Luft, bevor er seinen Motor abschaltet",
  "no board answers: is it powered, is this its port and its rate, is Klipper's firmware on it?":
    "keine Platine antwortet: hat sie Strom, sind Anschluss und Rate richtig, ist die Firmware von Klipper darauf?",
  "the board was configured by another program or for another machine ({0}): reset it, then connect again":
    "ein anderes Programm hat die Platine eingerichtet, oder für eine andere Maschine ({0}): sie zurücksetzen, dann neu verbinden",
  "the board has restarted: its position is lost; look at its supply, then connect and home again":
    "die Platine hat neu begonnen: ihr Ort ist verloren; den Strom prüfen, dann neu verbinden und referenzieren",
  "the board does not answer any more: its motors stop by themselves; look at its cable and supply":
    "die Platine antwortet nicht mehr: ihre Motoren halten von selbst; Kabel und Strom prüfen",
  "motor {0} made {1} steps, {2} were planned: home the machine, and report this":
    "Motor {0} machte {1} Schritte, {2} waren geplant: die Maschine referenzieren und das melden",
  "reason {0}": "Grund {0}",
  "a motor would have to step {0} ticks after its last step, and needs {1}: lower its speed or its steps":
    "ein Motor müsste {0} Takte nach seinem letzten Schritt den nächsten machen und braucht {1}: Geschwindigkeit oder Schritte senken",
  "board {0}: {1}": "Platine {0}: {1}",
  "the motor driver does not answer: is its supply on, is its wire on this pin, is its address right?":
    "der Treiber antwortet nicht: hat er Strom, ist die Leitung am richtigen Anschluss, stimmt die Adresse?",
  "the motor driver's answer is garbled: look at the wire, and at the resistor of 1 kΩ in it":
    "die Antwort des Treibers ist verstümmelt: die Leitung und den Widerstand von 1 kΩ darin prüfen",
  "it is too hot and has switched its motor off: less current, more air":
    "er ist zu heiß und hat seinen Motor abgeschaltet: weniger Strom, mehr Luft",
  "a coil of its motor is shorted: switch the power off, then look at the plug and the cable":
    "eine Spule seines Motors ist kurzgeschlossen: den Strom abschalten, dann Stecker und Kabel prüfen",
  "a stall threshold of {0} is none: 0 to 255 of a TMC2209, -64 to 63 of one with a chip select":
    "eine Schwelle von {0} gibt es nicht: 0 bis 255 bei einem TMC2209, -64 bis 63 bei einem mit Chip-Select",
  "no board is connected": "keine Platine ist verbunden",
  "the board is busy: wait until it stands": "die Platine ist beschäftigt: warten, bis sie steht",
  "nothing moves": "nichts bewegt sich",
  "the board is shut down: clear that first": "die Platine ist abgeschaltet: das zuerst aufheben",
  "the board is shut down ({0}): reset it, then connect again":
    "die Platine ist abgeschaltet ({0}): sie zurücksetzen, dann neu verbinden",
  "the board did not take its configuration: reset it, then connect again":
    "die Platine nahm ihre Einrichtung nicht an: sie zurücksetzen, dann neu verbinden",
  "the board does not answer `{0}`: flash its firmware anew":
    "die Platine beantwortet `{0}` nicht: ihre Firmware neu aufspielen",
  "the driver of motor {0}: {1}; nothing moves":
    "der Treiber von Motor {0}: {1}; nichts bewegt sich",
  "a piece of motion does not follow the one before it: this is a mistake in Kerf":
    "ein Stück der Bewegung folgt nicht auf das davor: das ist ein Fehler in Kerf",
  "a piece of motion is for other motors: this is a mistake in Kerf":
    "ein Stück der Bewegung ist für andere Motoren: das ist ein Fehler in Kerf",
  "the machine is coming to rest: the motion goes on from there":
    "die Maschine kommt zur Ruhe: von dort geht die Bewegung weiter",
  "no current is set for it: name it in amperes, less than its motor bears":
    "für ihn ist kein Strom gesetzt: ihn in Ampere nennen, weniger, als der Motor verträgt",
  "{0} A is beyond its resistors: from {1} to {2} A":
    "{0} A geht mit seinen Widerständen nicht: von {1} bis {2} A",
  "{0} microsteps are none: 1, 2, 4 and so on up to 256":
    "{0} Mikroschritte gibt es nicht: 1, 2, 4 und so weiter bis 256",
  "{0}: height control takes a reading every {1} ms, and Z answers it {2} ms later":
    "{0}: die Höhenregelung misst alle {1} ms, und Z folgt {2} ms später",
  "{0}: height control has Z answer its switches {1} ms later":
    "{0}: die Höhenregelung folgt ihren Schaltern {1} ms später",
  "has no height control by this sensor: it reads the voltage of a torch at the pin board.height, or two switches at the pins of inputs 17 and 20 (board.inputs)":
    "hat keine Höhenregelung mit diesem Sensor: sie liest die Spannung eines Brenners am Pin board.height, oder zwei Schalter an den Pins der Eingänge 17 und 20 (board.inputs)",
  "name the pins, and set height.mode by them": "die Pins nennen und height.mode danach setzen",
  "Name two pins, too high and too low: ^gpio10 ^gpio11":
    "Zwei Pins nennen, zu hoch und zu tief: ^gpio10 ^gpio11",
  "this system has none": "dieses System hat keine",
  "motion is sent without real-time priority ({0}): on a busy computer it may be late; a limit of rtprio 1 for this user gives it (/etc/security/limits.conf)":
    "Bewegung wird ohne Echtzeitpriorität gesendet ({0}): auf einem ausgelasteten Rechner kann sie zu spät kommen; eine Grenze rtprio 1 für diesen Benutzer gibt sie (/etc/security/limits.conf)",
};
