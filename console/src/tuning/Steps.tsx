import { useState } from "react";
import { drive } from "../actions/ask";
import { unlessReady } from "../actions/machine";
import { useHands, useShown, useSnapshot, worldOf } from "../app/context";
import { usedAxes } from "../app/units";
import { useSettings } from "../settings/useSettings";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Pick } from "../ui/Pick";
import { goal } from "../units/quantity";
import { t } from "../words/words";
import { numbersOf, truerSteps, withNumber } from "./tuning";
import { useLengths } from "./useLengths";

/** The setting of the machine's file that holds them, steps a mm. */
const key = "steps.per_unit";

/** Digits that are shown. */
const digits = 7;

const shortly = (steps: number): string => String(Number(steps.toPrecision(digits)));

/** Steps of an axis: it moves a way, the way is measured, and the steps that make it true are written. */
export function Steps() {
  const hands = useHands();
  const { link, screen } = hands;
  const refused = useShown((shown) => unlessReady({ shown, link, screen }));
  const units = useSnapshot("units");
  const entry = useSettings()
    .flatMap(({ settings }) => settings)
    .find((setting) => setting.key === key);
  const { unit, text, type, length } = useLengths();
  const [letter, setLetter] = useState("X");
  const [asks, setAsks] = useState(false);
  const axes = (units ? usedAxes(units) : []).filter(({ at }) => at < 3);
  const at = axes.find(({ axis }) => axis.letter === letter)?.at ?? 0;
  const [asked, measured] = [length("asked"), length("measured")];
  const kept = useSnapshot("controllerSteps")?.[at];
  const steps = kept ?? (entry && numbersOf(entry.value)[at]);
  if (!entry || steps === undefined) return null;
  const truer = asked && measured ? truerSteps(steps, asked, measured) : undefined;
  const move = () => {
    const place = goal([0, 1, 2, 3, 4, 5].map((n) => (n === at ? (asked ?? null) : null)));
    const way = { to: "place", place, relative: true, flat: false } as const;
    void drive(worldOf(hands), { do: "go", way });
  };
  const write = () => {
    setAsks(false);
    if (truer === undefined) return;
    void drive(
      worldOf(hands),
      kept === undefined
        ? { do: "set", key, value: withNumber(entry.value, at, truer) }
        : { do: "controllerSteps", axis: letter, steps: truer },
    );
  };
  return (
    <section className="tuning-part" aria-label={t("Steps per millimetre")}>
      <h3>{t("Steps per millimetre")}</h3>
      <Pick
        label="Axis"
        labelled
        options={axes.map(({ axis }) => ({ value: axis.letter, words: axis.letter }))}
        value={letter}
        onChange={setLetter}
      />
      <Field
        label="Way to move"
        unit={unit.linear}
        value={text("asked")}
        onChange={type("asked")}
      />
      <Button refused={asked ? refused : t("Give a way above 0.")} onPress={move}>
        {t("Move {0} so far", letter)}
      </Button>
      <Field
        label="Way that was measured"
        unit={unit.linear}
        value={text("measured")}
        onChange={type("measured")}
      />
      <p role="status">
        {kept === undefined
          ? t("{0} has {1} steps a millimetre.", letter, shortly(steps))
          : t("The controller keeps {1} steps a millimetre of {0}.", letter, shortly(steps))}
      </p>
      {truer !== undefined && (
        <>
          <p>{t("{0} steps make the way true.", shortly(truer))}</p>
          {kept !== undefined && (
            <p className="tuning-note">
              {t(
                "They are written into the controller and read back. It counts anew where {0} stands: home it then, or set its location.",
                letter,
              )}
            </p>
          )}
          {asks ? (
            <div className="tuning-asks" role="alertdialog" aria-label={t("Write the steps?")}>
              <p>{t("Write {0} in the place of {1}?", shortly(truer), shortly(steps))}</p>
              <Button look="primary" onPress={write}>
                Write
              </Button>
              <Button onPress={() => setAsks(false)}>Cancel</Button>
            </div>
          ) : (
            <Button
              refused={kept === undefined ? undefined : refused}
              onPress={() => setAsks(true)}
            >
              Write the steps…
            </Button>
          )}
        </>
      )}
    </section>
  );
}
