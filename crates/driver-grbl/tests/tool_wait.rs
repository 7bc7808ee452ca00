//! A change of tools that the controller has begun by itself (`Tool` of grblHAL): jogs, their end, and going on.

use crate::wire::{Wire, run, to};
use kerf_driver_grbl::fake::{Board, Fake};
use kerf_machine::driver::{Axes, Driver, Link, LinkState, Order, Signal, Wired};

/// A controller that has begun to change the tool, while somebody moves it by hand.
fn changing() -> (Link<Wire>, f64) {
    let mut link = Link::new(Wire::new(Fake::of(Board::hal(0), &[])));
    link.driver().fake.changes_tool();
    let now_s = looks(&mut link, 0.0, 0.5);
    link.driver().signal(Signal::ByHand, now_s);
    let now_s = looks(&mut link, now_s, 0.5);
    assert!(link.driver().grbl.waits_for_tool());
    (link, now_s)
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
