/** Effects of the commands of OpenSBP in German, by their letters. */

const fromFirst = (kind: string): string =>
  `${kind} die ersten Achsen zusammen geradeaus; eine leere bleibt, wo sie ist.`;
const alone = (axis: string): string =>
  `Fährt die Achse ${axis} allein an einen Ort, mit SR um einen Abstand.`;
const zeroed = (axes: string): string => `Macht den gegenwärtigen Ort von ${axes} zu null.`;
const home =
  "Hebt Z auf die sichere Höhe, wenn es tiefer steht, und fährt nach X 0, Y 0, auch bei Abständen. In einer Datei mit Versatz ist das ihr eigener Nullpunkt.";
const goesBack = "In einem Programm gehen die Werte an seinem Ende zurück, wenn SV sie nicht hält.";
const numbers = ["2", "3", "4", "5", "6"];
const axes = ["A", "B", "C", "X", "Y", "Z"];

const perAxis = Object.fromEntries([
  ...numbers.map((n) => [`J${n}`, fromFirst("Bewegt im Eilgang")]),
  ...numbers.map((n) => [`M${n}`, fromFirst("Bewegt")]),
  ...axes.flatMap((axis) => [
    [`J${axis}`, alone(axis)],
    [`M${axis}`, alone(axis)],
    [`Z${axis}`, `${zeroed(axis)} Die Koordinaten des Tisches bleiben.`],
  ]),
]) as Readonly<Record<string, string>>;

const motion: Readonly<Record<string, string>> = {
  CA: "Schneidet vom Werkzeug aus einen Bogen mit Spannweite und Höhe.",
  CC: "Schneidet einen Kreis oder Bogen, der beim Werkzeug beginnt.",
  CG: "Schneidet vom Werkzeug aus einen Bogen zu einem Ende, nach Mittelpunkt oder Durchmesser, wie G2 und G3.",
  CP: "Schneidet einen Kreis oder Bogen um einen Mittelpunkt. Zuerst fährt das Werkzeug gerade zum ersten Punkt, in seiner Höhe Z.",
  CR: "Schneidet ein Rechteck, von dem eine Ecke beim Werkzeug liegt.",
  JH: home,
  JS: "Setzt die Geschwindigkeit der Eilgänge. Die Bewegung kommt vorher zur Ruhe; VS ändert sie ohne das.",
  MD: "Fährt um eine Länge in eine Richtung, Z fährt mit.",
  MH: home,
  MI: "Dreht eine Achse mit einer Geschwindigkeit oder schwenkt sie, bis sie angehalten wird, während das Programm mit den anderen weitergeht. Das Ende der Datei hält sie nicht an, MO schon.",
  MN: "Öffnet ein Feld für kleine Korrekturen: das Werkzeug fährt, die Orte bleiben, die Koordinaten des Tisches folgen.",
  MO: "Nimmt den Motoren den Strom, wo die Steuerung das kann, und schaltet alle Ausgänge aus. Wer die Maschine danach schiebt, verliert ihren Ort.",
  MS: "Setzt die Geschwindigkeit der Fahrten. Die Bewegung kommt vorher zur Ruhe; VS ändert sie ohne das.",
  Z2: zeroed("X und Y"),
  Z3: zeroed("X, Y und Z"),
  Z4: zeroed("X, Y, Z und A"),
  Z5: zeroed("X, Y, Z, A und B"),
  Z6: zeroed("allen sechs Achsen"),
  ZT: "Macht diesen Ort zum Nullpunkt des Tisches. Die Arbeitsorte bleiben.",
};

const files: Readonly<Record<string, string>> = {
  FC: "Wandelt eine Zeichnung, ein Bild oder G-Code in ein Programm um. Fragt, was die Datei nicht sagt: Einheit, Tiefe, Höhe der Wege, Größe.",
  FE: "Öffnet eine Datei im Editor. In einem Programm zeigt es sie dem Bediener; es geht weiter, wenn der Editor geschlossen ist.",
  FG: "Öffnet eine Datei, um sie Zeile für Zeile auszuführen: ein Schritt, eine andere Zeile, von hier an laufen, oder Ende.",
  FN: "Öffnet den Editor mit einem neuen, leeren Programm.",
  FP: "Führt ein anderes Programm aus und kommt danach zurück. Maßstab und Versatz kommen zu denen der rufenden Datei. Bis zu acht Dateien sind ineinander offen.",
  FS: "Wählt den Ordner, in dem Programme gesucht werden. Er bleibt am Ende der Datei.",
  HA: "Zeigt Fassung, Lizenz und Ansteuerung.",
  HB: "Öffnet die Seite der Neuigkeiten.",
  HC: "Öffnet das Verzeichnis aller Befehle.",
  HE: "Öffnet die Befehle mit ihren Werten in der Reihenfolge der Datei.",
  HN: "Schreibt eine Bitte um Hilfe mit dem Protokoll der Fehler.",
  HQ: "Öffnet die Seite für den ersten Lauf.",
  HR: "Öffnet die Befehle auf einer Seite zum Drucken.",
  HT: "Öffnet Fehlersuche und Wartung.",
  HU: "Öffnet das Handbuch.",
  HW: "Zeigt die Adresse des Projekts.",
  RA: "Zeichnet von hier an die getippten Befehle auf; das ist von Anfang an so.",
  RI: "Beendet das Aufzeichnen; was aufgezeichnet ist, bleibt.",
  RP: "Führt alle aufgezeichneten Befehle noch einmal aus, höchstens 100 mal.",
  RR: "Führt die letzten aufgezeichneten Befehle noch einmal aus, mit denselben Werten.",
  RS: "Schreibt aufgezeichnete Befehle in ein Programm und öffnet es im Editor.",
  RZ: "Verwirft alle aufgezeichneten Befehle; das Aufzeichnen geht weiter wie zuvor.",
};

const settings: Readonly<Record<string, string>> = {
  SA: "Von hier an sind die Werte der Fahrten Orte, von 0 an gezählt.",
  SC: "SC,2 bringt die Bewegung zur Ruhe und beginnt eine neue Folge von Fahrten.",
  SF: "Sagt, ob Fahrten über die Grenzen von VL vor ihrem Beginn angehalten werden. In einem Programm geht es an seinem Ende zurück, wenn SV es nicht hält.",
  SI: "Öffnet ein Feld für einige Zeilen, die sofort ausgeführt werden.",
  SK: "Lässt den Bediener das Werkzeug von Hand bewegen; die Datei geht weiter, wenn das Tastenfeld geschlossen ist. In der Vorschau öffnet es sich nicht.",
  SL: "Löscht alle eigenen Variablen.",
  SM: "Befehle bewegen das Werkzeug. Nach einer Vorschau ist alles wie vorher. Ohne Steuerung bewegt sich nichts: die Vorschau wird angeboten.",
  SO: "Schaltet einen Ausgang: ein mit der Folge der Fahrten, aus beendet sie. Vor dem Start der Spindel (Ausgang 1) wird gefragt, außer sie läuft schon, in der Vorschau, oder wenn die Einstellungen es nicht wollen.",
  SP: "Befehle werden gezeichnet und ändern nichts; SM kehrt zum wahren Ort des Werkzeugs zurück. Noch einmal gegeben leert es das Bild.",
  SR: "Von hier an sind die Werte der Fahrten Abstände vom Werkzeug.",
  ST: "Setzt die Arbeitsorte gleich den Koordinaten des Tisches. Nichts bewegt sich.",
  SV: "Was am Ende des Programms zurückginge, bleibt wie jetzt: Geschwindigkeiten, VI, VU und Grenzen.",
  SW: "Sagt, wie lange Licht und Ton warnen, bevor sich etwas bewegt.",
  VA: "Sagt, wie der gegenwärtige Ort heißt, in Arbeitsorten und am Tisch. Nichts bewegt sich. Ein Arbeitsort ändert die Koordinaten des Tisches nicht.",
  VB: "Größe und Abstand der Stege, die beim letzten Durchgang stehen bleiben, und ob es von hier an welche gibt.",
  VC: "Durchmesser für Schnitte innen und außen, sichere Höhen, Vorzeichen des Eintauchens, Überlappung von Taschen, und ein Ausgang, den senkrechte Fahrten von Z oder A schalten.",
  VD: "Einheiten, Zahl der Achsen, und was wo angezeigt wird. Nach einem Wechsel der Einheit zählt jeder Wert in der neuen; sonst ändert sich nichts. Allein leert es die Meldungen.",
  VH: "Höhenregelung des Brenners, Leistung des Lasers oder eine Heizung, was davon VN im dritten Wert einschaltet.",
  VI: `Sagt, wie die Steuerung erreicht wird und welche Achse jeder Kanal treibt. ${goesBack}`,
  VL: `Sagt, wie weit jede Achse darf, am Tisch, und ob das geprüft wird. ${goesBack}`,
  VN: "Sagt, wofür jeder Eingang und Ausgang da ist. Ausgang 4 folgt SO,4,-1 bis -4. Grenzen ein oder aus gehen am Ende des Programms zurück, wenn SV sie nicht hält.",
  VO: "Verschiebt jede Achse, die ein Programm bewegt, wie ein zweiter Kopf es braucht. Nichts bewegt sich von selbst; die Orte zeigen das Werkzeug. Endet mit dem Programm.",
  VP: "Sagt, was die Vorschau zeigt: den Tisch mit Raster, das Werkzeug, Eilgänge, und wo sie beginnt.",
  VR: "Sagt, wie Fahrten und Eilgänge schneller und langsamer werden.",
  VS: `Geschwindigkeiten aller Achsen. Anders als MS und JS unterbricht es die Bewegung nicht. ${goesBack}`,
  VU: `Motorschritte je Einheit jeder Achse, und die Auflösung von Kreisen und Eilgängen. ${goesBack}`,
  VV: "Gibt einer eigenen Variablen einen Wert, wie die Zuweisung allein. UL zeigt sie, SL löscht sie.",
};

const tools: Readonly<Record<string, string>> = {
  TC: "Macht eine Datei, indem ein Objekt abgetastet wird.",
  TD: "Macht ein Programm, das Löcher bohrt.",
  TF: "Macht ein Programm, das Rillen schneidet.",
  TH: "Schreibt einen Kopf in ein Programm.",
  TI: "Macht ein Programm, das die Drehachse dreht.",
  TM: "Macht ein Programm, das eine Oberfläche in einem Raster tastet.",
  TP: "Macht ein Programm, das Ort oder Winkel durch Antasten findet und dort nullt.",
  TR: "Setzt die Drehzahl einer Spindel. Ohne Gerät dafür wird der Bediener gebeten, sie einzustellen.",
  TS: "Hält fest, womit die Maschine zum Nullen ausgerüstet ist.",
  TT: "Macht ein Programm, das Schrift schneidet.",
  TU: "Macht ein Programm, das den Tisch plant.",
  UD: "Zeigt, was beim Finden eines Fehlers hilft: Fassungen, Orte, Eingänge, Ausgänge, den letzten Fehler; mit den Werten von UV kommt es in problem.log.",
  UI: "Lädt die Firmware einer Steuerung, die eine hat.",
  UL: "Zeigt alle eigenen Variablen mit ihren Werten.",
  UN: "Nennt das Programm, das FE an einem Terminal startet.",
  UR: "Führt eine Datei mit Einstellungen aus: alles wird, wie sie sagt.",
  US: "Speichert alle wichtigen Einstellungen in einer Datei (.sbd), die ein Programm ist und sie setzt.",
  UU: "Zeigt, was ein Ausdruck ergibt; allein öffnet es den Rechner.",
  UV: "Zeigt die Werte aller Befehle mit V und den Ordner der Programme.",
  UZ: "Macht alle Arbeitsorte und alle Koordinaten des Tisches zu null.",
};

export const commandDocs: Readonly<Record<string, string>> = {
  ...perAxis,
  ...motion,
  ...files,
  ...settings,
  ...tools,
};
