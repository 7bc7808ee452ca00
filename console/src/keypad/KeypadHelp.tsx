import { keyHelp } from "./keys";

/** The keys of the keypad. */
export function KeypadHelp() {
  return (
    <dl className="keypad-help">
      {keyHelp.map(({ keys, means }) => (
        <div key={keys}>
          <dt>{keys}</dt>
          <dd>{means}</dd>
        </div>
      ))}
    </dl>
  );
}
