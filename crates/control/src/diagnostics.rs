//! Values of a machine that stands, as a program would read them.

use crate::run_context::RunContext;
use crate::session::Session;
use crate::world::World;
use kerf_journal::RunOptions;
use kerf_part::Program;
use kerf_sbp::{SystemVariable, Value};
use kerf_trace::Event;
use kerf_workspace::Workspace;

/// Lists labels and values that help to find a fault (UD), and leaves nothing behind.
pub fn diagnostics(session: &Session, workspace: &mut Workspace) -> Vec<(String, String)> {
    let program = kerf_sbp::read_typed("UD".into(), "UD\n");
    let mut options = RunOptions::default();
    options.program.typed = true;
    let mut events: Vec<Event> = Vec::new();
    let context = RunContext {
        sink: &mut events,
        operator: &mut (),
        requests: &mut (),
        machine: crate::simulated(),
    };
    session.clone().run(Program::from(program), options, workspace, context);
    let told = events.iter().find_map(|event| match event {
        Event::Message { text, .. } => Some(text.clone()),
        _ => None,
    });
    let parted = |line: &str| line.split_once(": ").map(|(a, b)| (a.to_owned(), b.to_owned()));
    told.as_deref().unwrap_or_default().lines().filter_map(parted).collect()
}

/// Reads every system variable as it is now, in order of numbers.
pub fn system_variables(
    session: &Session,
    workspace: &mut Workspace,
) -> Vec<(SystemVariable, Value)> {
    let (mut sink, mut operator) = ((), ());
    let mut world = World::new(
        session.machine(Vec::new()),
        workspace,
        &mut sink,
        &mut operator,
        crate::simulated(),
    );
    let options = kerf_sbp::Options::default();
    let program = kerf_sbp::Program::default();
    let mut reader = kerf_sbp::Interpreter::new(program, session.memory.clone(), options);
    let read = |variable: SystemVariable| {
        world.settled = true;
        let value = reader.system_variable(&mut world, variable.number);
        (variable, value.unwrap_or(Value::Empty))
    };
    kerf_sbp::system_variables().map(read).collect()
}
