import { actions } from "../actions/registry";
import { KeypadHelp } from "../keypad/KeypadHelp";
import { keyHelp } from "../timing/keys";

/** The keys of the console and of the keypad. */
export function KeyLists() {
  return (
    <>
      <h3>Everywhere</h3>
      <dl className="help-list">
        {actions
          .filter(({ keys }) => keys && keys.length > 0)
          .map(({ id, keys, title }) => (
            <div key={id}>
              <dt>
                {keys?.map((key) => (
                  <kbd key={key}>{key}</kbd>
                ))}
              </dt>
              <dd>{title}</dd>
            </div>
          ))}
      </dl>
      <h3>At the keypad</h3>
      <KeypadHelp look="help-list" />
      <h3>On the timing chart</h3>
      <dl className="help-list">
        {keyHelp.map(({ keys, means }) => (
          <div key={keys}>
            <dt>{keys}</dt>
            <dd>{means}</dd>
          </div>
        ))}
      </dl>
    </>
  );
}
