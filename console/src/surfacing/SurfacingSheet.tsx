import { start } from "../actions/job";
import { evaluate } from "../app/expression";
import { findCommand, useCommands } from "../command/table";
import { EntryFields } from "../probe/EntryFields";
import { type Maker, useMaker } from "../probe/useMaker";
import "../probe/probe.css";
import { ActionButton } from "../ui/ActionButton";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import type { CommandEntry } from "../wire/messages";
import { t } from "../words/words";
import { rings, zigzag } from "./rows";
import "./surfacing.css";

/** The part file that TU makes. */
const program = "surface.sbp";

/** Planes a board or the table: a program is made, drawn, and started. */
export function SurfacingSheet({ onClose }: { onClose: () => void }) {
  const entry = findCommand(useCommands(true), "TU");
  return entry ? <SurfacingForm entry={entry} onClose={onClose} /> : null;
}

function SurfacingForm({ entry, onClose }: { entry: CommandEntry; onClose: () => void }) {
  const maker = useMaker(entry, program);
  const places = entry.parameters.flatMap(({ name }, n) => (name === "Part file" ? [] : [n]));
  return (
    <Sheet
      title={t("Surfacing")}
      shape="side"
      onClose={onClose}
      foot={
        <>
          {maker.isMade && (
            <ActionButton action={start} look="go">
              {t("Start surfacing")}
            </ActionButton>
          )}
          <Button look="primary" refused={maker.refused} onPress={maker.make}>
            Make the program
          </Button>
        </>
      }
    >
      <p className="probe-words">
        {t("Set Z zero on the highest place of the surface, X and Y zero at its corner.")}
      </p>
      <SurfacePicture entry={entry} maker={maker} />
      <EntryFields entry={entry} maker={maker} places={places} />
    </Sheet>
  );
}

/** The area with the way of the tool over it. */
function SurfacePicture({ entry, maker }: { entry: CommandEntry; maker: Maker }) {
  const text = (name: string) =>
    maker.entries[entry.parameters.findIndex((parameter) => parameter.name === name)] ?? "";
  const number = (name: string) => evaluate(text(name)) ?? 0;
  const surface = {
    width: number("Area, X"),
    height: number("Area, Y"),
    bit: number("Bit diameter"),
    overlap: number("Overlap"),
  };
  const { width, height, bit, overlap } = surface;
  if (Math.min(width, height, bit) <= 0 || overlap >= 100) return null;
  const pattern = text("Pattern");
  const way = pattern.startsWith("rows") ? zigzag(surface, pattern.endsWith("X")) : rings(surface);
  const rim = bit / 2;
  return (
    <svg
      className="surfacing-picture"
      viewBox={`${-rim} ${-rim} ${width + bit} ${height + bit}`}
      role="img"
      aria-label={t("The way of the tool over the area")}
    >
      <rect width={width} height={height} />
      <path d={way} style={{ strokeWidth: bit * 0.08 }} />
      <circle cx={0} cy={height} r={rim} />
    </svg>
  );
}
