import { useMemo } from "react";
import { useSnapshot } from "../app/context";
import { useLook } from "../digitize/useLook";
import { expansionFactor, usualExpansion } from "../draw/window";
import type { Bounds, Vec3 } from "./camera";
import { type Recorded, recordedBounds, recordedIn, sightOf } from "./recorded";

export interface Picture {
  /** The origin of its places: mm, machine frame. */
  readonly origin: Vec3;
  /** Bounds of the tool path and of what is typed. */
  readonly data: Bounds | undefined;
  /** Has a box in the picture, so many times larger. */
  shows(box: Bounds, expansion: number): void;
  /** Has twice as much in the picture. */
  zoomOut(): void;
}

/** Points that are being digitized, and the hand console's wishes what is in the picture. */
export function useRecorded({ origin, data, shows, zoomOut }: Picture): Recorded | undefined {
  const digitized = useSnapshot("digitized");
  const setup = useSnapshot("setup");
  const [x, y, z] = origin;
  const recorded = useMemo(
    () => (digitized ? recordedIn(digitized, [x, y, z]) : undefined),
    [digitized, x, y, z],
  );
  useLook((look) => {
    if (look === "out") return zoomOut();
    const [wide, high] = setup?.reach ?? [0, 0];
    const table: Bounds = { min: [-x, -y, -z], max: [wide - x, high - y, -z] };
    const machine = wide > 0 && high > 0 ? table : undefined;
    const points = recorded && recordedBounds(recorded);
    const box = sightOf(look, { data, recorded: points, machine });
    if (box) shows(box, expansionFactor(setup?.windowExpansion ?? usualExpansion));
  });
  return recorded;
}
