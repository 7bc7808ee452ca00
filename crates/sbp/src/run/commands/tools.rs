//! Virtual tools, those of Kerf and those that somebody added.

use crate::run::{Arguments, Context, Stop};
use kerf_diag::Code;
use kerf_program::{Command, HostError, ToolCall, no_such_tool};

/// Starts a tool with the values that are given.
pub(super) fn start(c: &mut Context<'_>, letter: char, a: &Arguments) -> Result<(), Stop> {
    c.settle()?;
    let last = (0..a.len()).rev().find(|n| a.given(*n)).map_or(0, |n| n + 1);
    let value = |n: usize| a.text(n).map_or(String::new(), |text| text.trim().to_owned());
    let arguments = (0..last).map(value).collect::<Vec<_>>().join(", ");
    match c.host.tool(&ToolCall { letter, arguments }) {
        Ok(notes) => {
            let message = |text: String| Command::Message { text: text.into() };
            notes.into_iter().for_each(|note| c.emit(message(note)));
            Ok(())
        }
        Err(HostError::NotFound(what)) if what == no_such_tool(letter) => {
            let hint = "tools are added in virtualtools.ini, in the data folder";
            Err(c.fail_at(c.span, Code::NotSupported, what, hint))
        }
        Err(error) => Err(c.refused(error)),
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::{FakeHost, run_with};
    use crate::{Session, testing::run};

    #[test]
    fn tools_get_what_stands_behind_their_letters() {
        let host = FakeHost { tools: "CQ".into(), ..FakeHost::default() };
        let ran = run_with(
            "&some_value=7⏎TC, 1500, small, 2⏎TQ, &some_value⏎TQ",
            host,
            Session::default(),
        );
        assert!(ran.error.is_none(), "{:?}", ran.error);
        assert_eq!(ran.host.called, ["C:1500, small, 2", "Q:7", "Q:"]);
    }

    #[test]
    fn letters_without_a_tool_are_told() {
        run("MX,1⏎TQ,1").fails_with("no such tool: TQ");
        run("TZ").fails_with("virtualtools.ini");
    }
}
