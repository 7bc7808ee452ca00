import { ToggleButton } from "react-aria-components";
import { openTiming } from "../actions/go";
import { clearPreview } from "../actions/machine";
import { useHands, useScreen, useShown } from "../app/context";
import { ActionButton } from "../ui/ActionButton";
import { Button } from "../ui/Button";
import { Choice } from "../ui/Choice";
import { t } from "../words/words";
import type { Aspect } from "./camera";

const aspectWords: readonly { value: Aspect; words: string }[] = [
  { value: "top", words: "Top" },
  { value: "front", words: "Front" },
  { value: "side", words: "Side" },
  { value: "solid", words: "3D" },
];

interface Switch {
  readonly on: boolean;
  readonly set: (on: boolean) => void;
}

interface PathToolsProps {
  aspect: Aspect;
  look: (aspect: Aspect) => void;
  stock: Switch;
  /** Shows the path on the cylinder of a rotary axis; missing without such an axis. */
  rotary: Switch | undefined;
}

/** The buttons that choose the view of the tool path and what it shows. */
export function PathTools({ aspect, look, stock, rotary }: PathToolsProps) {
  const { screen } = useHands();
  const large = useScreen("large");
  const previews = useShown((shown) => shown.snapshot?.machine.mode === "preview");
  return (
    <div className="path-tools">
      <Choice label="View" options={aspectWords} value={aspect} onChange={look} />
      {rotary && <Toggle words={t("Rotary")} {...rotary} />}
      <Toggle words={t("Stock")} {...stock} />
      <Button size="small" onPress={() => look(aspect)}>
        Fit
      </Button>
      <ActionButton action={openTiming} size="small">
        Timing
      </ActionButton>
      {previews && (
        <ActionButton action={clearPreview} size="small">
          Clear
        </ActionButton>
      )}
      <Toggle words={t("Large")} on={large} set={screen.enlarge} />
    </div>
  );
}

const Toggle = ({ words, on, set }: Switch & { words: string }) => (
  <ToggleButton className="button button-small" isSelected={on} onChange={set}>
    {words}
  </ToggleButton>
);
