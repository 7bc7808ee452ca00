/** Recording points with the tool, in German. */

export const digitizing: Readonly<Record<string, string>> = {
  "A point where the tool is, before the current one": "Ein Punkt beim Werkzeug, vor dem jetzigen",
  "A point where the tool is, behind the current one":
    "Ein Punkt beim Werkzeug, hinter dem jetzigen",
  "Adds a closed shape to the job or the drawing":
    "Fügt Auftrag oder Zeichnung eine geschlossene Form hinzu",
  "Adds an open shape to the job or the drawing":
    "Fügt Auftrag oder Zeichnung eine offene Form hinzu",
  "All shapes on every sheet": "Alle Formen auf jedem Blatt",
  "Along the path to the first point": "Auf der Bahn zum ersten Punkt",
  "Along the path to the last point": "Auf der Bahn zum letzten Punkt",
  "Ends digitizing": "Beendet das Digitalisieren",
  Exit: "Ende",
  "Forgets all points": "Verwirft alle Punkte",
  "Insert after": "Dahinter einfügen",
  "Insert before": "Davor einfügen",
  "Load nearest": "Nächste laden",
  Modify: "Ändern",
  "Record the points of a shape with the tool": "Die Punkte einer Form mit dem Werkzeug aufnehmen",
  "Save closed": "Geschlossen sichern",
  "Save open": "Offen sichern",
  "Shapes with the height of each point, without arcs":
    "Formen mit der Höhe jedes Punkts, ohne Bögen",
  "Shapes without heights": "Formen ohne Höhen",
  "Show machine": "Maschine zeigen",
  "Show points": "Punkte zeigen",
  "Straight to the current point": "Gerade zum jetzigen Punkt",
  "Straight to the nearest point, which becomes current":
    "Gerade zum nächsten Punkt, der zum jetzigen wird",
  "Takes the current point out": "Nimmt den jetzigen Punkt heraus",
  "The current point goes where the tool is":
    "Der jetzige Punkt kommt dorthin, wo das Werkzeug ist",
  "The machine's bounds on every sheet": "Die Grenzen der Maschine auf jedem Blatt",
  "The points of the shape nearest to the tool":
    "Die Punkte der Form, die dem Werkzeug am nächsten liegt",
  "The points on every sheet": "Die Punkte auf jedem Blatt",
  "To current": "Zum jetzigen",
  "To end": "Zum Ende",
  "To nearest": "Zum nächsten",
  "To start": "Zum Anfang",
  "Twice as much on every sheet": "Doppelt so viel auf jedem Blatt",
};
