/** Messages between the page and the painter of its tool path, in both directions. */

import type { PreviewInfo } from "../../wire/messages";
import type { Camera, Size } from "../camera";
import type { Piece } from "../piece";
import type { Bared } from "../stock";
import type { Palette } from "./palette";

/** A path as it is drawn while the picture moves. */
export interface CoarsePath {
  readonly info: PreviewInfo;
  readonly pieces: readonly Piece[];
}

export type Order =
  | {
      readonly do: "begin";
      readonly canvas: OffscreenCanvas;
      readonly ratio: number;
      readonly palette: Palette;
    }
  | { readonly do: "paint"; readonly palette: Palette }
  /** With the address of the whole path, where the coarse one is not all there is. */
  | { readonly do: "show"; readonly path: CoarsePath | null; readonly whole: string | null }
  | { readonly do: "now"; readonly seconds: number }
  | { readonly do: "look"; readonly camera: Camera; readonly size: Size }
  | { readonly do: "simulate"; readonly on: boolean }
  | { readonly do: "jogs"; readonly drawn: boolean };

/** Message of the painter: a picture is done; the path shown last is whole or not; the area that is cut. */
export interface Told {
  readonly pictures: number;
  readonly whole: boolean;
  /** Of the stock, when it is shown and everything up to now is cut. */
  readonly bared: Bared | null;
}
