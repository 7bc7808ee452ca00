import { useEffect } from "react";
import { ask } from "../actions/ask";
import { t } from "../words/words";
import "../debugger/step-bar.css";
import { useHands, worldOf } from "../app/context";
import { GoesOn } from "../operator/GoesOn";
import { Button } from "../ui/Button";
import type { Asked } from "../wire/messages";

/** A program opened a file in the editor (FE): it waits until the person is done with it. */
export function EditorBar({ asked }: { asked: Asked }) {
  const hands = useHands();
  const { screen } = hands;
  const file = asked.edits ?? "";
  useEffect(() => screen.edit(file), [screen, file]);
  const done = asked.buttons[asked.default] ?? "OK";
  return (
    <section
      className="step card"
      aria-label={t("The program waits")}
      data-react-aria-top-layer="true"
    >
      <p className="step-line one-line">
        <span>{t("The program waits while you edit")}</span>
        <code>{file || t("a new file")}</code>
      </p>
      <GoesOn />
      <Button onPress={() => screen.edit(file)}>To the editor</Button>
      <Button
        look="primary"
        onPress={() =>
          void ask(worldOf(hands), { do: "answer", question: asked.number, answer: done })
        }
      >
        Done, go on
      </Button>
    </section>
  );
}
