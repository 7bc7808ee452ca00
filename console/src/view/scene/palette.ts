/** The colours of the view, from the design tokens of the theme. */

export interface Palette {
  readonly paper: string;
  readonly grid: string;
  readonly axis: string;
  readonly cut: string;
  readonly jog: string;
  readonly done: string;
  readonly tool: string;
  readonly text: string;
  /** The surface of the material, and what cutting bares. */
  readonly whole: string;
  readonly bared: string;
}

export function paletteOf(element: Element): Palette {
  const style = getComputedStyle(element);
  const token = (name: string) => style.getPropertyValue(name).trim();
  return {
    paper: token("--view"),
    grid: token("--view-grid"),
    axis: token("--view-axis"),
    cut: token("--view-cut"),
    jog: token("--view-jog"),
    done: token("--view-done"),
    tool: token("--view-tool"),
    text: token("--muted"),
    whole: token("--view-whole"),
    bared: token("--view-bared"),
  };
}
