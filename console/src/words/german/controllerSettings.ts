/** Texts of the settings that a controller keeps by number. */

export const controllerSettings: Readonly<Record<string, string>> = {
  "Settings of the controller: see, change, back up, compare":
    "Einstellungen der Steuerung: ansehen, ändern, sichern, vergleichen",
  "Settings of the controller": "Einstellungen der Steuerung",
  "The machine keeps no settings by number.": "Die Maschine hat keine Einstellungen nach Nummern.",
  "They are kept in the controller itself, and are read from it. What is changed here is written into it and read back.":
    "Sie stehen in der Steuerung selbst und werden aus ihr gelesen. Was hier geändert wird, wird in sie geschrieben und zurückgelesen.",
  "{0} has no settings of a controller ($110=5000).":
    "{0} hat keine Einstellungen einer Steuerung ($110=5000).",
  "Back up": "Sichern",
  "The controller has not told its settings.":
    "Die Steuerung hat ihre Einstellungen nicht genannt.",
  "Compare with a file…": "Mit einer Datei vergleichen…",
  "Change {0}": "{0} ändern",
  "Give a value.": "Einen Wert angeben.",
  "{0} or less": "{0} oder weniger",
  "Nothing is found.": "Nichts gefunden.",
  "number, name, unit or what it does": "Nummer, Name, Einheit oder Wirkung",
  "What it does is not known.": "Was sie bewirkt, ist nicht bekannt.",
  Setting: "Einstellung",
  "Compared with the file": "Mit der Datei verglichen",
  "The controller has every value of the file.": "Die Steuerung hat jeden Wert der Datei.",
  "The controller has no {0}.": "Die Steuerung hat {0} nicht.",
  "Write {0} settings into the controller?": "{0} Einstellungen in die Steuerung schreiben?",
  "They are being written.": "Sie werden gerade geschrieben.",
  "Write the values of the file…": "Die Werte der Datei schreiben…",
  Controller: "Steuerung",
  Value: "Wert",
  "{0} or more": "{0} oder mehr",
};
