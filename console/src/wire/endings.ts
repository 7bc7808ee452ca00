/** Endings of drawings and jobs. Written by `cargo xtask wire` from the table of formats. */

/** Files that a drawing is read from. */
export const drawingEndings = ["dxf", "svg", "rsg", "rsm", "plt", "hpg", "hpgl"] as const;

/** Files as which a drawing is saved. */
export const savedEndings = ["dxf", "svg", "rsg"] as const;

/** Files of tool paths. */
export const jobEnding = "rsm";
