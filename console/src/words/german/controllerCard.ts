/** Texts of the card of a controller. */

export const controllerCard: Readonly<Record<string, string>> = {
  "Card of the controller: list, upload, run, follow":
    "Karte der Steuerung: auflisten, hochladen, ausführen, verfolgen",
  "Card of the controller": "Karte der Steuerung",
  "This machine has no controller with a card of its own.":
    "Diese Maschine hat keine Steuerung mit einer eigenen Karte.",
  "The controller keeps these files itself and runs them without Kerf: a run goes on when the line is lost or Kerf ends.":
    "Die Steuerung hat diese Dateien selbst und führt sie ohne Kerf aus: Ein Lauf geht weiter, wenn die Leitung abreißt oder Kerf endet.",
  "Something is done on the card.": "Auf der Karte geschieht etwas.",
  "List the files": "Dateien auflisten",
  "The files are listed.": "Die Dateien werden aufgelistet.",
  "{0} is read back and looked through.": "{0} wird zurückgelesen und durchgesehen.",
  "{0} is looked through and put on the card.":
    "{0} wird durchgesehen und auf die Karte geschrieben.",
  "{0} is begun.": "{0} wird begonnen.",
  "{0} is deleted.": "{0} wird gelöscht.",
  "{0} is copied into the part folder.": "{0} wird in den Teileordner kopiert.",
  "{0} of {1}": "{0} von {1}",
  "1 file, {0}. The controller does not tell what room is left.":
    "1 Datei, {0}. Die Steuerung nennt nicht, wie viel Platz noch ist.",
  "{0} files, {1} in all. The controller does not tell what room is left.":
    "{0} Dateien, {1} zusammen. Die Steuerung nennt nicht, wie viel Platz noch ist.",
  "about {0}": "etwa {0}",
  "Estimated time": "Geschätzte Zeit",
  "{0} % is done, about {1} left": "{0} % sind getan, noch etwa {1}",
  "{0} % of it is read; the time left is unknown: its text was not looked through":
    "{0} % davon sind gelesen; wie lange noch, ist unbekannt: ihr Text wurde nicht durchgesehen",
  "Replace {0}": "{0} ersetzen",
  "Run {0}…": "{0} ausführen…",
  "It was looked through.": "Sie wurde durchgesehen.",
  "Look through {0}": "{0} durchsehen",
  "Look through": "Durchsehen",
  "Copy {0} into the part folder": "{0} in den Teileordner kopieren",
  "Delete {0}…": "{0} löschen…",
  "Delete {0}?": "{0} löschen?",
  "It is taken off the card, and is in no bin.":
    "Sie kommt von der Karte und liegt in keinem Papierkorb.",
  "Delete it": "Löschen",
  "Leave it there": "Dort lassen",
  "Run {0}?": "{0} ausführen?",
  "{0} runs it from its card by itself, from where it stands, at its zero point {1}. STOP slows it down, ends the file with the spindle off and lifts the tool; the file is not taken up again there.":
    "{0} führt sie selbst von ihrer Karte aus, von dort, wo sie steht, am Nullpunkt {1}. STOPP bremst sie ab, beendet die Datei mit abgeschalteter Spindel und hebt das Werkzeug; dort wird die Datei nicht wieder aufgenommen.",
  "It takes about {0}, as estimated.": "Sie dauert geschätzt etwa {0}.",
  "Its text cannot be read back: nobody has checked it, and its time is unknown.":
    "Ihr Text lässt sich nicht zurücklesen: Niemand hat sie geprüft, und ihre Zeit ist unbekannt.",
  "The material is fixed, the right tool is in, and everybody is clear of it?":
    "Ist das Material befestigt, das richtige Werkzeug eingespannt und niemand in der Nähe?",
  "Run it": "Ausführen",
  "Run it unchecked": "Ungeprüft ausführen",
  "Do not run it": "Nicht ausführen",
  "Progress of the task": "Fortschritt",
  "{0} is in the part folder.": "{0} ist im Teileordner.",
  "Open it: its preview is made": "Öffnen: ihre Vorschau wird gemacht",
  "File of the part folder": "Datei des Teileordners",
  "Put it on the card": "Auf die Karte schreiben",
  "The part folder has no file that goes on a card.":
    "Der Teileordner hat keine Datei, die auf eine Karte geht.",
  "{0} runs from the card": "{0} läuft von der Karte",
  "{0} is held": "{0} ist angehalten",
  "Progress of the file": "Fortschritt der Datei",
  "End the file: STOP": "Datei beenden: STOPP",
  "STOP slows it down, ends the file with the spindle off and lifts the tool.":
    "STOPP bremst sie ab, beendet die Datei mit abgeschalteter Spindel und hebt das Werkzeug.",
  "runs from the controller's card": "läuft von der Karte der Steuerung",
};
