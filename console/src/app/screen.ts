/** State that belongs to this browser and not to the server: route, theme, face, open sheets. */

import { applyTheme, rememberedTheme, type Theme } from "../theme/theme";
import type { FileAbout } from "../wire/messages";
import { type Route, routeOf } from "./routes";
import { createStore, type Store } from "./store";

/** Sheet that lies over the screen. Jobs' questions are not here: they belong to the server. */
export type Sheet =
  /** With files of this computer that go into the part folder. */
  | { readonly kind: "files"; readonly given?: readonly File[] }
  | { readonly kind: "command"; readonly letters: string; readonly given: readonly string[] }
  | { readonly kind: "keypad" }
  | { readonly kind: "moveTo" }
  | { readonly kind: "nudge" }
  | {
      readonly kind: "values";
      readonly which?: "variables" | "system" | "settings" | "diagnostics";
    }
  | { readonly kind: "scratch" }
  | { readonly kind: "recorder" }
  | { readonly kind: "inputs" }
  | { readonly kind: "ports" }
  | { readonly kind: "tools" }
  | { readonly kind: "zeros" }
  | { readonly kind: "controllerSettings" }
  | { readonly kind: "controllerCard" }
  | { readonly kind: "controllerLines" }
  | { readonly kind: "warmUp" }
  | { readonly kind: "toolTable" }
  | { readonly kind: "probe" }
  | { readonly kind: "heightMap" }
  | { readonly kind: "surfacing" }
  | { readonly kind: "tuning" }
  | { readonly kind: "wiring" }
  | { readonly kind: "timing" }
  | { readonly kind: "samples" }
  | { readonly kind: "history" }
  | { readonly kind: "todo" }
  | { readonly kind: "macros" }
  | { readonly kind: "versions"; readonly name: string }
  | { readonly kind: "bin" }
  | { readonly kind: "loadSettings"; readonly text: string }
  | { readonly kind: "setup" }
  | { readonly kind: "keys" }
  | { readonly kind: "confirm"; readonly action: string }
  | {
      readonly kind: "replace";
      readonly about: FileAbout;
      readonly answer: (mayBeReplaced: boolean) => void;
    }
  | { readonly kind: "palette" };

export type Face = "easy" | "full";

export interface ScreenState {
  readonly route: Route;
  readonly theme: Theme;
  readonly face: Face;
  readonly sheet: Sheet | null;
  /** The calculator lies over whatever is open, and knows the field that it was called from. */
  readonly calculator: { readonly field: HTMLInputElement | null } | null;
  /** The hand console lies over whatever is open. */
  readonly handConsole: boolean;
  /** Lines at which going line by line halts. */
  readonly breakpoints: readonly Breakpoint[];
  /** The run that this page steps on by itself until a line with a breakpoint is due. */
  readonly steppedRun: number | null;
  /** The line that the editor was asked to show, until it does. */
  readonly spot: Spot | null;
  /** The tool path takes the whole screen. */
  readonly large: boolean;
  /** The page of the help that was asked for: the letters of its command. */
  readonly topic: string;
  /** File that the editor was asked to show: a new value each time; an empty name is an empty page. */
  readonly edits: { readonly name: string } | null;
  /** The drawing tool that was asked for; a new value each time. */
  readonly tool: { readonly id: string } | null;
  /** Notices of the last refusals; the newest last. */
  readonly notices: readonly Notice[];
}

/** A line of a file of the part folder. */
export interface Spot {
  readonly file: string;
  readonly line: number;
}

export type Breakpoint = Spot;

export interface Notice {
  readonly id: number;
  readonly text: string;
}

export interface Screen extends Store<ScreenState> {
  go(route: Route): void;
  open(sheet: Sheet | null): void;
  /** Closes this sheet; another one that was opened meanwhile stays. */
  close(sheet: Sheet | null): void;
  /** Opens the calculator for the field that has the focus, or closes it. */
  calculate(open: boolean): void;
  /** Shows the hand console, or puts it away. */
  showHandConsole(shown: boolean): void;
  /** Goes to the drawing and begins a tool. */
  takeTool(id: string): void;
  wear(theme: Theme): void;
  face(face: Face): void;
  enlarge(large: boolean): void;
  /** Goes to a page of the help. */
  explain(topic: string): void;
  /** Goes to the editor with a file. */
  edit(name: string): void;
  /** Goes to the editor and shows a line there. */
  showLine(spot: Spot): void;
  /** The editor shows the line that it was asked for. */
  lineShown(): void;
  /** The lines of a file at which going line by line halts. */
  mark(file: string, lines: readonly number[]): void;
  /** Steps on by itself in this run, or no more. */
  stepOn(run: number | null): void;
  /** Shows a notice for a while. */
  tell(text: string): void;
  dismiss(id: number): void;
}

/** Time that a notice stays, milliseconds, and most notices at once. */
const noticeMs = 7000;
const mostNotices = 3;

const faceKey = "kerf.face";

/** The state of this browser, kept in step with its address bar. */
export function createScreen(): Screen {
  const store = createStore<ScreenState>({
    route: routeOf(location.pathname),
    theme: rememberedTheme(),
    face: localStorage.getItem(faceKey) === "full" ? "full" : "easy",
    sheet: null,
    calculator: null,
    handConsole: false,
    breakpoints: [],
    steppedRun: null,
    spot: null,
    large: false,
    topic: "how",
    edits: null,
    tool: null,
    notices: [],
  });
  let notices = 0;
  applyTheme(store.get().theme);
  addEventListener("popstate", () =>
    store.update((now) => ({ ...now, route: routeOf(location.pathname) })),
  );
  return {
    ...store,
    go(route) {
      if (route === store.get().route) return;
      history.pushState(null, "", route);
      store.update((now) => ({ ...now, route, sheet: null, calculator: null }));
    },
    open: (sheet) => store.update((now) => ({ ...now, sheet })),
    close: (sheet) => store.update((now) => (now.sheet === sheet ? { ...now, sheet: null } : now)),
    calculate(open) {
      const focused = document.activeElement;
      const field = focused instanceof HTMLInputElement ? focused : null;
      store.update((now) => ({ ...now, calculator: open ? (now.calculator ?? { field }) : null }));
    },
    showHandConsole: (handConsole) => store.update((now) => ({ ...now, handConsole })),
    takeTool(id) {
      this.go("/draw");
      store.update((now) => ({ ...now, sheet: null, tool: { id } }));
    },
    wear(theme) {
      applyTheme(theme);
      store.update((now) => ({ ...now, theme }));
    },
    face(face) {
      localStorage.setItem(faceKey, face);
      store.update((now) => ({ ...now, face }));
    },
    enlarge: (large) => store.update((now) => ({ ...now, large })),
    explain(topic) {
      this.go("/help");
      store.update((now) => ({ ...now, topic }));
    },
    edit(name) {
      this.go("/edit");
      store.update((now) => ({ ...now, edits: { name } }));
    },
    showLine(spot) {
      this.go("/edit");
      store.update((now) => ({ ...now, spot: { ...spot } }));
    },
    lineShown: () => store.update((now) => ({ ...now, spot: null })),
    mark: (file, lines) =>
      store.update((now) => {
        const others = now.breakpoints.filter((one) => one.file !== file);
        return { ...now, breakpoints: [...others, ...lines.map((line) => ({ file, line }))] };
      }),
    stepOn: (steppedRun) => store.update((now) => ({ ...now, steppedRun })),
    tell(text) {
      notices += 1;
      const notice = { id: notices, text };
      const other = (all: readonly Notice[]) => all.filter((told) => told.text !== text);
      const dismissed = () => this.dismiss(notice.id);
      store.update((now) => ({
        ...now,
        notices: [...other(now.notices), notice].slice(-mostNotices),
      }));
      setTimeout(dismissed, noticeMs);
    },
    dismiss: (id) =>
      store.update((now) => ({ ...now, notices: now.notices.filter((n) => n.id !== id) })),
  };
}
