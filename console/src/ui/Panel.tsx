import { type ReactNode, useId } from "react";
import { t } from "../words/words";
import { PanelHelp } from "./PanelHelp";
import "./panel.css";

interface PanelProps {
  title: string;
  /** Stands at the right of the title: a toggle, a count. */
  aside?: ReactNode;
  className?: string;
  children: ReactNode;
}

/** A named region of a screen. */
export function Panel({ title, aside, className = "", children }: PanelProps) {
  const heading = useId();
  return (
    <section className={`panel ${className}`} aria-label={t(title)}>
      <header className="panel-head">
        <h2 id={heading}>{t(title)}</h2>
        <div className="panel-aside">
          {aside}
          <PanelHelp title={title} heading={heading} />
        </div>
      </header>
      {children}
    </section>
  );
}
