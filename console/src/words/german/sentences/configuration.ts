/** Sentences about settings that contradict each other, bounds and moves by hand, in German. */

export const configurationSentences: Readonly<Record<string, string>> = {
  "motor {0} drives two axes: {1} and {2}": "Motor {0} treibt zwei Achsen: {1} und {2}",
  "One motor drives one axis.": "Ein Motor treibt eine Achse.",
  "axis A has two motors: motors.a and motors.z2":
    "Achse A hat zwei Motoren: motors.a und motors.z2",
  "The second head is axis A of part files: set one of the two to none.":
    "Der zweite Kopf ist in Programmen die Achse A: einen der beiden auf none setzen.",
  "job.heads is both, but there is no second head: motors.z2 is none":
    "job.heads ist both, aber es gibt keinen zweiten Kopf: motors.z2 ist none",
  "Tell which motor drives the second head, or let job.heads be z.":
    "Den Motor des zweiten Kopfs nennen, oder job.heads auf z setzen.",
  "the second head (motors.z2) is axis A, which rotary measures in degrees":
    "der zweite Kopf (motors.z2) ist Achse A, die rotary in Grad misst",
  "Let rotary begin with mm or in.": "rotary mit mm oder in beginnen lassen.",
  "{0} is true, but {1} is none": "{0} ist true, aber {1} ist none",
  "Only two motors can be homed apart.": "Nur zwei Motoren lassen sich getrennt referenzieren.",
  "misc.tangential is true, but motors.w is none":
    "misc.tangential ist true, aber motors.w ist none",
  "Tell which motor turns the tool: w, q or r.":
    "Den Motor nennen, der das Werkzeug dreht: w, q oder r.",
  "the tangential axis is C, which rotary does not measure in degrees":
    "die tangentiale Achse ist C, die rotary nicht in Grad misst",
  "Let rotary end with deg.": "rotary mit deg enden lassen.",
  "a step pulse takes {0} ns (motors.step_delay_ns and sim.output_delay_ns), but at its highest speed axis {1} steps every {2} ns":
    "ein Schrittpuls dauert {0} ns (motors.step_delay_ns und sim.output_delay_ns), aber bei höchster Geschwindigkeit macht Achse {1} alle {2} ns einen Schritt",
  "Shorten the step delay, or lower speed or steps.":
    "Die Schrittzeit kürzen, oder Geschwindigkeit oder Schritte senken.",
  "Each key has an input of its own that stops nothing, or 0.":
    "Jede Taste hat einen eigenen Eingang, der nichts anhält, oder 0.",
  "input {0} is a key of {1} and of {2}": "Eingang {0} ist eine Taste von {1} und von {2}",
  "input {0} is a key of {1} and stops the machine (VN)":
    "Eingang {0} ist eine Taste von {1} und hält die Maschine an (VN)",
  "limits.low is above limits.high for axis {0}": "limits.low liegt für Achse {0} über limits.high",
  "The low end of an axis is at most its high end.":
    "Das untere Ende einer Achse liegt höchstens am oberen.",
  "{0} ({1}) is above {2} ({3})": "{0} ({1}) liegt über {2} ({3})",
  "Z top is the highest, Z bottom the lowest of the three.":
    "Von den dreien ist Z oben am höchsten, Z unten am tiefsten.",
  "zpos.bottom_mm ({0}) is below the travel of Z ({1})":
    "zpos.bottom_mm ({0}) liegt unter dem Weg von Z ({1})",
  "The tool goes down from home by the third value of axis.length at most.":
    "Vom Referenzpunkt geht das Werkzeug höchstens um den dritten Wert von axis.length hinunter.",
  "{0} ({1}) is more than the travel of {2} ({3})": "{0} ({1}) ist mehr als der Weg von {2} ({3})",
  "Home lies so far from the switch, and axis.length is all the axis has.":
    "So weit liegt der Referenzpunkt vom Schalter, und mehr als axis.length hat die Achse nicht.",
  "{0} and {1} are the same serial port, {2}": "{0} und {1} sind derselbe serielle Anschluss, {2}",
  "Each of the three has a port of its own.": "Jedes der drei hat einen eigenen Anschluss.",
  "Lower it, or raise what the axis can do (dynamics).":
    "Ihn senken, oder heben, was die Achse kann (dynamics).",
  "{0} is {1} mm/s ({2} mm/min), axis {3} reaches {4} ({5})":
    "{0} ist {1} mm/s ({2} mm/min), Achse {3} erreicht {4} ({5})",
  "homing.b.fitted is true, but no input is a home switch of B":
    "homing.b.fitted ist true, aber kein Eingang ist ein Referenzschalter von B",
  "There are inputs for X, Y, Z and W: set it to false, and set the zero of B by hand.":
    "Eingänge gibt es für X, Y, Z und W: ihn auf false setzen und B von Hand nullen.",
  "the W home switch": "der Referenzschalter von W",
  "Too-Close of the plasma start": "Zu-nah des Plasmastarts",
  "the external start": "der Start von außen",
  "input A1 (WHOME) is {0} ({1}) and {2} ({3})": "Eingang A1 (WHOME) ist {0} ({1}) und {2} ({3})",
  "The input serves one purpose: turn the others off.":
    "Der Eingang dient einem Zweck: die anderen ausschalten.",
  "job.external_start and job.two_jigs cannot both be used":
    "job.external_start und job.two_jigs gehen nicht zusammen",
  "Jigs have start inputs of their own.": "Vorrichtungen haben eigene Starteingänge.",
  "plasma.use and laser.pierce.use are both true":
    "plasma.use und laser.pierce.use sind beide true",
  "A shape begins with one of the two sequences.":
    "Eine Form beginnt mit einem der beiden Abläufe.",
  "laser.use is true, but laser.type is none": "laser.use ist true, aber laser.type ist none",
  "Tell the kind of laser: cw or pwm.": "Die Art des Lasers nennen: cw oder pwm.",
  "no valid laser pulse width: at {0} Hz ({1}) the period is {2} µs, the pulse {3} µs at least (laser.min_pulse_us) and {4} µs at most (laser.max_pulse_us)":
    "keine gültige Pulsbreite des Lasers: bei {0} Hz ({1}) dauert die Periode {2} µs, der Puls mindestens {3} µs (laser.min_pulse_us) und höchstens {4} µs (laser.max_pulse_us)",
  "Lower the frequency, or let pulses be shorter.":
    "Die Frequenz senken, oder kürzere Pulse zulassen.",
  "{0} cannot be a date or a number this large": "{0} kann kein Datum und keine so große Zahl sein",
  "the system knows the interrupts of its ports: options.devices names them":
    "das System kennt die Interrupts seiner Anschlüsse: options.devices nennt sie",
  "{0} is ignored: {1}": "{0} gilt nicht: {1}",
  "`kerf get` lists every setting": "kerf get nennt alle Einstellungen",
  "Out of bounds: {0} ends at {1}": "Außerhalb: {0} endet bei {1}",
  "the keypad moves nothing in preview": "Das Tastenfeld bewegt in der Vorschau nichts.",
  "SM sets Move/Cut mode": "SM stellt auf Bewegen und Schneiden",
  "Out of bounds: {0} would reach {1}": "Außerhalb: {0} käme nach {1}",
  "{0} goes from {1} to {2}": "{0} geht von {1} bis {2}",
  "move to home": "zum Referenzpunkt fahren",
  "move to origin": "zum Ursprung fahren",
  "move to finish": "zum Endort fahren",
  "move to": "fahren nach",
  "move along": "fahren längs",
  "release the stop input": "den Halteingang lösen",
  ", Z bottom (zpos.bottom_mm)": ", Z unten (zpos.bottom_mm)",
  "mm or deg": "mm oder Grad",
  "mm/s or deg/s": "mm/s oder Grad/s",
  "mm/s² or deg/s²": "mm/s² oder Grad/s²",
  "mm/s³ or deg/s³": "mm/s³ oder Grad/s³",
  "steps for a mm or degree": "Schritte für einen mm oder ein Grad",
  "a number of mm/s, or one with its unit: {0}": "eine Zahl in mm/s, oder eine mit Einheit: {0}",
  "a finite number": "eine endliche Zahl",
  "greater than 0": "größer als 0",
  "0 or greater": "0 oder größer",
  "{0} to {1}, or 0 for none": "{0} bis {1}, oder 0 für keine",
  "one of {0}": "eines von {0}",
  "greater than 0, or inf": "größer als 0, oder inf",
  "{0} home not found{1}": "{0}: Referenzpunkt nicht gefunden{1}",
  "there are no settings {0}; {1}": "die Einstellungen {0} gibt es nicht; {1}",
  "'{0}' is no name of a settings file": "»{0}« ist kein Name einer Datei mit Einstellungen",
  "tool_change.plate_input names a loose plate, and tool_change.sensor_input a sensor":
    "tool_change.plate_input nennt eine lose Platte, und tool_change.sensor_input einen Sensor",
  "Tools are measured at one of them: set the other to none.":
    "Werkzeuge werden an einem davon gemessen: das andere auf none setzen.",
  "tool_change.sensor_input names a sensor, but tool_change.sensor_x or tool_change.sensor_y is none":
    "tool_change.sensor_input nennt einen Sensor, aber tool_change.sensor_x oder tool_change.sensor_y fehlt",
  "Give the place of the sensor first.": "Zuerst den Ort des Sensors angeben.",
  "the tools hold until Kerf ends, they cannot be kept: {0}":
    "die Werkzeuge gelten, bis Kerf endet, sie lassen sich nicht speichern: {0}",
  "tools have numbers from 1": "Werkzeuge haben Nummern ab 1",
  "a tool has a diameter of 0 or more and a length, in millimetres":
    "ein Werkzeug hat einen Durchmesser von 0 oder mehr und eine Länge, in Millimetern",
  "the name of a tool is one line of at most {0} bytes":
    "der Name eines Werkzeugs ist eine Zeile von höchstens {0} Bytes",
};
