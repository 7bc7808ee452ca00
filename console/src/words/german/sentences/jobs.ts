/** Sentences about tool paths and about jobs while they are cut, in German. */

export const jobsSentences: Readonly<Record<string, string>> = {
  "its tag of {0} mm leaves a bridge of {1} mm between the walls":
    "ihr Steg von {0} mm lässt zwischen den Wänden eine Brücke von {1} mm",
  "its tag of {0} mm leaves less by the width of the tool, which is not known: set the cutter of the group":
    "ihr Steg von {0} mm lässt um die Breite des Werkzeugs weniger, die nicht bekannt ist: den Fräser der Ebene angeben",
  "the part is loose": "das Teil ist lose",
  "the part is loose where it is cut through": "das Teil ist lose, wo es durchgeschnitten wird",
  "; so are {0} more of the group": "; ebenso {0} weitere der Ebene",
  " or smaller leads": " oder kürzere An- und Abfahrten",
  "its tag of {0} mm leaves nothing between the walls, the tool and its leads are wider by {1} mm: {2}{3}; take a longer tag{4}":
    "ihr Steg von {0} mm lässt zwischen den Wänden nichts, Werkzeug mit An- und Abfahrt sind um {1} mm breiter: {2}{3}; einen längeren Steg nehmen{4}",
  "a 3D path is entered straight down, without the {0} of its group":
    "in eine 3D-Bahn wird senkrecht eingetaucht, ohne das, was ihre Ebene verlangt: {0}",
  "shape {0}": "Form {0}",
  "one of {0} mm is cut instead": "stattdessen wird eine von {0} mm geschnitten",
  "it goes down along its path instead": "stattdessen geht es längs der Bahn hinunter",
  "its helix of {0} mm would cut into {1}{2}: {3}":
    "ihre Helix von {0} mm würde in {1}{2} schneiden: {3}",
  "its {0} cuts into {1}: move the start or make the lead smaller":
    "{0} schneidet in {1}: den Anfang verschieben, oder kürzer machen",
  "group {0}: beside its paths nobody knows the room for a helix: the tool goes down along them instead, as steeply":
    "Ebene {0}: neben ihren Bahnen kennt niemand den Platz für eine Helix: das Werkzeug geht stattdessen ebenso steil längs ihnen hinunter",
  "the arrays make {0} copies of the drawing, which come to {1} paths: 200,000 paths and 5 million vertices at the most beyond the drawing's own; give the arrays fewer rows and columns":
    "die Anordnungen machen {0} Kopien der Zeichnung, das sind {1} Bahnen: höchstens 200.000 Bahnen und 5 Millionen Punkte über die der Zeichnung hinaus; den Anordnungen weniger Zeilen und Spalten geben",
  "in the array its cut takes from shape {0}{1}: make the gap larger":
    "in der Anordnung nimmt ihr Schnitt etwas von Form {0}{1}: den Abstand vergrößern",
  " of the block {0},{1} away": " des Blocks {0},{1} weiter",
  "it comes free before shape {0}{1} in it is cut: cut what lies inside first, with `sequence auto 0,0`":
    "sie kommt frei, bevor Form {0}{1} in ihr geschnitten ist: zuerst schneiden, was innen liegt",
  "its cut takes from shape {0}: they lie nearer than the tool is wide; move them apart or take a smaller tool":
    "ihr Schnitt nimmt etwas von Form {0}: sie liegen näher, als das Werkzeug breit ist; auseinanderrücken oder ein kleineres Werkzeug nehmen",
  "so many shapes cross each other that not all of it was looked for: take copies out":
    "so viele Formen kreuzen einander, dass nicht nach allen gesucht wurde: Kopien herausnehmen",
  "it crosses shape {0}: the parts overlap": "sie kreuzt Form {0}: die Teile überlappen",
  "it is open and is cut across shape {0}: move it, or cut it less deep":
    "sie ist offen und wird quer über Form {0} geschnitten: sie verschieben, oder weniger tief schneiden",
  "it had {0} paths and has {1}": "sie hatte {0} Bahnen und hat {1}",
  "its paths or groups are not what they were": "ihre Bahnen oder Ebenen sind nicht, was sie waren",
  "it crosses itself{0}: look at its offset before it is cut, it may not be what is meant":
    "sie kreuzt sich selbst{0}: ihren Versatz vor dem Schneiden ansehen, vielleicht ist er nicht, was gemeint ist",
  "too small for an offset of {0} mm: no path": "zu klein für einen Versatz von {0} mm: keine Bahn",
  "it crosses itself{0}": "sie kreuzt sich selbst{0}",
  "offset failed: {0}: no path": "Versatz misslungen: {0}: keine Bahn",
  "the tag of {0} mm is longer than its path of {1} mm: no path":
    "der Steg von {0} mm ist länger als die Bahn von {1} mm: keine Bahn",
  "leaves the table: {0}": "verlässt den Tisch: {0}",
  "{0} mm at the {1}": "{0} mm an der Seite {1}",
  "it is drawn twice, as shape {0} is: erase one of them":
    "sie ist zweimal gezeichnet, wie Form {0}: eine davon löschen",
  "it and {0} more are drawn twice": "sie und {0} weitere sind zweimal gezeichnet",
  "the type of laser is not chosen": "die Art des Lasers ist nicht gewählt",
  "no valid laser pulse width": "keine gültige Pulsbreite des Lasers",
  "Out of bounds: {0} reaches {1} {2}": "Außerhalb: {0} erreicht {1} {2}",
  "; misc.tangential_endless tells that the tangential axis has no end":
    "; misc.tangential_endless sagt, dass die tangentiale Achse kein Ende hat",
  "the finish position": "der Endort",
  "no end-of-bottom-delay input": "kein Eingang, der die Wartezeit unten beendet",
  "the plasma torch starts above the sheet": "der Plasmabrenner beginnt über dem Blech",
  "the laser pierces": "der Laser sticht durch",
  "height control follows the sheet": "die Höhenregelung folgt dem Blech",
  "the tool goes straight down, without its {0}: {1}":
    "das Werkzeug geht senkrecht hinunter, ohne {0}: {1}",
  "close the door": "die Tür schließen",
  "waiting for a jig": "wartet auf eine Vorrichtung",
  "surface not found": "Oberfläche nicht gefunden",
  "pause mark of shape {0}": "Pausenmarke der Form {0}",
  "Start with shape {0}?": "Mit Form {0} beginnen?",
  "head too close": "Kopf zu nah",
  "arc lost": "Lichtbogen verloren",
  "stop input {0}": "Halteingang {0}",
  "group {0}: {1} mm/min is limited to {2} mm/min":
    "Ebene {0}: {1} mm/min ist auf {2} mm/min begrenzt",
  "Lower the group's speed, or raise the machine's cutting speed.":
    "Die Geschwindigkeit der Ebene senken, oder die der Maschine heben.",
  "the tool and cut outputs of its groups": "die Werkzeug- und Schneidausgänge ihrer Ebenen",
  "the start of a plasma cut": "der Start eines Plasmaschnitts",
  "the piercing and the gas of a laser": "das Durchstechen und das Gas eines Lasers",
  "the intensity of a beam": "die Leistung eines Strahls",
  "height control": "Höhenregelung",
  "the turns of a knife": "die Drehungen eines Messers",
  "a second head": "ein zweiter Kopf",
  "the input that ends the bottom delay": "der Eingang, der die Wartezeit unten beendet",
  "no arc": "kein Lichtbogen",
  "shape {0}: {1}": "Form {0}: {1}",
  "no height readings: zhigh is off at Z top": "keine Höhenmessung: zhigh ist oben bei Z aus",
  "no height readings": "keine Höhenmessung",
  "height sensors conflict": "die Höhenfühler widersprechen einander",
  "shape {0} lies across the divider and is not cut":
    "Form {0} liegt über der Trennlinie und wird nicht geschnitten",
  "emergency stop released": "Not-Halt gelöst",
  "acknowledge first": "zuerst zur Kenntnis nehmen",
  "the set points are held between 0 and 255": "die Sollwerte bleiben zwischen 0 und 255",
  "the shape to begin with is chosen before the job starts":
    "mit welcher Form begonnen wird, wird vor dem Start gewählt",
  "Z ends at {0} mm": "Z endet bei {0} mm",
  "above ZSurface at {0} mm": "über ZSurface bei {0} mm",
  "ZBottom would be at {0} mm, {1}: it stays at {2} mm":
    "ZBottom käme nach {0} mm, {1}: es bleibt bei {2} mm",
  "the job has {0} shapes": "der Auftrag hat {0} Formen",
  "OpenSBP moves while cutter compensation is on":
    "OpenSBP bewegt sich, während die Fräserkorrektur an ist",
  "write G40 before it, or the move in G-code": "davor G40 schreiben, oder die Bewegung in G-Code",
  "tabs are not left in G-code: this file is cut through":
    "in G-Code bleiben keine Stege: diese Datei wird durchgeschnitten",
  "kerf convert makes a part file of it, which FP runs with tabs":
    "kerf convert macht daraus ein Programm, das FP mit Stegen ausführt",
  "save it again where it was made": "sie noch einmal dort speichern, wo sie gemacht wurde",
  "shape {0}: no path lies {1} mm beside it": "Form {0}: keine Bahn liegt {1} mm neben ihr",
  "shape {0} has heights of its own: offset it in the drawing":
    "Form {0} hat eigene Höhen: sie in der Zeichnung versetzen",
  "the tool paths were given up before they were made: ask for them again":
    "Die Werkzeugwege wurden aufgegeben, bevor sie gemacht waren: noch einmal verlangen.",
  "the job is damaged and is not cut ({0}): make it anew from its drawing":
    "der Auftrag ist beschädigt und wird nicht geschnitten ({0}): ihn aus seiner Zeichnung neu machen",
};
