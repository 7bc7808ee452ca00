/** Drawing: every tool, and what changes the drawing as a whole. */

import { tools } from "../draw/tools/catalog";
import type { Op } from "../wire/messages";
import type { Action } from "./action";
import { ask } from "./ask";

const toolActions = tools.map(
  ({ id, title }): Action => ({
    id: `draw.${id}`,
    title: `Draw: ${title}`,
    section: "draw",
    run: ({ screen }) => screen.takeTool(id),
  }),
);

/** Works on the drawing where it is in sight. */
const onDrawing = (id: string, title: string, op: Op, keys: readonly string[]): Action => ({
  id: `draw.${id}`,
  title: `Drawing: ${title}`,
  section: "draw",
  keys,
  refused: ({ screen }) =>
    screen.get().route === "/draw" ? undefined : "The drawing is not in sight.",
  run: (world) => void ask(world, { do: "draw", op }),
});

export const drawActions: readonly Action[] = [
  ...toolActions,
  onDrawing("undo", "undo", { op: "undo" }, ["Ctrl+Z"]),
  onDrawing("redo", "redo", { op: "redo" }, ["Ctrl+Y", "Ctrl+Shift+Z"]),
  onDrawing("select-all", "select all", { op: "do", clauses: "select all" }, ["Ctrl+A"]),
];
