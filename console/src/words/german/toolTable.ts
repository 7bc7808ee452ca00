/** Texts of the tools by their numbers and of the change of tools. */

export const toolTable: Readonly<Record<string, string>> = {
  "Tools by their numbers: lengths, changing and measuring them":
    "Werkzeuge nach Nummern: Längen, Wechsel, Messen",
  "Tools by their numbers": "Werkzeuge nach Nummern",
  "T2 M6 in G-code, and &Tool = 2 with C9 in OpenSBP, ask for the tool by its number and what stands here. A length that the sensor has measured is in Z zero; others are for G43.":
    "T2 M6 in G-Code und &Tool = 2 mit C9 in OpenSBP fragen nach dem Werkzeug mit seiner Nummer und dem, was hier steht. Eine Länge, die der Taster gemessen hat, steckt im Z-Nullpunkt; andere sind für G43.",
  "No tool is known yet.": "Noch ist kein Werkzeug bekannt.",
  Tool: "Werkzeug",
  "in the spindle": "in der Spindel",
  measured: "gemessen",
  "No sensor for tools is set up.": "Kein Werkzeugtaster ist eingerichtet.",
  "Measure tool {0}": "Werkzeug {0} messen",
  Measure: "Messen",
  "Tool {0} is in the spindle": "Werkzeug {0} ist in der Spindel",
  "Is in": "Ist drin",
  "Change tool {0}": "Werkzeug {0} ändern",
  Change: "Ändern",
  "Forget tool {0}": "Werkzeug {0} vergessen",
  Forget: "Vergessen",
  "Add a tool": "Ein Werkzeug hinzufügen",
  "end mill": "Schaftfräser",
  "Keep tool {0}": "Werkzeug {0} merken",
  "The number of a tool is 1 or more.": "Die Nummer eines Werkzeugs ist mindestens 1.",
  "The diameter is no length of 0 or more.": "Der Durchmesser ist keine Länge ab 0.",
  "The length is no length.": "Die Länge ist keine Länge.",
  "Changing tools": "Werkzeugwechsel",
  "M6 of G-code": "M6 in G-Code",
  "Goes there and measures": "Fährt hin und misst",
  "Asks where it stands": "Fragt, wo es steht",
  "Tools are changed at": "Werkzeuge werden gewechselt bei",
  "Change tools where the tool is now": "Werkzeuge am jetzigen Ort wechseln",
  "The sensor is at": "Der Taster ist bei",
  "The tool is over the sensor now": "Das Werkzeug ist jetzt über dem Taster",
  "{0} of the table": "{0} vom Tisch",
  "no place of their own yet.": "noch keinem eigenen Ort.",
  "Input of the sensor": "Eingang des Tasters",
  "No sensor": "Kein Taster",
  "Input of a loose plate": "Eingang einer losen Platte",
  "No plate": "Keine Platte",
  "Move the tool over the sensor first, and press the button above.":
    "Zuerst das Werkzeug über den Taster fahren und den Knopf darüber drücken.",
  "Lengths of tools": "Längen der Werkzeuge",
  "Measured at each change": "Bei jedem Wechsel gemessen",
  "Kept in their holders": "Bleiben in ihren Haltern",
  Continue: "Weiter",
  "Continue: the tool is in": "Weiter: das Werkzeug ist drin",
  "Forget what runs have shown of the machine's time":
    "Vergessen, was Läufe über die Zeit der Maschine gezeigt haben",
  "Nothing was learned of this machine's time.":
    "Über die Zeit dieser Maschine ist nichts gelernt.",
  Learned: "Gelernt",
  "1 run here: motion takes {0} times as long as estimated":
    "1 Lauf hier: Bewegung dauert {0}-mal so lange wie geschätzt",
  "{1} runs here: motion takes {0} times as long as estimated":
    "{1} Läufe hier: Bewegung dauert {0}-mal so lange wie geschätzt",
  "This machine finds no home of Z: lengths that were measured hold until its location is set anew, or it is moved while it is off. Measure the tools again then.":
    "Diese Maschine findet keine Referenz von Z: gemessene Längen gelten, bis ihr Ort neu gesetzt oder sie ausgeschaltet bewegt wird. Dann die Werkzeuge neu messen.",
  "The controller waits for no tool.": "Die Steuerung wartet auf kein Werkzeug.",
  "The controller waits for no tool that it touches off.":
    "Die Steuerung wartet auf kein Werkzeug, das sie vermisst.",
  "Touch off": "Vermessen",
  "Touch off: the controller measures the tool at the plate below it":
    "Vermessen: die Steuerung vermisst das Werkzeug an der Platte darunter",
};
