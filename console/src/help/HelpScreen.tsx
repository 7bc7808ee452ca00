import { useHands, useScreen } from "../app/context";
import { Panel } from "../ui/Panel";
import { t } from "../words/words";
import "./help.css";
import { topics } from "./topics";

/** The help: its pages are those of the H commands. */
export function HelpScreen() {
  const { screen } = useHands();
  const asked = useScreen("topic");
  const [name, place] = splitAt(asked);
  const topic = topics.find(({ letters }) => letters === name) ?? topics[0];
  if (!topic) return null;
  const { page: Page } = topic;
  return (
    <div className="help page">
      <h1>{t("Help")}</h1>
      <div className="help-columns">
        <nav className="help-topics" aria-label={t("Pages of the help")}>
          {topics.map(({ letters, title }) => (
            <button
              key={letters}
              type="button"
              className="list-row"
              aria-current={letters === topic.letters ? "page" : undefined}
              onClick={() => screen.explain(letters)}
            >
              {t(title)} <small>{letters.length === 2 ? letters : ""}</small>
            </button>
          ))}
        </nav>
        <Panel title={topic.title} about="Help" className="help-page">
          <Page place={place} />
        </Panel>
      </div>
    </div>
  );
}

/** `book/frames#working` as the page of the help and the place on it. */
function splitAt(topic: string): [string, string] {
  const [name = "", ...rest] = topic.split("/");
  return [name, rest.join("/")];
}
