//! The endings of drawings and jobs for the console, as the table of formats has them.

use kerf_formats::{Content, FORMATS, Format, JOB_ENDING};

/// Returns the lists as TypeScript.
pub fn typescript() -> String {
    let opened = list(|format| format.content() != Content::Picture);
    let saved = list(|format| format.content() == Content::Drawing && format.is_written());
    format!(
        "/** Endings of drawings and jobs. Written by `cargo xtask wire` from the table of formats. */\n\n\
         /** Files that a drawing is read from. */\n\
         export const drawingEndings = [{opened}] as const;\n\n\
         /** Files as which a drawing is saved. */\n\
         export const savedEndings = [{saved}] as const;\n\n\
         /** Files of tool paths. */\n\
         export const jobEnding = \"{JOB_ENDING}\";\n"
    )
}

fn list(wanted: impl Fn(&Format) -> bool) -> String {
    let endings = FORMATS.iter().filter(|format| wanted(format)).flat_map(|format| format.endings);
    endings.map(|ending| format!("\"{ending}\"")).collect::<Vec<_>>().join(", ")
}
