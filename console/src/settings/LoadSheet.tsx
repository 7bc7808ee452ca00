import { useHands } from "../app/context";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import { t } from "../words/words";
import { fullName } from "./names";
import { useSet } from "./SettingValue";
import { type Loaded, readFile, type Wanted } from "./settingsFile";
import { useSettings } from "./useSettings";

/** Asks before the settings of a file of the part folder are loaded: of one that was dropped onto the page. */
export function LoadedFile({ text, onClose }: { text: string; onClose: () => void }) {
  const areas = useSettings();
  if (areas.length === 0) return null;
  return <LoadSheet loaded={readFile(text, areas)} onClose={onClose} />;
}

/** Asks before settings are loaded: each with its value before and after. */
export function LoadSheet({ loaded, onClose }: { loaded: Loaded; onClose: () => void }) {
  const load = useLoad();
  const { wanted, unknown } = loaded;
  const foot = (
    <>
      <Button onPress={onClose}>Cancel</Button>
      <Button
        look="primary"
        refused={wanted.length === 0 ? t("Nothing in this file is another value.") : undefined}
        onPress={() => {
          onClose();
          void load(wanted);
        }}
      >
        {wanted.length === 1 ? t("Change 1 setting") : t("Change {0} settings", wanted.length)}
      </Button>
    </>
  );
  return (
    <Sheet title="Load settings?" onClose={onClose} foot={foot}>
      <ul className="settings-changes">
        {wanted.map(({ key, from, to }) => (
          <li key={key}>
            <b>{fullName(key)}</b> <ChangeText from={from} to={to} />
          </li>
        ))}
        {unknown.map((line) => (
          <li key={line} className="settings-unknown">
            {t("This machine has no such setting, it is left out: {0}", line)}
          </li>
        ))}
      </ul>
    </Sheet>
  );
}

export const ChangeText = ({ from, to }: { from: string; to: string }) => (
  <span>
    {from || t("nothing")} → {to || t("nothing")}
  </span>
);

/** Changes settings one by one; what contradicts another first is tried again when that is changed. */
function useLoad() {
  const set = useSet();
  const { screen } = useHands();
  return async (wanted: readonly Wanted[]) => {
    let left = wanted;
    while (left.length > 0) {
      const refused: Wanted[] = [];
      for (const one of left) if (!(await set(one.key, one.to))) refused.push(one);
      if (refused.length === left.length) break;
      left = refused;
    }
    const done = wanted.length - left.length;
    const names = left.map(({ key }) => fullName(key)).join("; ");
    screen.tell(
      left.length === 0 ? t("{0} settings are loaded.", done) : t("Not loaded: {0}.", names),
    );
  };
}
