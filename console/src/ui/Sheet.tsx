import { type ReactNode, useEffect, useId, useRef } from "react";
import { t } from "../words/words";
import { Button } from "./Button";
import { PanelHelp } from "./PanelHelp";
import "./sheet.css";

interface SheetProps {
  title: string;
  /** The title by which the book tells of it, where it is another. */
  about?: string;
  /** Without it the sheet cannot be closed, only answered. */
  onClose?: () => void;
  /** `question` asks for an answer; `side` leaves the screen in sight. */
  shape?: "middle" | "side" | "wide" | "question";
  /** Stands below the contents and does not scroll. */
  foot?: ReactNode;
  children: ReactNode;
}

/**
 * Sheet that lies over a screen. It covers the screen, never the strip with STOP: the screen behind is
 * inert, so that Tab goes between the sheet and the strip only.
 */
export function Sheet(props: SheetProps) {
  const { title, about = title, onClose, shape = "middle", foot, children } = props;
  const name = useId();
  const box = useFocusWithin();
  useEscape(onClose);
  return (
    <div className={`sheet-cover sheet-cover-${shape}`}>
      <section
        ref={box}
        className={`sheet sheet-${shape}`}
        role="dialog"
        aria-labelledby={name}
        tabIndex={-1}
      >
        <div className="sheet-head">
          <h2 id={name}>{t(title)}</h2>
          <PanelHelp title={about} heading={name} />
          {onClose && (
            <Button look="quiet" size="small" onPress={onClose} aria-label="Close">
              ✕
            </Button>
          )}
        </div>
        <div className="sheet-body">{children}</div>
        {foot && <div className="sheet-foot">{foot}</div>}
      </section>
    </div>
  );
}

/** The sheets that are open, the topmost last. */
const stack: object[] = [];

/** Esc closes the topmost sheet, wherever the focus is: the strip can have it. */
function useEscape(onClose: (() => void) | undefined) {
  const close = useRef(onClose);
  close.current = onClose;
  useEffect(() => {
    const self = {};
    stack.push(self);
    const hear = (event: KeyboardEvent) => {
      if (event.key !== "Escape" || event.defaultPrevented || stack.at(-1) !== self) return;
      event.preventDefault();
      close.current?.();
    };
    addEventListener("keydown", hear);
    return () => {
      stack.splice(stack.indexOf(self), 1);
      removeEventListener("keydown", hear);
    };
  }, []);
}

/** Moves the focus in when it opens, and back to where it was when it closes. */
function useFocusWithin() {
  const box = useRef<HTMLElement>(null);
  useEffect(() => {
    const before = document.activeElement;
    const first = box.current?.querySelector<HTMLElement>("[data-first]");
    if (!box.current?.contains(before)) (first ?? box.current)?.focus();
    // What is typed takes the place of what stands there.
    if (first instanceof HTMLInputElement) first.select();
    return () => {
      if (before instanceof HTMLElement) setTimeout(() => before.focus());
    };
  }, []);
  return box;
}
