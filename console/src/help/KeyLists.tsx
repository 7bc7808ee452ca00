import { keysOf } from "../actions/bindings";
import { actions } from "../actions/registry";
import { keyHelp as keypadKeys } from "../keypad/keys";
import { keyHelp as timingKeys } from "../timing/keys";
import { KeyHelp } from "../ui/KeyHelp";
import { t } from "../words/words";

/** The keys of the console and of the keypad. */
export function KeyLists() {
  return (
    <>
      <h3>{t("Everywhere")}</h3>
      <dl className="help-list">
        {actions
          .filter((action) => keysOf(action).length > 0)
          .map((action) => (
            <div key={action.id}>
              <dt>
                {keysOf(action).map((key) => (
                  <kbd key={key}>{key}</kbd>
                ))}
              </dt>
              <dd>{action.title}</dd>
            </div>
          ))}
      </dl>
      <h3>{t("At the keypad")}</h3>
      <KeyHelp keys={keypadKeys} look="help-list" />
      <h3>{t("On the timing chart")}</h3>
      <KeyHelp keys={timingKeys} look="help-list" />
    </>
  );
}
