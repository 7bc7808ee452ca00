//! Cuts that look for a switch or a plate which is not there.

use kerf_control::{Outcome, TextOptions, run_text};
use kerf_trace::Event;

/// Runs lines on a table of 96 by 48 inches that is 6 inches deep, from X 30, Y 20, Z 1.
fn on_a_table(lines: &str, options: TextOptions) -> Outcome {
    let program = format!("VL,0,96,0,48,-6,8\nJ3,30,20,1\n{lines}\n");
    run_text(&[("a.sbp", &program)], "a.sbp", options)
}

/// The lowest place of an axis that was reached, and what was asked.
fn reached(outcome: &Outcome, axis: usize) -> (f64, Vec<String>) {
    let (mut low, mut asked) = (f64::INFINITY, Vec::new());
    for event in &outcome.events {
        match event {
            Event::Move(made) => low = low.min([made.to.x, made.to.y, made.to.z][axis]),
            Event::Ask(ask) => asked.push(ask.text.clone()),
            _ => {}
        }
    }
    ((low * 1e4).round() / 1e4, asked)
}

#[test]
fn a_homing_cut_ends_behind_the_table_and_says_why() {
    let (low, asked) = reached(&on_a_table("C3", TextOptions::default()), 0);
    // The switch of the shipped variables lies half an inch behind zero; it is looked for half an inch further.
    assert_eq!(low, -1.0);
    let [said] = asked.as_slice() else { panic!("{asked:?}") };
    assert!(said.contains("switch of X on input 2") && said.contains("my_home_input_x"), "{said}");
}

#[test]
fn the_second_switch_is_named_too() {
    let found = TextOptions::default().input(2, 20.0, true);
    let (_, asked) = reached(&on_a_table("C3", found.clone()), 0);
    let (low, _) = reached(&on_a_table("C3", found), 1);
    let [said] = asked.as_slice() else { panic!("{asked:?}") };
    assert!(said.contains("switch of Y on input 3") && said.contains("my_home_input_y"), "{said}");
    assert_eq!(low, -1.0);
}

#[test]
fn a_plate_is_looked_for_no_lower_than_the_table_goes() {
    let (low, asked) = reached(&on_a_table("C2", TextOptions::default()), 2);
    assert_eq!(low, -1.0, "two inches from where it stood");
    let said = asked.last().unwrap();
    assert!(said.contains("plate on input 1") && said.contains("my_plate_input"), "{said}");
    let (low, _) = reached(&on_a_table("VL,,,,,-.25,8\nC2", TextOptions::default()), 2);
    assert_eq!(low, -0.25);
}
