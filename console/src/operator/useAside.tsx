import { type ReactNode, useState } from "react";
import { useSnapshot } from "../app/context";
import { KeypadSheet } from "../keypad/KeypadSheet";
import { InputsSheet } from "../tools/InputsSheet";
import { NudgeSheet } from "../tools/NudgeSheet";
import { Button } from "../ui/Button";
import { t } from "../words/words";

type Aside = "keypad" | "nudge" | "inputs";

const words: Record<Aside, string> = {
  keypad: t("Move the tool…"),
  nudge: t("Nudge…"),
  inputs: t("Inputs…"),
};

interface Asides {
  /** Sheet of the work that was begun; it lies in the place of the question until it is closed. */
  readonly sheet: ReactNode | null;
  readonly buttons: ReactNode;
}

/** Offers work by hand while a job stands and asks, before it goes on at the same place. */
export function useAside(offered: readonly Aside[]): Asides {
  const [begun, setBegun] = useState<Aside | null>(null);
  // A switch that stopped the machine has to be let go, on the page where it is moved there.
  const inputs = useSnapshot("machine")?.offers.inputs;
  const possible = offered.filter((aside) => aside !== "inputs" || inputs);
  return {
    sheet: begun && <AsideSheet aside={begun} onClose={() => setBegun(null)} />,
    buttons: possible.map((aside) => (
      <Button key={aside} onPress={() => setBegun(aside)}>
        {words[aside]}
      </Button>
    )),
  };
}

function AsideSheet({ aside, onClose }: { aside: Aside; onClose: () => void }) {
  switch (aside) {
    case "keypad":
      return (
        <KeypadSheet
          words={t("The job stands. Where it goes on, the tool goes back by itself.")}
          onClose={onClose}
        />
      );
    case "nudge":
      return <NudgeSheet onClose={onClose} />;
    case "inputs":
      return <InputsSheet onClose={onClose} />;
  }
}
