/** Sentences of the server that an operator reads most, in German. */

export const operatingSentences: Readonly<Record<string, string>> = {
  "the machine is disarmed: arm it first": "Die Maschine ist gesperrt: zuerst freigeben.",
  "nobody drives: take control first": "Niemand steuert: zuerst die Steuerung übernehmen.",
  "this belongs to an older turn at driving": "Inzwischen steuert jemand anderes.",
  "somebody else drives: {0}. Press Give up control there, or close that page; another page takes it with Take control":
    "Jemand anderes steuert: {0}. Dort die Steuerung abgeben oder die Seite schließen; eine andere Seite übernimmt sie.",
  "the machine is busy": "Die Maschine ist beschäftigt.",
  "stopped before it began: start it again": "Vor dem Beginn angehalten: noch einmal starten.",
  "take note of the alarm first": "Zuerst den Alarm zur Kenntnis nehmen.",
  "it waits for a tool: put it in and touch it off, then press Continue":
    "sie wartet auf ein Werkzeug: einsetzen und vermessen, dann Weiter drücken",
  "it touches the tool off": "sie vermisst das Werkzeug",
  "the tool is touched off: take the plate away, then press Continue":
    "das Werkzeug ist vermessen: die Platte wegnehmen, dann Weiter drücken",
  "the tool has touched nothing: bring it nearer to the plate, and look at the probe's lead":
    "das Werkzeug hat nichts berührt: näher an die Platte bringen und die Leitung des Tasters ansehen",
  "press Continue first: the controller takes the tool to where it is touched off":
    "zuerst Weiter drücken: die Steuerung bringt das Werkzeug dorthin, wo es vermessen wird",
  "error {0}: {1}": "Fehler {0}: {1}",
  "the tool is touched off, the first one: set Z zero with it, the next ones are measured against it":
    "das Werkzeug ist vermessen, das erste: mit ihm Z null setzen, die nächsten werden an ihm gemessen",
  "the tool is touched off: Z zero is {0} mm higher":
    "das Werkzeug ist vermessen: Z null liegt {0} mm höher",
  "the tool is touched off: Z zero is {0} mm lower":
    "das Werkzeug ist vermessen: Z null liegt {0} mm tiefer",
  "it is at work, or was moved a moment ago: try again":
    "sie arbeitet, oder wurde gerade bewegt: noch einmal versuchen",
  "it waits for no tool that it touches off": "sie wartet auf kein Werkzeug, das sie vermisst",
  "stopped while it touched the tool off: it has given the change of tools up":
    "angehalten, während sie das Werkzeug vermaß: sie hat den Werkzeugwechsel aufgegeben",
  "{0} waits for no tool": "{0} wartet auf kein Werkzeug",
  "there is no controller that waits for a tool":
    "es gibt keine Steuerung, die auf ein Werkzeug wartet",
  "the controller touches no tool off now: it waits for none, or a job runs":
    "die Steuerung vermisst jetzt kein Werkzeug: sie wartet auf keines, oder ein Auftrag läuft",
  "it waits for a tool: put it in, then press Continue, or its own button":
    "Sie wartet auf ein Werkzeug: einsetzen, dann Weiter drücken, oder ihren eigenen Knopf.",
  "the controller waits for no tool": "Die Steuerung wartet auf kein Werkzeug.",
  "the controller does not wait for a tool any more: it was stopped, and has given the change up":
    "Die Steuerung wartet nicht mehr auf ein Werkzeug: Sie wurde angehalten und hat den Wechsel aufgegeben.",
  "nothing is held": "Nichts wird gehalten.",
  "no file is open": "Keine Datei ist offen.",
  "no run was cut short": "Kein Lauf wurde unterbrochen.",
  "the preview is not ready": "Die Vorschau ist noch nicht fertig.",
  "this is not the file that is open": "Das ist nicht die offene Datei.",
  "somebody else has answered this question": "Jemand anderes hat diese Frage beantwortet.",
  "this question is not open any more": "Diese Frage ist nicht mehr offen.",
  "in preview only part files are drawn: choose Move mode before a job is cut":
    "In der Vorschau werden nur Programme gezeichnet: vor einem Auftrag den Schneidebetrieb wählen.",
  "the file has mistakes, the first in line {0}: {1}":
    "Die Datei hat Fehler, den ersten in Zeile {0}: {1}",
  "{0} was changed since it was previewed; open the file again":
    "{0} wurde seit der Vorschau geändert; die Datei noch einmal öffnen.",
  "this needs the role {0}, this device is {1}":
    "Das darf nur die Rolle {0}, dieses Gerät ist {1}.",
  "the controlling browser disconnected": "Der steuernde Browser ist nicht mehr verbunden.",
  "the controlling device was revoked": "Dem steuernden Gerät wurde der Zugang entzogen.",
  "the controlling program was not heard for {0} s":
    "Vom steuernden Programm kam {0} s lang nichts.",
  "disarmed at a page": "An einer Seite gesperrt.",
  "stopped by stop input {0}": "Angehalten durch Halteingang {0}.",
  "stopped by limit input {0}": "Angehalten durch Endschalter {0}.",
  "stopped by a limit": "Angehalten an einer Grenze.",
  "Stopped. Resume, Quit, or nudge the workpiece (nudge y .05)":
    "Angehalten. Fortsetzen, beenden, oder das Werkstück rücken.",
  "where the machine stands is not verified: home {0}, or zero them anew":
    "Wo die Maschine steht, ist nicht sicher: {0} referenzieren oder neu nullen.",
  "outputs are off: the machine was stopped or disarmed":
    "Ausgänge sind aus: die Maschine wurde angehalten oder gesperrt.",
  "another Kerf has run the machine: it is disarmed":
    "Ein anderes Kerf hat die Maschine benutzt: sie ist gesperrt.",
  "preview was left meanwhile, and the machine is not armed":
    "Die Vorschau wurde inzwischen verlassen, und die Maschine ist gesperrt.",
};
