/** Sentences of the server about files, drafts, drawings and jobs that are opened and saved, in German. */

export const filesSentences: Readonly<Record<string, string>> = {
  "{0}: shapes were digitized into it that were not saved when Kerf ended; they are there again when it is opened":
    "{0}: darin wurden Formen aufgenommen, die nicht gespeichert waren, als Kerf endete; sie sind beim Öffnen wieder da.",
  "{0}; they lie in {1}": "{0}; sie liegen in {1}",
  "what is digitized into a job is only kept until Kerf ends: {0}":
    "Was in einen Auftrag aufgenommen wird, bleibt nur, bis Kerf endet: {0}",
  "there is no name for the job": "Für den Auftrag gibt es keinen Namen.",
  "{0} was changed since shapes were digitized into it: the job with them is {1}":
    "{0} wurde geändert, seit Formen darin aufgenommen wurden: der Auftrag mit ihnen ist {1}",
  "shapes that were digitized into jobs and not saved cannot be read: {0}":
    "Formen, die in Aufträge aufgenommen und nicht gespeichert wurden, lassen sich nicht lesen: {0}",
  "when files ran last is not known any more: {0}":
    "Wann Dateien zuletzt liefen, ist nicht mehr bekannt: {0}",
  "the history of runs is not known any more: {0}":
    "Der Verlauf der Läufe ist nicht mehr bekannt: {0}",
  "this was given up before it was done: nothing was changed; ask for it again":
    "Es wurde aufgegeben, bevor es getan war: nichts wurde geändert; noch einmal verlangen.",
  "These are tool paths: what is changed here is lost when they are made anew from the drawing. They are saved as .rsm.":
    "Das sind Werkzeugwege: was hier geändert wird, ist fort, sobald sie aus der Zeichnung neu gemacht werden. Gespeichert werden sie als .rsm.",
  "a drawing is written as {0}": "Eine Zeichnung wird als {0} geschrieben.",
  "Made from {0}": "Gemacht aus {0}",
  "a program is written as .sbp or .nc": "Ein Programm wird als .sbp oder .nc geschrieben.",
  "tool paths are made by Machine; as .rsm those are saved that were opened":
    "Werkzeugwege macht »Maschine«; als .rsm werden nur geöffnete gespeichert.",
  "a place has two numbers": "Ein Ort hat zwei Zahlen.",
  "clause {0}: {1}": "Schritt {0}: {1}",
  "a drawing is {0}": "Eine Zeichnung ist {0}.",
  "it is empty": "Sie ist leer",
  "its first line is damaged": "Ihre erste Zeile ist beschädigt",
  "it is not as Kerf wrote it": "Sie ist nicht so, wie Kerf sie schrieb",
  "{0} in the job": "{0} im Auftrag",
  "{0} in the drawing": "{0} in der Zeichnung",
  "a part file is open: close it, or open a drawing or a job":
    "Ein Programm ist offen: es schließen, oder eine Zeichnung oder einen Auftrag öffnen.",
  "there is no name for a new job": "Für einen neuen Auftrag gibt es keinen Namen.",
  "no shape was added since the job was saved":
    "Seit der Auftrag gespeichert wurde, kam keine Form hinzu.",
  "It was not saved when Kerf ended: here it is again.":
    "Als Kerf endete, war es nicht gespeichert: hier ist es wieder.",
  "The drawing that was not saved is an older copy, without what was drawn since. Its file (drawing.draft in the data folder) was replaced.":
    "Die ungespeicherte Zeichnung ist eine ältere Kopie, ohne das seither Gezeichnete. Ihre Datei (drawing.draft im Datenordner) wurde ersetzt.",
  "The drawing that was not saved is gone: its file (drawing.draft) was taken out of the data folder.":
    "Die ungespeicherte Zeichnung ist fort: ihre Datei (drawing.draft) wurde aus dem Datenordner genommen.",
  "Its file was changed since it was opened: Save asks before it is replaced.":
    "Die Datei wurde seit dem Öffnen geändert: beim Speichern wird gefragt, bevor sie ersetzt wird.",
  "what is drawn is only kept until Kerf ends: {0}":
    "Was gezeichnet wird, bleibt nur, bis Kerf endet: {0}",
  "the drawing that was not saved cannot be read: {0}; it lies in {1}":
    "Die ungespeicherte Zeichnung lässt sich nicht lesen: {0}; sie liegt in {1}",
  "{0} is too large": "{0} ist zu groß.",
  "'{0}' is no name of a file in the part folder":
    "»{0}« ist kein Name einer Datei im Ordner der Programme.",
  "{0} is not written, it is as it was before: the disk is full; make room ({1})":
    "{0} ist nicht geschrieben und bleibt, wie es war: die Platte ist voll; Platz schaffen ({1})",
  "cut short": "abgebrochen",
  "the list holds {0} files at most, each wanted once at least":
    "Die Liste hat höchstens {0} Dateien, jede mindestens einmal.",
  "the list is only known until Kerf ends: {0}":
    "Die Liste bleibt nur bekannt, bis Kerf endet: {0}",
  "when files ran last is only known until Kerf ends: {0}":
    "Wann Dateien zuletzt liefen, bleibt nur bekannt, bis Kerf endet: {0}",
  "the history of runs is only known until Kerf ends: {0}":
    "Der Verlauf der Läufe bleibt nur bekannt, bis Kerf endet: {0}",
  "the job has the paths 1 to {0}": "Der Auftrag hat die Bahnen 1 bis {0}.",
  "origin, finish, offset and lift are lengths": "Ursprung, Ende, Versatz und Hub sind Längen.",
  "no job is open": "Kein Auftrag ist offen.",
  "the job lies where its file says": "Der Auftrag liegt, wo seine Datei es sagt.",
  "the file was changed since it was opened; open it again":
    "Die Datei wurde seit dem Öffnen geändert; sie noch einmal öffnen.",
  "{0} has tool paths already: save it, and open it as a job":
    "{0} hat schon Werkzeugwege: sie speichern und als Auftrag öffnen.",
  "{0}: its paths were changed by hand; making them anew loses that":
    "{0}: die Bahnen wurden von Hand geändert; beim neuen Machen geht das verloren.",
  "nothing is drawn that could be cut": "Nichts ist gezeichnet, das sich schneiden ließe.",
  "the job has no path": "Der Auftrag hat keine Bahn.",
  "the small picture of {0} is not kept: {1}": "Das kleine Bild von {0} wird nicht aufgehoben: {1}",
  "another file, or another chart, was asked for meanwhile":
    "Inzwischen wurde eine andere Datei oder ein anderes Diagramm verlangt.",
  "a digitized shape": "eine aufgenommene Form",
  "digitized shapes": "aufgenommene Formen",
  "{0} has {1} more than its file: save the job, or take them back":
    "{0} hat {1} mehr als die Datei: den Auftrag speichern, oder sie zurücknehmen.",
  "'{0}' has a sign that nobody sees: leave it out":
    "»{0}« hat ein Zeichen, das niemand sieht: es weglassen.",
  "'{0}' ends with a dot or a blank, which other computers leave out: end it otherwise":
    "»{0}« endet mit einem Punkt oder Leerzeichen, das andere Rechner weglassen: anders enden lassen.",
  "'{0}' is a device on other computers: choose another name":
    "»{0}« ist auf anderen Rechnern ein Gerät: einen anderen Namen wählen.",
  "{0} was not read to its end: it was given up, or another drawing was opened meanwhile":
    "{0} wurde nicht zu Ende gelesen: es wurde aufgegeben, oder eine andere Zeichnung wurde inzwischen geöffnet.",
  "the file": "die Datei",
  "overrides are 10 to 200 percent": "Der Vorschub lässt sich auf 10 bis 200 Prozent stellen.",
  "rapid moves are overridden by 10 to 100 percent, a spindle by 10 to 200":
    "Eilgänge lassen sich auf 10 bis 100 Prozent stellen, eine Spindel auf 10 bis 200.",
  "the machine overrides neither rapid moves nor its spindle":
    "Bei dieser Maschine lassen sich weder Eilgang noch Spindel verstellen.",
  "{0}: Machine makes it from the drawing": "{0}: »Maschine« macht es aus der Zeichnung.",
  "the file cannot run": "Die Datei kann nicht laufen.",
  "'{0}' is nothing that a job that waits could be told":
    "»{0}« ist nichts, was ein wartender Auftrag annimmt.",
  "answer one of {0}": "Eine Antwort aus {0} geben.",
  "{0} stays as it is: its present version cannot be kept in the data folder ({1}); make room there, or save under another name":
    "{0} bleibt, wie es ist: die jetzige Fassung lässt sich nicht im Datenordner aufheben ({1}); dort Platz schaffen, oder unter anderem Namen speichern.",
  "{0} is another file by now: look at it again before you delete it":
    "{0} ist inzwischen eine andere Datei: sie ansehen, bevor sie gelöscht wird.",
  "the bin": "der Papierkorb",
  "{0} is not in the bin": "{0} ist nicht im Papierkorb.",
  "a job: the tool paths of a drawing": "ein Auftrag: die Werkzeugwege einer Zeichnung",
  "a part program of {0}": "ein Programm aus {0}",
  "a file of {0}": "eine Datei aus {0}",
  "{0} is there already, {1}, {2} bytes: nothing was written. Choose another name, or say that it may be replaced (over HTTP: If-Match with its hash, or ?replace=1)":
    "{0} ist schon da, {1}, {2} Byte: nichts wurde geschrieben. Einen anderen Namen wählen, oder sagen, dass es ersetzt werden darf.",
  "versions of {0}: {1}": "Fassungen von {0}: {1}",
  "what is typed is not kept as a draft: {0}; save it":
    "Was getippt wird, bleibt nicht als Entwurf: {0}; speichern.",
  "the draft of {0} stays: {1}": "Der Entwurf von {0} bleibt: {1}",
  "{0} was changed on the disk before anything was typed, and what is typed is not kept as a draft: save it under another name":
    "{0} wurde auf der Platte geändert, bevor etwas getippt wurde, und was getippt wird, bleibt nicht als Entwurf: unter anderem Namen speichern.",
  "what is typed into {0} is not kept as a draft: {1}; save it":
    "Was in {0} getippt wird, bleibt nicht als Entwurf: {1}; speichern.",
  "the text that was typed into: {0}": "Der Text, in den getippt wurde: {0}",
  "it lies in {0}": "Er liegt in {0}",
  "text of the editor that was not saved cannot be read: {0}":
    "Ungespeicherter Text des Editors lässt sich nicht lesen: {0}",
  "drafts: {0}": "Entwürfe: {0}",
};
