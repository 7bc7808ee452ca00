/** German texts of the settings of switches and tools, as those of the others. */

import { type SettingText, said } from "./settingText";

export const machineSwitches: Readonly<Record<string, SettingText>> = {
  "io.limits_active": said("Endschalter halten an", "Endschalter halten die Bewegung an."),
  "io.input4_normally_open": said(
    "Eingang 4 als Schließer",
    "Eingang 4 ist ein Halt, der im Ruhezustand offen ist.",
  ),
  "io.analog": said("Analog", "0 nichts, 1 Brenner, 2 Laser, 3 analog 1, 4 analog 2, 5 beide."),
  "io.inputs": said(
    "Eingänge",
    "Art jedes Eingangs: 0 gewöhnlich, 1 Endschalter als Schließer, 2 als Öffner, 3 Halt als Schließer, 4 als Öffner.",
  ),
  "io.outputs": said("Ausgänge", "Art jedes Ausgangs, wie VN sie nennt."),
  "io.output4": said("Ausgang 4", "Art von Ausgang 4."),
  "io.interlock": said("Schutzhaube", "Der Eingang, der EIN ist, solange die Haube offen steht."),
  "ports.card": said(
    "Beschaltung",
    "Wie Eingänge beschaltet sind: none, pci (aktiv an Masse) oder io (aktiv bei Spannung).",
  ),
  "ports.invert_a": said("A umgekehrt", "Eingänge A0 bis A7, deren Pegel umgekehrt ist."),
  "ports.invert_b": said("B umgekehrt", "Eingänge B0 bis B7, deren Pegel umgekehrt ist."),
  "pendant.fast": said(
    "Taste für Eilgang",
    "Eingang der Taste für Eilgang: gehalten fahren die anderen so schnell; 0 ohne Taste.",
  ),
  "pendant.close": said(
    "Taste zum Schließen",
    "Eingang der Taste, die das Tastenfeld schließt; 0 ohne Taste.",
  ),
  "pendant.*": said("Tasten", "Eingänge der Tasten in Richtung plus und minus; 0 ohne Taste."),
  "estop.active": said(
    "Pegel",
    "Der Pegel, der anhält: 1, oder 0, damit auch ein gebrochener Draht anhält.",
  ),
  "estop.cuts_power": said(
    "Trennt den Strom",
    "Eingang 4 trennt die Spindeln sofort vom Strom, die Motoren nach 5 s (Alpha-Maschinen): nichts läuft weiter.",
  ),
};

export const machineTools: Readonly<Record<string, SettingText>> = {
  "cutter.diameter_mm": said("Durchmesser", "Durchmesser des Fräsers."),
  "cutter.safe_z_mm": said("Sichere Höhe", "Höhe für MH, JH und Fahrten; none schaltet sie aus."),
  "cutter.safe_a_mm": said("Sichere Höhe von A", "Höhe der A-Achse für MH und JH."),
  "cutter.plunge": said(
    "Vorzeichen nach unten",
    "Vorzeichen eines Eintauchens nach unten: minus oder plus.",
  ),
  "cutter.pocket_overlap_percent": said(
    "Überlappung in Taschen",
    "So weit überlappen sich die Ringe einer Tasche.",
  ),
  "cutter.trigger.on_at_mm": said(
    "Auslöser ein bei",
    "Der ausgelöste Ausgang geht EIN, wenn dieser Ort abwärts durchfahren wird.",
  ),
  "cutter.trigger.off_at_mm": said(
    "Auslöser aus bei",
    "Er geht AUS, wenn dieser Ort aufwärts durchfahren wird.",
  ),
  "cutter.trigger.axis": said("Achse des Auslösers", "Die Achse, die auslöst: z oder a."),
  "cutter.trigger.output": said("Ausgang des Auslösers", "Der ausgelöste Ausgang."),
  "tabs.up_mm": said("Dicke", "Dicke eines Stegs."),
  "tabs.next_mm": said("Abstand", "Weg zwischen zwei Stegen."),
  "tabs.size_mm": said("Länge", "Länge der flachen Oberseite."),
  "tabs.lead_mm": said("Schräge", "Länge jeder Schräge längs des Wegs."),
  "tabs.count": said("Anzahl", "So viele einfügen, dann aufhören."),
  "tabs.start_mm": said("Erster Steg", "Weg bis zum ersten Steg; none: wie der Abstand."),
  "torch.on": said("Ein", "Ein oder aus."),
  "torch.rate": said("Anteil für Z", "Anteil der Geschwindigkeit in XY, der für Z genommen wird."),
  "torch.low_percent": said("Puls in Ruhe", "Pulsbreite in Ruhe."),
  "torch.high_percent": said("Puls bei vollem Tempo", "Pulsbreite bei voller Geschwindigkeit."),
  "torch.frequency_khz": said("Frequenz", "Frequenz der Pulse."),
  "torch.low_cycle": said("Zyklus", "Kurze Zykluszeit."),
  "torch.temperature": said("Temperatur", "Solltemperatur der Heizung."),
  "intensity.output": said("Ausgeben", "Die Intensität geht an den Anschluss."),
  "intensity.table": said("Tabelle", "Intensität zu jeder der 128 Stufen der Geschwindigkeit."),
  "intensity.scale_percent": said("Maßstab", "Maßstab der Ausgabe."),
  "intensity.strict_clip": said(
    "Unten gerundet",
    "Die untere Grenze wird aufgerundet, damit kein Puls kürzer ist als der kürzeste.",
  ),
  "intensity.low_bit_at_bottom": said(
    "Niedrigstes Bit unten",
    "Das niedrigste Bit ist während der Wartezeit unten gesetzt (Brennbit).",
  ),
  "intensity.port": said(
    "Anschluss",
    "Paralleler Anschluss für Intensität und Laserfrequenz: 1 oder 2.",
  ),
  "height.on": said("Ein", "Die Höhenregelung wirkt in durchgeschnittenen Formen."),
  "height.mode": said(
    "Messart",
    "Wie die Höhe gemessen wird: simple (zwei Eingänge) oder proportional (Messwerte).",
  ),
  "height.speed_mm_s": said(
    "Höchste Geschwindigkeit",
    "Höchste Geschwindigkeit von Z bei Höhenregelung; höchstens die der Achse.",
  ),
  "height.accel_mm_s2": said(
    "Höchste Beschleunigung",
    "Höchste Beschleunigung von Z bei Höhenregelung.",
  ),
  "height.activation_percent": said(
    "Wirkt ab",
    "Wirkt über diesem Anteil der Schnittgeschwindigkeit; 0 immer.",
  ),
  "height.between": said(
    "Auch dazwischen",
    "Wirkt auch zwischen den Formen. Vorsicht bei hohem Tempo in X und Y.",
  ),
  "height.x_set_point": said("Sollwert längs X", "Gewünschter Messwert beim Schneiden längs X."),
  "height.y_set_point": said("Sollwert längs Y", "Gewünschter Messwert beim Schneiden längs Y."),
  "height.k": said("Schritte je Messwert", "Schritte des Z-Motors für eine Einheit des Messwerts."),
  "height.scale_mm": said("Weg je Messwert", "Millimeter für eine Einheit des Messwerts."),
  "height.display_accuracy_mm": said(
    "Anzeige ab",
    "Größere Fehler werden in anderer Farbe gezeichnet.",
  ),
  "height.invert": said("Umgekehrt", "Ein größerer Messwert heißt ein kleinerer Abstand."),
  "height.port": said("Anschluss", "Serieller Anschluss der Messwerte."),
  "height.baud": said("Baudrate", "Seine Geschwindigkeit."),
  "plasma.use": said("Startfolge", "Die Startfolge des Plasmas wird benutzt."),
  "plasma.initial_height_mm": said("Anfangshöhe", "Höhe über dem Ort, an dem Zu-nah kam."),
  "plasma.initial_wait_s": said(
    "Wartezeit am Anfang",
    "Wartezeit nach dem Lichtbogen, in der sein Eingang nicht beachtet wird.",
  ),
  "plasma.debounce_s": said(
    "Entprellen",
    "So lange wird der Eingang des Lichtbogens ab dem Schneiden nicht beachtet.",
  ),
  "plasma.arc_timeout_s": said(
    "Warten auf den Lichtbogen",
    "So lange wird auf den Lichtbogen gewartet.",
  ),
  "laser.use": said("Laser", "Ein Laser ist das Werkzeug."),
  "laser.type": said("Art", "Die Art: cw (dauernd) oder pwm (gepulst)."),
  "laser.cut_hz": said("Frequenz beim Schneiden", "Pulsfrequenz beim Schneiden."),
  "laser.min_pulse_us": said("Kürzester Puls", "Kürzester Puls."),
  "laser.max_pulse_us": said("Längster Puls", "Längster Puls."),
  "laser.legacy_board": said(
    "Alte Platine",
    "Eine alte Platine: das niedrigste Bit gibt mit Ausgang 1 volle Intensität, mit Ausgang 2 keine.",
  ),
  "laser.engrave_cut": said(
    "Ausgang zum Gravieren",
    "Schnittausgang von Ebenen, die graviert und nicht durchstochen werden.",
  ),
  "laser.pierce.use": said(
    "Durchstechen",
    "Das Durchstechen tritt an die Stelle der Wartezeit unten.",
  ),
  "laser.pierce.hz": said("Frequenz beim Durchstechen", "Pulsfrequenz beim Durchstechen."),
  "laser.pierce.height_mm": said("Höhe beim Durchstechen", "Höhe über der Oberfläche."),
  "laser.pierce.gas_tool": said("Gas beim Durchstechen", "Werkzeugausgang des Gases."),
  "laser.pierce.gas_wait_ms": said("Warten auf das Gas", "Wartezeit auf das Gas zum Durchstechen."),
  "laser.pierce.intensity": said(
    "Intensität beim Durchstechen",
    "Intensität, durch die Tabelle übersetzt.",
  ),
  "laser.pierce.time_ms": said("Zeit beim Durchstechen", "Zeit, die der Laser an ist."),
  "laser.pierce.purge_ms": said("Spülen", "Wartezeit, in der das Schneidgas das andere verdrängt."),
  "laser.gas.tool": said("Schneidgas", "Werkzeugausgang des Schneidgases."),
  "laser.gas.wait_ms": said("Warten auf Schneidgas", "Wartezeit auf das Schneidgas."),
  "laser.gas.overrides": said(
    "Schneidgas geht vor",
    "Es gilt anstelle des Werkzeugausgangs der Ebene.",
  ),
};
