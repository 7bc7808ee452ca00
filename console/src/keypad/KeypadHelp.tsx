import { keyHelp } from "./keys";

/** The keys of the keypad; `look` is the class of the list. */
export function KeypadHelp({ look = "keypad-help" }: { look?: string }) {
  return (
    <dl className={look}>
      {keyHelp.map(({ keys, means }) => (
        <div key={keys}>
          <dt>{keys}</dt>
          <dd>{means}</dd>
        </div>
      ))}
    </dl>
  );
}
