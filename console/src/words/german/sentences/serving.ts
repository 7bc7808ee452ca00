/** Sentences of the server about who may do what, devices, moves by hand and its own state, in German. */

export const servingSentences: Readonly<Record<string, string>> = {
  "nobody drives": "Niemand steuert.",
  "a jog has a direction, a share of the speed above 0, and perhaps a distance":
    "Ein Handverfahren hat eine Richtung, einen Anteil der Geschwindigkeit über 0 und vielleicht einen Weg.",
  "no output bit is called {0}": "Kein Ausgangsbit heißt {0}.",
  "this bit belongs to a motor: step it instead":
    "Dieses Bit gehört zu einem Motor: stattdessen Schritte machen.",
  "no axis is moved by a motor {0}": "Keine Achse wird von einem Motor {0} bewegt.",
  "two motors move this axis: a step of one of them would set it askew":
    "Zwei Motoren bewegen diese Achse: ein Schritt von einem würde sie schief stellen.",
  "this machine keeps no zero points of its own: zero its axes (ZX, ZY, ZZ), or say what they read (VA)":
    "Diese Maschine hat keine eigenen Nullpunkte: ihre Achsen nullen (ZX, ZY, ZZ), oder sagen, was sie anzeigen (VA).",
  "no zero point is called {0}: {1}": "Kein Nullpunkt heißt {0}: {1}",
  "the switches of this machine are moved where they are, not on a page":
    "Die Schalter dieser Maschine werden an ihr bewegt, nicht auf einer Seite.",
  "this machine has no card whose bits are switched: it has outputs (SO)":
    "Diese Maschine hat keine Karte, deren Bits sich schalten lassen: sie hat Ausgänge (SO).",
  "axis {0} is not there, or has no home switch":
    "Die Achse {0} gibt es nicht, oder sie hat keinen Referenzschalter.",
  "name the axes by their letters, as xy": "Die Achsen mit ihren Buchstaben nennen, wie xy.",
  "a place has a number for at least one axis": "Ein Ort hat eine Zahl für mindestens eine Achse.",
  "{0} runs and is not on the screen: {1}": "{0} läuft und steht nicht auf dem Bildschirm: {1}",
  "{0} is changed, but not in the history of changes: the disk refuses":
    "{0} ist geändert, steht aber nicht im Verlauf der Änderungen: die Platte weigert sich.",
  "{0} is not on the disk after {1} s: look at the disk, and whether the setting is as you want it":
    "{0} ist nach {1} s nicht auf der Platte: die Platte prüfen, und ob die Einstellung so ist, wie sie soll.",
  "there is no setting {0}; {1}": "Die Einstellung {0} gibt es nicht; {1}",
  "Kerf alone writes {0}; values of your own have other names, as uValue or one with a $":
    "{0} schreibt nur Kerf; eigene Werte heißen anders, wie uWert oder mit einem $.",
  "no answer moves the tool: hold a key of the keypad (jogStart), or nudge (nudge); both work while the question is open":
    "Keine Antwort bewegt das Werkzeug: eine Taste des Tastenfelds halten oder rücken; beides geht, solange die Frage offen ist.",
  "another page": "eine andere Seite",
  "this is not available in the editing version: only drawings are worked on here":
    "Das gibt es in der Fassung zum Bearbeiten nicht: hier wird nur an Zeichnungen gearbeitet.",
  "Kerf was started for files only: no commands, no keypad":
    "Kerf wurde nur für Dateien gestartet: keine Befehle, kein Tastenfeld.",
  "Somebody else drives": "Jemand anderes steuert",
  "Nobody drives": "Niemand steuert",
  "Points were being digitized when Kerf ended: function 70 goes on with them.":
    "Als Kerf endete, wurden Punkte aufgenommen: Funktion 70 macht mit ihnen weiter.",
  "points that were being digitized cannot be read: {0}":
    "Punkte, die aufgenommen wurden, lassen sich nicht lesen: {0}",
  "what is digitized is only kept until Kerf ends: {0}":
    "Was aufgenommen wird, bleibt nur, bis Kerf endet: {0}",
  "hand console": "Handbedienung",
  "hand console's link": "Verbindung der Handbedienung",
  "hand console: {0}": "Handbedienung: {0}",
  "the machine moves: Stop it first": "Die Maschine bewegt sich: zuerst Stop.",
  "an axis and a distance are needed": "Eine Achse und ein Weg sind nötig.",
  "the key was pressed too long ago: the link is slow; press it anew":
    "Die Taste wurde vor zu langer Zeit gedrückt: die Verbindung ist langsam; noch einmal drücken.",
  "another jog is not over yet": "Ein anderes Handverfahren ist noch nicht vorbei.",
  "no program asks this any more: nothing is lifted":
    "Kein Programm fragt das noch: nichts wird gehoben.",
  "this jog is over": "Dieses Handverfahren ist vorbei.",
  "nothing to tell": "nichts zu sagen",
  "other files are being received, and there is no room for this one: send it again":
    "Andere Dateien werden empfangen, für diese ist kein Platz: noch einmal senden.",
  "the body of this request came too slowly": "Der Inhalt dieser Anfrage kam zu langsam.",
  "the machine moves: files are sent when it stands":
    "Die Maschine bewegt sich: Dateien werden gesendet, wenn sie steht.",
  "the file is damaged: send it again": "Die Datei ist beschädigt: noch einmal senden.",
  "the machine is busy: files are deleted when nothing runs":
    "Die Maschine ist beschäftigt: Dateien werden gelöscht, wenn nichts läuft.",
  "this device is not paired with the machine; at the machine itself open the address that kerf serve printed":
    "Dieses Gerät ist nicht mit der Maschine gekoppelt; an der Maschine selbst die Adresse öffnen, die kerf serve nannte.",
  "this device has too many connections: close some of its pages":
    "Dieses Gerät hat zu viele Verbindungen: einige seiner Seiten schließen.",
  "this took too long": "Das dauerte zu lange.",
  "this is not the name of this machine": "Das ist nicht der Name dieser Maschine.",
  "a page of another site may not ask this machine":
    "Eine Seite eines anderen Orts darf diese Maschine nichts fragen.",
  "this is not how things are asked here": "So wird hier nicht gefragt.",
  "there is no sound {0}": "Den Klang {0} gibt es nicht.",
  "Pairing: {0} tried a wrong code, {1} wrong so far; the code that is shown stays good":
    "Koppeln: {0} versuchte einen falschen Code, bisher {1} falsche; der gezeigte Code gilt weiter.",
  "this failed in the server": "Das misslang im Server.",
  "{0} was passed in and not carried out: {1}": "{0} wurde übergeben und nicht ausgeführt: {1}",
  "this device has too many pages open: close one of them":
    "Dieses Gerät hat zu viele Seiten offen: eine davon schließen.",
  "passed in by a program on this computer (uCommand)":
    "von einem Programm auf diesem Rechner übergeben (uCommand)",
  "{0} of the start-up line is not carried out: {1}":
    "{0} der Startzeile wird nicht ausgeführt: {1}",
  "{0}; start it here": "{0}; hier starten.",
  "the machine was stopped meanwhile": "Die Maschine wurde inzwischen angehalten.",
  "{0} cannot be used: {1}": "{0} lässt sich nicht verwenden: {1}",
  "the height map stays as it was: {0}": "Die Höhenkarte bleibt, wie sie war: {0}",
  "{0} holds until Kerf ends, it cannot be kept: {1}":
    "{0} gilt, bis Kerf endet; es lässt sich nicht aufheben: {1}",
  "1 setting saved": "1 Einstellung gespeichert",
  "{0} settings saved": "{0} Einstellungen gespeichert",
  "settings that {0} changed are not in their history: the disk refuses":
    "Einstellungen, die {0} änderte, stehen nicht in ihrem Verlauf: die Platte weigert sich.",
  "{0}. Find home where the controller has homing, or set its location and begin at a line":
    "{0}. Referenzieren, wo die Steuerung es kann, oder ihren Ort setzen und bei einer Zeile beginnen.",
  "look at its cable, its power and its port": "Kabel, Strom und Anschluss prüfen",
  "what the controller lacks cannot be looked for: {0}":
    "Was der Steuerung fehlt, lässt sich nicht herausfinden: {0}",
  "there is no controller that keeps zero points": "Es gibt keine Steuerung, die Nullpunkte hat.",
  "what a run leaves cannot be kept: {0}":
    "Was ein Lauf hinterlässt, kann nicht aufgehoben werden: {0}",
  "cut move to": "schneidend fahren nach",
  "the nudge holds until Kerf ends, it cannot be kept: {0}":
    "Das Rücken gilt, bis Kerf endet; es lässt sich nicht aufheben: {0}",
  "the computer slept for {0} s while the machine moved: stopped. See to it that it does not sleep while Kerf runs":
    "Der Rechner schlief {0} s, während die Maschine sich bewegte: angehalten. Dafür sorgen, dass er nicht schläft, solange Kerf läuft.",
  "{0} homed; its last home was {1} steps off":
    "{0} referenziert; der letzte Referenzpunkt lag {1} Schritte daneben",
  "the server's memory is used up by what it does: ask again when that is done":
    "Der Speicher des Servers ist mit dem voll, was er tut: danach noch einmal verlangen.",
  "the server's memory is used up: long work of other devices is refused for now":
    "Der Speicher des Servers ist voll: lange Arbeit anderer Geräte wird vorerst abgelehnt.",
  "the server has memory again": "Der Server hat wieder Speicher.",
  "nobody asked for this": "Niemand hat das verlangt.",
  "the machine's thread has ended; start Kerf anew":
    "Der Teil, der die Maschine steuert, ist beendet; Kerf neu starten.",
  "No device is paired now: pair each anew, or end Kerf and put a copy of the list in its place":
    "Kein Gerät ist jetzt gekoppelt: jedes neu koppeln, oder Kerf beenden und eine Kopie der Liste an ihren Platz legen",
  "Devices that were revoked since may be in it again, and others may be missing: look at the list of devices, and revoke what is not to drive the machine":
    "Geräte, denen seither der Zugang entzogen wurde, können wieder darin stehen, andere fehlen: die Liste der Geräte ansehen und entziehen, was die Maschine nicht steuern soll",
  "{0}, the list of paired devices,": "{0}, die Liste der gekoppelten Geräte,",
  "{0} is gone. {1}": "{0} ist fort. {1}",
  "{0} is an older copy. {1}": "{0} ist eine ältere Kopie. {1}",
  "{0}, the list of paired devices, cannot be read ({1}). It was put aside as {2}. {3}":
    "{0}, die Liste der gekoppelten Geräte, lässt sich nicht lesen ({1}). Sie wurde als {2} beiseitegelegt. {3}",
  "the page's clock is ahead of the machine's by {0} ms: let it measure the link by pings, and stamp with the clock that they are answered with":
    "Die Uhr der Seite geht der Maschine {0} ms voraus: die Seite neu laden.",
  "this computer gives no random numbers": "Dieser Rechner gibt keine Zufallszahlen.",
  "short work": "kurze Arbeit",
  "long work": "lange Arbeit",
  "too much was asked for and is not done yet: wait a moment, then ask again":
    "Zu viel ist verlangt und noch nicht getan: kurz warten, dann noch einmal.",
  "this was asked for by nobody": "Niemand hat das verlangt.",
  "the settings are protected: give the password first":
    "Die Einstellungen sind geschützt: zuerst das Passwort angeben.",
  "another password is being tried, one at a time: wait 1 s, then try again":
    "Gerade wird ein anderes Passwort versucht, eines nach dem anderen: 1 s warten, dann noch einmal.",
  "wrong passwords were tried from here: wait {0} s, then try again":
    "Von hier wurden falsche Passwörter versucht: {0} s warten, dann noch einmal.",
  "at the machine": "an der Maschine",
  "a wrong password of the settings was tried: {0}, {1} wrong so far":
    "Ein falsches Passwort der Einstellungen wurde versucht: {0}, bisher {1} falsche.",
  "this is not the password of the settings": "Das ist nicht das Passwort der Einstellungen.",
  "the two passwords are not the same": "Die beiden Passwörter sind nicht gleich.",
  "a password has {0} characters at least": "Ein Passwort hat mindestens {0} Zeichen.",
  "proportions are numbers other than 0": "Verhältnisse sind Zahlen außer 0.",
  "a file runs once at least": "Eine Datei läuft mindestens einmal.",
  "offset is 0 (none), 1 (X, Y and Z) or 2 (X and Y)":
    "Der Versatz ist 0 (keiner), 1 (X, Y und Z) oder 2 (X und Y).",
  "plunge is a length": "Das Eintauchen ist eine Länge.",
  "{0} is no folder": "{0} ist kein Ordner.",
  "one command of OpenSBP can be recorded": "Aufzeichnen lässt sich ein Befehl von OpenSBP.",
  "{0} names at most, each with its &, $ or #": "Höchstens {0} Namen, jeder mit &, $ oder #.",
  "inputs are 1 to {0}": "Eingänge gehen von 1 bis {0}.",
  "release the emergency stop": "Den Not-Halt lösen",
  "release stop input {0}": "Halteingang {0} lösen",
  "a webhook begins with http:// or https://, without spaces":
    "Ein Webhook beginnt mit http:// oder https://, ohne Leerzeichen.",
  "a webhook has the name of a host behind http:// or https://":
    "Ein Webhook nennt hinter http:// oder https:// einen Rechner.",
  "{0} was not told that {1}: {2}": "{0} erfuhr nicht, dass {1}: {2}",
  "needs you": "braucht jemanden",
  "{0} needs you: {1}": "{0} braucht jemanden: {1}",
  "{0} is done": "{0} ist fertig",
  "a board is being wired: end that first": "Eine Platine wird verdrahtet: zuerst das beenden.",
  "ports are being looked at: wait some seconds":
    "Anschlüsse werden geprüft: einige Sekunden warten.",
  "no thread for it: {0}": "Dafür ist im Rechner kein Platz: {0}",
  "a real machine is driven: start Kerf without one (kerf serve) to wire a board":
    "Eine echte Maschine wird gesteuert: Kerf ohne sie starten (kerf serve), um eine Platine zu verdrahten.",
  "name the machine's file, as mine.toml": "Die Datei der Maschine nennen, wie mine.toml.",
  "{0} is there already: name another file": "{0} ist schon da: eine andere Datei nennen.",
  "written: {0}. kerf serve --machine {1} drives it":
    "Geschrieben: {0}. Mit kerf serve --machine {1} wird sie gesteuert.",
  "not written: {0}": "Nicht geschrieben: {0}",
  "stopped; nothing is written": "Angehalten; nichts ist geschrieben.",
  "{0}; nothing is written": "{0}; nichts ist geschrieben.",
  "no code is shown at the machine, or it is too old: show a new one":
    "An der Maschine wird kein Code gezeigt, oder er ist zu alt: einen neuen zeigen.",
  "this is not the code that the machine shows": "Das ist nicht der Code, den die Maschine zeigt.",
  "wrong codes were tried from this device: wait {0} s, then try again":
    "Von diesem Gerät wurden falsche Codes versucht: {0} s warten, dann noch einmal.",
  "the device cannot be entered": "Das Gerät lässt sich nicht eintragen.",
  "this jog is over already": "Dieses Handverfahren ist schon vorbei.",
};
