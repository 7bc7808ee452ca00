/**
 * The part of the drawing that is in sight.
 *
 * Pixels count from the upper left corner of the picture, downwards; the drawing's y goes up.
 */

import { type Box, isEmpty, type Place, place } from "./geometry/vec";

export interface Window {
  /** The place in the middle. */
  readonly middle: Place;
  readonly mmPerPixel: number;
}

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** So much larger than the data is the window that shows all of it where no setting says otherwise, percent. */
export const usualExpansion = 5;

/** An expansion in percent as a factor, half of it on each side. */
export const expansionFactor = (percent: number): number => 1 + percent / 100;

const finest = 1e-5;
const coarsest = 1e4;
const kept = (mmPerPixel: number): number => Math.min(coarsest, Math.max(finest, mmPerPixel));

export const toPixels = (window: Window, size: Size, at: Place): Place =>
  place(
    size.width / 2 + (at.x - window.middle.x) / window.mmPerPixel,
    size.height / 2 - (at.y - window.middle.y) / window.mmPerPixel,
  );

export const toDrawing = (window: Window, size: Size, pixel: Place): Place =>
  place(
    window.middle.x + (pixel.x - size.width / 2) * window.mmPerPixel,
    window.middle.y - (pixel.y - size.height / 2) * window.mmPerPixel,
  );

/** Everything in a box, and somewhat more: a factor of 1 shows no more than the box. */
export function fitted(box: Box, size: Size, factor = expansionFactor(usualExpansion)): Window {
  if (isEmpty(box)) return { middle: place(0, 0), mmPerPixel: 1 };
  const [wide, high] = [box.max.x - box.min.x, box.max.y - box.min.y];
  const needed = Math.max(wide / Math.max(size.width, 1), high / Math.max(size.height, 1));
  return {
    middle: place((box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2),
    mmPerPixel: needed > 0 ? kept(needed * factor) : 1,
  };
}

/** Half or double the size, with a place in the middle (Z and X). */
export const zoomedTo = (window: Window, middle: Place, factor: number): Window => ({
  middle,
  mmPerPixel: kept(window.mmPerPixel / factor),
});

/** Zoomed so that the place under the pointer stays there (the wheel). */
export function zoomedAbout(window: Window, at: Place, factor: number): Window {
  const mmPerPixel = kept(window.mmPerPixel / factor);
  const share = mmPerPixel / window.mmPerPixel;
  return {
    middle: place(at.x + (window.middle.x - at.x) * share, at.y + (window.middle.y - at.y) * share),
    mmPerPixel,
  };
}

export const centredOn = (window: Window, middle: Place): Window => ({ ...window, middle });

/** Moved by pixels, as a hand moves a sheet of paper. */
export const panned = (window: Window, across: number, down: number): Window =>
  centredOn(
    window,
    place(window.middle.x - across * window.mmPerPixel, window.middle.y + down * window.mmPerPixel),
  );

/** The part of the drawing in sight. */
export function boxInSight(window: Window, size: Size): Box {
  const [wide, high] = [size.width * window.mmPerPixel, size.height * window.mmPerPixel];
  const { x, y } = window.middle;
  return { min: place(x - wide / 2, y - high / 2), max: place(x + wide / 2, y + high / 2) };
}
