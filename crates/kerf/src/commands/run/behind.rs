//! The work after a run: commands that other software passed in meanwhile, and the end of the visit.

use super::options::MachineArgs;
use super::{FileLines, Show, VcdArgs, attended, editor, over};
use crate::args::RunArgs;
use crate::clock;
use crate::commands::protect;
use crate::exit::Exit;
use crate::report::Talk;
use crate::setup;
use crate::stop::Stop;
use crate::visit::Visit;
use anyhow::Result;
use kerf_control::Session;
use kerf_journal::Work;
use kerf_sbp::FileParameters;
use kerf_workspace::Workspace;
use kerf_workspace::command_passing;

/// Carries out what other software passed in while the file ran, and closes.
pub fn closes(
    mut exit: Exit,
    visit: &Visit,
    (session, workspace): (&mut Session, &mut Workspace),
    args: &MachineArgs,
    run: &RunArgs,
) -> Result<Exit> {
    let stop = Stop::listen()?;
    while let Some(command) = visit.command(session, workspace)? {
        let why_not = match run.place.machine.controller() {
            _ if stop.leaves() => Some("Kerf ends"),
            _ if exit != Exit::Good => Some("what ran before did not come to its end"),
            Some(_) => Some("on a controller nothing is carried out behind the file"),
            None => None,
        };
        match why_not {
            Some(why) => Visit::refuses(&command, why, session, workspace),
            None => exit = passed_in(command, session, workspace, args, run)?,
        }
    }
    visit.ends(session, workspace);
    Ok(exit)
}

/// Carries out a command that other software passed in while the file ran.
fn passed_in(
    command: String,
    session: &mut Session,
    workspace: &mut Workspace,
    args: &MachineArgs,
    run: &RunArgs,
) -> Result<Exit> {
    let work = Work::from(kerf_sbp::read_typed(command_passing::NAME.into(), &command));
    let mut options = setup::run_options(run, &session.memory.settings, false);
    (options.program.typed, options.program.file) = (true, FileParameters::default());
    options.started = Some(clock::started());
    options.opened = protect::given(&session.machine_is, args.password.as_deref())?;
    let machine = session.configuration();
    let show = Show {
        name: command_passing::NAME.into(),
        lines: 1,
        talk: Talk::all(),
        source: FileLines::of(&work),
        machine,
        editor: editor(workspace),
    };
    let vcd = VcdArgs::default();
    let again = MachineArgs { trace: None, picture: None, readings: None, vcd, ..args.clone() };
    attended(&again, run, show, setup::answers(run)?, None, |context| {
        let (summary, unkept) =
            over(session.run_on_record(work, options, None, workspace, context))?;
        Ok((summary, session, unkept))
    })
}
