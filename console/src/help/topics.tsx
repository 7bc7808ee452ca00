/** The pages of the help, each by the letters of the command that opens it. */

import { lazy, type ReactNode, Suspense, useEffect, useState } from "react";
import { useHands, useSnapshot } from "../app/context";
import { useCommands } from "../command/table";
import { getText } from "../link/http";
import { Button } from "../ui/Button";
import { t } from "../words/words";
import { CommandReference } from "./CommandReference";
import { HowDoI } from "./HowDoI";
import { KeyLists } from "./KeyLists";
import { Bulletins, Web } from "./News";

export interface Topic {
  readonly letters: string;
  readonly title: string;
  readonly page: (props: { place: string }) => ReactNode;
}

export const topics: readonly Topic[] = [
  { letters: "how", title: t("How do I …"), page: HowDoI },
  { letters: "book", title: t("The book"), page: BookPage },
  { letters: "glossary", title: t("Glossary"), page: () => <BookPage place="glossary" /> },
  { letters: "HQ", title: t("Quick start"), page: QuickStart },
  { letters: "HU", title: t("User guide"), page: UserGuide },
  { letters: "HC", title: t("Command reference"), page: CommandReference },
  { letters: "HR", title: t("Commands on a page"), page: OnePage },
  { letters: "HE", title: t("For writing part files"), page: ForEditing },
  { letters: "HK", title: t("Keys"), page: KeyLists },
  { letters: "HT", title: t("Troubleshooting"), page: Troubleshooting },
  { letters: "HN", title: t("Ask for help"), page: AskForHelp },
  { letters: "HB", title: t("Bulletins"), page: Bulletins },
  { letters: "HW", title: t("On the web"), page: Web },
  { letters: "HA", title: t("About"), page: About },
];

/** The book and its reader are fetched when they are wanted. */
const Book = lazy(async () => ({ default: (await import("./book/Book")).Book }));

function BookPage({ place }: { place: string }) {
  return (
    <Suspense fallback={<p>{t("Reading…")}</p>}>
      <Book place={place} />
    </Suspense>
  );
}

function QuickStart() {
  return (
    <ol className="help-steps">
      <li>
        <b>{t("Choose a file")}</b>{" "}
        {t("on the operator's screen (Ctrl O). Its tool path appears; ▶ plays it.")}
      </li>
      <li>
        <b>{t("Arm the machine")}</b> {t("in the strip at the top. Until then nothing moves.")}
      </li>
      <li>
        <b>{t("Move the tool")}</b>{" "}
        {t(
          "with the keypad (K) over the corner of the stock and set the zeros of X, Y and Z there.",
        )}
      </li>
      <li>
        <b>{t("Start.")}</b>{" "}
        {t(
          "The program asks what it has to ask; Hold pauses it, STOP ends the motion and asks whether to go on.",
        )}
      </li>
      <li>
        {t("On the simulated machine all of this is done without anything that could break.")}
      </li>
    </ol>
  );
}

function UserGuide() {
  return (
    <div className="help-guide">
      <h3>{t("Operate")}</h3>
      <p>
        {t(
          "Location, tool path, program and messages of the job on one screen. EASY has buttons, FULL menus and the command line. The chip PREVIEW, SIMULATED or CUT says what running a file means, and changes it.",
        )}
      </p>
      <h3>{t("Edit")}</h3>
      <p>
        {t(
          "Part files are checked while they are written. A click beside a line number sets a breakpoint; “Go line by line” asks before every line, and watched variables show what they hold.",
        )}
      </p>
      <h3>{t("Draw")}</h3>
      <p>
        {t(
          "Shapes, their layers and tool paths, and the part program that is made of them: with the mouse, by keys, or by typed places.",
        )}
      </p>
      <h3>{t("Settings")}</h3>
      <p>
        {t(
          "How this browser shows things, devices that may connect, and every setting of the machine, in the unit that is set.",
        )}
      </p>
    </div>
  );
}

/** Every command in a line, to be printed. */
function OnePage() {
  const table = useCommands();
  return (
    <>
      <Button onPress={() => print()}>Print</Button>
      <ul className="help-one-page">
        {table.map(({ letters, name }) => (
          <li key={letters}>
            <code>{letters}</code> {name}
          </li>
        ))}
      </ul>
    </>
  );
}

/** The parameters of each command in the order of part files, a column each. */
function ForEditing() {
  const table = useCommands().filter(({ parameters }) => parameters.length > 0);
  return (
    <section className="help-columns-page" aria-label={t("Parameters in their order")}>
      <table className="list-table">
        <tbody>
          {table.map(({ letters, parameters }) => (
            <tr key={letters}>
              <th scope="row">{letters}</th>
              {parameters.map(({ name, required }, n) => (
                // biome-ignore lint/suspicious/noArrayIndexKey: the place is what tells them apart
                <td key={n}>
                  {name}
                  {required && "*"}
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

const troubles: readonly [string, string][] = [
  [
    t("No link to the machine"),
    t(
      "The program on the machine has ended, or the network is gone. What is shown is old; a job goes on without the page. Start Kerf again, or bring the network back: the page connects by itself.",
    ),
  ],
  [
    t("The machine is disarmed"),
    t(
      "So it is after a start, an alarm, or when the controlling browser disconnected. Look that all is clear, then press Arm.",
    ),
  ],
  [
    t("Somebody else drives"),
    t(
      "One page drives at a time. “Take control” takes it over; STOP works from every page all the same.",
    ),
  ],
  [
    t("The keypad moves by steps only"),
    t("The link takes longer than 150 ms: a hand that lets go would be heard too late."),
  ],
  [
    t("The file was changed since it was previewed"),
    t("What runs is what was looked at. Open the file again."),
  ],
  [
    t("The machine does not know where it is"),
    t(
      "After a power cut its places are not verified (UD). Zero the axes or home them before you cut.",
    ),
  ],
  [
    t("Limits are reached"),
    t(
      "The table limits (VL) or a limit switch ended the motion. Acknowledge the alarm, move the tool away with the keypad.",
    ),
  ],
];

function Troubleshooting() {
  return (
    <dl className="help-troubles">
      {troubles.map(([what, help]) => (
        <div key={what}>
          <dt>{what}</dt>
          <dd>{help}</dd>
        </div>
      ))}
    </dl>
  );
}

/** Fetches the server's record of problems, for whoever helps. */
function useProblems(): string | null {
  const { screen } = useHands();
  const [text, setText] = useState<string | null>(null);
  useEffect(() => {
    getText("/api/problems").then(setText, (error: Error) => screen.tell(error.message));
  }, [screen]);
  return text;
}

/** Report for whoever helps, to be sent by the person himself. */
function AskForHelp() {
  const told = useProblems();
  if (told === null) return <p>{t("Reading…")}</p>;
  const text = `${told}Browser: ${navigator.userAgent}\n`;
  const file = `data:text/plain;charset=utf-8,${encodeURIComponent(text)}`;
  return (
    <>
      <p>
        {t(
          "This is what helps others to help you. Nothing of it is sent by Kerf: save it, and add what you did and what you expected.",
        )}
      </p>
      <pre className="help-request">{text}</pre>
      <a className="button" href={file} download="problem.log">
        {t("Save problem.log")}
      </a>
    </>
  );
}

function About() {
  const kerf = useSnapshot("kerf");
  const machine = useSnapshot("machine");
  return (
    <dl className="help-troubles">
      <div>
        <dt>{t("Version")}</dt>
        <dd>Kerf {kerf}</dd>
      </div>
      <div>
        <dt>{t("Driver")}</dt>
        <dd>{machine?.name}</dd>
      </div>
      <div>
        <dt>{t("Licence")}</dt>
        <dd>{t("MIT or Apache-2.0, as you choose")}</dd>
      </div>
      <div>
        <dt>{t("Safety")}</dt>
        <dd>
          {t("This page is no safety device: a machine needs an emergency stop that is wired.")}
        </dd>
      </div>
    </dl>
  );
}
