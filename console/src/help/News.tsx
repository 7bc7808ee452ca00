/** The help pages HB (the changelog) and HW (links to what this Kerf serves). */

import { useEffect, useState } from "react";
import { phrase, t } from "../words/words";

/** The text of the changelog; it comes with the page and needs no network. */
const changes = async (): Promise<string> => (await import("../../../CHANGELOG.md?raw")).default;

/** Reads one of the parts of the changelog: a heading, or a point with the lines that belong to it. */
export function newsOf(changelog: string): readonly { heading: boolean; text: string }[] {
  const parts = changelog.split(/\n(?=\S)/).map((part) => part.replace(/\s+/g, " ").trim());
  return parts
    .filter((part) => part !== "")
    .map((part) => ({ heading: /^#|^[^-\s][^.]*$/.test(part), text: part.replace(/^[#-]+ /, "") }));
}

/** News of each version, and where known problems of this machine are told. */
export function Bulletins() {
  const [news, setNews] = useState("");
  useEffect(() => void changes().then(setNews), []);
  return (
    <>
      <p>
        {phrase(
          "What this Kerf has noticed of itself and of this machine, for whoever helps: {0}, in a new tab.",
          <a href="/api/problems" target="_blank" rel="noreferrer">
            {t("known problems here")}
          </a>,
        )}
      </p>
      <section className="help-news" aria-label={t("News")}>
        {newsOf(news).map(({ heading, text }, n) =>
          heading ? (
            // biome-ignore lint/suspicious/noArrayIndexKey: the list never changes
            <h3 key={n}>{text}</h3>
          ) : (
            // biome-ignore lint/suspicious/noArrayIndexKey: the list never changes
            <p key={n}>{text}</p>
          ),
        )}
      </section>
    </>
  );
}

/** Links to what this Kerf serves itself, so that they work in a shop without a network. */
export function Web() {
  return (
    <ul className="help-web">
      <li>
        <a href="/" target="_blank" rel="noreferrer">
          {location.origin}
        </a>
        {t(": this console, for another screen in the shop (with `--lan`).")}
      </li>
      <li>
        <a href="/api/openapi.json" target="_blank" rel="noreferrer">
          {t("What programs can ask of this Kerf")}
        </a>
        {t(", as OpenAPI.")}
      </li>
      <li>
        <a href="/api/problems" target="_blank" rel="noreferrer">
          {t("What somebody who helps has to know")}
        </a>
        {t(", as text.")}
      </li>
      <li>{t("The book comes with this page: see The book at the left.")}</li>
    </ul>
  );
}
