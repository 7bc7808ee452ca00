/** Pieces of a tool path as lines of the graphics card: a strip each, nothing doubled. */

import { BufferAttribute, BufferGeometry, Group, Line } from "three";
import type { Piece } from "../piece";
import type { PathMaterial } from "./pathMaterial";

/** A value a vertex: that of the segment that ends there. */
function ofEnds<T extends Float32Array | Uint8Array>(values: T, shifted: T): T {
  shifted.set(values, 1);
  return shifted;
}

function geometryOf(piece: Piece): BufferGeometry {
  const vertices = piece.segments + 1;
  const geometry = new BufferGeometry();
  const over = ofEnds(piece.over, new Float32Array(vertices));
  const kinds = ofEnds(piece.kinds, new Uint8Array(vertices));
  geometry.setAttribute("position", kept(new BufferAttribute(piece.vertices, 3)));
  geometry.setAttribute("over", kept(new BufferAttribute(over, 1)));
  geometry.setAttribute("kind", kept(new BufferAttribute(kinds, 1)));
  return geometry;
}

const nothing = new Float32Array(0);

/** Frees the page's copy of an attribute once the graphics card has it. */
function kept(attribute: BufferAttribute): BufferAttribute {
  return attribute.onUpload(() => {
    attribute.array = nothing;
  });
}

/** The lines of one level of detail. */
export class PathLines {
  readonly group = new Group();
  readonly #material: PathMaterial;

  constructor(material: PathMaterial) {
    this.#material = material;
  }

  get lines(): readonly Line[] {
    return this.group.children.filter((child) => child instanceof Line);
  }

  /** Shows these pieces and no others. */
  show(pieces: readonly Piece[]): void {
    this.clear();
    for (const piece of pieces) this.add(piece);
  }

  add(piece: Piece): void {
    const line = new Line(geometryOf(piece), this.#material);
    line.frustumCulled = false;
    this.group.add(line);
  }

  clear(): void {
    for (const line of this.lines) line.geometry.dispose();
    this.group.clear();
  }
}
