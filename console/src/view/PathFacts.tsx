import { forgetPace } from "../actions/machine";
import { useShown } from "../app/context";
import { durationText, lengthText, numberText } from "../app/units";
import { ActionButton } from "../ui/ActionButton";
import { difference, isMetric, type Mm } from "../units/quantity";
import type { PreviewInfo, Units } from "../wire/messages";
import { t } from "../words/words";

/** Shows the extents of the cuts, in working locations, and the time of the whole. */
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
      <Learned />
    </dl>
  );
}

/** By which runs the time is told otherwise than the planner of the controller says; they can be forgotten. */
function Learned() {
  const pace = useShown((shown) => shown.snapshot?.machine.pace);
  if (!pace) return null;
  const factor = pace.factor.toFixed(2);
  return (
    <div className="path-learned">
      <dt>{t("Learned")}</dt>
      <dd>
        {pace.runs === 1
          ? t("1 run here: motion takes {0} times as long as estimated", factor)
          : t("{1} runs here: motion takes {0} times as long as estimated", factor, pace.runs)}
        <ActionButton action={forgetPace} size="small">
          Forget
        </ActionButton>
      </dd>
    </div>
  );
}
