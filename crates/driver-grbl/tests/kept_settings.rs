//! Settings that change while the controller is attached count from then on.

use crate::wire::Wire;
use kerf_driver_grbl::fake::{Board, Fake};
use kerf_machine::driver::planners::{Grbl, OwnPlanner};
use kerf_machine::driver::{Driver, Link, Signal, Wired};

/// A controller that is attached and stands.
fn attached() -> Link<Wire> {
    Link::new(Wire::new(Fake::default()))
}

/// It stands for so long, and is asked where it is now and then.
fn stands(link: &mut Link<Wire>, from_s: f64, seconds: f64) {
    for tick in 0..(seconds / 0.05) as u32 {
        let now_s = from_s + 0.05 * f64::from(tick);
        if tick % 4 == 0 {
            link.driver().signal(Signal::Ask, now_s);
        }
        link.poll(now_s);
    }
}

/// The acceleration of X and the junction deviation that it plans with, as the driver knows them.
fn plans_with(link: &mut Link<Wire>) -> (f64, f64) {
    match &link.driver().grbl.facts().unwrap().planner {
        Some(OwnPlanner::Grbl(Grbl { accel_mm_s2, junction_deviation_mm, .. })) => {
            (accel_mm_s2.0[0], *junction_deviation_mm)
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_kerf_writes_counts_from_then_on() {
    let mut link = attached();
    assert_eq!(plans_with(&mut link), (400.0, 0.01));
    link.driver().grbl.keeps_setting(120, "150").unwrap();
    link.driver().grbl.keeps_setting(11, "0.05").unwrap();
    stands(&mut link, 0.0, 1.0);
    assert_eq!(plans_with(&mut link), (150.0, 0.05));
    assert_eq!(link.driver().grbl.setting(120), Some("150.000"));
    assert!(link.driver().fake.lines.iter().filter(|line| *line == "$$").count() >= 3);
}

#[test]
fn what_somebody_at_the_controller_writes_is_seen_while_it_stands() {
    let mut link = attached();
    stands(&mut link, 0.0, 1.0);
    link.driver().fake.hear(b"$120=250\n$32=1\n", 7.0);
    drop(link.driver().fake.speak(7.0));
    stands(&mut link, 2.0, 12.0);
    assert_eq!(plans_with(&mut link).0, 250.0);
    // Its laser mode is on: a beam would burn along every jog.
    assert!(link.driver().grbl.facts().unwrap().no_spindle.contains("$32=0"));
    assert_eq!(link.driver().grbl.trouble(), None);
}

#[test]
fn reports_that_somebody_else_turned_off_are_turned_on_again() {
    let mut link = attached();
    stands(&mut link, 0.0, 1.0);
    link.driver().fake.hear(b"$10=0\n", 7.0);
    drop(link.driver().fake.speak(7.0));
    stands(&mut link, 2.0, 12.0);
    assert_eq!(link.driver().fake.is_set_to(10), 3.0);
}

#[test]
fn what_is_no_value_of_a_setting_is_refused_and_ends_nothing() {
    let mut link = attached();
    let check = |link: &mut Link<Wire>, number, value: &str, why: &str| {
        let told = link.driver().grbl.keeps_setting(number, value).unwrap_err();
        assert!(told.contains(why), "${number}={value}: {told}");
    };
    check(&mut link, 120, "fast", "$120 is a number, and 'fast' is none");
    check(&mut link, 22, "-1", "$22 is from 0");
    check(&mut link, 777, "1", "it has no setting $777");
    check(&mut link, 10, "0", "as Kerf needs it");
    // One that only the controller knows to refuse.
    link.driver().fake.keeps_settings = true;
    link.driver().grbl.keeps_setting(120, "150").unwrap();
    stands(&mut link, 0.0, 1.0);
    let told = link.driver().grbl.takes_refusal().unwrap();
    assert!(told.starts_with("$120=150: error 8"), "{told}");
    assert_eq!(plans_with(&mut link).0, 400.0);
    assert_eq!(link.driver().grbl.trouble(), None);
}

#[test]
fn a_board_that_describes_its_settings_is_asked_for_a_few_at_a_time_while_it_stands() {
    let mut link = Link::new(Wire::new(Fake::of(Board::hal(0), &[(341, 1.0)])));
    let described = |link: &mut Link<Wire>| {
        let lines = link.driver().fake.lines.iter();
        lines.filter(|line| line.starts_with("$SED=")).cloned().collect::<Vec<_>>()
    };
    stands(&mut link, 0.0, 9.0);
    assert!(
        described(&mut link).is_empty(),
        "a program that is started at once is not kept waiting"
    );
    let mut now_s = 9.0;
    while described(&mut link).is_empty() {
        now_s += 0.05;
        link.driver().signal(Signal::Ask, now_s);
        link.poll(now_s);
    }
    assert!(described(&mut link).len() <= 8, "{:?}", described(&mut link));
    stands(&mut link, now_s, 5.0);
    let told = link.driver().grbl.told_settings();
    let numbers: Vec<_> = told.iter().map(|it| format!("$SED={}", it.number)).collect();
    assert_eq!(described(&mut link), numbers, "each once");
    let of = |number| told.iter().find(|it| it.number == number).unwrap();
    assert_eq!(of(110).own, "How quick X may be.\nNOTE: rapid moves are.");
    assert!(of(341).does.contains("M6") && of(341).own.is_empty());
}

#[test]
fn a_setting_that_a_board_does_not_describe_ends_nothing() {
    // It says that it describes them, and knows no such line.
    let mut board = Board::grbl();
    board.tells.push("[NEWOPT:ENUMS,SED]".into());
    let mut link = Link::new(Wire::new(Fake::of(board, &[])));
    stands(&mut link, 0.0, 15.0);
    assert!(link.driver().fake.lines.iter().any(|line| line == "$SED=0"));
    let grbl = &mut link.driver().grbl;
    assert_eq!(grbl.takes_refusal(), None);
    assert_eq!(grbl.trouble(), None);
}

#[test]
fn characters_that_a_controller_obeys_at_once_are_in_no_value() {
    let mut link = attached();
    for value in ["1!", "~1", "1?", "1\u{18}", "1\n$X"] {
        let why = link.driver().grbl.keeps_setting(120, value).unwrap_err();
        assert!(why.contains("the controller obeys them"), "{value:?}: {why}");
    }
    stands(&mut link, 0.0, 1.0);
    assert_eq!(link.driver().grbl.setting(120), Some("400.000"));
}
