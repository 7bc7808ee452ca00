/** Looks at what is painted, for tests. */

import type { Locator, Page } from "playwright-core";

export type Pixel = readonly [number, number, number];

export interface Painted {
  readonly width: number;
  readonly height: number;
  at(x: number, y: number): Pixel;
  /** Counts the pixels that meet a condition. */
  count(is: (pixel: Pixel) => boolean): number;
}

/** The pixels of an element as they are on the screen. */
export async function painted(page: Page, element: Locator): Promise<Painted> {
  const png = (await element.screenshot({ animations: "disabled" })).toString("base64");
  const { width, height, data } = await page.evaluate(async (bytes) => {
    const image = new Image();
    image.src = `data:image/png;base64,${bytes}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const pen = canvas.getContext("2d");
    pen?.drawImage(image, 0, 0);
    const found = pen?.getImageData(0, 0, image.width, image.height).data ?? [];
    const { width, height } = image;
    // As a text: a list of so many numbers takes seconds on its way.
    let text = "";
    for (let n = 0; n < found.length; n += 8192)
      text += String.fromCharCode(...found.slice(n, n + 8192));
    return { width, height, data: text };
  }, png);
  const at = (x: number, y: number): Pixel => {
    const n = 4 * (Math.round(y) * width + Math.round(x));
    return [data.charCodeAt(n), data.charCodeAt(n + 1), data.charCodeAt(n + 2)];
  };
  return {
    width,
    height,
    at,
    count(is) {
      let sum = 0;
      for (let y = 0; y < height; y += 1)
        for (let x = 0; x < width; x += 1) sum += Number(is(at(x, y)));
      return sum;
    },
  };
}
