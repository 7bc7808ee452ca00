import { durationText, lengthText, numberText } from "../app/units";
import { difference, isMetric, type Mm } from "../units/quantity";
import type { PreviewInfo, Units } from "../wire/messages";
import { t } from "../words/words";

/** How far the cuts reach, in working locations, and how long all of it takes. */
export function PathFacts({ info, units }: { info: PreviewInfo; units: Units }) {
  const reach = (n: 0 | 1 | 2): string => {
    if (!info.bounds) return "–";
    const from = (at: Mm) =>
      numberText(difference(at, info.zero[n]), units, isMetric(units) ? 1 : 3);
    return `${from(info.bounds[0][n])} … ${from(info.bounds[1][n])}`;
  };
  return (
    <dl className="path-facts" aria-label={t("Extents and time")}>
      {(["X", "Y", "Z"] as const).map((letter, n) => (
        <div key={letter}>
          <dt>{letter}</dt>
          <dd>{reach(n as 0 | 1 | 2)}</dd>
        </div>
      ))}
      <div>
        <dt>{t("Cut")}</dt>
        <dd>{lengthText(info.cut, units, 1)}</dd>
      </div>
      <div>
        <dt>{t("Time")}</dt>
        <dd>{durationText(info.seconds)}</dd>
      </div>
    </dl>
  );
}
