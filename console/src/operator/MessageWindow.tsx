import { type PointerEvent, useEffect, useRef, useState } from "react";
import { drive } from "../actions/ask";
import { clearPrinted } from "../actions/job";
import { useHands, useScreen, useSnapshot, worldOf } from "../app/context";
import { type DisplaySettings, twips, useDisplay } from "../app/display";
import { ActionButton } from "../ui/ActionButton";
import { Button } from "../ui/Button";
import { Tail } from "../ui/Tail";
import { t } from "../words/words";
import "./message-window.css";

/**
 * The message screen of part files: PRINT opens it, and comments do where VD says so. VD keeps its place
 * and size.
 */
export function MessageWindow() {
  const display = useDisplay();
  const [open, setOpen] = useOpened(display);
  const here = useScreen("route") === "/";
  if (!open || !display || !here) return null;
  return <Opened key={display.message.join()} display={display} onClose={() => setOpen(false)} />;
}

/** Messages of the program: its comments, when they are wanted, and its printed lines. */
function useSaid(comments: boolean): { lines: readonly string[]; printed: number; notes: number } {
  const printed = useSnapshot("printed") ?? [];
  const messages = useSnapshot("messages") ?? [];
  const run = useSnapshot("job")?.run ?? 0;
  const notes = messages.filter((message) => message.tone === "program" && message.run === run);
  const said = comments ? notes.map(({ text }) => text) : [];
  return { lines: [...said, ...printed], printed: printed.length, notes: said.length };
}

/** Open as soon as something is said; closed by a VD without comments, typed or in a file, until the next word. */
function useOpened(display: DisplaySettings | null) {
  const comments = display?.comments ?? false;
  const { printed, notes } = useSaid(comments);
  const [open, setOpen] = useState(false);
  const job = useSnapshot("job");
  const silent = job?.silent ?? false;
  const before = useRef<{ said: number; silent: boolean }>(undefined);
  const said = printed + notes;
  useEffect(() => {
    if (!display) return;
    // What was said before this page came is in the list; it opens nothing.
    const { current = { said: display.comments ? 0 : said, silent } } = before;
    if (silent && !current.silent) setOpen(false);
    else if (said > current.said) setOpen(!silent);
    before.current = { said, silent };
  }, [said, silent, display]);
  return [open, setOpen] as const;
}

/** Least of it that is always in sight, pixels. */
const least = 120;

type Place = DisplaySettings["message"];

/** Room between it and what it must not cover, pixels. */
const room = 8;

/** Place of the window until somebody moves it: at the right, over the listing, neither over the locations nor over Start. */
function placed([x, y, width, height]: Place): Place {
  if (x !== 0 || y !== 0) return [x, y, width, height];
  const bar = document.querySelector(".job-start, .job.panel")?.getBoundingClientRect();
  const strip = document.querySelector(".strip")?.getBoundingClientRect();
  // Places count from below the strip.
  const top = strip?.bottom ?? 0;
  const low = bar ? bar.top - top - room : innerHeight - 190;
  const tall = Math.min(height, Math.max(least, low - room));
  return [Math.max(0, innerWidth - width - 24), Math.max(0, low - tall), width, tall];
}

function Opened({ display, onClose }: { display: DisplaySettings; onClose: () => void }) {
  const hands = useHands();
  const { lines } = useSaid(display.comments);
  const [[x, y, width, height], setPlace] = useState(() => placed(display.message));
  const box = useRef<HTMLElement>(null);
  const moved = useRef(false);
  useEffect(() => {
    const bar = document.querySelector(".job.panel");
    if (!bar) return;
    // The panel with Start is moved by those beside it, which grow and shrink with what they say.
    const watch = new ResizeObserver(() => {
      if (!moved.current) setPlace(placed(display.message));
    });
    for (const panel of bar.parentElement?.children ?? []) watch.observe(panel);
    return () => watch.disconnect();
  }, [display]);
  const keep = () => {
    const size = box.current?.getBoundingClientRect();
    if (!size) return;
    const inTwips = (pixels: number) => Math.round(pixels * twips);
    const all = [x, y, size.width, size.height].map(inTwips);
    if (all.join() === placed(display.message).map(inTwips).join()) return;
    const value = `[${all.join(", ")}]`;
    void drive(worldOf(hands), { do: "set", key: "display.message_twips", value });
  };
  const move = (event: PointerEvent) => {
    if (event.buttons !== 1) return;
    moved.current = true;
    const [right, low] = [innerWidth - least, innerHeight - least];
    setPlace([
      Math.min(Math.max(0, x + event.movementX), right),
      Math.min(Math.max(0, y + event.movementY), low),
      width,
      height,
    ]);
  };
  return (
    <section
      ref={box}
      className="message-window card"
      aria-label={t("Message screen")}
      style={{ left: x, top: y, width, height }}
      onPointerUp={keep}
    >
      <header
        onPointerDown={(event) => {
          if (event.target instanceof HTMLButtonElement) return;
          event.currentTarget.setPointerCapture(event.pointerId);
        }}
        onPointerMove={move}
      >
        <h2>{t("Message screen")}</h2>
        <ActionButton action={clearPrinted} look="quiet" size="small">
          Empty
        </ActionButton>
        <Button look="quiet" size="small" onPress={onClose} aria-label="Close the message screen">
          ✕
        </Button>
      </header>
      <Tail
        label={t("What the program says")}
        empty={t("The program said nothing.")}
        count={lines.length}
      >
        <pre className="word-printed">{lines.join("\n")}</pre>
      </Tail>
    </section>
  );
}
