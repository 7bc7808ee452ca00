//! The queue by itself: what goes out when, and what does not.

use kerf_driver_klipper::compress::Limits;
use kerf_driver_klipper::queue::{Change, Late, Lead, Piece, Queue, Refused, Release, Rules, Step};

const FREQUENCY: f64 = 12e6;
/// A second in ticks.
const S: u64 = 12_000_000;

/// An output with a watch of a second.
const WATCHED: Rules = Rules { watch: S, off: 0, at_once: true };

fn queue() -> Queue {
    let mut queue = Queue::new(vec![Limits { error: 60.0, least: 60, turn: 240 }], &[WATCHED], 100);
    queue.start(S, &[0]);
    queue
}

/// A piece of steps at an even pace from one clock to another, with a tail of some more.
fn piece(from: u64, to: u64) -> Piece {
    let even = |from: u64| {
        (1..=10)
            .map(move |k| Step { clock: (from + k * 10_000) as f64, forward: true, count: 1 })
            .collect()
    };
    Piece {
        steps: vec![even(from)],
        ends: to,
        tail: vec![even(to)],
        rests: to + S,
        ..Piece::default()
    }
}

fn steps(releases: &[Release]) -> usize {
    releases.iter().filter(|release| matches!(release, Release::Steps { .. })).count()
}

#[test]
fn a_step_that_is_due_already_is_not_sent() {
    let mut queue = queue();
    queue.offer(&piece(S, 2 * S)).expect("a piece");
    let released =
        queue.clone().release(S - 100_000, 1000, &Lead::new(FREQUENCY), true).expect("in time");
    assert_eq!(steps(&released), 1);
    assert_eq!(queue.release(S + 9_500, 1000, &Lead::new(FREQUENCY), true), Err(Late));
}

#[test]
fn nothing_goes_out_before_the_latches_are_armed() {
    let mut queue = queue();
    queue.offer(&piece(S, 2 * S)).expect("a piece");
    assert_eq!(queue.release(S - 100_000, 0, &Lead::new(FREQUENCY), false), Ok(vec![]));
}

#[test]
fn the_tail_goes_out_when_nothing_follows_and_nothing_follows_it() {
    let lead = Lead::new(FREQUENCY);
    let mut queue = queue();
    queue.offer(&piece(S, 2 * S)).expect("a piece");
    let mut other = queue.clone();
    let early = 2 * S - lead.full();
    assert_eq!(queue.release(S - lead.full(), 0, &lead, true).map(|r| steps(&r)), Ok(1));
    assert_eq!(queue.release(early, 0, &lead, true).map(|r| steps(&r)), Ok(0));
    assert_eq!(queue.release(2 * S - lead.least(), 0, &lead, true).map(|r| steps(&r)), Ok(2));
    assert!(queue.is_stopping() && queue.is_sent());
    assert_eq!(queue.offer(&piece(2 * S, 3 * S)), Err(Refused::Stopping));
    // With a piece behind it the tail of the first is never made.
    other.offer(&piece(2 * S, 3 * S)).expect("a piece");
    other.release(S - lead.full(), 0, &lead, true).expect("in time");
    other.release(2 * S - lead.full(), 0, &lead, true).expect("in time");
    assert!(!other.is_stopping());
    assert_eq!(other.counts(), [20]);
}

#[test]
fn whoever_may_be_silent_for_longer_has_motion_sent_earlier() {
    let check = |deadline_s: f64, least_s: f64| {
        let lead = Lead::new(FREQUENCY).of_deadline(deadline_s);
        assert_eq!(lead.least(), (least_s * FREQUENCY) as u64, "{deadline_s}");
    };
    check(0.03, 0.05);
    check(0.1, 0.05);
    check(2.0, 1.0);
    check(5.0, 1.0);
}

#[test]
fn what_was_not_sent_can_be_taken_back() {
    let lead = Lead::new(FREQUENCY);
    let mut queue = queue();
    queue.offer(&piece(S, 2 * S)).expect("a piece");
    queue.offer(&piece(2 * S, 3 * S)).expect("a piece");
    queue.release(S - lead.full(), 0, &lead, true).expect("in time");
    assert_eq!(queue.withdraw(), 2 * S);
    queue.offer(&piece(2 * S, 4 * S)).expect("another one");
    assert_eq!(queue.ends(), 4 * S);
}

#[test]
fn pieces_that_do_not_follow_are_refused_whole() {
    let mut queue = queue();
    let mut early = piece(S, 2 * S);
    early.steps[0][0].clock = S as f64 - 1.0;
    assert_eq!(queue.offer(&early), Err(Refused::Order));
    let mut late = piece(S, 2 * S);
    late.tail[0][9].clock = (4 * S) as f64;
    assert_eq!(queue.offer(&late), Err(Refused::Order));
    let changes = vec![Change { output: 0, clock: 3 * S, value: 1 }];
    assert_eq!(queue.offer(&Piece { changes, ..piece(S, 2 * S) }), Err(Refused::Order));
    assert_eq!(queue.offer(&Piece { ends: S, ..Piece::default() }), Err(Refused::Motors));
    assert_eq!(queue.offer(&piece(S, 2 * S)), Ok(()));
}

#[test]
fn counts_of_the_past_are_known_to_the_step() {
    let mut queue = queue();
    queue.offer(&piece(S, 2 * S)).expect("a piece");
    queue.release(S - 100_000, 0, &Lead::new(FREQUENCY), true).expect("in time");
    let at = |clock| queue.count_at(0, clock);
    assert_eq!(
        [at(S), at(S + 10_000), at(S + 45_000), at(2 * S)],
        [Some(0), Some(1), Some(4), Some(10)]
    );
}
