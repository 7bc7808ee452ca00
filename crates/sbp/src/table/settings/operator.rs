//! The commands that hand over to the operator.

use crate::interp::{Arguments, Context, Stop};
use crate::table::{CommandSpec, Group, Kind, ParamSpec, Stack};
use kerf_diag::Code;
use kerf_program::settings::Mode;
use kerf_program::{AxisSet, Button, Command, QuestionKind};

pub(super) static SI: CommandSpec = CommandSpec::new(
    "SI",
    "Send lines",
    Group::Settings,
    &[],
    Stack::Ends,
    "Opens a box for a few lines that are run at once. In a part file, write the lines themselves.",
    |c, _| {
        let hint = "a file has no need of it: write the lines here";
        Err(c.fail_at(c.span, Code::NotSupported, "SI needs the console", hint))
    },
);

pub(super) static SK: CommandSpec = CommandSpec::new(
    "SK",
    "Keypad",
    Group::Settings,
    &[ParamSpec::keep("Message", Kind::Text).about("What the operator is asked to do.")],
    Stack::Ends,
    "Lets the operator move the tool by hand controls; the file goes on when the keypad is closed. \
     In preview it does not open.",
    keypad,
);

fn keypad(c: &mut Context<'_>, a: &Arguments) -> Result<(), Stop> {
    if c.core.options.preview || c.settings().mode == Mode::Preview {
        c.emit(Command::Message { text: "The keypad does not open in preview.".into() });
        return Ok(());
    }
    let text = a.text(0).unwrap_or_default();
    let question = c.question(QuestionKind::Keypad, &*text, &[Button::OK]);
    c.ask(&question)?;
    c.take_machine_position(AxisSet::first(6));
    if c.settings().display.keypad_auto_off {
        for number in 1..=12 {
            if c.host.output(number) {
                c.emit(Command::Output { number, on: false });
            }
        }
    }
    Ok(())
}
