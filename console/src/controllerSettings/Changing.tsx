import { useState } from "react";
import { drive } from "../actions/ask";
import { unlessReady } from "../actions/machine";
import { useHands, useShown, worldOf } from "../app/context";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import type { ControllerSetting } from "../wire/messages";
import { t } from "../words/words";
import { named } from "./said";

interface ChangingProps {
  setting: ControllerSetting;
  onClose: () => void;
}

/** Another value for a setting. */
export function Changing({ setting, onClose }: ChangingProps) {
  const hands = useHands();
  const { link, screen } = hands;
  const refused = useShown((shown) => unlessReady({ shown, link, screen }));
  const [value, setValue] = useState(setting.value);
  const write = async () => {
    const line = `$${setting.number}=${value.trim()}`;
    if (await drive(worldOf(hands), { do: "command", line })) onClose();
  };
  return (
    <section
      className="controller-settings-change"
      aria-label={t("Change {0}", `$${setting.number}`)}
    >
      <Field
        label={`$${setting.number} ${named(setting)}`}
        unit={setting.unit}
        hint={boundsOf(setting)}
        value={value}
        onChange={setValue}
        autoFocus
      />
      <div className="controller-settings-kept">
        <Button
          look="primary"
          refused={value.trim() === "" ? t("Give a value.") : refused}
          onPress={() => void write()}
        >
          Write
        </Button>
        <Button onPress={onClose}>Cancel</Button>
      </div>
    </section>
  );
}

/** The values that a setting may have, in words. */
function boundsOf({ least, most }: ControllerSetting): string | undefined {
  if (least === null && most === null) return undefined;
  if (most === null) return t("{0} or more", least ?? 0);
  if (least === null) return t("{0} or less", most);
  return t("{0} to {1}", least, most);
}
