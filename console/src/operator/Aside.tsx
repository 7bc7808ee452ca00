import { lazy, type ReactNode, Suspense } from "react";
import { useSnapshot } from "../app/context";

/** Fetched when somebody digitizes. */
const DigitizePanel = lazy(async () => ({
  default: (await import("../digitize/DigitizePanel")).DigitizePanel,
}));

/** The right side of the operator's screen: what belongs to the open file, and the points while somebody digitizes. */
export function Aside({ children }: { children: ReactNode }) {
  const digitized = useSnapshot("digitized") ?? null;
  if (digitized === null) return children;
  return (
    <Suspense fallback={children}>
      <div className="operator-points">
        <DigitizePanel />
      </div>
    </Suspense>
  );
}
