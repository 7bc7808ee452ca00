/** Explanations of the settings that controllers of the grbl family keep by number. */

export const settingsExplained: Readonly<Record<string, string>> = {
  "Length of a step pulse: motor drivers miss a shorter one than they need.":
    "Länge eines Schrittimpulses: einen kürzeren, als sie brauchen, übersehen die Motortreiber.",
  "Time for which the motors stay powered after a move; 255 keeps them powered.":
    "Zeit, die die Motoren nach einer Bewegung Strom behalten; bei 255 behalten sie ihn immer.",
  "Reverses the level of step pulses; add 1 for X, 2 for Y, 4 for Z.":
    "Kehrt den Pegel der Schrittimpulse um; 1 für X, 2 für Y, 4 für Z werden addiert.",
  "Reverses the direction of an axis; add 1 for X, 2 for Y, 4 for Z.":
    "Kehrt die Richtung einer Achse um; 1 für X, 2 für Y, 4 für Z werden addiert.",
  "Reverses the level that enables the motor drivers.":
    "Kehrt den Pegel um, der die Motortreiber freigibt.",
  "Reverses the limit switches, for switches that open when they are hit.":
    "Kehrt die Endschalter um, für Schalter, die öffnen, wenn sie angefahren werden.",
  "Reverses the probe input, for a probe that opens on contact.":
    "Kehrt den Tastereingang um, für einen Taster, der bei Berührung öffnet.",
  "Chooses what status reports tell; Kerf sets what it needs while it drives.":
    "Wählt, was Statusberichte melden; Kerf stellt ein, was es braucht, solange es steuert.",
  "Decides how fast corners are taken: a greater one is faster and rougher.":
    "Bestimmt, wie schnell Ecken gefahren werden: ein größerer Wert ist schneller und rauer.",
  "Distance by which the chords of an arc may leave its circle.":
    "Abstand, um den die Sehnen eines Bogens von seinem Kreis abweichen dürfen.",
  "Reports places and feeds in inches in place of millimetres.":
    "Meldet Orte und Vorschübe in Zoll statt in Millimetern.",
  "Ends a move that would leave the travel of an axis with an alarm; needs homing.":
    "Beendet eine Bewegung, die den Verfahrweg einer Achse verließe, mit einem Alarm; braucht eine Referenzfahrt.",
  "Stops at once with an alarm when a limit switch is hit.":
    "Hält sofort mit einem Alarm an, wenn ein Endschalter angefahren wird.",
  "Allows homing; the controller stays locked after power-up until it is homed.":
    "Erlaubt die Referenzfahrt; nach dem Einschalten bleibt die Steuerung gesperrt, bis sie gefahren ist.",
  "Chooses the low end of an axis for its home; add 1 for X, 2 for Y, 4 for Z.":
    "Wählt das untere Ende einer Achse als Referenzpunkt; 1 für X, 2 für Y, 4 für Z werden addiert.",
  "Feed of the slow approach, which finds the exact place of the switch.":
    "Vorschub der langsamen Anfahrt, die den genauen Ort des Schalters findet.",
  "Feed of the first search for the switch.": "Vorschub der ersten Suche nach dem Schalter.",
  "Time that a switch has to stop bouncing in.": "Zeit, die ein Schalter zum Ausprellen hat.",
  "Distance from the switch after homing; too short a one leaves the switch hit.":
    "Abstand vom Schalter nach der Referenzfahrt; ist er zu kurz, bleibt der Schalter gedrückt.",
  "Spindle speed at full output: S words are scaled by it.":
    "Spindeldrehzahl bei voller Ausgabe: S-Worte werden nach ihr bemessen.",
  "Spindle speed at the least output: no S word gives a lower one but 0.":
    "Spindeldrehzahl bei kleinster Ausgabe: kein S-Wort ergibt eine kleinere außer 0.",
  "Drives a router (0), a laser whose beam follows the speed (1), or a lathe (2).":
    "Steuert eine Fräse (0), einen Laser, dessen Strahl der Geschwindigkeit folgt (1), oder eine Drehbank (2).",
  "Steps that move the axis by a millimetre or a degree.":
    "Schritte, die die Achse um einen Millimeter oder ein Grad bewegen.",
  "Highest speed of the axis, which rapid moves have.":
    "Höchste Geschwindigkeit der Achse, mit der Eilgänge fahren.",
  "Acceleration of the axis; the motor loses steps where it is too high.":
    "Beschleunigung der Achse; ist sie zu hoch, verliert der Motor Schritte.",
  "Travel of the axis from its home; soft limits and the search for home go by it.":
    "Verfahrweg der Achse von ihrem Referenzpunkt; Softwaregrenzen und die Suche nach ihm richten sich danach.",
  "Reverses the second motor of an axis that has two, on top of $3.":
    "Kehrt den zweiten Motor einer Achse um, die zwei hat, zusätzlich zu $3.",
  "Switches the PWM output of the spindle on, and says how S words work on it.":
    "Schaltet den PWM-Ausgang der Spindel ein und sagt, wie S-Worte auf ihn wirken.",
  "Reverses inputs for reset, hold, cycle start, door and others, a bit each.":
    "Kehrt Eingänge für Reset, Halt, Start, Tür und andere um, je ein Bit.",
  "Reverses the coolant outputs: 1 for flood, 2 for mist.":
    "Kehrt die Kühlmittelausgänge um: 1 für Flut, 2 für Nebel.",
  "Reverses the spindle outputs: 1 for on, 2 for the direction, 4 for PWM.":
    "Kehrt die Spindelausgänge um: 1 für Ein, 2 für die Richtung, 4 für PWM.",
  "Takes the pull-up resistors off the control inputs, a bit each.":
    "Nimmt die Pull-up-Widerstände von den Steuereingängen, je ein Bit.",
  "Takes the pull-up resistors off the limit inputs; add 1 for X, 2 for Y, 4 for Z.":
    "Nimmt die Pull-up-Widerstände von den Endschaltereingängen; 1 für X, 2 für Y, 4 für Z werden addiert.",
  "Takes the pull-up resistor off the probe input.":
    "Nimmt den Pull-up-Widerstand vom Tastereingang.",
  "Way back between the pecks of G73.": "Rückweg zwischen den Hüben von G73.",
  "Time between a change of direction and the step behind it.":
    "Zeit zwischen einem Richtungswechsel und dem Schritt danach.",
  "Frequency of the PWM signal for the spindle.": "Frequenz des PWM-Signals für die Spindel.",
  "PWM output while the spindle is off.": "PWM-Ausgabe, solange die Spindel aus ist.",
  "PWM output at the least spindle speed ($31).":
    "PWM-Ausgabe bei der kleinsten Spindeldrehzahl ($31).",
  "PWM output at the greatest spindle speed ($30).":
    "PWM-Ausgabe bei der größten Spindeldrehzahl ($30).",
  "Motors that stay powered while nothing moves; add 1 for X, 2 for Y, 4 for Z.":
    "Motoren, die Strom behalten, solange nichts fährt; 1 für X, 2 für Y, 4 für Z werden addiert.",
  "Pulses of the spindle's encoder in a turn.": "Impulse des Spindelgebers je Umdrehung.",
  "Obeys ?, ! and ~ inside comments and settings, too, as grbl does.":
    "Befolgt ?, ! und ~ auch in Kommentaren und Einstellungen, wie grbl es tut.",
  "Ends jogs of homed axes at the end of their travel.":
    "Beendet Tippbewegungen referenzierter Achsen am Ende ihres Verfahrwegs.",
  "Parks the tool when the safety door opens; needs homing.":
    "Parkt das Werkzeug, wenn die Schutztür aufgeht; braucht eine Referenzfahrt.",
  "Axis that moves when the tool is parked.": "Achse, die fährt, wenn das Werkzeug geparkt wird.",
  "Times that homing approaches a switch.":
    "Anzahl der Anfahrten eines Schalters bei der Referenzfahrt.",
  "Axes that are homed first; add 1 for X, 2 for Y, 4 for Z.":
    "Achsen, die zuerst auf Referenz fahren; 1 für X, 2 für Y, 4 für Z werden addiert.",
  "Axes that are homed second; add 1 for X, 2 for Y, 4 for Z.":
    "Achsen, die als zweite auf Referenz fahren; 1 für X, 2 für Y, 4 für Z werden addiert.",
  "Axes that are homed third; add 1 for X, 2 for Y, 4 for Z.":
    "Achsen, die als dritte auf Referenz fahren; 1 für X, 2 für Y, 4 für Z werden addiert.",
  "Axes that are homed fourth; add 1 for X, 2 for Y, 4 for Z.":
    "Achsen, die als vierte auf Referenz fahren; 1 für X, 2 für Y, 4 für Z werden addiert.",
  "Axes that are homed fifth; add 1 for X, 2 for Y, 4 for Z.":
    "Achsen, die als fünfte auf Referenz fahren; 1 für X, 2 für Y, 4 für Z werden addiert.",
  "Axes that are homed sixth; add 1 for X, 2 for Y, 4 for Z.":
    "Achsen, die als sechste auf Referenz fahren; 1 für X, 2 für Y, 4 für Z werden addiert.",
  "Speed of single steps that a jog keypad asks for.":
    "Geschwindigkeit einzelner Schritte, die ein Handbediengerät verlangt.",
  "Speed of slow jogs that a jog keypad asks for.":
    "Geschwindigkeit langsamer Tippbewegungen, die ein Handbediengerät verlangt.",
  "Speed of fast jogs that a jog keypad asks for.":
    "Geschwindigkeit schneller Tippbewegungen, die ein Handbediengerät verlangt.",
  "Length of single steps that a jog keypad asks for.":
    "Länge einzelner Schritte, die ein Handbediengerät verlangt.",
  "Distance at which a slow jog of a jog keypad ends.":
    "Weg, nach dem eine langsame Tippbewegung eines Handbediengeräts endet.",
  "Distance at which a fast jog of a jog keypad ends.":
    "Weg, nach dem eine schnelle Tippbewegung eines Handbediengeräts endet.",
  "Way out of the cut before parking, and back into it afterwards.":
    "Weg aus dem Schnitt vor dem Parken und danach wieder hinein.",
  "Feed of the way out of the cut before parking, and back into it.":
    "Vorschub des Wegs aus dem Schnitt vor dem Parken und wieder hinein.",
  "Place at which the tool is parked, in the machine's own frame.":
    "Ort, an dem das Werkzeug geparkt wird, in Maschinenkoordinaten.",
  "Speed of the way to the parking place.": "Geschwindigkeit des Wegs zum Parkplatz.",
  "Sets the overrides back to 100 % when a program ends.":
    "Stellt die Overrides am Ende eines Programms auf 100 % zurück.",
  "Says whether an open door counts at rest, and whether coolant stays on.":
    "Sagt, ob eine offene Tür im Stillstand zählt und ob das Kühlmittel an bleibt.",
  "Allows sleep ($SLP), in which the motors have no power.":
    "Erlaubt den Schlaf ($SLP), in dem die Motoren keinen Strom haben.",
  "Says what a hold does to laser and spindle, and what comes back behind it.":
    "Sagt, was ein Halt mit Laser und Spindel macht und was danach wiederkommt.",
  "Starts locked after power-up, with an alarm.":
    "Beginnt nach dem Einschalten gesperrt, mit einem Alarm.",
  "Says whether the feed override counts for probing, and where probing ends.":
    "Sagt, ob der Vorschub-Override beim Tasten zählt und wo das Tasten endet.",
  "Services in the network: telnet, web socket, web page, FTP and others, a bit each.":
    "Dienste im Netz: Telnet, WebSocket, Webseite, FTP und andere, je ein Bit.",
  "Joins a wireless network, opens one of its own, or both.":
    "Tritt einem Funknetz bei, öffnet ein eigenes, oder beides.",
  "Name of the wireless network that the controller joins.":
    "Name des Funknetzes, dem die Steuerung beitritt.",
  "Password of the wireless network that the controller joins.":
    "Kennwort des Funknetzes, dem die Steuerung beitritt.",
  "Name of the wireless network that the controller opens.":
    "Name des Funknetzes, das die Steuerung öffnet.",
  "Password of the wireless network that the controller opens.":
    "Kennwort des Funknetzes, das die Steuerung öffnet.",
  "Current of the axis's motor.": "Strom des Motors der Achse.",
  "Microsteps of the axis's motor driver; the steps of a millimetre follow them.":
    "Mikroschritte des Motortreibers der Achse; die Schritte je Millimeter folgen ihnen.",
  "Play of the axis, which is made up for when its direction changes.":
    "Spiel der Achse, das ausgeglichen wird, wenn sich ihre Richtung ändert.",
  "Offset between the two home switches of an axis that has two motors.":
    "Versatz der beiden Referenzschalter einer Achse, die zwei Motoren hat.",
  "Feed of the slow approach to the home switch of this axis.":
    "Vorschub der langsamen Anfahrt des Referenzschalters dieser Achse.",
  "Feed of the first search for the home switch of this axis.":
    "Vorschub der ersten Suche nach dem Referenzschalter dieser Achse.",
  "Name of the controller in the network.": "Name der Steuerung im Netz.",
  "Says whether the network gives the address (DHCP) or $302 does.":
    "Sagt, ob das Netz die Adresse vergibt (DHCP) oder $302.",
  "Address of the controller in the network.": "Adresse der Steuerung im Netz.",
  "Address of the router of the network.": "Adresse des Routers im Netz.",
  "Mask that tells which addresses are in the same network.":
    "Maske, die sagt, welche Adressen im selben Netz sind.",
  "Port of telnet.": "Port von Telnet.",
  "Port of the web page.": "Port der Webseite.",
  "Port of the web socket.": "Port des WebSockets.",
  "Port of FTP.": "Port von FTP.",
  "Deviation at which the spindle still counts as up to speed; 0 does not look.":
    "Abweichung, bei der die Spindel noch als auf Drehzahl gilt; bei 0 wird nicht nachgesehen.",
  "Says what M6 does: wait, have the tool touched off by you or by itself, or nothing.":
    "Sagt, was M6 tut: warten, das Werkzeug von Hand oder von selbst vermessen lassen, oder nichts.",
  "Longest way of the probe when a tool is touched off.":
    "Längster Weg des Tasters, wenn ein Werkzeug vermessen wird.",
  "Feed of the slow touch when a tool is touched off.":
    "Vorschub der langsamen Berührung, wenn ein Werkzeug vermessen wird.",
  "Feed of the first touch when a tool is touched off.":
    "Vorschub der ersten Berührung, wenn ein Werkzeug vermessen wird.",
  "Feed of the way up between the two touches of a tool.":
    "Vorschub des Wegs nach oben zwischen den beiden Berührungen eines Werkzeugs.",
  "Bits of M6: 1 goes back to its place afterwards, 2 has the tool put in at G30, 4 comes off the plate quickly.":
    "Bits von M6: 1 fährt danach an seinen Ort zurück, 2 lässt das Werkzeug bei G30 einsetzen, 4 hebt schnell von der Platte ab.",
  "Share of its travel by which the two home switches of an axis may lie apart.":
    "Anteil ihres Verfahrwegs, um den die beiden Referenzschalter einer Achse auseinander liegen dürfen.",
  "Least distance that the share of $347 may come to.":
    "Kleinster Abstand, den der Anteil von $347 ergeben darf.",
  "Greatest distance that the share of $347 may come to.":
    "Größter Abstand, den der Anteil von $347 ergeben darf.",
  "Reverses auxiliary inputs, a bit each.": "Kehrt Zusatzeingänge um, je ein Bit.",
  "Takes the pull-up resistors off auxiliary inputs, a bit each.":
    "Nimmt die Pull-up-Widerstände von Zusatzeingängen, je ein Bit.",
  "Reverses auxiliary outputs, a bit each.": "Kehrt Zusatzausgänge um, je ein Bit.",
  "Makes auxiliary outputs open drain, a bit each.":
    "Macht Zusatzausgänge zu Open-Drain, je ein Bit.",
  "Axes that turn, whose unit is a degree: add 1 for A, 2 for B, 4 for C.":
    "Achsen, die drehen und deren Einheit ein Grad ist: 1 für A, 2 für B, 4 für C werden addiert.",
  "Forgets the shift of G92 when the power goes off.":
    "Vergisst die Verschiebung von G92, wenn der Strom ausgeht.",
  "Time that the spindle has to come up again when the door is closed.":
    "Zeit, die die Spindel zum Hochlaufen hat, wenn die Tür geschlossen wird.",
  "Time that the coolant has to flow again when the door is closed.":
    "Zeit, die das Kühlmittel zum Fließen hat, wenn die Tür geschlossen wird.",
  "Time that the spindle has to come up to speed.": "Zeit, die die Spindel zum Hochlaufen hat.",
  "Spindle that is there after power-up.": "Spindel, die nach dem Einschalten da ist.",
  "Moves that are planned ahead; counts after a restart.":
    "Bewegungen, die vorausgeplant werden; zählt nach einem Neustart.",
  "Interval of status reports that come unasked; 0 sends none.":
    "Abstand der Statusberichte, die ungefragt kommen; bei 0 kommen keine.",
  "Stays locked after an emergency stop until it is unlocked.":
    "Bleibt nach einem Not-Halt gesperrt, bis entsperrt wird.",
  "Keeps the number of the tool over a restart.":
    "Behält die Nummer des Werkzeugs über einen Neustart.",
  "Protects G59.1, G59.2 and G59.3 against changes, a bit each.":
    "Schützt G59.1, G59.2 und G59.3 vor Änderungen, je ein Bit.",
  "Turning axes that take the short way to G28; a bit each.":
    "Drehachsen, die den kurzen Weg nach G28 nehmen; je ein Bit.",
  "Time that the spindle has to come to rest.": "Zeit, in der die Spindel zum Stillstand kommt.",
};
