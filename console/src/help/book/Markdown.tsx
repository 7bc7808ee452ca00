import { marked, type Token, type Tokens } from "marked";
import { Fragment, type ReactNode } from "react";
import { t } from "../../words/words";
import { anchorOf, figureAddress } from "./pages";

interface MarkdownProps {
  text: string;
  /** The page that the text is of: its own anchors lead there. */
  page: string;
  /** Goes to another place of the book. */
  onGo: (place: string) => void;
}

/** A page of the book. HTML in it is shown as text. */
export function Markdown({ text, page, onGo }: MarkdownProps) {
  const draw = drawing((href) =>
    onGo(href.startsWith("#") ? page + href : href.replace(".md", "")),
  );
  return <div className="book-text">{draw(marked.lexer(text))}</div>;
}

type Draw = (tokens: readonly Token[] | undefined) => ReactNode;

/** Draws tokens; links into the book lead there, all others open beside the page. */
function drawing(go: (href: string) => void): Draw {
  const draw: Draw = (tokens) =>
    tokens?.map((token, n) => (
      // biome-ignore lint/suspicious/noArrayIndexKey: a text never changes its order
      <Fragment key={n}>{drawn(token as Tokens.Generic, draw, go)}</Fragment>
    ));
  return draw;
}

function drawn(token: Tokens.Generic, draw: Draw, go: (href: string) => void): ReactNode {
  const inner = () => draw(token.tokens);
  switch (token.type) {
    case "heading": {
      const Head = token.depth === 1 ? "h3" : token.depth === 2 ? "h4" : "h5";
      return <Head id={anchorOf(token.text.replaceAll("`", ""))}>{inner()}</Head>;
    }
    case "paragraph":
      return <p>{inner()}</p>;
    case "strong":
      return <b>{inner()}</b>;
    case "em":
      return <em>{inner()}</em>;
    case "codespan":
      return <code>{token.text}</code>;
    case "code":
      return (
        // biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, also by keys
        <pre tabIndex={0}>{token.text}</pre>
      );
    case "blockquote":
      return <blockquote>{inner()}</blockquote>;
    case "list":
      return <List token={token as Tokens.List} draw={draw} />;
    case "table":
      return <Table token={token as Tokens.Table} draw={draw} />;
    case "link":
      return <Way href={token.href} go={go} words={inner()} />;
    case "image":
      return <img src={figureAddress(token.href)} alt={token.text} loading="lazy" />;
    case "space":
      return null;
    case "br":
      return <br />;
    default:
      return token.tokens ? inner() : token.type === "text" ? unescaped(token.text) : token.raw;
  }
}

/** The lexer writes these as HTML would. */
const unescaped = (text: string): string =>
  text
    .replaceAll("&lt;", "<")
    .replaceAll("&gt;", ">")
    .replaceAll("&quot;", '"')
    .replaceAll("&#39;", "'")
    .replaceAll("&amp;", "&");

function List({ token, draw }: { token: Tokens.List; draw: Draw }) {
  const List = token.ordered ? "ol" : "ul";
  return (
    <List>
      {token.items.map((item, n) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: a text never changes its order
        <li key={n}>{draw(item.tokens)}</li>
      ))}
    </List>
  );
}

function Table({ token, draw }: { token: Tokens.Table; draw: Draw }) {
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: it scrolls, also by keys
    <section className="book-table" tabIndex={0} aria-label={t("Table")}>
      <table>
        <thead>
          <tr>
            {token.header.map((cell, n) => (
              // biome-ignore lint/suspicious/noArrayIndexKey: a column is its place
              <th key={n} scope="col">
                {draw(cell.tokens)}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {token.rows.map((row, n) => (
            // biome-ignore lint/suspicious/noArrayIndexKey: a row is its place
            <tr key={n}>
              {row.map((cell, n) => (
                // biome-ignore lint/suspicious/noArrayIndexKey: a column is its place
                <td key={n}>{draw(cell.tokens)}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}

/** A link: into the book, or beside the page; what is not of the book and not of the web is told as words. */
function Way({ href, go, words }: { href: string; go: (href: string) => void; words: ReactNode }) {
  if (/^https?:/.test(href))
    return (
      <a href={href} target="_blank" rel="noreferrer">
        {words}
      </a>
    );
  if (!/^([\w-]+\.md)?(#.*)?$/.test(href)) return <i>{words}</i>;
  return (
    <button type="button" className="text-link" onClick={() => go(href)}>
      {words}
    </button>
  );
}
