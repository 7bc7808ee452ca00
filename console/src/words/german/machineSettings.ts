/**
 * Settings of the machine in German: name and description of each, by its key; `*` stands for an axis. The English ones are
 * the server's.
 */

import { machineSwitches, machineTools } from "./machineTools";
import { type SettingText, said } from "./settingText";

/** The driver of a motor. */
const driver = (motor: string): SettingText =>
  said(
    `Treiber ${motor}`,
    "Bauart und Pins des Motortreibers: tmc2209 gpio9 gpio8 2 an einer Leitung, tmc5160 PC4 mit Auswahlpin; leer, wenn er von Hand eingestellt ist.",
  );

/** Topics, by their English titles. */
export const topics: Readonly<Record<string, string>> = {
  "Units and axes": "Einheiten und Achsen",
  "Changing tools": "Werkzeugwechsel",
  Speeds: "Geschwindigkeiten",
  Ramps: "Rampen",
  "Table limits": "Tischgrenzen",
  "Modes of switches": "Arten der Schalter",
  Steps: "Schritte",
  "What the axes can do": "Was die Achsen können",
  "Smoothing and cutting speed": "Glättung und Schnittgeschwindigkeit",
  Cutter: "Fräser",
  Tabs: "Stege",
  "Torch, laser and heater": "Brenner, Laser und Heizung",
  Driver: "Ansteuerung",
  Preview: "Vorschau",
  Display: "Anzeige",
  Axes: "Achsen",
  Motors: "Motoren",
  Homing: "Referenzfahrt",
  "Heights of Z": "Höhen von Z",
  "Plunging and arrow keys": "Eintauchen und Pfeiltasten",
  "Simulated machine": "Simulierte Maschine",
  Delays: "Wartezeiten",
  Pausing: "Pausen",
  Intensity: "Intensität",
  "Height control": "Höhenregelung",
  Plasma: "Plasma",
  Laser: "Laser",
  Inputs: "Eingänge",
  Pendant: "Handbediengerät",
  "Emergency stop": "Not-Halt",
  Jobs: "Aufträge",
  Miscellaneous: "Verschiedenes",
  "Options of the program": "Optionen des Programms",
  "Board with step queues": "Platine mit Schrittspeicher",
  "Motor drivers with registers": "Motortreiber mit Registern",
};

const units: Readonly<Record<string, SettingText>> = {
  units: said(
    "Einheit",
    "Einheit der Längen beim Lesen und Schreiben: in oder mm. Zahlen der Datei bleiben Millimeter.",
  ),
  axes: said("Zahl der Achsen", "So viele Achsen gibt es."),
  rotary: said("Einheit von A, B, C", "Worin A, B und C gemessen werden: in, mm oder deg."),
  distance: said(
    "Entfernungen",
    "Was die Werte von Bewegungen sind: absolute Orte (SA) oder relative Strecken (SR).",
  ),
  warning_s: said(
    "Warnung vor Bewegung",
    "So lange wird vor dem Beginn einer Bewegung gewarnt (SW).",
  ),
  ask_spindle: said(
    "Vor der Spindel fragen",
    "Bevor ein Programm die Spindel startet, wird der Bediener gefragt.",
  ),
  m6_runs_c9: said(
    "M6 wechselt das Werkzeug",
    "M6 in G-Code wechselt das Werkzeug wie C9: Spindel aus, angehoben, Frage an den Bediener, gemessen, wo es einen Taster gibt.",
  ),
  spindle_device: said(
    "Gerät für die Drehzahl",
    "Ein Gerät übernimmt die Drehzahlen der Spindel (TR). Ohne eines wird der Bediener gebeten, sie einzustellen.",
  ),
  stack_limit: said(
    "Grenze des Stapels",
    "So viele Bewegungen werden gelesen, bevor das Werkzeug angehoben und der Rest gelesen wird; none ohne Grenze.",
  ),
  motion: said(
    "Bewegungsmodell",
    "shopbot (Rampen von VR), profiler (geglättete Abschnitte) oder optimal; none: optimal, wo bekannt ist, was die Achsen können, sonst shopbot.",
  ),
};

const motion: Readonly<Record<string, SettingText>> = {
  "speeds.cut.*": said("Schneiden", "Geschwindigkeit beim Schneiden; X und Y gemeinsam."),
  "speeds.jog.*": said("Eilgang", "Geschwindigkeit im Eilgang; X und Y gemeinsam."),
  "ramps.cut.*": said(
    "Anfang beim Schneiden",
    "Mit dieser Geschwindigkeit beginnen und enden Schnitte.",
  ),
  "ramps.jog.*": said(
    "Anfang im Eilgang",
    "Mit dieser Geschwindigkeit beginnen und enden Eilgänge.",
  ),
  "ramps.cut_rate_mm": said(
    "Rampe beim Schneiden",
    "Weg, auf dem ein Schnitt 2 in/s über seiner Anfangsgeschwindigkeit gewinnt.",
  ),
  "ramps.jog_rate_mm": said("Rampe im Eilgang", "Das Gleiche für Eilgänge."),
  "ramps.threshold_3d_percent": said(
    "Schwelle in 3D",
    "So scharf muss eine Ecke in 3D sein, damit gebremst wird.",
  ),
  "ramps.min_distance_mm": said(
    "Kleinster Weg",
    "Weg, über den Richtungsänderungen zusammengezählt werden.",
  ),
  "ramps.slow_corner_percent": said(
    "Langsame Ecke",
    "Geschwindigkeit an einer Ecke, die gerade noch zählt, von der des Schnitts.",
  ),
  "ramps.keypad_rate_mm": said("Rampe am Tastenfeld", "Rampe beim Fahren mit dem Tastenfeld."),
  "ramps.small_circle_mm": said(
    "Kleine Kreise",
    "Kreise mit kleinerem Durchmesser fahren mit Anfangsgeschwindigkeit.",
  ),
  "limits.low": said("Untere Grenze", "Niedrigster Ort von X, Y, Z, A, B, C am Tisch."),
  "limits.high": said("Obere Grenze", "Höchster Ort jeder Achse."),
  "limits.check": said("Grenzen prüfen", "Bewegungen über die Grenzen hinaus werden abgelehnt."),
  "steps.per_unit": said(
    "Schritte je Einheit",
    "Schritte jeder Achse für einen Millimeter oder ein Grad.",
  ),
  "steps.multipliers": said("Vielfache", "Vielfache der Auflösung im Eilgang."),
  "steps.divider": said("Teiler", "Teiler des Schrittabstands."),
  "steps.no_shift": said(
    "Auflösung bleibt",
    "Die Auflösung wird nicht umgeschaltet; Eilgänge erreichen höchstens 16 in/s.",
  ),
  "steps.circle_mm": said("Kreisstücke", "Länge der Stücke, aus denen Kreise gemacht werden."),
  "dynamics.speed_mm_s": said(
    "Höchste Geschwindigkeit",
    "Höchste Geschwindigkeit jeder Achse: X, Y, Z, A, B, C (w); none, wo sie unbekannt ist.",
  ),
  "dynamics.accel_mm_s2": said("Höchste Beschleunigung", "Höchste Beschleunigung jeder Achse."),
  "dynamics.jerk_mm_s3": said("Höchster Ruck", "Höchster Ruck jeder Achse; none lässt ihn frei."),
  "dynamics.tolerance_mm": said("Abweichung", "So weit darf der Weg den programmierten verlassen."),
  "smoothing.factor": said(
    "Glättung",
    "Eine glatte Kurve darf so viele Zehntelmillimeter von den Strecken abweichen; 0 glättet nicht.",
  ),
  "smoothing.stop_angle_deg": said(
    "Winkel zum Bremsen",
    "Ecken, die um weniger drehen, werden ungebremst durchfahren.",
  ),
  "smoothing.centripetal_percent": said(
    "Beschleunigung in Kurven",
    "Beschleunigung in Kurven, von der kleineren von X und Y.",
  ),
  "smoothing.cut_speed_mm_s": said(
    "Höchste Schnittgeschwindigkeit",
    "Höchste Schnittgeschwindigkeit der Maschine längs X, auch als „6000 mm/min“; none: die der X-Achse.",
  ),
  "smoothing.y_factor": said(
    "Faktor längs Y",
    "Die höchste Schnittgeschwindigkeit längs Y ist so vielmal die längs X.",
  ),
  "plunge.speed_mm_s": said(
    "Eintauchen",
    "Geschwindigkeit von Z oben bis zur Schnitthöhe, auch als „1200 mm/min“; höchstens die der Z-Achse.",
  ),
  "arrows.speed_percent": said(
    "Tempo der Pfeiltasten",
    "Geschwindigkeit der Pfeiltasten, von der höchsten der Achse.",
  ),
  "arrows.accel_percent": said(
    "Beschleunigung der Pfeiltasten",
    "Beschleunigung der Pfeiltasten, von der höchsten der Achse.",
  ),
  "axis.length": said(
    "Verfahrweg",
    "Weg von X, Y, Z, A (z2), B, C (w) ab der Referenz; 0 ohne Grenzen.",
  ),
  "axis.limit_movement": said(
    "Weg begrenzen",
    "Bewegungen, die den Verfahrweg verlassen, werden abgelehnt.",
  ),
};

const machine: Readonly<Record<string, SettingText>> = {
  "motors.x": said("X", "Der Motor dieser Achse, immer x."),
  "motors.y": said("Y", "Der Motor dieser Achse, immer y."),
  "motors.z": said("Z", "Der Motor dieser Achse, immer z."),
  "motors.*": said("Motor", "Welcher Motor die Achse bewegt, oder ihr zweiter ist: w, q oder r."),
  "motors.direction": said(
    "Richtung",
    "Positive Richtung von X, Y, Z, A (z2), B, C (w): forwards (vorwärts) oder backwards (rückwärts).",
  ),
  "motors.dir_delay_ns": said(
    "Richtung vor Schritt",
    "Zeit von der Richtung bis zum Schritt; 0 gibt beide zugleich aus.",
  ),
  "motors.step_delay_ns": said("Schrittpuls länger", "Verlängert den Schrittpuls."),
  "homing.*.fitted": said("Schalter vorhanden", "Die Achse hat einen Referenzschalter."),
  "homing.*.end": said("Lage", "Wo er sitzt: low (links, vorn) oder high (rechts, hinten, oben)."),
  "homing.*.fast": said("Suche", "Geschwindigkeit der Suche."),
  "homing.*.slow": said(
    "Kante",
    "Geschwindigkeit bis zur Kante; 0 nimmt den Ort, an dem der Schalter abfiel.",
  ),
  "homing.*.off": said("Abstand", "Abstand der Referenz von der Kante."),
  "homing.separate_x": said(
    "X einzeln",
    "Die beiden Motoren von X werden nach der gemeinsamen Fahrt einzeln referenziert.",
  ),
  "homing.separate_y": said("Y einzeln", "Das Gleiche für Y."),
  "homing.z2_adjustment_mm": said(
    "Ausgleich von Z2",
    "Der zweite Kopf fährt so viel weiter, nachdem er vom Schalter weg ist.",
  ),
  "homing.before_runs": said(
    "Vor Läufen",
    "Beginnt ein Lauf ohne Referenz einer Achse mit Schalter: tell meldet es, ask fragt vorher, refuse lehnt ab.",
  ),
  "homing.at_program_start": said(
    "Beim Start des Programms",
    "Achsen, die beim Start des Programms referenziert werden: eine Liste aus x, y, z, a, b, w.",
  ),
  "homing.at_job_start": said(
    "Beim Start eines Auftrags",
    "Achsen, die beim Start eines Auftrags referenziert werden.",
  ),
  "zpos.top_mm": said(
    "Z oben",
    "Höhe zwischen Formen und ohne Schnitt; 0 ist die Referenz, darunter negativ.",
  ),
  "zpos.surface_mm": said("Z Oberfläche", "Null der Schnitthöhen."),
  "zpos.bottom_mm": said("Z unten", "Höhe von Schnitten hindurch; tiefer geht das Werkzeug nie."),
  "sim.switch_at": said(
    "Schalter bei",
    "Wo der Referenzschalter jedes Motors X, Y, Z, W, Q, R einschaltet; none ohne Schalter.",
  ),
  "sim.hysteresis": said("Schaltweg", "Weg vom Einschalten bis zum Ausschalten."),
  "sim.start_at": said("Steht am Anfang bei", "Wahrer Ort jeder Achse beim Start des Programms."),
  "sim.output_delay_ns": said(
    "Abstand der Ausgänge",
    "Kürzeste Zeit von einer Änderung eines Ausgangs zur nächsten.",
  ),
  "delays.router_start_s": said(
    "Spindel",
    "Nachdem Spindel oder Klappe an ist, bei der ersten Form und nach einer Pause.",
  ),
  "delays.air_tool_s": said(
    "Druckluft",
    "Nach dem Ein- und Ausschalten eines Werkzeugausgangs, bei jeder Form.",
  ),
  "delays.bottom_type": said(
    "Ende der Wartezeit unten",
    "Was die Wartezeit unten beendet: time, oder input (Eingang EndBottomDelay) und dann die Zeit.",
  ),
  "delays.bottom_s": said("Wartezeit unten", "Die Wartezeit unten."),
  "delays.bottom_timeout_s": said(
    "Warten auf den Eingang",
    "So lange wird auf den Eingang gewartet.",
  ),
  "delays.bottom_timeout": said(
    "Kommt der Eingang nicht",
    "Was dann geschieht: pause oder continue (weiter).",
  ),
  "delays.end_s": said(
    "Wartezeit am Ende",
    "Nachdem der Schnittausgang aus ist und vor dem Anheben.",
  ),
  "delays.end_intensity": said("Intensität am Ende", "Intensität während der Wartezeit am Ende."),
  "pause.raise": said(
    "Anheben",
    "Das Werkzeug geht nach Z oben, sobald die Maschine in einer Pause steht.",
  ),
};

const work: Readonly<Record<string, SettingText>> = {
  "driver.port": said("Anschluss", "Steckplatz des Anschlusses."),
  "driver.channels": said("Kanäle", "Achse jedes Kanals: x, y, z, a, b, w (Achse C)."),
  "driver.speed_code": said("Tempo", "2 115,2, 3 230,4, 4 460,8, 5 921,6 kbaud."),
  "driver.enabled": said("Eingeschaltet", "Schritte und Ausgänge werden ausgegeben."),
  "driver.ports": said(
    "Anschlüsse von VI",
    "Was jeder Anschluss von VI ist: ein serielles Gerät, eine TCP-Adresse oder sim; leer ist auch sim.",
  ),
  "driver.outputs": said("Zahl der Ausgänge", "So viele Ausgänge hat die Steuerung."),
  "driver.pwm": said("PWM", "Die Steuerung hat PWM, für Laser oder Heizung."),
  "driver.independent": said("Achsen unabhängig", "Achsen können neben den anderen fahren (MI)."),
  "view.grid_mm": said("Gitter", "Abstand der Gitterlinien."),
  "view.table_mm": said("Tischgröße", "Größe des Tischs: X, Y, Z."),
  "view.simulate": said("Schnitt zeigen", "Der Schnitt läuft im Bild ab."),
  "view.draw_tool": said("Fräser zeichnen", "Der Fräser wird gezeichnet."),
  "view.start_actual": said("Beginn am Werkzeug", "Beginnt, wo das Werkzeug steht, sonst bei 0,0."),
  "view.show_jogs": said("Eilgänge zeichnen", "Eilgänge werden gezeichnet."),
  "display.console": said("Steuerpult zeigen", "Das Steuerpult wird gezeigt."),
  "display.comments": said("Kommentare zeigen", "Kommentare der Datei stehen bei den Meldungen."),
  "display.keypad_fixed_mm": said("Tippweg", "Weg eines Tippens am Tastenfeld."),
  "display.keypad_remote": said(
    "Tastenfeld von außen",
    "Was das Werkzeug am Tastenfeld bewegt: 0 Maus und Tasten, 1 auch ein Handbediengerät an Eingängen, 2 auch ein anderes Programm.",
  ),
  "display.part_log": said(
    "Protokoll der Programme",
    "Das Protokoll der Programme wird geschrieben.",
  ),
  "display.system_log": said(
    "Protokoll des Systems",
    "Das Protokoll des Systems wird geschrieben.",
  ),
  "display.message_twips": said(
    "Fenster der Meldungen",
    "Fenster der Meldungen: X, Y, Breite, Höhe.",
  ),
  "display.keypad_auto_off": said(
    "Ausgänge aus",
    "Ausgänge gehen aus, wenn das Tastenfeld geschlossen wird.",
  ),
  "display.progress": said("Fortschritt zeigen", "Der Fortschritt der Datei wird gezeigt."),
  "display.easy": said("Anzeige EASY", "Die Anzeige EASY, sonst FULL."),
  "job.origin_mm": said(
    "Ursprung",
    "Wo der Ursprung der Aufträge liegt: X und Y ab der Referenz. Ein Auftrag mit eigenem behält ihn.",
  ),
  "job.finish_mm": said(
    "Endlage",
    "Wohin der Kopf nach einem Auftrag fährt: X und Y ab seinem Ursprung.",
  ),
  "job.change_origin_at_start": said(
    "Ursprung beim Start",
    "Jeder Start nimmt den jetzigen Ort als Ursprung.",
  ),
  "job.repeats": said("Wiederholungen", "So oft wird ein Auftrag geschnitten."),
  "job.external_start": said(
    "Start von außen",
    "Der Eingang, den sich die Referenz von W teilt, startet Aufträge, oder ist die Tür, die zu sein muss.",
  ),
  "job.heads": said(
    "Köpfe",
    "Welche Köpfe schneiden: z allein, oder both, der zweite neben dem ersten.",
  ),
  "job.two_jigs": said(
    "Zwei Vorrichtungen",
    "Zwei Vorrichtungen, jede mit einem Eingang zum Starten.",
  ),
  "job.divider_mm": said(
    "Trennlinie",
    "Was links von diesem X ab der Referenz liegt, ist Vorrichtung 1.",
  ),
  "misc.double_start": said(
    "Doppelter Start",
    "Der erste Start bereitet vor und wartet, der zweite schneidet.",
  ),
  "misc.tangential": said("Tangential", "Die Achse w hält das Werkzeug längs des Wegs."),
  "misc.tangential_endless": said(
    "Tangential ohne Ende",
    "Die tangentiale Achse dreht ohne Ende: Aufträge achten nicht auf die Grenzen von C.",
  ),
  "misc.runtime_drawing": said(
    "Zeichnen im Lauf",
    "0 nie in Bewegung, 10 immer, n bis n Zehntel der höchsten Geschwindigkeit.",
  ),
  "misc.outputs_stay_on": said(
    "Ausgänge bleiben an",
    "Ausgänge bleiben an, wenn die Maschine steht und angehalten, gesperrt oder verlassen wird.",
  ),
  "options.devices": said("Serielle Geräte", "Geräte der seriellen Anschlüsse 1 bis 4."),
  "options.console": said(
    "Steuerpult vorhanden",
    "An seinem seriellen Anschluss gibt es ein Steuerpult.",
  ),
  "options.console_port": said("Anschluss des Steuerpults", "Serieller Anschluss des Steuerpults."),
  "options.console_baud": said("Baudrate des Steuerpults", "Seine Geschwindigkeit."),
  "options.send_port": said(
    "Anschluss zum Senden",
    "Serieller Anschluss, über den Dateien gesendet werden.",
  ),
  "options.send_baud": said("Baudrate zum Senden", "Seine Geschwindigkeit."),
  "options.controller": said(
    "Steuerung",
    "Die Steuerung dieser Maschine, wie --machine sie nennt: grbl:/dev/ttyUSB0; leer ist die simulierte Maschine. Sie wird angesprochen, wo --machine diese Datei oder gespeicherte Maschine nennt.",
  ),
  "options.firmware": said(
    "Firmware laden",
    "Befehl, der Firmware in eine echte Steuerung lädt (UI); {port} steht für ihren Anschluss.",
  ),
  "options.warm_up": said(
    "Aufwärmen der Spindel",
    "Schritte, in denen die Spindel warm läuft: Prozent ihrer größten Drehzahl und Minuten, 25:2, 50:2.",
  ),
  "options.filter_mm": said(
    "Punkte ausdünnen",
    "Punkte von Wegen, die näher beieinander liegen, fallen weg; 0 keine.",
  ),
  "options.join_mm": said("Fügeabstand", "Abstand, der beim Verbinden vorgeschlagen wird."),
  "options.pick_radius_px": said("Fangradius", "So nah wählt die Maus aus."),
  "options.window_expansion_percent": said(
    "Rand des Bilds",
    "So viel größer als das Gezeichnete ist das Bild, das alles zeigt.",
  ),
};

const board: Readonly<Record<string, SettingText>> = {
  "drivers.spi": said("SPI", "MISO, MOSI und SCK der Treiber mit Auswahlpin."),
  "drivers.current_a": said(
    "Strom",
    "Strom einer Spule, solange der Motor dreht, Effektivwert in Ampere.",
  ),
  "drivers.hold": said("Strom im Stand", "Anteil des Stroms, solange der Motor steht."),
  "drivers.ohms": said("Messwiderstand", "Messwiderstände in Ohm; 0 für die üblichen der Bauart."),
  "drivers.microsteps": said("Mikroschritte", "Mikroschritte eines ganzen Schritts."),
  "drivers.interpolates": said(
    "Interpolation",
    "Die Treiber machen von selbst 256 Mikroschritte aus jedem ganzen Schritt.",
  ),
  "drivers.quiet": said("Leise", "StealthChop statt SpreadCycle."),
  "drivers.stall": said(
    "Blockiererkennung",
    "Schwellen, ab denen ein blockierter Motor gemeldet wird; 0, wo keiner gemeldet wird.",
  ),
  "drivers.x": driver("X"),
  "drivers.y": driver("Y"),
  "drivers.z": driver("Z"),
  "drivers.w": driver("W"),
  "drivers.q": driver("Q"),
  "drivers.r": driver("R"),
  "board.others": said(
    "Weitere Platinen",
    "Weitere Platinen mit ihrem Anschluss: „tools /dev/ttyACM1“; ihre Anschlüsse heißen tools:gpio4.",
  ),
  "board.*": said(
    "Motor",
    "Anschlüsse für Schritt und Richtung: „gpio0 gpio1“; ! davor kehrt den Pegel um.",
  ),
  "board.enable": said(
    "Freigabe",
    "Anschluss, der allen Motoren Strom gibt; leer, wo sie ihn immer haben.",
  ),
  "board.home_*": said(
    "Referenzschalter",
    "Anschluss des Referenzschalters; ^ davor zieht ihn hoch, ~ herunter.",
  ),
  "board.outputs": said(
    "Ausgänge",
    "Ausgänge der Programme mit ihren Anschlüssen: „1 gpio20, 2 !gpio21“.",
  ),
  "board.spindle": said(
    "Spindel",
    "Anschluss der Drehzahl, der für einen Anteil der Zeit an ist; leer ohne Spindel.",
  ),
  "board.spindle_rpm": said(
    "Volle Drehzahl",
    "Drehzahl, wenn der Anschluss immer an ist, Umdrehungen je Minute.",
  ),
  "board.spindle_hz": said("Takt der Spindel", "Takt des Anschlusses der Spindel."),
  "board.error_us": said(
    "Abweichung der Schritte",
    "Wie weit ein Schritt höchstens von seinem geplanten Zeitpunkt liegt; ist es mehr, gehen weniger Bytes über die Leitung.",
  ),
  "board.pwm": said(
    "PWM-Kanäle",
    "PWM-Kanäle mit ihren Anschlüssen, jeder einen Teil der Zeit an: „1 gpio5, 2 gpio6“; 1 ist E0 von M67 und M68.",
  ),
  "board.pwm_hz": said("Takt der PWM-Kanäle", "Takt der Anschlüsse der PWM-Kanäle."),
  "board.height": said(
    "Höhe des Brenners",
    "Anschluss, der die Höhe des Brenners misst: die geteilte Spannung seines Lichtbogens; leer, wenn es keinen gibt.",
  ),
  "board.inputs": said(
    "Eingänge",
    "Eingänge der Programme mit ihren Anschlüssen, höchstens acht: „3 ^gpio22“.",
  ),
  "board.pulse_us": said("Schrittpuls", "Kleinste Breite eines Schrittpulses."),
  "board.turn_us": said(
    "Richtung vor Schritt",
    "Zeit, die die Endstufen zwischen Richtung und Schritt brauchen.",
  ),
  "board.both_edges": said(
    "Beide Flanken",
    "Jede Flanke ist ein Schritt, wo Platine und Endstufen es können.",
  ),
  "board.steps_s": said(
    "Höchste Schrittrate",
    "So viele Schritte in der Sekunde macht ein Motor höchstens.",
  ),
  "board.deadline_s": said(
    "Frist ohne Wort",
    "Nach so viel Zeit ohne ein Wort des Rechners hält die Platine alle Motoren selbst an.",
  ),
  "board.watch_s": said(
    "Frist der Ausgänge",
    "So lange bleibt ein Ausgang an, wenn der Rechner schweigt; dann schaltet die Platine alle aus.",
  ),
};

const toolChanges: Readonly<Record<string, SettingText>> = {
  "tool_change.place_x": said(
    "Wechselort X",
    "X des Ortes, an dem der Bediener das Werkzeug wechselt, vom Tisch aus; none: dort, wo es steht.",
  ),
  "tool_change.place_y": said(
    "Wechselort Y",
    "Y des Ortes, an dem der Bediener das Werkzeug wechselt, vom Tisch aus; none: dort, wo es steht.",
  ),
  "tool_change.sensor_input": said(
    "Eingang des Werkzeugtasters",
    "Eingang des Tasters oder der festen Platte, an der Werkzeuge beim Wechsel gemessen werden; none ohne.",
  ),
  "tool_change.plate_input": said(
    "Eingang einer losen Platte",
    "Eingang einer losen Platte: der Bediener legt sie vor und nach einem Wechsel unter das Werkzeug; none ohne.",
  ),
  "tool_change.sensor_x": said(
    "Werkzeugtaster X",
    "X des Tasters, der Werkzeuge misst, vom Tisch aus.",
  ),
  "tool_change.sensor_y": said(
    "Werkzeugtaster Y",
    "Y des Tasters, der Werkzeuge misst, vom Tisch aus.",
  ),
  "tool_change.sensor_reach": said(
    "Weg zum Werkzeugtaster",
    "So weit sucht das Werkzeug den Taster unterhalb der sicheren Höhe; none: 4 Zoll oder was my_variables.sbc sagt.",
  ),
  "tool_change.sensor_speed": said(
    "Geschwindigkeit des Messens",
    "So schnell fährt das Werkzeug auf den Taster; none: wie bei der Tastplatte in my_variables.sbc.",
  ),
  "tool_change.keeps_lengths": said(
    "Werkzeuge behalten ihre Länge",
    "Werkzeuge behalten in ihren Haltern ihre Länge: Eines, dessen Länge bekannt ist, wird nicht neu gemessen.",
  ),
};

/** All of them. */
export const machineSettings: Readonly<Record<string, SettingText>> = {
  ...units,
  ...toolChanges,
  ...motion,
  ...machineSwitches,
  ...machineTools,
  ...machine,
  ...work,
  ...board,
};
