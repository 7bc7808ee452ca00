import { lengthText } from "../app/units";
import { Field } from "../ui/Field";
import { isMetric, mm } from "../units/quantity";
import { t } from "../words/words";
import { squareness } from "./tuning";
import { useLengths } from "./useLengths";

const fields = [
  ["x", t("Rectangle, X")],
  ["y", t("Rectangle, Y")],
  ["d1", t("Diagonal from the front left")],
  ["d2", t("Diagonal from the front right")],
  ["apart", t("Between the two motors")],
] as const;

/** Squareness of a gantry with two motors: from the diagonals of a rectangle that it marked. */
export function Square() {
  const { unit, text, type, length } = useLengths();
  const [x, y, d1, d2, apart] = fields.map(([name]) => length(name));
  const found = x && y && d1 && d2 && apart ? squareness(x, y, d1, d2, apart) : undefined;
  return (
    <section className="tuning-part" aria-label={t("Squareness")}>
      <h3>{t("Squareness")}</h3>
      <p>{t("Mark the corners of a rectangle with the machine, and measure both diagonals.")}</p>
      <svg className="tuning-picture" viewBox="0 0 120 70" aria-hidden="true">
        <path d="M14 60H96L106 10H24Z" />
        <path className="tuning-diagonal" d="M14 60L106 10M96 60L24 10" />
      </svg>
      <div className="tuning-fields">
        {fields.map(([name, label]) => (
          <Field
            key={name}
            label={label}
            unit={unit.linear}
            value={text(name)}
            onChange={type(name)}
          />
        ))}
      </div>
      {found && (
        <p role="status">
          {t("Y leans by {0}° to the right.", found.degrees.toFixed(4))}{" "}
          {found.front >= 0
            ? t("Bring the right side to the front by {0}.", distance(found.front))
            : t("Bring the right side to the back by {0}.", distance(-found.front))}{" "}
          {t("Move the switch of its motor so far, or its pull-off.")}
        </p>
      )}
    </section>
  );

  function distance(length: number): string {
    return lengthText(mm(length), unit, isMetric(unit) ? 2 : 4);
  }
}
