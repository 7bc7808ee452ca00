/** Meanings of the values of commands in German, by the English sentences. */

const cuts: Readonly<Record<string, string>> = {
  "Span of the arch.": "Spannweite des Bogens.",
  "Rise of the arch.": "Höhe des Bogens.",
  "O: the part left inside has the size; I: the hole has the size; T: the cutter centre runs on the shape.":
    "O: das Teil innen hat die Größe; I: das Loch hat die Größe; T: die Fräsermitte läuft auf der Form.",
  "1 to the right, -1 to the left; it always rises.":
    "1 nach rechts, -1 nach links; er steigt immer.",
  "Turns the arch clockwise.": "Dreht den Bogen im Uhrzeigersinn.",
  "Change of Z before each repetition; negative is down.":
    "Änderung von Z vor jeder Wiederholung; negativ ist abwärts.",
  "How many passes.": "So viele Durchgänge.",
  "Scales in X; negative mirrors.": "Maßstab in X; negativ spiegelt.",
  "Scales in Y; negative mirrors.": "Maßstab in Y; negativ spiegelt.",
  "1: leave tabs on the last pass.": "1: Stege beim letzten Durchgang stehen lassen.",
  "1: stay at depth afterwards.": "1: danach in der Tiefe bleiben.",
  "1: move Z to 0 first and plunge from there.":
    "1: Z zuerst auf 0 fahren und von dort eintauchen.",
  "1 clockwise, -1 counter-clockwise.": "1 im Uhrzeigersinn, -1 gegen ihn.",
  "Clock degrees, 0 at the top. Blank: 0 clockwise, 360 counter-clockwise.":
    "Grad wie auf der Uhr, 0 oben. Leer: 0 im Uhrzeigersinn, 360 gegen ihn.",
  "Clock degrees. Blank: a full circle.": "Grad wie auf der Uhr. Leer: ein ganzer Kreis.",
  "0 none, 1 tabs, 2 pocket, 3 spiral plunge, 4 spiral plunge with a flat last pass.":
    "0 keine, 1 Stege, 2 Tasche, 3 Eintauchen als Spirale, 4 ebenso mit flachem letztem Durchgang.",
  "Instead of the centre; the arc is half a turn at most.":
    "Statt der Mitte; der Bogen ist höchstens eine halbe Drehung.",
  "Blank: where the tool is.": "Leer: wo das Werkzeug ist.",
  "From the tool to the centre; blank: as in the last CG.":
    "Vom Werkzeug zur Mitte; leer: wie im letzten CG.",
  "Blank: a square.": "Leer: ein Quadrat.",
  "Where the tool is: 1 upper left, 2 upper right, 3 lower right, 4 lower left.":
    "Wo das Werkzeug ist: 1 oben links, 2 oben rechts, 3 unten rechts, 4 unten links.",
  "0 none, 1 tabs, 2 pocket.": "0 keine, 1 Stege, 2 Tasche.",
  "Accepted and ignored.": "Wird angenommen und übergangen.",
};

const files: Readonly<Record<string, string>> = {
  "A .dxf, .plt, .hpg, .nc, .tap, .bmp, .jpg or .png file. Blank: asks for one.":
    "Eine Datei .dxf, .plt, .hpg, .nc, .tap, .bmp, .jpg oder .png. Leer: fragt nach einer.",
  "The file to show. Blank: the last one that ran, or an empty page.":
    "Die Datei. Leer: die zuletzt lief, oder eine leere Seite.",
  "Looked for in the current part folder, ignoring case; may carry a path or be a variable. Without an extension .sbp is tried as well.":
    "Gesucht im Ordner der Programme, groß wie klein; auch mit Pfad oder als Variable. Ohne Endung auch als .sbp.",
  "Scales every X value of the file.": "Maßstab für jeden Wert X der Datei.",
  "Scales every Y value of the file.": "Maßstab für jeden Wert Y der Datei.",
  "Scales every Z value of the file. Calls with .5, .85 and 1 cut a file in three passes.":
    "Maßstab für jeden Wert Z der Datei. Mit .5, .85 und 1 schneidet sie in drei Durchgängen.",
  "How often the whole file runs, each time from where the tool is; 0 as 1.":
    "So oft läuft die ganze Datei, jedes Mal vom Werkzeug aus; 0 wie 1.",
  "0: locations as written. 1: the present X, Y, Z counts as 0,0,0 in the file. 2: only the present X, Y; Z as written.":
    "0: Orte wie geschrieben. 1: das gegenwärtige X, Y, Z gilt in der Datei als 0,0,0. 2: nur X, Y; Z wie geschrieben.",
  "How far Z moves before each repetition; negative is down unless VC says otherwise. Z returns after the last one. For files without Z moves.":
    "So weit fährt Z vor jeder Wiederholung; negativ ist abwärts, wenn VC nichts anderes sagt. Nach der letzten kehrt Z zurück. Für Dateien ohne Fahrten in Z.",
  "1: leave tabs (see VB) on the last repetition, also in files that this one calls.":
    "1: bei der letzten Wiederholung Stege lassen (siehe VB), auch in gerufenen Dateien.",
  "1: Z moves to 0 first, so that plunges count from there.":
    "1: Z fährt zuerst auf 0, so dass das Eintauchen von dort zählt.",
  "A path, or a name below the present folder, or .. for the one above. Blank: the folder at the start, unless only a mask is given.":
    "Ein Pfad, ein Name unter dem jetzigen Ordner, oder .. für den darüber. Leer: der Ordner vom Start, wenn nicht nur ein Suchmuster dasteht.",
  "Which files lists show: *.sb? at first. It has no effect on a run.":
    "Welche Dateien Listen zeigen: zuerst *.sb?. Auf einen Lauf wirkt es nicht.",
};

const moves: Readonly<Record<string, string>> = {
  "Where to go, or how far with SR.": "Wohin, oder mit SR wie weit.",
  "Of the tool's tip along its path.": "Der Werkzeugspitze auf ihrer Bahn.",
  "How far, in absolute mode too; negative goes backwards.":
    "So weit, auch bei Orten; negativ geht rückwärts.",
  "Degrees clockwise from +Y; with R or L right or left of the last move; a time of day (1:30); or points of the compass (SSW).":
    "Grad im Uhrzeigersinn von +Y; mit R oder L rechts oder links der letzten Fahrt; eine Uhrzeit (1:30); oder eine Himmelsrichtung (SSW).",
  "A Z location, in relative mode too; with U or D up or down by so much.":
    "Ein Ort Z, auch bei Abständen; mit U oder D um so viel auf oder ab.",
  "Of a rotation: 1 clockwise, -1 the other way.":
    "Einer Drehung: 1 im Uhrzeigersinn, -1 gegen ihn.",
  "Units of the axis a second; 0 stops it. Not with a frequency.":
    "Einheiten der Achse je Sekunde; 0 hält sie an. Nicht mit einer Frequenz.",
  "Of an oscillation, cycles a second; 0 stops it.":
    "Eines Schwenkens, Male je Sekunde; 0 hält sie an.",
  "Of an oscillation, from one end to the other, in units of the axis.":
    "Eines Schwenkens, von einem Ende zum anderen, in Einheiten der Achse.",
  "How many, 100 at most, or A for all; 1 when blank.":
    "So viele, höchstens 100, oder A für alle; leer 1.",
  "1 when blank.": "Leer: 1.",
  "SBTEMP.SBP when blank.": "Leer: SBTEMP.SBP.",
  "All when blank.": "Leer: alle.",
  "2, the only one there is.": "2, etwas anderes gibt es nicht.",
  "1 on, 0 off.": "1 ein, 0 aus.",
  "What the operator is asked to do.": "Worum der Bediener gebeten wird.",
  "1 on, 0 off. Output 4 only: -1 on during motion, -2 also off at a stop, -3 also off at a stall, -4 free.":
    "1 ein, 0 aus. Nur Ausgang 4: -1 ein während der Bewegung, -2 auch aus beim Halt, -3 auch aus beim Stehen, -4 frei.",
  "Seconds; 0 is none. Blank is what held when the file began.":
    "Sekunden; 0 ist keine. Leer gilt, was am Anfang der Datei galt.",
  "Revolutions a minute.": "Umdrehungen je Minute.",
};

const feeling: Readonly<Record<string, string>> = {
  "3D feels the whole object from above, 2D its outline at one height.":
    "3D tastet das ganze Objekt von oben, 2D seinen Umriss in einer Höhe.",
  "A part file that cuts what was felt, or a drawing of it.":
    "Ein Programm, das Getastetes schneidet, oder eine Zeichnung davon.",
  "3D: left edge of the area; 2D: a place inside of the object.":
    "3D: linker Rand der Fläche; 2D: ein Ort im Objekt.",
  "3D: lower edge of the area; 2D: a place inside of the object.":
    "3D: unterer Rand der Fläche; 2D: ein Ort im Objekt.",
  "3D: of the area.": "3D: der Fläche.",
  "3D: from one point to the next.": "3D: von einem Punkt zum nächsten.",
  "2D: so far outside the probe begins; further than any part of the object.":
    "2D: so weit außen beginnt der Taster; weiter als jeder Teil des Objekts.",
  "2D: all round.": "2D: ringsum.",
  "Above everything.": "Über allem.",
  "3D: no deeper than this; 2D: the height at which the outline is felt.":
    "3D: nicht tiefer; 2D: die Höhe, in der der Umriss getastet wird.",
  "2D, sbp: how deep the outline is cut.": "2D, sbp: so tief wird der Umriss geschnitten.",
  "Of the probe. Slow is exact: a stop from ramp speed or less is at once.":
    "Des Tasters. Langsam ist genau: aus Rampengeschwindigkeit oder weniger hält er sofort.",
  "What the lengths here are measured in, and the part file is written in.":
    "Worin die Längen hier gemessen und im Programm geschrieben werden.",
  "The left edge of the grid.": "Der linke Rand des Rasters.",
  "Its lower edge.": "Sein unterer Rand.",
  "Above everything between two places.": "Über allem zwischen zwei Orten.",
  "Probed no deeper than this.": "Tiefer wird nicht getastet.",
  "Between the tool and the surface.": "Zwischen Werkzeug und Oberfläche.",
  "From the first touch up to the second.": "Von der ersten Berührung hinauf zur zweiten.",
  "The tool stands above a plate, a boss or an outside corner, else beside it.":
    "Das Werkzeug steht über einer Platte, einem Zapfen oder einer Außenecke, sonst daneben.",
  "Of the axes that are found; none only tells the place.":
    "Von den gefundenen Achsen; kein sagt nur den Ort.",
  "The way of the tool towards the edge; of a slot, its axis.":
    "Der Weg des Werkzeugs zur Kante; bei einer Nut ihre Achse.",
  "Between the tool and the surface that becomes Z zero.":
    "Zwischen Werkzeug und der Oberfläche, die Z null wird.",
  "Of its tip, or of the tool that touches.": "Seiner Spitze oder des Werkzeugs, das berührt.",
  "Boss: its diameter, about. Angle: from one touch to the other.":
    "Zapfen: sein Durchmesser, ungefähr. Winkel: von einer Berührung zur anderen.",
  "Outside corner: so far from both edges the tool stands. Boss: so far beside it the probe goes down.":
    "Außenecke: so weit von beiden Kanten steht das Werkzeug. Zapfen: so weit daneben geht der Taster hinab.",
  "Sides are touched so far below the top of a corner, or below the place where the tool begins over a boss.":
    "So tief unter der Oberseite einer Ecke oder unter dem Anfang über einem Zapfen werden Seiten berührt.",
  "Farthest way of a touch. Without contact nothing is set.":
    "Weitester Weg bis zur Berührung. Ohne Berührung wird nichts gesetzt.",
  "The tool backs off so far from what it touched.":
    "So weit fährt das Werkzeug vom Berührten zurück.",
};

const tools: Readonly<Record<string, string>> = {
  "X Y diameter of each, depth behind it where it does not go through: 2 3 .5; 4 3 .25 .3":
    "X Y Durchmesser von jedem, dahinter die Tiefe, wo es nicht hindurchgeht: 2 3 .5; 4 3 .25 .3",
  "Above the blank.": "Über dem Rohling.",
  "Clears the whole hole, so that no waste comes loose.":
    "Räumt das ganze Loch, so dass sich kein Abfall löst.",
  "Along the flutes.": "Entlang der Rillen.",
  "Of a V bit, both sides together, degrees.": "Eines V-Fräsers, beide Seiten zusammen, Grad.",
  "The others follow from the width.": "Die anderen folgen aus der Breite.",
  "From the middle of a flute to the next.": "Von der Mitte einer Rille zur nächsten.",
  "From the edges of the blank, all round.": "Von den Rändern des Rohlings, ringsum.",
  "The file that gets the header; as it is now it is kept as .bak.":
    "Die Datei, die den Kopf erhält; wie sie jetzt ist, bleibt sie als .bak.",
  "Where X, Y and Z are zero.": "Wo X, Y und Z null sind.",
  "A part file that runs first.": "Ein Programm, das zuerst läuft.",
  "A part file that runs last.": "Ein Programm, das zuletzt läuft.",
  "To turn to or by, degrees.": "Bis wohin oder um wie viel, Grad.",
  "Degrees a second.": "Grad je Sekunde.",
  "Seconds; 0 goes on until MO, or MI with speed 0.":
    "Sekunden; 0 dauert bis MO oder MI mit Geschwindigkeit 0.",
  "What the machine is called.": "Wie die Maschine heißt.",
  "| begins another line. In a typed command a comma ends it.":
    "| beginnt eine neue Zeile. Getippt endet der Text mit einem Komma.",
  "The name of an installed font, or of a file in the data folder's folder fonts.":
    "Der Name einer installierten Schrift oder einer Datei im Ordner fonts der Daten.",
  "From side to side, degrees.": "Von Seite zu Seite, Grad.",
  "Where the first line begins.": "Wo die erste Zeile beginnt.",
  "The line on which the letters of the first line stand.":
    "Die Linie, auf der die Buchstaben der ersten Zeile stehen.",
  "Above the surface, which is Z 0.": "Über der Oberfläche, die Z 0 ist.",
  "Letters that would be carved deeper are refused; 0 is no bound.":
    "Buchstaben, die tiefer würden, werden abgelehnt; 0 ist keine Grenze.",
  "Below Z zero, which is the table as it is.": "Unter Z null, dem Tisch, wie er ist.",
  "Of neighbouring paths, percent of the bit.": "Benachbarter Bahnen, Prozent des Fräsers.",
  "Blank: the built-in editor.": "Leer: der eingebaute Editor.",
  "Blank: asks which of those there are.": "Leer: fragt, welche von denen, die es gibt.",
  "1 begins the system log anew, 0 keeps it. Blank: asks.":
    "1 beginnt das Systemprotokoll neu, 0 behält es. Leer: fragt.",
  "Blank: asks for one.": "Leer: fragt danach.",
};

const surfacing: Readonly<Record<string, string>> = {
  "Rows clear the corners: the cutter reaches over the edges at their ends by its radius.":
    "Zeilen räumen die Ecken: der Fräser ragt an ihren Enden um seinen Radius über die Kanten.",
  "0 is the move speed that is set.": "0 ist die eingestellte Geschwindigkeit der Fahrten.",
};

const values: Readonly<Record<string, string>> = {
  "What the display shows here from now on.": "Was die Anzeige hier von nun an zeigt.",
  "The same quantity as %(6) to %(10): how far base is ahead of working; a location in the dialect strict.":
    "Dieselbe Größe wie %(6) bis %(10): so weit ist der Tisch dem Arbeitsort voraus; im Dialekt strict ein Ort.",
  "Thickness of a tab.": "Dicke eines Stegs.",
  "Path between the end of a tab and the next.": "Weg vom Ende eines Stegs zum nächsten.",
  "Length of the flat top, at the centre of the cutter.":
    "Länge der flachen Oberseite, in der Fräsermitte.",
  "Length of the incline before and after the top.": "Länge der Schräge davor und dahinter.",
  "1 begins tabs here, 0 ends them; a file ends them too.":
    "1 beginnt hier mit Stegen, 0 endet damit; auch eine Datei endet damit.",
  "So many tabs after 1, then none.": "So viele Stege nach 1, dann keine.",
  "Path to the first tab after 1; blank is the distance to the next.":
    "Weg zum ersten Steg nach 1; leer wie zum nächsten.",
  "Height for MH, JH and travel; OFF lifts nothing.": "Höhe für MH, JH und Wege; OFF hebt nichts.",
  "- when negative plunges go down, + when positive ones do. Older files write 0 for -.":
    "-, wenn negatives Eintauchen abwärts geht, +, wenn positives. Ältere Dateien schreiben 0 für -.",
  "How much of the cutter runs over the ring before.":
    "Welcher Teil des Fräsers über den Ring davor läuft.",
  "Height of the A axis for MH and JH.": "Höhe der Achse A für MH und JH.",
  "1 switches an output by vertical moves, until the part file ends.":
    "1 schaltet einen Ausgang durch senkrechte Fahrten, bis das Programm endet.",
  "On when a plunge passes this location.": "Ein, wenn ein Eintauchen hier vorbeikommt.",
  "Off when a pull-up passes this location.": "Aus, wenn ein Heben hier vorbeikommt.",
  "How many of X Y Z A B C are in use.": "Wie viele von X Y Z A B C in Gebrauch sind.",
  "0 inches, 1 mm. Values keep their size.": "0 Zoll, 1 mm. Werte behalten ihre Größe.",
  "0 inches, 1 mm, 2 degrees.": "0 Zoll, 1 mm, 2 Grad.",
  "Obsolete.": "Veraltet.",
  "1 opens the message screen for comments.": "1 öffnet die Meldungen für Kommentare.",
  "How far a tap moves.": "So weit fährt ein kurzer Druck.",
  "0 mouse, 1 pendant on the inputs, 2 another.":
    "0 Maus, 1 Bediengerät an den Eingängen, 2 ein anderes.",
  "1 switches all outputs off when the keypad closes.":
    "1 schaltet alle Ausgänge aus, wenn sich das Tastenfeld schließt.",
  "1 EASY, 0 FULL.": "1 EASY, 0 FULL.",
};

const outputs: Readonly<Record<string, string>> = {
  "1 on, 0 off; with 0 the other values are prepared for later.":
    "1 ein, 0 aus; mit 0 sind die anderen Werte für später.",
  "Torch: speed of Z as a share of the XY speed.": "Brenner: Z als Teil der Geschwindigkeit XY.",
  "PWM at rest, percent.": "PWM in Ruhe, Prozent.",
  "PWM at full speed, percent.": "PWM bei voller Geschwindigkeit, Prozent.",
  "Kilohertz.": "Kilohertz.",
  "Heater: share of time at low PWM, tenths.": "Heizung: Teil der Zeit mit niedrigem PWM, Zehntel.",
  "Heater: 0 is off.": "Heizung: 0 ist aus.",
  "Which of the connections in the settings is used.":
    "Welche der Verbindungen in den Einstellungen gilt.",
  "The axis that it drives; an axis on two channels drives both.":
    "Die Achse, die er treibt; eine Achse auf zwei Kanälen treibt beide.",
  "2 is 115.2, 3 is 230.4, 4 is 460.8, 5 is 921.6 kbaud, from the next connection on.":
    "2 ist 115.2, 3 ist 230.4, 4 ist 460.8, 5 ist 921.6 kbaud, ab der nächsten Verbindung.",
  "0 gives no steps and switches no outputs.": "0 gibt keine Schritte und schaltet nichts.",
  "1 refuses moves that would leave the limits, as SF does.":
    "1 lehnt Fahrten über die Grenzen ab, wie SF.",
  "1 lets limit inputs stop motion.": "1: Endschalter halten die Bewegung an.",
  "Input 4 is a stop: 0 normally closed, 1 normally open.":
    "Eingang 4 hält an: 0 Öffner, 1 Schließer.",
  "0 none, 1 torch, 2 laser, 3 analog input 1, 4 analog input 2, 5 both.":
    "0 nichts, 1 Brenner, 2 Laser, 3 Analogeingang 1, 4 Analogeingang 2, 5 beide.",
  "0 free for programs, 1 limit normally open, 2 limit normally closed, 3 stop normally open, 4 stop normally closed.":
    "0 frei für Programme, 1 Endschalter als Schließer, 2 als Öffner, 3 Halt als Schließer, 4 als Öffner.",
  "By command: 0 off at the end of a file, 1 left as it is, 2 also off during a stop. On with the file: 3 off at its end, 4 left on, 5 off at its end and during a stop.":
    "Durch Befehl: 0 aus am Ende einer Datei, 1 bleibt, 2 aus auch beim Halt. Ein mit der Datei: 3 aus an ihrem Ende, 4 bleibt ein, 5 aus an ihrem Ende und beim Halt.",
  "1 on, 2 off; 0 is off too.": "1 ein, 2 aus; auch 0 ist aus.",
};

const motion: Readonly<Record<string, string>> = {
  "Between the lines drawn on the table.": "Zwischen den Linien auf dem Tisch.",
  "Also how thick a blank is that a rotary axis turns.":
    "Auch die Dicke eines Rohlings, den eine Drehachse dreht.",
  "1 shows the cutting fast forward, 0 the whole path at once.":
    "1 zeigt das Schneiden im Zeitraffer, 0 gleich die ganze Bahn.",
  "0 starts previews at 0,0.": "0 beginnt Vorschauen bei 0,0.",
  "Speed at which moves start and end.": "Geschwindigkeit, mit der Fahrten beginnen und enden.",
  "Speed at which jogs start and end.": "Geschwindigkeit, mit der Eilgänge beginnen und enden.",
  "Path in which a move gains 2 in/s (50.8 mm/s) from its ramp speed.":
    "Weg, auf dem eine Fahrt von der Rampe aus um 2 in/s (50.8 mm/s) schneller wird.",
  "More makes ramps for changes of Z speed rarer.":
    "Mehr macht Rampen wegen der Geschwindigkeit von Z seltener.",
  "Path over which changes of direction are summed.":
    "Weg, über den Änderungen der Richtung zusammengezählt werden.",
  "Speed at a gentle corner in percent of the speed before it.":
    "Geschwindigkeit in einer flachen Ecke, Prozent der vorigen.",
  "Circles of a smaller diameter run at ramp speed.":
    "Kreise mit kleinerem Durchmesser laufen mit Rampengeschwindigkeit.",
  "Motor steps for one inch, millimetre or degree; negative turns the axis round.":
    "Motorschritte für einen Zoll, Millimeter oder Grad; negativ kehrt die Achse um.",
  "Length of the chords for machines that know no arcs.":
    "Länge der Sehnen für Maschinen, die keine Bögen kennen.",
  "Coarser steps while jogging.": "Gröbere Schritte im Eilgang.",
  "Makes all motion so many times slower.": "Macht jede Bewegung so viele Male langsamer.",
  "1 limits jogs to about 16 in/s (400 mm/s).": "1 begrenzt Eilgänge auf etwa 16 in/s (400 mm/s).",
  "`&name = value`.": "`&name = Wert`.",
};

export const parameterDocs: Readonly<Record<string, string>> = {
  ...cuts,
  ...files,
  ...moves,
  ...feeling,
  ...tools,
  ...surfacing,
  ...values,
  ...outputs,
  ...motion,
};
