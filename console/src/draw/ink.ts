/** Colours of the theme, and where on an element a pointer is. */

import { type Place, place } from "./geometry/vec";
import type { Ink } from "./paint/picture";

export function inkOf(element: Element): Ink {
  const style = getComputedStyle(element);
  return (token) => style.getPropertyValue(token).trim();
}

export function pixelOf(
  box: Element | null,
  { clientX, clientY }: { clientX: number; clientY: number },
): Place {
  const at = box?.getBoundingClientRect();
  return place(clientX - (at?.left ?? 0), clientY - (at?.top ?? 0));
}
