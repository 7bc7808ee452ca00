import { useEffect, useRef } from "react";
import type { LengthUnit } from "../units/quantity";
import { t } from "../words/words";
import { entered } from "./enter";
import { asked } from "./tools/running";
import type { Desk } from "./useDesk";
import { type Size, toPixels } from "./window";

interface EntryBoxProps {
  desk: Desk;
  size: Size;
  unit: LengthUnit;
  onDone: () => void;
}

/** Field at the cursor for a typed place or number. */
export function EntryBox({ desk, size, unit, onDone }: EntryBoxProps) {
  const input = useRef<HTMLInputElement>(null);
  const { entry, running, window, pointer } = desk.state;
  const open = entry !== null && running !== null;
  const question = running?.answers.length;
  // biome-ignore lint/correctness/useExhaustiveDependencies: for each thing that is asked
  useEffect(() => {
    if (!open) return;
    input.current?.focus();
    if ((input.current?.value.length ?? 0) > 1) input.current?.select();
  }, [open, question]);
  if (!open) return null;
  const ask = asked(running);
  const at = toPixels(window, size, pointer ?? window.middle);
  const label = running.bending ? t("Bulge") : (ask?.prompt ?? "");
  const close = () => {
    desk.set((state) => ({ ...state, entry: null }));
    onDone();
  };
  const [x, y] = [Math.min(at.x + 14, size.width - 220), Math.min(at.y + 14, size.height - 60)];
  return (
    <form
      className="entry"
      style={{ translate: `${Math.max(x, 4)}px ${Math.max(y, 4)}px` }}
      onSubmit={(event) => {
        event.preventDefault();
        desk.act((state, around) => entered(state, entry, unit, around));
        onDone();
      }}
    >
      <label htmlFor="drawing-entry">{label}</label>
      <input
        id="drawing-entry"
        ref={input}
        value={entry}
        placeholder={ask?.ask === "number" || running.bending ? "" : t("x,y  @dx,dy  length<angle")}
        autoComplete="off"
        spellCheck={false}
        onChange={({ target }) => desk.set((state) => ({ ...state, entry: target.value }))}
        onKeyDown={(event) => {
          if (event.key !== "Escape") return;
          event.stopPropagation();
          close();
        }}
      />
    </form>
  );
}
