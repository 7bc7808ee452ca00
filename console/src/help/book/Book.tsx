import { useEffect, useRef, useState } from "react";
import { useHands } from "../../app/context";
import { Field } from "../../ui/Field";
import { Pick } from "../../ui/Pick";
import { t } from "../../words/words";
import "./book.css";
import { Markdown } from "./Markdown";
import {
  anchorOf,
  type Chapter,
  chaptersOf,
  type Found,
  findIn,
  pageText,
  wholeBook,
} from "./pages";

/** The book inside the page: its chapters, and a search through all of it. */
export function Book({ place }: { place: string }) {
  const { screen } = useHands();
  const [page = "console", anchor = ""] = place.split("#");
  const [wanted, setWanted] = useState("");
  const chapters = useChapters();
  const go = (to: string) => {
    setWanted("");
    screen.explain(`book/${to}`);
  };
  return (
    <div className="book">
      <div className="book-head">
        <Field
          label="Search the book"
          value={wanted}
          onChange={setWanted}
          placeholder="tool change"
        />
        <Pick
          label="Chapter"
          labelled
          options={chapters.map(({ name, title }) => ({ value: name, words: title }))}
          value={page}
          onChange={go}
        />
      </div>
      {wanted.trim() === "" ? (
        <Page page={page} anchor={anchor} onGo={go} />
      ) : (
        <Results wanted={wanted} chapters={chapters} onGo={go} />
      )}
    </div>
  );
}

function useChapters(): readonly Chapter[] {
  const [chapters, setChapters] = useState<readonly Chapter[]>([]);
  useEffect(() => void pageText("SUMMARY").then((text) => setChapters(chaptersOf(text))), []);
  return chapters;
}

interface PageProps {
  page: string;
  anchor: string;
  onGo: (place: string) => void;
}

function Page({ page, anchor, onGo }: PageProps) {
  const { screen } = useHands();
  const [text, setText] = useState<string | null>(null);
  const box = useRef<HTMLDivElement>(null);
  useEffect(() => {
    setText(null);
    let isWanted = true;
    pageText(page).then(
      (found) => isWanted && setText(found),
      (error: Error) => screen.tell(error.message),
    );
    return () => {
      isWanted = false;
    };
  }, [page, screen]);
  useEffect(() => {
    if (text === null) return;
    const target = anchor === "" ? null : document.getElementById(anchor);
    (target ?? box.current)?.scrollIntoView({ block: target ? "start" : "nearest" });
  }, [text, anchor]);
  return <div ref={box}>{text !== null && <Markdown text={text} page={page} onGo={onGo} />}</div>;
}

interface ResultsProps {
  wanted: string;
  chapters: readonly Chapter[];
  onGo: (place: string) => void;
}

function Results({ wanted, chapters, onGo }: ResultsProps) {
  const [found, setFound] = useState<readonly Found[] | null>(null);
  useEffect(() => {
    let isWanted = true;
    void wholeBook().then((parts) => isWanted && setFound(findIn(parts, wanted)));
    return () => {
      isWanted = false;
    };
  }, [wanted]);
  if (found === null) return <p>{t("Reading…")}</p>;
  if (found.length === 0)
    return <p role="status">{t("The book says nothing of “{0}”.", wanted)}</p>;
  return (
    <ol className="book-found">
      {found.map((part) => (
        <li key={`${part.page}${part.heading}`}>
          <button
            type="button"
            className="text-link"
            onClick={() => onGo(`${part.page}#${anchorOf(part.heading)}`)}
          >
            {part.heading}
          </button>{" "}
          <small>{chapters.find(({ name }) => name === part.page)?.title}</small>
          <p>{part.around}</p>
        </li>
      ))}
    </ol>
  );
}
