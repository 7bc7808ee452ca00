//! Pages of help that the console shows.

use crate::run::Context;
use crate::syntax::table::CommandSpec;
use kerf_diag::Code;
use kerf_program::Command;

/// Names the page for the console when it is typed; a part file goes on without.
pub(super) fn show(c: &mut Context<'_>, spec: &CommandSpec) {
    if c.core.options.typed {
        let text = format!("{}: {}", spec.letters, spec.name).into();
        c.emit(Command::Message { text });
    } else {
        let hint = "help opens when it is typed";
        c.warn(Code::IgnoredInFile, "help is not shown from a part file", hint);
    }
}

#[cfg(test)]
mod tests {
    use crate::Options;
    use crate::testing::{FakeHost, check, run_as};
    use kerf_program::Command;

    #[test]
    fn help_in_a_part_file_is_passed_over() {
        for letter in "ABCENQRTUW".chars() {
            check(&format!("H{letter}⏎MX,1"), "at 1,0,0; warning help is not shown");
        }
    }

    #[test]
    fn typed_help_names_its_page() {
        let typed = Options { typed: true, ..Options::default() };
        let ran = run_as("HC", FakeHost::default(), Default::default(), typed);
        let page = Command::Message { text: "HC: Command reference".into() };
        assert!(ran.commands.iter().any(|c| c.command == page), "{:?}", ran.commands);
    }
}
