import { useState } from "react";
import { ask } from "../actions/ask";
import { isThere } from "../actions/replace";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { readFile, writeFile } from "../link/http";
import { answersOf } from "../operator/folder";
import { Button } from "../ui/Button";
import { Choice } from "../ui/Choice";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import type { Opened, SampleAnswer } from "../wire/messages";
import { buttonWords } from "../words/asked";
import { t } from "../words/words";
import { answersText } from "./samples";

/** The questions of the open program, with the answers that its preview gets. They are kept beside the file. */
export function SamplesSheet({ onClose }: { onClose: () => void }) {
  const opened = useSnapshot("opened");
  if (!opened || opened.samples.length === 0) {
    return (
      <Sheet title="Sample answers" onClose={onClose}>
        <p className="tail-empty">{t("The open file asks nothing.")}</p>
      </Sheet>
    );
  }
  return <Samples key={opened.hash} opened={opened} onClose={onClose} />;
}

function Samples({ opened, onClose }: { opened: Opened; onClose: () => void }) {
  const hands = useHands();
  const { name, samples, parameters } = opened;
  const [answers, setAnswers] = useState(() => samples.map(({ answer }) => answer));
  const put = (at: number, answer: string) =>
    setAnswers((now) => now.map((one, n) => (n === at ? answer : one)));
  const draw = async () => {
    try {
      await keepAnswers(name, samples, answers);
      if (await ask(worldOf(hands), { do: "parameters", parameters })) onClose();
    } catch (error) {
      hands.screen.tell((error as Error).message);
    }
  };
  return (
    <Sheet
      title={t("Sample answers of {0}", name)}
      about="Sample answers"
      onClose={onClose}
      foot={
        <Button look="primary" size="large" onPress={() => void draw()}>
          Draw with these
        </Button>
      }
    >
      <p className="tool-words">
        {t(
          "The preview and its times are made with these answers. When the file runs it asks whoever drives. A value that is left empty counts as 0.",
        )}
      </p>
      <form
        className="samples"
        onSubmit={(event) => {
          event.preventDefault();
          void draw();
        }}
      >
        {samples.map((sample, n) => (
          <SampleField
            // biome-ignore lint/suspicious/noArrayIndexKey: a line may ask several times
            key={n}
            sample={sample}
            answer={answers[n] ?? ""}
            first={n === 0}
            onChange={(answer) => put(n, answer)}
          />
        ))}
        <button type="submit" hidden />
      </form>
    </Sheet>
  );
}

interface SampleFieldProps {
  sample: SampleAnswer;
  answer: string;
  first: boolean;
  onChange: (answer: string) => void;
}

function SampleField({ sample, answer, first, onChange }: SampleFieldProps) {
  const label = t("{0} (line {1})", sample.text || t("A value"), sample.line);
  if (sample.buttons.length === 0) {
    return <Field label={label} value={answer} onChange={onChange} placeholder="0" first={first} />;
  }
  const options = sample.buttons.map((word) => ({ value: word, words: buttonWords(word) }));
  return (
    <div className="samples-choice">
      <span>{label}</span>
      <Choice label={label} options={options} value={answer} onChange={onChange} />
    </div>
  );
}

/** Writes the file of answers beside a program; what else stands in it stays. */
async function keepAnswers(
  name: string,
  samples: readonly SampleAnswer[],
  answers: readonly string[],
): Promise<void> {
  const file = answersOf(name);
  const before = (await isThere(file)) ? await readFile(file) : null;
  await writeFile(file, answersText(before?.text ?? "", samples, answers), before?.hash ?? null);
}
