import type { ReactNode } from "react";
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
  return (
    <section className={`panel ${className}`} aria-label={title}>
      <header className="panel-head">
        <h2>{title}</h2>
        {aside}
      </header>
      {children}
    </section>
  );
}
