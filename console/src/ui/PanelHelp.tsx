import { useContext } from "react";
import { HandsContext } from "../app/context";
import { places } from "../help/places";
import { t } from "../words/words";

/** Places by their titles as panels have them, in the language of the page too. */
const placeOf: Readonly<Record<string, string>> = {
  ...Object.fromEntries(Object.entries(places).map(([title, place]) => [t(title), place])),
  ...places,
};

/** Opens the place of the book that tells of a panel; nothing where the book does not. */
export function PanelHelp({ title, heading }: { title: string; heading: string }) {
  const screen = useContext(HandsContext)?.screen;
  const place = placeOf[title];
  if (!screen || place === undefined) return null;
  return (
    <button
      type="button"
      className="panel-help"
      aria-label={t("What is this?")}
      aria-describedby={heading}
      title={t("Opens the book here")}
      onClick={() => screen.explain(`book/${place}`)}
    >
      ?
    </button>
  );
}
