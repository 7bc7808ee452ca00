import type { ReactNode } from "react";
import { Choice } from "../ui/Choice";
import type { Aspect } from "./space/space";

interface ViewBarProps {
  aspect: Aspect;
  onAspect: (aspect: Aspect) => void;
  /** Buttons of this view. */
  children?: ReactNode;
}

const aspects: readonly { value: Aspect; words: string }[] = [
  { value: "top", words: "Top" },
  { value: "side", words: "Side" },
  { value: "end", words: "End" },
  { value: "solid", words: "3D" },
];

/** From where the drawing is seen. */
export function ViewBar({ aspect, onAspect, children }: ViewBarProps) {
  return (
    <div className="view-bar">
      <Choice label="View" options={aspects} value={aspect} onChange={onAspect} />
      {children}
    </div>
  );
}
