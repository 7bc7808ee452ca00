import { useEffect, useRef, useState } from "react";
import { useSize } from "../view/useSize";
import { t } from "../words/words";
import { lineAt } from "./lineIndex";
import { useLines } from "./useLines";
import "./listing.css";

interface ListingProps {
  name: string;
  hash: string;
  lines: number;
  /** The line that runs; 0 when none does. */
  running: number;
}

const lineHeight = 20;
/** Lines drawn beyond what is in sight. */
const spare = 10;
/** Browsers do not make elements higher than this; the scroll bar of longer files is scaled. */
const highest = 8_000_000;

/** A program of any length: only lines in sight exist. Follows the line that runs. */
export function Listing({ name, hash, lines, running }: ListingProps) {
  const box = useRef<HTMLElement>(null);
  const { height } = useSize(box);
  const [top, setTop] = useState(0);
  const scale = Math.max(1, (lines * lineHeight) / highest);
  const sight = Math.ceil(height / lineHeight);
  const first = Math.min(
    Math.max(1, Math.floor((top * scale) / lineHeight) + 1),
    Math.max(lines, 1),
  );
  const from = Math.max(1, first - spare);
  const to = Math.min(lines, first + sight + spare);
  const index = useLines(name, hash);
  useEffect(() => {
    if (running > 0 && box.current) {
      box.current.scrollTop = ((running - sight / 2) * lineHeight) / scale;
    }
  }, [running, sight, scale]);
  return (
    <section
      ref={box}
      className="listing"
      aria-label={t("Lines of {0}", name)}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: a region that scrolls must be reached by key
      tabIndex={0}
      onScroll={(event) => setTop(event.currentTarget.scrollTop)}
    >
      <div className="listing-all" style={{ height: (lines * lineHeight) / scale }}>
        <ol
          className="listing-lines"
          style={{ top: top - (first - from) * lineHeight - offsetOf(top * scale) }}
        >
          {Array.from({ length: to - from + 1 }, (_, k) => from + k).map((n) => (
            <li
              key={n}
              className={lineClass(n, running)}
              aria-current={n === running ? "step" : undefined}
            >
              <span className="listing-number">{n}</span>
              {index ? lineAt(index, n) : ""}
            </li>
          ))}
        </ol>
      </div>
    </section>
  );
}

/** Height of the first line in sight that is scrolled out of it, pixels. */
const offsetOf = (top: number): number => top % lineHeight;

const lineClass = (n: number, running: number): string =>
  n === running ? "listing-running" : n < running ? "listing-done" : "";
