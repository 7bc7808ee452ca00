import { type ReactNode, useId } from "react";
import { t } from "../words/words";
import { PanelHelp } from "./PanelHelp";
import "./panel.css";

interface PanelProps {
  title: string;
  /** The title by which the book tells of it, where it is another. */
  about?: string;
  /** Stands at the right of the title: a toggle, a count. */
  aside?: ReactNode;
  className?: string;
  children: ReactNode;
}

/** A named region of a screen. */
export function Panel({ title, about = title, aside, className = "", children }: PanelProps) {
  const heading = useId();
  return (
    <section className={`panel ${className}`} aria-label={t(title)}>
      <header className="panel-head">
        <h2 id={heading}>{t(title)}</h2>
        <div className="panel-aside">
          {aside}
          <PanelHelp title={about} heading={heading} />
        </div>
      </header>
      {children}
    </section>
  );
}
