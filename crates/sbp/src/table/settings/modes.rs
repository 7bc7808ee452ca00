//! Modes, and what becomes of locations, variables and values.

use crate::interp::{Context, Stop};
use crate::table::{CommandSpec, Group, Kind, ParamSpec, Stack};
use kerf_diag::Code;
use kerf_program::settings::{Distance, Mode};
use kerf_program::{AxisSet, Command};

/// A command of this menu without values.
const fn plain(
    letters: &'static str,
    name: &'static str,
    doc: &'static str,
    effect: crate::table::Effect,
) -> CommandSpec {
    CommandSpec::new(letters, name, Group::Settings, &[], Stack::Ends, doc, effect)
}

pub(super) static SA: CommandSpec = plain(
    "SA",
    "Set absolute",
    "From here on values of moves are locations, counted from 0.",
    |c, _| distance(c, Distance::Absolute),
);

pub(super) static SR: CommandSpec = plain(
    "SR",
    "Set relative",
    "From here on values of moves are distances from where the tool is.",
    |c, _| distance(c, Distance::Relative),
);

pub(super) static SM: CommandSpec = plain(
    "SM",
    "Set move/cut mode",
    "Commands drive the tool. After a preview everything is as it was before it. Without a controller \
     nothing moves: preview is offered.",
    |c, _| {
        c.leave_preview();
        if !c.core.options.preview && !c.host.is_connected() {
            let text = "not connected: nothing moves; SP shows files in preview".into();
            c.emit(Command::Message { text });
        }
        Ok(())
    },
);

pub(super) static SP: CommandSpec = plain(
    "SP",
    "Set preview mode",
    "Commands are drawn and change nothing: SM returns to where the tool really is. Given again in \
     preview it clears the picture.",
    |c, _| {
        if c.settings().mode == Mode::Preview {
            c.emit(Command::ClearPreview);
        } else {
            c.enter_preview();
        }
        Ok(())
    },
);

pub(super) static ST: CommandSpec = plain(
    "ST",
    "Set to table base",
    "Makes the working locations equal to the table base coordinates. Nothing moves.",
    |c, _| {
        c.core.frame.working_zero = c.core.frame.base_zero;
        c.core.working_aside = c.core.working_aside.and(Some(c.core.frame.base_zero));
        c.location_set(AxisSet::first(6), AxisSet::EMPTY);
        Ok(())
    },
);

pub(super) static SL: CommandSpec =
    plain("SL", "Clear variables", "Deletes all user variables.", |c, _| {
        c.core.variables.clear();
        Ok(())
    });

pub(super) static SV: CommandSpec = plain(
    "SV",
    "Set values permanent",
    "The values that would go back at the end of the part file stay as they are now: speeds, VI, VU \
     and limits.",
    |c, _| {
        if c.core.options.typed {
            let hint = "values set at the keyboard stay anyway";
            return Err(c.fail_at(c.span, Code::OnlyInFiles, "SV works only in part files", hint));
        }
        if c.core.options.protected {
            let hint = "give the password of the settings with the run";
            c.warn(
                Code::KeptProtected,
                "the settings are protected: these values end with the file",
                hint,
            );
            return Ok(());
        }
        c.core.kept = c.core.settings.clone();
        Ok(())
    },
);

pub(super) static SC: CommandSpec = CommandSpec::new(
    "SC",
    "End the stack",
    Group::Settings,
    &[ParamSpec::keep("Value", Kind::Whole).demanded().about("2, the only one there is.")],
    Stack::Ends,
    "SC,2 brings motion to rest and begins a new stack of moves (handbooks, Movement Blocks).",
    |c, a| {
        if a.whole(0) != Some(2) {
            return Err(c.fail_at(a.span(0), Code::OutOfRange, "only SC,2 is defined", ""));
        }
        c.emit(Command::EndStack);
        Ok(())
    },
);

fn distance(c: &mut Context<'_>, distance: Distance) -> Result<(), Stop> {
    c.change_settings(|s| s.distance = distance);
    Ok(())
}
