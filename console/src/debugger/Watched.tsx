import { useState } from "react";
import { ask } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Panel } from "../ui/Panel";
import { t } from "../words/words";
import "./watched.css";

/** Names as they are asked for: with their sign, each once. */
export function namesIn(text: string): string[] {
  const names = text.split(/[\s,]+/).filter((name) => name !== "");
  const signed = names.map((name) => (/^[&$#]/.test(name) ? name : `&${name}`));
  return [...new Set(signed)];
}

/** Variables that are watched while a program runs; every page sees the same. */
export function Watched() {
  const hands = useHands();
  const watched = useSnapshot("watched") ?? [];
  const [asked, setAsked] = useState<readonly string[]>(() => watched.map(({ name }) => name));
  const [text, setText] = useState("");
  const watch = (names: readonly string[]) => {
    setAsked(names);
    void ask(worldOf(hands), { do: "watch", names: [...names] });
  };
  const shownValue = (name: string) =>
    watched.find((one) => one.name === name)?.value ?? t("not set");
  return (
    <Panel title="Watched variables" className="watched">
      <form
        onSubmit={(event) => {
          event.preventDefault();
          watch([...new Set([...asked, ...namesIn(text)])]);
          setText("");
        }}
      >
        <Field label="Variable" value={text} onChange={setText} placeholder="&depth" />
        <Button
          type="submit"
          refused={
            namesIn(text).length === 0
              ? t("Enter the name of a variable first, as &depth.")
              : undefined
          }
        >
          Watch
        </Button>
      </form>
      <dl>
        {asked.map((name) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>
              <output>{shownValue(name)}</output>
              <Button
                size="small"
                look="quiet"
                aria-label={t("Do not watch {0}", name)}
                onPress={() => watch(asked.filter((one) => one !== name))}
              >
                ✕
              </Button>
            </dd>
          </div>
        ))}
      </dl>
      {asked.length === 0 && <p className="tail-empty">{t("Nothing is watched.")}</p>}
    </Panel>
  );
}
