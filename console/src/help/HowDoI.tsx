import { useState } from "react";
import { ask } from "../actions/ask";
import { isThere, writing } from "../actions/replace";
import { useHands, worldOf } from "../app/context";
import { Refused, readFile, writeFile } from "../link/http";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { t } from "../words/words";
import { cards } from "./cards";
import { pictureOf, type Sample, samples, sampleText } from "./samples";

/** Questions of newcomers with short answers, and jobs to try. */
export function HowDoI() {
  const { screen } = useHands();
  const [wanted, setWanted] = useState("");
  const fits = (text: string) => text.toLowerCase().includes(wanted.trim().toLowerCase());
  const shown = cards.filter(({ question, steps }) => fits(`${question} ${steps.join(" ")}`));
  return (
    <div className="how">
      <Field label="Search the questions" value={wanted} onChange={setWanted} placeholder="zero" />
      <ul className="how-cards">
        {shown.map(({ question, steps, place }) => (
          <li key={question}>
            <h3>{question}</h3>
            <ol className="help-steps">
              {steps.map((step) => (
                <li key={step}>{step}</li>
              ))}
            </ol>
            <Button
              size="small"
              look="quiet"
              aria-label={t("More in the book: {0}", question)}
              onPress={() => screen.explain(`book/${place}`)}
            >
              More in the book
            </Button>
          </li>
        ))}
      </ul>
      <h3>{t("Jobs to try")}</h3>
      <ul className="how-samples">
        {samples.map((sample) => (
          <SampleCard key={sample.title} sample={sample} />
        ))}
      </ul>
    </div>
  );
}

function SampleCard({ sample }: { sample: Sample }) {
  const open = useOpenSample();
  return (
    <li>
      <button type="button" onClick={() => void open(sample)}>
        <img src={pictureOf(sample)} alt="" loading="lazy" width="180" height="120" />
        <b>{sample.title}</b>
        <span>{sample.about}</span>
      </button>
    </li>
  );
}

/** Writes the files of a sample into the part folder and opens it; a drawing opens in Draw. */
function useOpenSample() {
  const hands = useHands();
  return async ({ files }: Sample) => {
    const world = worldOf(hands);
    for (const file of files) if (!(await isAsItComes(file)) && !(await write(file))) return;
    const [first = ""] = files;
    const isDrawing = first.endsWith(".rsg");
    const done = isDrawing
      ? await ask(world, { do: "draw", op: { op: "open", name: first } })
      : await ask(world, { do: "open", name: first });
    if (done) hands.screen.go(isDrawing ? "/draw" : "/");
  };
  async function write(file: string): Promise<boolean> {
    const text = await sampleText(file);
    return writing(worldOf(hands), file, async (replaces) => {
      try {
        await writeFile(file, text, replaces);
        return null;
      } catch (error) {
        if (error instanceof Refused) return error.problem;
        throw error;
      }
    });
  }
}

/** Tells whether the part folder has the file as it comes with the console. */
const isAsItComes = async (file: string): Promise<boolean> =>
  (await isThere(file)) && (await readFile(file)).text === (await sampleText(file));
