//! Drawing diagnostics for a person at a terminal.

use crate::{Diagnostic, Severity};
use annotate_snippets::{AnnotationKind, Group, Level, Origin, Renderer, Snippet};

/// Source of the text of files when a diagnostic is drawn.
pub trait Sources {
    /// One line of a file, without its line end, or nothing when the file is unknown.
    fn line(&self, file: &str, line: u32) -> Option<String>;
}

/// Draws one diagnostic with the line it points to.
pub fn render_text(diagnostic: &Diagnostic, sources: &dyn Sources, colour: bool) -> String {
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Note => Level::NOTE,
    };
    let place = &diagnostic.place;
    // Only a window of a very long line is shown; tabs would shift the marks.
    let text = sources.line(&place.file, place.line).unwrap_or_default().replace('\t', " ");
    let (shown, from) = window(&text, place.column.saturating_sub(1) as usize);
    let start = byte_of(&shown, (place.column.saturating_sub(1) as usize).saturating_sub(from));
    let end = byte_of(&shown[start..], place.length as usize) + start;
    let title = level.primary_title(&diagnostic.message).id(diagnostic.code.as_str());
    let snippet = Snippet::source(shown.as_str())
        .line_start(place.line as usize)
        .path(place.file.as_ref())
        .annotation(AnnotationKind::Primary.span(start..end));
    let group = Group::with_title(title);
    // Line 0 is the whole file.
    let mut group = if place.line == 0 {
        group.element(Origin::path(place.file.as_ref()))
    } else {
        group.element(snippet)
    };
    if !diagnostic.hint.is_empty() {
        group = group.element(Level::HELP.message(&diagnostic.hint));
    }
    for caller in &diagnostic.callers {
        group = group.element(
            Level::NOTE.message(format!("called from {} line {}", caller.file, caller.line)),
        );
    }
    let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
    renderer.render(&[group])
}

/// At most this many characters of a line are drawn.
const WINDOW: usize = 160;

fn window(text: &str, column: usize) -> (String, usize) {
    let from = if column < WINDOW { 0 } else { column - WINDOW / 2 };
    (text.chars().skip(from).take(WINDOW).collect(), from)
}

fn byte_of(text: &str, chars: usize) -> usize {
    text.char_indices().nth(chars).map_or(text.len(), |(i, _)| i)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Code, SourcePlace};

    struct One(&'static str);
    impl Sources for One {
        fn line(&self, _: &str, line: u32) -> Option<String> {
            (line == 3).then(|| self.0.to_string())
        }
    }

    #[test]
    fn what_is_said_of_a_whole_file_names_no_line() {
        let whole =
            Diagnostic::new(Code::OutsideLimits, SourcePlace::line("a.rsm".into(), 0), "too far");
        let text = render_text(&whole, &One("M23"), false);
        assert!(text.contains("--> a.rsm\n") || text.ends_with("--> a.rsm"), "{text}");
    }

    #[test]
    fn points_at_the_place_and_gives_the_hint() {
        let place = SourcePlace { file: "a.sbp".into(), line: 3, column: 1, length: 3 };
        let d =
            Diagnostic::new(Code::UnknownCommand, place, "unknown command M23").hint("write M2, 3");
        let text = render_text(&d, &One("M23, 4.2"), false);
        assert!(text.contains("error[S002]: unknown command M23"), "{text}");
        assert!(
            text.contains("a.sbp:3:1")
                && text.contains("^^^")
                && text.contains("help: write M2, 3"),
            "{text}"
        );
    }

    #[test]
    fn a_place_past_the_end_of_the_line_is_no_panic() {
        let place = SourcePlace { file: "a.sbp".into(), line: 3, column: 900, length: 7 };
        let text = render_text(&Diagnostic::new(Code::Syntax, place, "x"), &One("äö"), false);
        assert!(text.contains("S004"));
    }
}
