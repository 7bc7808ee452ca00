import { type ReactNode, useEffect, useRef } from "react";
import "./tail.css";

interface TailProps {
  label: string;
  /** Said when there is nothing. */
  empty: string;
  /** Grows with what is added; the end is shown then. */
  count: number;
  children: ReactNode;
}

/** A list that shows its end, as long as nobody scrolled away from it. */
export function Tail({ label, empty, count, children }: TailProps) {
  const box = useRef<HTMLElement>(null);
  const follows = useRef(true);
  // biome-ignore lint/correctness/useExhaustiveDependencies: scrolls when something is added
  useEffect(() => {
    const list = box.current;
    if (list && follows.current) list.scrollTop = list.scrollHeight;
  }, [count]);
  const watch = () => {
    const list = box.current;
    if (list) follows.current = list.scrollHeight - list.scrollTop - list.clientHeight < 8;
  };
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: a region that scrolls must be reached by key
    <section ref={box} className="tail" aria-label={label} tabIndex={0} onScroll={watch}>
      {children}
      {count === 0 && <p className="tail-empty">{empty}</p>}
    </section>
  );
}
