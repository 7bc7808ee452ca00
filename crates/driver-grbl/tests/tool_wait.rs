//! A change of tools that the controller has begun by itself (`Tool` of grblHAL): jogs, their end, and going on.

use crate::wire::{Wire, run, to};
use kerf_driver_grbl::fake::{Board, Fake};
use kerf_machine::driver::{Axes, Driver, Link, LinkState, Order, Signal, TouchOff, Wired, Zero};

/// A controller that has begun to change the tool, while somebody moves it by hand.
fn changing() -> (Link<Wire>, f64) {
    changing_by(0.0)
}

/// The same, which changes tools by a mode.
fn changing_by(mode: f64) -> (Link<Wire>, f64) {
    let mut link = Link::new(Wire::new(Fake::of(Board::hal(0), &[(341, mode)])));
    let now_s = changes(&mut link, 0.0);
    (link, now_s)
}

/// It begins to change the tool; returns the time then.
fn changes(link: &mut Link<Wire>, now_s: f64) -> f64 {
    link.driver().fake.changes_tool();
    let now_s = looks(link, now_s, 0.5);
    link.driver().signal(Signal::ByHand, now_s);
    let now_s = looks(link, now_s, 0.5);
    assert!(link.driver().grbl.waits_for_tool());
    now_s
}

/// The tool is touched off at a plate of a height, where there is one; returns the time then, and what came of it.
fn touches(link: &mut Link<Wire>, plate_mm: Option<f64>, now_s: f64) -> (f64, TouchOff) {
    link.driver().fake.plate_mm = plate_mm;
    link.driver().signal(Signal::TouchOff, now_s);
    let now_s = looks(link, now_s, 0.5);
    assert_eq!(link.driver().grbl.touch_off(), Some(TouchOff::Going));
    let now_s = looks(link, now_s, 6.0);
    (now_s, link.driver().grbl.touch_off().unwrap())
}

/// Looks at it for a while; returns the time then.
fn looks(link: &mut Link<Wire>, from_s: f64, for_s: f64) -> f64 {
    let mut now_s = from_s;
    while now_s < from_s + for_s {
        now_s += 0.01;
        link.driver().signal(Signal::Ask, now_s);
        link.poll(now_s);
    }
    now_s
}

#[test]
fn it_takes_jogs_while_it_waits_and_goes_on_when_the_tool_is_in() {
    let (mut link, now_s) = changing();
    let order = Order::Jog { to: Axes::xyz(3.0, -2.0, 0.0), speed_mm_s: 20.0 };
    link.order(order);
    let took_s = run(&mut link, now_s, |_, _| {});
    let Wire { grbl, fake, .. } = link.driver();
    assert_eq!((fake.position().0[0], fake.position().0[1]), (3.0, -2.0));
    assert!(fake.waits_for_tool() && grbl.waits_for_tool(), "a jog is not its end");
    assert!(fake.lines.iter().any(|line| line.starts_with("$J=")), "{:?}", fake.lines);
    link.driver().signal(Signal::ToolIn, now_s + took_s);
    let now_s = looks(&mut link, now_s + took_s, 0.5);
    let Wire { grbl, fake, .. } = link.driver();
    assert!(!fake.waits_for_tool() && !grbl.waits_for_tool() && grbl.waits().is_none());
    // From then on it makes moves as ever.
    link.order(to(5.0, 0.0));
    run(&mut link, now_s, |_, _| {});
    let Wire { grbl, fake, .. } = link.driver();
    assert_eq!((grbl.trouble(), fake.position().0[0]), (None, 5.0));
}

#[test]
fn a_question_that_was_on_its_way_does_not_keep_it_from_jogs_and_is_answered_when_the_tool_is_in() {
    let mut link = Link::new(Wire::new(Fake::of(Board::hal(0), &[])));
    let now_s = looks(&mut link, 0.0, 1.0);
    link.driver().grbl.asks("$G").unwrap();
    // It begins to wait before the question is there.
    let now_s = changes(&mut link, now_s);
    link.order(Order::Jog { to: Axes::xyz(3.0, -2.0, 0.0), speed_mm_s: 20.0 });
    let took_s = run(&mut link, now_s, |_, _| {});
    let fake = &link.driver().fake;
    assert!(fake.waits_for_tool() && fake.position().0[0] == 3.0, "{:?}", fake.lines);
    link.driver().signal(Signal::ToolIn, now_s + took_s);
    let now_s = looks(&mut link, now_s + took_s, 1.0);
    let Wire { grbl, fake, .. } = link.driver();
    assert!(!fake.waits_for_tool() && grbl.has_said_all() && grbl.trouble().is_none());
    assert!(fake.lines.iter().any(|line| line == "$G"), "{:?}", fake.lines);
    let order = Order::Move { to: Axes::xyz(5.0, 0.0, 0.0), speed_mm_s: 20.0 };
    link.order(order);
    run(&mut link, now_s, |_, _| {});
    assert_eq!(link.driver().fake.position().0[0], 5.0);
}

#[test]
fn a_jog_that_is_ended_leaves_it_waiting() {
    let (mut link, now_s) = changing();
    link.order(Order::Jog { to: Axes::xyz(50.0, 0.0, 0.0), speed_mm_s: 20.0 });
    let now_s = looks(&mut link, now_s, 0.5);
    link.stop(now_s);
    let now_s = looks(&mut link, now_s, 1.0);
    let Wire { grbl, fake, .. } = link.driver();
    let x = fake.position().0[0];
    assert!(x > 2.0 && x < 20.0, "{x}");
    assert!(fake.waits_for_tool(), "a reset would have ended the change of tools");
    assert!(grbl.begin_anew() && grbl.trouble().is_none());
    link.restart(now_s);
    link.order(Order::Jog { to: Axes::xyz(1.0, 0.0, 0.0), speed_mm_s: 20.0 });
    run(&mut link, now_s, |_, _| {});
    assert_eq!((link.state(), link.driver().fake.position().0[0]), (LinkState::Up, 1.0));
}

#[test]
fn a_change_of_tools_is_given_up_by_a_reset_alone() {
    let (mut link, now_s) = changing();
    link.stop(now_s);
    let now_s = looks(&mut link, now_s, 1.0);
    let Wire { grbl, fake, .. } = link.driver();
    assert!(fake.waits_for_tool() && grbl.begin_anew());
    link.driver().signal(Signal::ToolOff, now_s);
    looks(&mut link, now_s, 1.0);
    let Wire { grbl, fake, .. } = link.driver();
    assert!(!fake.waits_for_tool() && grbl.begin_anew());
}

#[test]
fn nothing_but_jogs_is_made_meanwhile() {
    let (mut link, now_s) = changing();
    link.order(Order::Output { line: 1, on: true });
    looks(&mut link, now_s, 0.5);
    assert!(matches!(link.state(), LinkState::Refused(1, why) if why.contains("waits for a tool")));
    assert_eq!(link.driver().fake.spindle(), None);
}

#[test]
fn a_job_that_it_interrupts_goes_on_when_the_tool_is_in() {
    let mut link = Link::new(Wire::new(Fake::of(Board::hal(0), &[])));
    link.order(to(30.0, 0.0));
    let now_s = run(&mut link, 0.0, |_, _| {});
    link.driver().fake.changes_tool();
    let now_s = looks(&mut link, now_s, 0.5);
    // The next move of the job is no jog: it waits.
    link.order(to(60.0, 0.0));
    let now_s = looks(&mut link, now_s, 2.0);
    let Wire { grbl, fake, .. } = link.driver();
    assert!(grbl.waits_for_tool() && fake.position().0[0] == 30.0, "{:?}", fake.lines);
    link.driver().signal(Signal::ToolIn, now_s);
    looks(&mut link, now_s, 3.0);
    let Wire { grbl, fake, .. } = link.driver();
    assert_eq!((grbl.trouble(), fake.position().0[0]), (None, 60.0));
}

#[test]
fn one_that_waits_for_a_tool_from_the_start_is_driven() {
    let mut fake = Fake::of(Board::hal(0), &[]);
    fake.changes_tool();
    let mut link = Link::new(Wire::new(fake));
    looks(&mut link, 0.0, 1.0);
    let Wire { grbl, fake, .. } = link.driver();
    assert!(grbl.facts().is_some() && grbl.waits_for_tool() && fake.waits_for_tool());
}

#[test]
fn a_tool_is_touched_off_by_the_controller_and_goes_by_the_reference() {
    let (mut link, now_s) = changing_by(1.0);
    assert!(link.driver().grbl.waits().unwrap().contains("touch it off"));
    // It does not go on before.
    link.driver().signal(Signal::ToolIn, now_s);
    let now_s = looks(&mut link, now_s, 0.5);
    assert!(link.driver().fake.waits_for_tool());
    let (now_s, touched) = touches(&mut link, Some(-10.0), now_s);
    assert_eq!(touched, TouchOff::Done { is_reference: true });
    assert!(link.driver().fake.lines.iter().any(|line| line == "$TLR"));
    let lifted = link.driver().fake.position().0[2];
    assert!(lifted > -6.6 && lifted < -5.9, "{lifted}");
    link.driver().signal(Signal::ToolIn, now_s);
    let now_s = looks(&mut link, now_s, 0.5);
    let Wire { grbl, fake, .. } = link.driver();
    assert!(!fake.waits_for_tool() && grbl.touch_off().is_none() && grbl.trouble().is_none());
    // The next tool is longer.
    let now_s = changes(&mut link, now_s);
    let (_, touched) = touches(&mut link, Some(-7.5), now_s);
    assert_eq!(touched, TouchOff::Done { is_reference: false });
    let tool = link.driver().grbl.zeros().iter().find(|zero| zero.name == Zero::TOOL).cloned();
    assert!((tool.unwrap().at.0[2] - 2.5).abs() < 0.02);
}

#[test]
fn a_tool_that_touches_nothing_is_touched_off_again() {
    let (mut link, now_s) = changing_by(2.0);
    let (now_s, touched) = touches(&mut link, None, now_s);
    assert!(
        matches!(&touched, TouchOff::Failed(why) if why.contains("has touched nothing")),
        "{touched:?}"
    );
    let Wire { grbl, fake, .. } = link.driver();
    assert!(fake.waits_for_tool() && grbl.trouble().is_none() && grbl.waits_for_tool());
    // Jogs begin where it stands now.
    link.order(Order::Jog { to: Axes::default(), speed_mm_s: 20.0 });
    let took_s = run(&mut link, now_s, |_, _| {});
    assert_eq!(link.driver().fake.position().0[2], 0.0);
    let (_, touched) = touches(&mut link, Some(-5.0), now_s + took_s);
    assert!(matches!(touched, TouchOff::Done { .. }), "{touched:?}");
}

#[test]
fn a_stop_ends_a_touch_off_and_the_change_of_tools() {
    let (mut link, now_s) = changing_by(1.0);
    link.driver().signal(Signal::TouchOff, now_s);
    let now_s = looks(&mut link, now_s, 1.0);
    link.stop(now_s);
    looks(&mut link, now_s, 2.0);
    let Wire { grbl, fake, .. } = link.driver();
    let z = fake.position().0[2];
    assert!(z < -2.0 && z > -15.0, "{z}");
    assert!(grbl.begin_anew() && grbl.trouble().is_none() && !fake.waits_for_tool());
}

#[test]
fn nothing_is_touched_off_where_the_controller_does_not() {
    let (mut link, now_s) = changing();
    link.driver().signal(Signal::TouchOff, now_s);
    looks(&mut link, now_s, 0.5);
    let Wire { grbl, fake, .. } = link.driver();
    assert_eq!(grbl.touch_off(), None);
    assert!(!fake.lines.iter().any(|line| line == "$TPW"));
}
