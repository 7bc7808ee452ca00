/** Sentences about the journal, what it rescued, and files that programs open, in German. */

export const journalSentences: Readonly<Record<string, string>> = {
  "{0} is outside the folders that may be used (--parts, --allow-path)":
    "{0} liegt außerhalb der erlaubten Ordner (--parts, --allow-path)",
  "cannot write {0}: no such folder below {1}":
    "{0} lässt sich nicht schreiben: unter {1} gibt es keinen solchen Ordner",
  "folder {0} not found below {1}": "Der Ordner {0} ist unter {1} nicht zu finden",
  "{0} not found in {1}": "{0} ist in {1} nicht zu finden",
  "file #{0} is open for reading": "Die Datei #{0} ist zum Lesen offen",
  "too much written to file #{0}": "In die Datei #{0} wurde zu viel geschrieben",
  "file #{0} is open for writing": "Die Datei #{0} ist zum Schreiben offen",
  "file #{0} is not open": "Die Datei #{0} ist nicht offen",
  "make the folder": "den Ordner machen",
  "cannot {0} {1}: {2}": "{1}: {0} geht nicht: {2}",
  " at path ": " unter ",
  "too much written for a preview": "Für eine Vorschau wurde zu viel geschrieben",
  "no version has this number": "Keine Fassung hat diese Nummer.",
  "no file of the part folder": "Keine Datei im Ordner der Programme.",
  "is empty": "ist leer",
  "is not as Kerf left it": "ist nicht, wie Kerf es ließ",
  "is gone": "ist fort",
  "cannot be read": "lässt sich nicht lesen",
  "the data folder cannot be written ({0}): {1}; give another with --data, or run with --start fresh, which keeps nothing":
    "der Datenordner lässt sich nicht schreiben ({0}): {1}; mit --data einen anderen nennen, oder mit --start fresh laufen, was nichts aufhebt",
  "the disk of the data folder is full ({0}); make room: what was kept before is still there":
    "die Platte des Datenordners ist voll ({0}); Platz schaffen: was vorher aufgehoben wurde, ist noch da",
  "the machine's settings cannot be used: {0}; `kerf machine check` shows all mistakes, --start fresh runs without them":
    "die Einstellungen der Maschine lassen sich nicht verwenden: {0}; kerf machine check zeigt alle Fehler, --start fresh läuft ohne sie",
  "moves by hand are not taken up": "Bewegungen von Hand werden nicht fortgesetzt",
  "{0}, the copy of the journal, {1}: a new one was made":
    "{0}, die Kopie des Journals, {1}: eine neue wurde gemacht",
  "the thread that writes: {0}": "der Teil, der schreibt: {0}",
  "it is gone": "es ist fort",
  "; it is kept as {0}": "; aufgehoben als {0}",
  "; its write-ahead file is kept as {0}": "; sein Schreibprotokoll ist aufgehoben als {0}",
  "the journal was damaged ({0}: {1}){2}": "das Journal war beschädigt ({0}: {1}){2}",
  "locations are not verified: home the machine, zero its axes anew, or confirm them":
    "die Orte sind nicht sicher: referenzieren, die Achsen neu nullen, oder die Orte bestätigen",
  "{0} {1}: whether {2} is the newest cannot be told; it was sealed anew":
    "{0} {1}: ob {2} der neueste Stand ist, lässt sich nicht sagen; neu versiegelt",
  "{0}: {1} from the copy": "{0}: {1} aus der Kopie",
  "{0}: {1} saved, {2} from the copy": "{0}: {1} gerettet, {2} aus der Kopie",
  "it ran on {0}: name that machine, --machine {1}":
    "er lief an {0}: diese Maschine nennen, --machine {1}",
  "Kerf {0} ran it, this is {1}": "Kerf {0} führte ihn aus, dies ist {1}",
  "its last change": "seine letzte Änderung",
  "its last {0} changes": "seine letzten {0} Änderungen",
  "it is the journal of another data folder": "es ist das Journal eines anderen Datenordners",
  "it lacks {0}: the write-ahead file journal.db-wal is gone, emptied or damaged, or an older journal was put in its place":
    "ihm fehlt {0}: die Datei journal.db-wal ist fort, geleert oder beschädigt, oder ein älteres Journal wurde an seinen Platz gelegt",
  "its rows are not those that Kerf left in it": "seine Zeilen sind nicht die, die Kerf darin ließ",
  "it is older than its write-ahead file": "es ist älter als sein Schreibprotokoll",
  "it is older than its copy, and lacks {0}": "es ist älter als seine Kopie, und ihm fehlt {0}",
  "is damaged": "ist beschädigt",
  "is damaged in part": "ist zum Teil beschädigt",
  "; as Kerf left it, it is kept as {0}: put that in its place to have it back":
    "; wie Kerf es ließ, ist es als {0} aufgehoben: an seinen Platz legen, um es wiederzuhaben",
  "{0} {1}: {2}{3}. Locations are not verified: home the machine, zero its axes anew, or confirm them":
    "{0} {1}: {2}{3}. Die Orte sind nicht sicher: referenzieren, die Achsen neu nullen, oder die Orte bestätigen",
  "options.password is another": "options.password ist ein anderes",
  "{0} was {1} and is {2}": "{0} war {1} und ist {2}",
  "more is on record than the run asks for": "aufgezeichnet ist mehr, als der Lauf verlangt",
  "the text of {0} was not kept": "der Text von {0} wurde nicht aufgehoben",
  "another {0} was expected": "ein anderes {0} wurde erwartet",
  "in its first move": "in der ersten Bewegung",
  "before its first move": "vor der ersten Bewegung",
  "at shape {0}": "bei Form {0}",
  "behind line {0}": "hinter Zeile {0}",
  "behind line {0} of {1}": "hinter Zeile {0} von {1}",
  "run of": "Lauf von",
  "the {0} {1} was {2} {3}{4}": "{0} {1}: {2} {3}{4}",
  "a value has a key: its name is empty": "Ein Wert hat einen Schlüssel: sein Name ist leer.",
  "{0} is no key: it takes no line break and no =":
    "{0} ist kein Schlüssel: er hat keinen Zeilenumbruch und kein =.",
  "the machine tells {0}, nobody sets it": "{0} sagt die Maschine, niemand setzt es.",
  "a value is one line, and that of {0} has a line break or another control character":
    "Ein Wert ist eine Zeile, und der von {0} hat einen Zeilenumbruch oder ein anderes Steuerzeichen.",
  "{0} is damaged: {1}": "{0} ist beschädigt: {1}",
  "{0} was written by a later version of Kerf":
    "{0} wurde von einer späteren Fassung von Kerf geschrieben",
  "another Kerf runs the machine of {0}; wait until it is done":
    "ein anderes Kerf benutzt die Maschine von {0}; warten, bis es fertig ist",
  "what the run left is not kept: {0}": "Was der Lauf hinterließ, wird nicht aufgehoben: {0}",
  "no run was cut short: there is nothing to take up in {0}":
    "Kein Lauf wurde unterbrochen: in {0} lässt sich nichts fortsetzen",
  "the run cannot be taken up: {0}": "Der Lauf lässt sich nicht fortsetzen: {0}",
  "{0} ({1}); the machine's settings stay as they were":
    "{0} ({1}); die Einstellungen der Maschine bleiben, wie sie waren",
};
