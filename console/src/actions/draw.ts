/** Drawing: every tool, and what changes the drawing as a whole. */

import { tools } from "../draw/tools/catalog";
import type { Op } from "../wire/messages";
import { t } from "../words/words";
import type { Action, World } from "./action";
import { ask } from "./ask";

const toolActions = tools.map(
  ({ id, title }): Action => ({
    id: `draw.${id}`,
    title: t("Draw: {0}", title),
    section: "draw",
    run: ({ screen }) => screen.takeTool(id),
  }),
);

/** Works on the drawing where it is in sight. */
const onDrawing = (id: string, title: string, op: Op, keys: readonly string[]): Action => ({
  id: `draw.${id}`,
  title: t("Drawing: {0}", title),
  section: "draw",
  keys,
  refused: ({ screen }) =>
    screen.get().route === "/draw" ? undefined : t("The drawing is not in sight."),
  run: (world) => void ask(world, { do: "draw", op }),
});

/** Tells whether another drawing in place of the one on the sheet would lose unsaved changes. */
export const isUnsaved = ({ shown }: World): boolean => {
  const drawing = shown.snapshot?.drawing;
  return drawing ? drawing.changed && drawing.shapes > 0 : false;
};

export const unsaved = t("The drawing on the sheet has changes that are not saved: they are lost.");

const begin = onDrawing("drop", t("drop it and begin a new one"), { op: "new" }, []);
const drop: Action = { ...begin, warns: () => unsaved };

/** An empty sheet; asks first where something would be lost. */
export const beginDrawing: Action = {
  ...begin,
  id: "draw.new",
  title: t("Drawing: begin a new one"),
  run: (world) => {
    if (isUnsaved(world)) world.screen.open({ kind: "confirm", action: drop.id });
    else drop.run(world);
  },
};

export const drawActions: readonly Action[] = [
  ...toolActions,
  beginDrawing,
  drop,
  onDrawing("undo", t("undo"), { op: "undo" }, ["Ctrl+Z"]),
  onDrawing("redo", t("redo"), { op: "redo" }, ["Ctrl+Y", "Ctrl+Shift+Z"]),
  onDrawing("select-all", t("select all"), { op: "do", clauses: "select all" }, ["Ctrl+A"]),
];
