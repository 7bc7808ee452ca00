/** Texts of the help in German, by their English ones. */
export const help: Readonly<Record<string, string>> = {
  ", as OpenAPI.": ", als OpenAPI.",
  ", as text.": ", als Text.",
  ": this console, for another screen in the shop (with `--lan`).":
    ": diese Konsole, für einen anderen Bildschirm in der Werkstatt (mit `--lan`).",
  "A circular pocket, cut out with tabs.": "Eine runde Tasche, mit Stegen ausgeschnitten.",
  "A drawing, with layers and an array.": "Eine Zeichnung mit Ebenen und einer Anordnung.",
  "A drilling cycle, a loop, a subroutine.": "Ein Bohrzyklus, eine Schleife, ein Unterprogramm.",
  "A loop that converts to G-code.": "Eine Schleife, die zu G-Code wird.",
  "After a power cut its places are not verified (UD). Zero the axes or home them before you cut.":
    "Nach einem Stromausfall ist der Ort nicht geprüft (UD). Vor dem Schneiden die Achsen nullen oder referenzieren.",
  "Answer the six steps.": "Die sechs Schritte beantworten.",
  "Arcs, an arch, holes in spirals.": "Bögen, ein Rundbogen, Bohrungen in Spiralen.",
  "Ask for help": "Hilfe anfragen",
  "Asks for sizes, then cuts.": "Fragt nach Maßen und schneidet dann.",
  "At the keypad": "Am Tastenfeld",
  Bracket: "Winkel",
  Bulletins: "Neuigkeiten",
  Chapter: "Kapitel",
  "Choose Probe in the list of actions, and Plate or surface.":
    "In der Liste der Aktionen Taster wählen, dann Platte oder Fläche.",
  "Choose a file": "Datei wählen",
  "Choose a step, or While held.": "Einen Schritt wählen, oder Solange gehalten.",
  "Choose mm at Units.": "Bei Einheiten mm wählen.",
  "Close other senders.": "Andere Sendeprogramme schließen.",
  Coaster: "Untersetzer",
  "Command reference": "Befehle",
  "Commands on a page": "Befehle auf einer Seite",
  "Drag Feed while it cuts.": "Beim Schneiden den Regler Vorschub ziehen.",
  Driver: "Treiber",
  "Drop it anywhere on the page, or press Choose file, then Upload.":
    "Irgendwo auf der Seite ablegen, oder Datei wählen und dann Hochladen drücken.",
  "Drop it on the page, or go to Draw and press Open.":
    "Auf der Seite ablegen, oder in Zeichnen auf Öffnen drücken.",
  Everywhere: "Überall",
  "Finds the stock and sets Z.": "Findet das Material und setzt Z.",
  "First cut": "Erster Schnitt",
  "For writing part files": "Zum Schreiben von Programmen",
  "G-code": "G-Code",
  Glossary: "Glossar",
  "Go line by line, and watch variables.": "Zeile für Zeile gehen und Variablen beobachten.",
  "Go to Settings and press Set up.": "Im Setup auf Einrichten drücken.",
  "Go to Settings, Devices, and show a code.": "Im Setup unter Geräte einen Code zeigen.",
  "Go to Settings.": "Ins Setup gehen.",
  "Grid of holes": "Lochraster",
  "Hold only pauses: Resume goes on.": "Halt macht nur Pause: Fortsetzen geht weiter.",
  "How do I back up my settings?": "Wie sichere ich meine Einstellungen?",
  "How do I bring in a file of my own?": "Wie bringe ich eine eigene Datei herein?",
  "How do I clear a pocket?": "Wie räume ich eine Tasche aus?",
  "How do I connect a real controller?": "Wie schließe ich eine wirkliche Steuerung an?",
  "How do I cut my first part?": "Wie schneide ich mein erstes Teil?",
  "How do I cut slower or faster?": "Wie schneide ich langsamer oder schneller?",
  "How do I find a mistake in a part file?": "Wie finde ich einen Fehler im Programm?",
  "How do I go on after a stop or a power cut?":
    "Wie geht es nach einem Stopp oder Stromausfall weiter?",
  "How do I home the machine?": "Wie fahre ich die Maschine in die Grundstellung?",
  "How do I make a tool path?": "Wie mache ich einen Werkzeugweg?",
  "How do I move the tool by hand?": "Wie bewege ich das Werkzeug von Hand?",
  "How do I open a DXF or SVG?": "Wie öffne ich DXF oder SVG?",
  "How do I run G-code?": "Wie führe ich G-Code aus?",
  "How do I see how long a job takes?": "Wie sehe ich, wie lange ein Auftrag dauert?",
  "How do I set Z with a touch plate?": "Wie setze ich Z mit einer Tastplatte?",
  "How do I set up a new machine?": "Wie richte ich eine neue Maschine ein?",
  "How do I set zero?": "Wie setze ich den Nullpunkt?",
  "How do I stop the machine?": "Wie halte ich die Maschine an?",
  "How do I use a tablet or phone?": "Wie benutze ich ein Tablet oder Telefon?",
  "How do I work in millimetres?": "Wie arbeite ich in Millimetern?",
  "How do I …": "Wie kann ich …",
  "How this browser shows things, devices that may connect, and every setting of the machine, in the unit that is set.":
    "Wie dieser Browser anzeigt, welche Geräte sich verbinden dürfen, und jede Einstellung der Maschine, in der gewählten Einheit.",
  "In Settings, Homing, tell which axes have a switch.":
    "Im Setup unter Homing angeben, welche Achsen einen Schalter haben.",
  "Jobs to try": "Aufträge zum Ausprobieren",
  Keys: "Tasten",
  "Lay it on the stock below the tool.": "Sie unter dem Werkzeug auf das Material legen.",
  Leaves: "Blätter",
  Licence: "Lizenz",
  "Limits are reached": "Grenzen sind erreicht",
  "Load settings brings it back.": "Einstellungen laden bringt sie zurück.",
  "Location, tool path, program and messages of the job on one screen. EASY has buttons, FULL menus and the command line. The chip PREVIEW, SIMULATED or CUT says what running a file means, and changes it.":
    "Position, Werkzeugweg, Programm und Meldungen des Auftrags auf einer Seite. Einfach hat Knöpfe, Voll Menüs und die Befehlszeile. Das Schild PREVIEW, SIMULATED oder CUT sagt, was das Starten einer Datei bedeutet, und ändert es.",
  "Look that tool and stock are where they were.":
    "Nachsehen, ob Werkzeug und Material noch dort sind, wo sie waren.",
  "Look whether all of it was read: notes stand at the right.":
    "Nachsehen, ob alles gelesen wurde: Hinweise stehen rechts.",
  "MIT or Apache-2.0, as you choose": "MIT oder Apache-2.0, nach Wahl",
  "More in the book": "Mehr im Buch",
  "More in the book: {0}": "Mehr im Buch: {0}",
  "Move the tool": "Werkzeug bewegen",
  "Move the tool to the corner of the stock.": "Das Werkzeug an die Ecke des Materials fahren.",
  News: "Neuigkeiten",
  "No link to the machine": "Keine Verbindung zur Maschine",
  "On the simulated machine all of this is done without anything that could break.":
    "Auf der simulierten Maschine geht all das, ohne dass etwas zu Bruch gehen kann.",
  "On the timing chart": "Im Zeitverlauf",
  "On the web": "Im Netz",
  "One file three times, moved and scaled.": "Eine Datei dreimal, verschoben und skaliert.",
  "One page drives at a time. “Take control” takes it over; STOP works from every page all the same.":
    "Nur eine Seite steuert. „Steuerung übernehmen“ übernimmt sie; STOP wirkt trotzdem von jeder Seite.",
  "Open Move the tool to, and press Home.":
    "Werkzeug bewegen nach öffnen und Grundstellung drücken.",
  "Open a sample job below.": "Unten einen Auftrag zum Ausprobieren öffnen.",
  "One file is opened at once; of several, press Open at the one that is meant.":
    "Eine einzelne Datei wird gleich geöffnet; bei mehreren auf Öffnen neben der gemeinten drücken.",
  "Open it: planned time stands below the picture.":
    "Ihn öffnen: die geplante Zeit steht unter dem Bild.",
  "Open the .nc file as any other.": "Die .nc-Datei wie jede andere öffnen.",
  "Open the address on the phone and type the code.":
    "Die Adresse auf dem Telefon öffnen und den Code eingeben.",
  "Pages of the help": "Seiten der Hilfe",
  "Parameters in their order": "Parameter in ihrer Reihenfolge",
  "Part files are checked while they are written. A click beside a line number sets a breakpoint; “Go line by line” asks before every line, and watched variables show what they hold.":
    "Programme werden beim Schreiben geprüft. Ein Klick neben eine Zeilennummer setzt einen Haltepunkt; „Zeile für Zeile“ fragt vor jeder Zeile, und beobachtete Variablen zeigen, was sie enthalten.",
  "Press Arm.": "Freigeben drücken.",
  "Press Make the part program.": "Programm erzeugen drücken.",
  "Press Move tool.": "Bewegen drücken.",
  "Press Pocket and enter the tool's diameter.":
    "Tasche drücken und den Durchmesser des Werkzeugs eingeben.",
  "Press STOP, or the space bar.": "STOP drücken, oder die Leertaste.",
  "Press Save settings: a text file is downloaded.":
    "Einstellungen sichern drücken: eine Textdatei wird heruntergeladen.",
  "Press Start and answer what the program asks.":
    "Start drücken und beantworten, was das Programm fragt.",
  "Press Zero beside X and Y.": "Neben X und Y auf Null drücken.",
  "Press an arrow for as long as it is to move.":
    "Einen Pfeil drücken, solange es sich bewegen soll.",
  "Press the words beside the name of the file: the line opens in the editor.":
    "Die Worte neben dem Namen der Datei drücken: die Zeile öffnet sich im Editor.",
  Questions: "Fragen",
  "Quick start": "Schnellstart",
  "Read the notes: what Kerf does not know is told before the start.":
    "Die Hinweise lesen: was Kerf nicht kennt, wird vor dem Start gesagt.",
  "Rounded sign": "Rundes Schild",
  Safety: "Sicherheit",
  "Save problem.log": "problem.log sichern",
  "Save the settings as a backup.": "Die Einstellungen sichern.",
  "Search for inch.": "Nach inch suchen.",
  "Search the book": "Im Buch suchen",
  "Search the questions": "Fragen durchsuchen",
  "Select the closed shape in Draw.": "In Zeichnen die geschlossene Form auswählen.",
  "Select the shapes in Draw.": "In Zeichnen die Formen auswählen.",
  "Set how their layer is cut: side, depth, tool.":
    "Festlegen, wie ihre Ebene geschnitten wird: Seite, Tiefe, Werkzeug.",
  "Set the depth of its layer.": "Die Tiefe ihrer Ebene festlegen.",
  "Shapes, their layers and tool paths, and the part program that is made of them: with the mouse, by keys, or by typed places.":
    "Formen, ihre Ebenen und Werkzeugwege und das Programm, das daraus wird: mit der Maus, mit Tasten oder mit eingegebenen Orten.",
  Slots: "Schlitze",
  "So it is after a start, an alarm, or when the controlling browser disconnected. Look that all is clear, then press Arm.":
    "So ist es nach einem Start, einem Alarm, oder wenn der steuernde Browser die Verbindung verlor. Nachsehen, ob alles frei ist, dann Freigeben drücken.",
  "Somebody else drives": "Jemand anderes steuert",
  "Start Kerf with --lan.": "Kerf mit --lan starten.",
  "Start Kerf with the port of the controller.": "Kerf mit dem Anschluss der Steuerung starten.",
  "Start.": "Start.",
  Table: "Tabelle",
  "Take the job up where it was interrupted.":
    "Den Auftrag dort fortsetzen, wo er unterbrochen wurde.",
  "The book": "Das Buch",
  "The book comes with this page: see The book at the left.":
    "Das Buch kommt mit dieser Seite: siehe Das Buch links.",
  "The book says nothing of “{0}”.": "Das Buch sagt nichts über „{0}“.",
  "The file was changed since it was previewed": "Die Datei wurde seit ihrer Vorschau geändert",
  "The keypad moves by steps only": "Das Tastenfeld bewegt nur in Schritten",
  "The link takes longer than 150 ms: a hand that lets go would be heard too late.":
    "Die Verbindung braucht länger als 150 ms: das Loslassen würde zu spät gehört.",
  "The machine does not know where it is": "Die Maschine weiß nicht, wo sie ist",
  "The machine is disarmed": "Die Maschine ist gesperrt",
  "The outline of a rectangle.": "Der Umriss eines Rechtecks.",
  "The program asks what it has to ask; Hold pauses it, STOP ends the motion and asks whether to go on.":
    "Das Programm fragt, was es zu fragen hat; Halt macht Pause, STOP beendet die Bewegung und fragt, ob es weitergeht.",
  "The program on the machine has ended, or the network is gone. What is shown is old; a job goes on without the page. Start Kerf again, or bring the network back: the page connects by itself.":
    "Das Programm an der Maschine ist beendet, oder das Netz ist weg. Was gezeigt wird, ist alt; ein Auftrag geht ohne die Seite weiter. Kerf wieder starten oder das Netz zurückbringen: die Seite verbindet sich von selbst.",
  "The table limits (VL) or a limit switch ended the motion. Acknowledge the alarm, move the tool away with the keypad.":
    "Die Tischgrenzen (VL) oder ein Endschalter beendeten die Bewegung. Den Alarm quittieren, das Werkzeug mit dem Tastenfeld wegfahren.",
  "This is what helps others to help you. Nothing of it is sent by Kerf: save it, and add what you did and what you expected.":
    "Das hilft anderen, dir zu helfen. Kerf sendet nichts davon: sichern und dazuschreiben, was du getan und was du erwartet hast.",
  "This page is no safety device: a machine needs an emergency stop that is wired.":
    "Diese Seite ist keine Sicherheitseinrichtung: eine Maschine braucht einen verdrahteten Not-Halt.",
  "Timing shows what switches when.": "Zeitverlauf zeigt, was wann schaltet.",
  "To change it for good, press Move beside Speeds.":
    "Um es auf Dauer zu ändern, neben Geschwindigkeiten auf Bewegen drücken.",
  "Touch plate": "Tastplatte",
  "Touch the stock and press Zero beside Z.": "Das Material berühren und neben Z auf Null drücken.",
  Troubleshooting: "Wenn etwas nicht geht",
  "Try the moves by hand before a job.": "Die Bewegungen vor einem Auftrag von Hand probieren.",
  "User guide": "Anleitung",
  "Variables, loops, a subroutine.": "Variablen, Schleifen, ein Unterprogramm.",
  Version: "Version",
  "What programs can ask of this Kerf": "Was Programme dieses Kerf fragen können",
  "What runs is what was looked at. Open the file again.":
    "Was läuft, ist das, was angesehen wurde. Die Datei noch einmal öffnen.",
  "What somebody who helps has to know": "Was einer wissen muss, der hilft",
  "What this Kerf has noticed of itself and of this machine, for whoever helps: {0}, in a new tab.":
    "Was dieses Kerf an sich und an dieser Maschine bemerkt hat, für den, der hilft: {0}, in einem neuen Tab.",
  "Wire the plate to an input.": "Die Platte an einen Eingang anschließen.",
  "in the strip at the top. Until then nothing moves.":
    "in der Leiste oben. Vorher bewegt sich nichts.",
  "known problems here": "hier bekannte Probleme",
  "on the operator's screen (Ctrl O). Its tool path appears; ▶ plays it.":
    "auf der Seite Bedienen (Strg O). Ihr Werkzeugweg erscheint; ▶ spielt ihn ab.",
  "tool change": "tool change",
  "with the keypad (K) over the corner of the stock and set the zeros of X, Y and Z there.":
    "mit dem Tastenfeld (K) über die Ecke des Materials und dort X, Y und Z nullen.",
};
