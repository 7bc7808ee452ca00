//! A run that somebody watches and drives from outside while it goes on.

use kerf_control::answers::Operator;
use kerf_control::{OperatorRequest, Requests, RunContext, Session};
use kerf_files::MemoryDisk;
use kerf_journal::RunOptions;
use kerf_program::settings::{LinearUnit, MM_PER_INCH};
use kerf_program::{Axis, Question};
use kerf_sbp::Status;
use kerf_trace::{Doing, Event, Sink, Summary};
use kerf_workspace::Workspace;

/// Asks for something at a moment of machine time.
#[derive(Default)]
struct Hand {
    request: Option<(f64, OperatorRequest)>,
}

impl Requests for Hand {
    fn take(&mut self, _: f64, to_s: f64) -> Option<(f64, OperatorRequest)> {
        self.request.take_if(|(at_s, _)| *at_s <= to_s)
    }
}

/// Notes where X is, mm, each tenth of a second.
#[derive(Default)]
struct Onlooker(Vec<(f64, f64)>);

impl Sink for Onlooker {
    fn event(&mut self, _: &Event) {}

    fn under_way(&mut self, doing: &Doing<'_>, from_s: f64, to_s: f64) {
        if let Some(going) = doing.going {
            let tenths = (1..).map(|n| from_s + 0.1 * f64::from(n)).take_while(|t| *t < to_s);
            self.0.extend(tenths.map(|t| (t, going.at(t).position[Axis::X])));
        }
    }
}

/// Stops the machine instead of answering.
struct Refuses;

impl Operator for Refuses {
    fn answer(&mut self, _: &Question, _: u32) -> Option<String> {
        None
    }

    fn gives_up(&self) -> bool {
        true
    }
}

fn run(
    program: &str,
    operator: &mut dyn Operator,
    hand: &mut Hand,
) -> (Summary, Session, Vec<Event>) {
    let mut events = Vec::new();
    let (summary, session) = run_seen(program, operator, hand, &mut events);
    (summary, session, events)
}

fn run_seen(
    program: &str,
    operator: &mut dyn Operator,
    requests: &mut Hand,
    sink: &mut dyn Sink,
) -> (Summary, Session) {
    let mut session = Session::default();
    session.memory.settings.use_linear_unit(LinearUnit::Inch);
    let mut workspace = Workspace::in_memory(MemoryDisk::default());
    let program = kerf_sbp::read("part.sbp".into(), program.as_bytes());
    let context = RunContext { sink, operator, requests, machine: kerf_control::simulated() };
    let summary = session.run(program, RunOptions::default(), &mut workspace, context);
    (summary, session)
}

#[test]
fn a_run_is_over_where_it_stands_and_nobody_is_asked() {
    let mut hand = Hand { request: Some((1.0, OperatorRequest::End)) };
    let (summary, session, events) = run("MS,1\nMX,10\nMY,10\n", &mut (), &mut hand);
    assert_eq!(summary.status, Status::Ended);
    let x_in = session.memory.position[Axis::X] / MM_PER_INCH;
    assert!((0.5..2.0).contains(&x_in), "{x_in}");
    assert_eq!(session.memory.position[Axis::Y], 0.0);
    assert!(!events.iter().any(|e| matches!(e, Event::Ask(_))));
}

#[test]
fn whoever_watches_sees_the_machine_on_its_way() {
    let mut onlooker = Onlooker::default();
    run_seen("MS,1\nMX,3\n", &mut (), &mut Hand::default(), &mut onlooker);
    let seen = onlooker.0;
    assert!(seen.len() > 20, "{seen:?}");
    assert!(seen.windows(2).all(|w| w[0].0 < w[1].0 && w[0].1 < w[1].1));
}

#[test]
fn a_stop_instead_of_an_answer_ends_the_run_and_the_default_does_not_count() {
    let (summary, session, _) =
        run("INPUT \"how far\" &x\nMX,5\n", &mut Refuses, &mut Hand::default());
    assert_eq!(summary.status, Status::Stopped);
    assert_eq!(session.memory.position[Axis::X], 0.0);
}

/// A switch that somebody moves counts from that moment, whether the machine moves or waits.
#[test]
fn a_switch_that_is_moved_while_the_program_waits_is_seen_by_it() {
    for (program, at_s) in [("PAUSE 2\nMX,9", 1.0), ("PAUSE 2\nMX,9", 0.0), ("MX,9\nMX,0", 1.0)] {
        let program = format!("ON INPUT(2,1) GOTO HIT\n{program}\nEND\nHIT:\nMY,1\n");
        let request = OperatorRequest::Input { number: 2, on: true };
        let mut hand = Hand { request: Some((at_s, request)) };
        let (summary, session, _) = run(&program, &mut (), &mut hand);
        let y_in = session.memory.position[Axis::Y] / MM_PER_INCH;
        assert_eq!((summary.status, y_in), (Status::Ok, 1.0), "{program}");
        assert!(session.memory.position[Axis::X] < 8.0 * MM_PER_INCH, "{program}");
    }
}
