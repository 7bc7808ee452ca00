import { colourWords } from "../words/operations";
import { t } from "../words/words";
import { choices, chosen } from "./desk";
import type { Scene } from "./scene";
import type { Desk } from "./useDesk";
import { type Size, toPixels } from "./window";

interface ChooserProps {
  desk: Desk;
  scene: Scene;
  size: Size;
}

/** Small buttons in group colours, when several shapes lie under a click; in cutting order. */
export function Chooser({ desk, scene, size }: ChooserProps) {
  const { chooser, window } = desk.state;
  if (!chooser) return null;
  const at = toPixels(window, size, chooser.at);
  return (
    <div className="chooser" role="menu" style={{ translate: `${at.x + 8}px ${at.y + 8}px` }}>
      {choices(desk.state, desk.around).map(({ number, highlighted: marked }, n) => {
        const shape = scene.shapes.find((other) => other.number === number);
        const name = t("Shape {0}, layer {1}", number, colourWords(shape?.group ?? ""));
        return (
          <button
            key={number}
            type="button"
            role="menuitem"
            // biome-ignore lint/a11y/noAutofocus: it opens at a click and waits for an answer
            autoFocus={n === 0}
            className={marked ? "chooser-one chooser-marked" : "chooser-one"}
            style={{ background: `var(--draw-group-${shape?.group})` }}
            title={name}
            aria-label={marked ? t("{0}, selected", name) : name}
            onClick={(event) =>
              desk.act((state, around) => chosen(state, number, chooser.at, event.shiftKey, around))
            }
            onKeyDown={(event) => {
              if (event.key === "Escape") desk.set((state) => ({ ...state, chooser: null }));
            }}
          />
        );
      })}
    </div>
  );
}
