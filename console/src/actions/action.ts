/**
 * Everything a person can do, as data: menus, keys, the palette, the command line and tests share it.
 *
 * An action knows nothing of React and nothing of machines: it looks at a {@link World}, says whether
 * it can be done now, and asks the server.
 */

import type { Screen } from "../app/screen";
import type { Link } from "../link/link";
import type { Shown } from "../link/shown";

/** The page, the server and the person's answers, as actions see and use them. */
export interface World {
  /** State that the server told last. */
  readonly shown: Shown;
  /** Asks the server. */
  readonly link: Link;
  /** State of this browser: route, theme, open sheets. */
  readonly screen: Screen;
}

/** Group of a menu in which an action stands. */
export type Section = "machine" | "job" | "file" | "view" | "go" | "draw" | "help";

export interface Action {
  readonly id: string;
  readonly title: string;
  readonly section: Section;
  /** As `KeyboardEvent.key` with modifiers before it: `F10`, `Ctrl+K`. */
  readonly keys?: readonly string[];
  /** Its keys are heard only while this is so, and before those of an action that are heard always. */
  readonly when?: (world: World) => boolean;
  /** Also heard while somebody types into a field. */
  readonly everywhere?: boolean;
  /** Tells why it cannot be done now; nothing when it can. */
  readonly refused?: (world: World) => string | undefined;
  /** Goes to what keeps it from being done, where a person can mend that: a press on its button does. */
  readonly mends?: (world: World) => void;
  /** Its keys say why it cannot be done now; those of others do nothing then. */
  readonly keysTell?: boolean;
  /** Warning that a person reads before he lets it happen. */
  readonly warns?: (world: World) => string;
  readonly run: (world: World) => void;
}

/** Does it, or tells the person why it cannot be done. */
export function attempt(action: Action, world: World): void {
  const why = action.refused?.(world);
  if (why === undefined) action.run(world);
  else world.screen.tell(why);
}

/** Does it unless it is refused; tells whether it did. */
export function perform(action: Action, world: World): boolean {
  if (action.refused?.(world) !== undefined) return false;
  action.run(world);
  return true;
}

/** The same behind a question: what one press does cannot be taken back. */
export const asking = (action: Action): Action => ({
  ...action,
  run: ({ screen }) => screen.open({ kind: "confirm", action: action.id }),
});
