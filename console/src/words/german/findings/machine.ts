/** Findings about the machine, its configuration and its journal, in German. */

import { type FindingText, told } from "./finding";

const machine: Readonly<Record<string, FindingText>> = {
  M001: told(
    "Außerhalb der Tischgrenzen",
    "Die Fahrt verlässt die Grenzen von VL. Den Nullpunkt oder die Größe prüfen.",
  ),
  M002: told("Von einem Eingang angehalten", "Ein Endschalter oder Halteingang sprach an."),
  M003: told(
    "Ein Referenzschalter kam nicht",
    "Die Achse ist nicht referenziert. Schalter, Leitung, Länge und Ende der Achse in den Einstellungen prüfen.",
  ),
  M004: told("Die Maschine ist nicht referenziert", "Vor dem Lauf referenzieren."),
  M005: told(
    "Die Maschine ist nicht verbunden",
    "Die Steuerung antwortet nicht; der Lauf ist vorbei. Das Kabel prüfen. Vor der nächsten Datei wird nach dem Ort gefragt.",
  ),
  M006: told(
    "Eine Ebene wird langsamer geschnitten, als sie verlangt",
    "Ihre Geschwindigkeit senken oder die der Maschine heben.",
  ),
  M007: told(
    "Das Werkzeug taucht anders ein als verlangt",
    "Rampe oder Helix ist hier nicht möglich. Nichts wird geschnitten, das die Bahn nicht schneidet.",
  ),
  M008: told(
    "Die Steuerung tut das nicht",
    "Sie hielt selbst an, lehnte ab, oder ihr fehlt, was das Programm verlangt. Nach einem Alarm den Ort prüfen.",
  ),
  M009: told(
    "Die Höhenregelung hat kein Blech",
    "Auf dem Tisch der simulierten Maschine liegt nichts, dem die Höhe folgt.",
  ),
  M010: told(
    "Ein Schnitt verlässt die Höhenkarte",
    "Mehr als 5 mm neben dem Raster kennt niemand die Oberfläche: ein größeres Raster tasten oder die Karte abnehmen.",
  ),
  M011: told("Z folgt einer Höhenkarte", "Zu jedem Z kommt die getastete Höhe der Oberfläche."),
  M012: told(
    "Der Höhenkarte lässt sich nicht folgen",
    "Ihre Datei ist beschädigt, oder es ist ein Auftrag: ihm folgt nur ein Programm. Die Karte abnehmen oder eine andere nehmen.",
  ),
};

const journal: Readonly<Record<string, FindingText>> = {
  J001: told(
    "Der Lauf wird nicht aufgezeichnet",
    "Die Platte ist voll oder der Ordner gesperrt. Der Lauf geht weiter; Platz schaffen.",
  ),
  J002: told(
    "machine.toml ist nicht mehr, wie Kerf sie ließ",
    "Sie gilt, wie sie jetzt ist. Vor dem nächsten Schnitt die Orte bestätigen.",
  ),
};

const configuration: Readonly<Record<string, FindingText>> = {
  K001: told(
    "Das ist keine Konfiguration",
    "Die Datei einer Maschine ist TOML: Zeilen wie `axes = 4`.",
  ),
  K002: told("Diese Einstellung gibt es nicht", "Falsch geschriebene Namen werden abgelehnt."),
  K003: told(
    "Eine Einstellung nimmt den Wert nicht an",
    "Er ist von anderer Art oder außerhalb der Grenzen.",
  ),
  K004: told(
    "Einstellungen widersprechen einander",
    "Zusammen beschreiben sie keine Maschine. Nichts bewegt sich, bis eine geändert ist.",
  ),
};

export const machineFindings: Readonly<Record<string, FindingText>> = {
  ...machine,
  ...journal,
  ...configuration,
};
