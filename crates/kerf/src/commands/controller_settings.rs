//! Settings that a controller keeps by number, written by `kerf send`: `$120=500`.

use super::run::MachineArgs;
use crate::args::RunArgs;
use crate::controller;
use crate::exit::{Exit, Usage};
use crate::remote::Remote;
use crate::stop::Stop;
use crate::{out, setup};
use anyhow::{Result, anyhow, bail};
use kerf_workspace::Workspace;

/// Settings by their numbers, with the values that they are to have.
type Wanted = [(u16, String)];

/// Writes them into the controller of the machine, in their order, and tells of each; ends at one that is refused.
pub fn written(
    wanted: &Wanted,
    mut workspace: Workspace,
    args: &MachineArgs,
    run: &RunArgs,
) -> Result<Exit> {
    let number = wanted.first().map_or(0, |(number, _)| *number);
    let refused = |why: &str| {
        anyhow!(Usage(format!("${number} is a setting of a controller of grbl's family: {why}")))
    };
    let Some(name) = run.place.machine.controller() else {
        bail!(refused(
            "name one with --machine grbl:PORT; the simulated machine has none by number"
        ));
    };
    if name.is_linuxcnc() {
        bail!(refused("LinuxCNC has its settings in its INI file"));
    }
    if name.is_board() {
        bail!(refused(
            "a board with step queues has its settings in the machine's file (kerf set)"
        ));
    }
    let (mut session, _) = setup::session(&run.place, false, &mut workspace)?;
    let quiet = args.quiet();
    let ready = controller::ready(name, args.beginning(), &mut session, &mut workspace)?;
    let stop = Stop::listen()?;
    let mut done = Ok(());
    for (number, value) in wanted {
        match ready.keeps_setting(*number, value, &mut workspace, || stop.is_wanted()) {
            Ok(written) => tell(&written.sentence(), quiet),
            Err(why) => done = Err(anyhow!(why)),
        }
        if done.is_err() {
            break;
        }
    }
    ready.detach(&mut workspace);
    done.map(|()| Exit::Good)
}

/// Has a running server write them, and tells what it says of each; ends at one that is refused.
pub fn written_by_server(server: &Remote, wanted: &Wanted, quiet: bool) -> Result<Exit> {
    for (number, value) in wanted {
        tell(&server.keeps_setting(*number, value)?, quiet);
    }
    Ok(Exit::Good)
}

fn tell(sentence: &str, quiet: bool) {
    if !quiet {
        out::print(&format!("{sentence}\n"));
    }
}
