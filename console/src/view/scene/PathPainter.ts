/**
 * Paints a tool path on a canvas, beside the page: however long a path is, the page is never busy with it.
 *
 * While the picture moves, the coarse path is drawn; when it stands, the whole of it, a piece a frame, so that
 * no frame is long. Nothing is drawn when nothing changed.
 */

import {
  type BufferGeometry,
  type Line,
  OrthographicCamera,
  Scene,
  Vector2,
  WebGLRenderer,
} from "three";
import type { Camera, Size } from "../camera";
import type { Piece } from "../piece";
import type { Bared } from "../stock";
import { CutStock } from "./cutStock";
import type { CoarsePath } from "./orders";
import type { Palette } from "./palette";
import { PathLines } from "./pathLines";
import { PathMaterial } from "./pathMaterial";
import { TableLines } from "./tableLines";

/** Time that the picture has to stand before all of it is drawn, milliseconds. */
const stillMs = 160;
/** Vertices up to which a path is drawn wide, when it stands and while it moves. */
const wideUpTo = 60_000;
const wideWhileMoving = 8_000;
/** Half the depth of what is seen, mm. */
const farMm = 1e5;

export class PathPainter {
  readonly #renderer: WebGLRenderer;
  readonly #ratio: number;
  readonly #drawn: () => void;
  #palette: Palette;
  readonly #eye = new OrthographicCamera();
  readonly #ground = new Scene();
  readonly #table = new TableLines();
  readonly #material = new PathMaterial();
  readonly #coarse = new PathLines(this.#material);
  readonly #fine = new PathLines(this.#material);
  #vertices = 0;
  #wide = wideUpTo;
  #size: Size = { width: 0, height: 0 };
  #now = 0;
  #stock: CutStock | null = null;
  #carving = 0;
  #bared: Bared | null = null;
  #queue: readonly Line[] = [];
  #frame = 0;
  #still: ReturnType<typeof setTimeout> | undefined;

  /** `drawn` is told whenever a picture is done. */
  constructor(canvas: OffscreenCanvas, ratio: number, palette: Palette, drawn: () => void) {
    this.#ratio = ratio;
    this.#palette = palette;
    this.#drawn = drawn;
    this.#renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.#renderer.autoClear = false;
    // Drawn in the order they are given: sorting would ask for the extent of vertices that are not kept.
    this.#renderer.sortObjects = false;
    this.#ground.add(this.#table.group);
    this.paint(palette);
  }

  /** Takes the colours of the theme over. */
  paint(palette: Palette): void {
    this.#palette = palette;
    this.#renderer.setClearColor(palette.paper);
    this.#table.paint(palette);
    this.#material.paint(palette);
    this.#stock?.mesh.paint(palette);
    this.#moved();
  }

  /** Another path, coarse; all of it is added when it is there. */
  show(path: CoarsePath | null): void {
    this.#coarse.show(path?.pieces ?? []);
    this.#fine.clear();
    if (path) {
      this.#table.show(path.info);
      const [low, high] = path.info.bounds ?? [];
      const z = path.info.origin[2];
      this.#material.heights = [(low?.[2] ?? 0) - z, (high?.[2] ?? 1) - z];
    }
    this.#moved();
  }

  /** A piece of the whole path; the picture is drawn anew by `whole` when all are there. */
  add(piece: Piece): void {
    this.#fine.add(piece);
  }

  whole(): void {
    this.#moved();
  }

  /** Everything before this planned time is made. */
  set now(seconds: number) {
    this.#now = seconds;
    this.#material.now = seconds;
    this.#carve();
    this.#moved();
  }

  /** Draws jogs, or leaves them out. */
  set jogs(drawn: boolean) {
    this.#material.jogs = drawn;
    this.#moved();
  }

  /** Shows the material that is cut, or only the path. */
  simulate(path: CoarsePath | null): void {
    this.#stock?.dispose();
    this.#stock = path && new CutStock(path);
    this.#stock?.mesh.paint(this.#palette);
    this.#carve();
    this.#moved();
  }

  /** Area that is cut of the material, once all is that is made. */
  get bared(): Bared | null {
    return this.#bared;
  }

  /** Cuts on for a part of a frame, and again in the next until all is cut. */
  #carve(): void {
    cancelAnimationFrame(this.#carving);
    const all = this.#stock?.carve(this.#now) ?? true;
    this.#bared = all ? (this.#stock?.bared() ?? null) : null;
    if (all) return;
    this.#carving = requestAnimationFrame(() => {
      this.#carve();
      this.#moved();
    });
  }

  look(camera: Camera, size: Size): void {
    this.#resize(size);
    const [x, y] = [(size.width * camera.mmPerPixel) / 2, (size.height * camera.mmPerPixel) / 2];
    Object.assign(this.#eye, { left: -x, right: x, top: y, bottom: -y, near: -farMm, far: farMm });
    this.#eye.position.set(...camera.target);
    this.#eye.rotation.set(camera.tiltRad, 0, camera.yawRad, "ZXY");
    this.#eye.updateProjectionMatrix();
    this.#moved();
  }

  /** A canvas is made anew when its size is set, so only when it is another. */
  #resize(size: Size): void {
    if (size.width === this.#size.width && size.height === this.#size.height) return;
    this.#size = size;
    this.#renderer.setPixelRatio(this.#ratio);
    this.#renderer.setSize(size.width, size.height, false);
  }

  dispose(): void {
    cancelAnimationFrame(this.#frame);
    cancelAnimationFrame(this.#carving);
    clearTimeout(this.#still);
    this.#stock?.dispose();
    this.#coarse.clear();
    this.#fine.clear();
    this.#renderer.dispose();
  }

  /** Something is different: the swift picture at once, all of it when it stands. */
  #moved(): void {
    clearTimeout(this.#still);
    this.#draw(this.#coarse.lines, wideWhileMoving);
    this.#still = setTimeout(() => {
      const { lines } = this.#fine;
      this.#draw(lines.length > 0 ? lines : this.#coarse.lines, wideUpTo);
    }, stillMs);
  }

  #draw(lines: readonly Line[], wide: number): void {
    this.#wide = wide;
    this.#vertices = lines.reduce((sum, { geometry }) => sum + verticesOf(geometry), 0);
    this.#queue = lines;
    cancelAnimationFrame(this.#frame);
    this.#frame = requestAnimationFrame(() => {
      this.#renderer.clear();
      this.#renderer.render(this.#ground, this.#eye);
      if (this.#stock) this.#renderer.render(this.#stock.mesh.mesh, this.#eye);
      this.#next();
    });
  }

  /** Paths that are not long are drawn two pixels wide. */
  #paint(line: Line): void {
    const { x, y } = this.#renderer.getDrawingBufferSize(new Vector2());
    const wide = this.#vertices <= this.#wide;
    const shifts = wide
      ? [
          [0, 0],
          [2 / x, 0],
          [0, 2 / y],
          [2 / x, 2 / y],
        ]
      : [[0, 0]];
    for (const [across = 0, up = 0] of shifts) {
      this.#material.shift = [across, up];
      this.#renderer.render(line, this.#eye);
    }
  }

  /** Draws one piece and asks for a frame for the rest. */
  #next(): void {
    const [line, ...rest] = this.#queue;
    this.#queue = rest;
    if (line) this.#paint(line);
    if (rest.length > 0) this.#frame = requestAnimationFrame(() => this.#next());
    else this.#drawn();
  }
}

const verticesOf = (geometry: BufferGeometry): number => geometry.getAttribute("position").count;
