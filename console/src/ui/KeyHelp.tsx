/** Lists keys with their meanings; `look` is the class of the list. */
export function KeyHelp({ keys, look }: { keys: readonly KeyMeaning[]; look: string }) {
  return (
    <dl className={look}>
      {keys.map(({ keys, means }) => (
        <div key={keys}>
          <dt>{keys}</dt>
          <dd>{means}</dd>
        </div>
      ))}
    </dl>
  );
}

/** Keys, and what they do. */
interface KeyMeaning {
  readonly keys: string;
  readonly means: string;
}
