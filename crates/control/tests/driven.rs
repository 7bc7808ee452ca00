//! A run that somebody watches and drives from outside while it goes on.

use kerf_control::answers::Operator;
use kerf_control::files::MemoryDisk;
use kerf_control::{Company, Doing, Event, Pace, RunOptions, Session, Shelf, Summary, Wish};
use kerf_program::settings::{LinearUnit, MM_PER_INCH};
use kerf_program::{Axis, Question};
use kerf_sbp::Status;

/// Wants something at a moment of machine time, and notes where X is meanwhile.
#[derive(Default)]
struct Hand {
    wish: Option<(f64, Wish)>,
    /// Times and places of X, mm, each tenth of a second.
    seen: Vec<(f64, f64)>,
}

impl Pace for Hand {
    fn pass(&mut self, _: f64, to_s: f64) -> Option<(f64, Wish)> {
        self.wish.take_if(|(at_s, _)| *at_s <= to_s)
    }

    fn watch(&mut self, from_s: f64, to_s: f64, doing: &Doing<'_>) -> Option<(f64, Wish)> {
        if let Some(going) = doing.going {
            let tenths = (1..).map(|n| from_s + 0.1 * f64::from(n)).take_while(|t| *t < to_s);
            self.seen.extend(tenths.map(|t| (t, going.at(t).position[Axis::X])));
        }
        self.pass(from_s, to_s)
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
    pace: &mut Hand,
) -> (Summary, Session, Vec<Event>) {
    let mut session = Session::default();
    session.memory.settings.use_linear_unit(LinearUnit::Inch);
    let mut shelf = Shelf::in_memory(MemoryDisk::default());
    let program = kerf_sbp::read("part.sbp".into(), program.as_bytes());
    let mut events = Vec::new();
    let company = Company { sink: &mut events, operator, pace, machine: None };
    let summary = session.run(program, RunOptions::default(), &mut shelf, company);
    (summary, session, events)
}

#[test]
fn a_run_is_over_where_it_stands_and_nobody_is_asked() {
    let mut hand = Hand { wish: Some((1.0, Wish::End)), ..Hand::default() };
    let (summary, session, events) = run("MS,1\nMX,10\nMY,10\n", &mut (), &mut hand);
    assert_eq!(summary.status, Status::Ended);
    let x_in = session.memory.position[Axis::X] / MM_PER_INCH;
    assert!((0.5..2.0).contains(&x_in), "{x_in}");
    assert_eq!(session.memory.position[Axis::Y], 0.0);
    assert!(!events.iter().any(|e| matches!(e, Event::Ask(_))));
}

#[test]
fn whoever_watches_sees_the_machine_on_its_way() {
    let mut hand = Hand::default();
    run("MS,1\nMX,3\n", &mut (), &mut hand);
    assert!(hand.seen.len() > 20, "{:?}", hand.seen);
    assert!(hand.seen.windows(2).all(|w| w[0].0 < w[1].0 && w[0].1 < w[1].1));
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
        let wish = Wish::Input { number: 2, on: true };
        let mut hand = Hand { wish: Some((at_s, wish)), ..Hand::default() };
        let (summary, session, _) = run(&program, &mut (), &mut hand);
        let y_in = session.memory.position[Axis::Y] / MM_PER_INCH;
        assert_eq!((summary.status, y_in), (Status::Ok, 1.0), "{program}");
        assert!(session.memory.position[Axis::X] < 8.0 * MM_PER_INCH, "{program}");
    }
}
