//! FabMo's dialect.

use super::rig::Rig;
use super::{press, typed};
use crate::testing::{FakeHost, Ran, run_as};
use crate::{Dialect, Interpreter, Options, Session, Status, read_as};
use kerf_program::{Answer, Axis, Button, Command, Feed, Sourced};

fn options() -> Options {
    Options { dialect: Dialect::Fabmo, ..Options::default() }
}

fn fabmo(text: &str) -> Ran {
    run_as(text, FakeHost::default(), Session::default(), options())
}

fn answered(text: &str, answers: &[Answer]) -> Ran {
    let host = FakeHost { answers: answers.to_vec(), ..FakeHost::default() };
    run_as(text, host, Session::default(), options())
}

impl Ran {
    #[track_caller]
    fn warns(&self, part: &str) {
        let warned =
            |s: &Sourced| matches!(&s.command, Command::Diagnostic(d) if d.message.contains(part));
        assert!(self.commands.iter().any(warned), "{:?}", self.commands);
    }
}

fn rig(text: &str) -> Rig {
    let text = text.split('⏎').map(str::trim).collect::<Vec<_>>().join("\n");
    let program = read_as("test.sbp".into(), text.as_bytes(), Dialect::Fabmo);
    assert!(!program.has_errors(), "{:?}", program.diagnostics);
    Rig::of(Interpreter::new(program, Session::default(), options()), FakeHost::default())
}

#[test]
fn a_probe_stops_where_its_input_goes_on() {
    let mut rig = rig("PZ,-2,.5,4 ⏎ ZZ ⏎ MZ,1");
    rig.read_ahead();
    let feed = rig.out.iter().find_map(|s| match &s.command {
        Command::Line(line) => Some(line.feed),
        _ => None,
    });
    assert_eq!((feed, rig.motion_count()), (Some(Feed::Path(12.7)), 1), "nothing is read ahead");
    rig.fires(4, 1, 1, [0.0, 0.0, -0.5]).finish().at(0.0, 0.0, 0.5);
}

#[test]
fn a_probe_that_touches_nothing_goes_on() {
    let mut rig = rig("PZ,-2,.5,4 ⏎ ON INPUT(3,1) &hit=1 ⏎ MX,1");
    rig.read_ahead().come_to_rest().read_ahead();
    assert_eq!(rig.interpreter.watches().count(), 1, "the probe is over");
    rig.finish().at(1.0, 0.0, -2.0);
}

#[test]
fn a_probe_comes_before_a_handler_of_the_same_input() {
    let mut rig = rig("ON INPUT(4,1) &hit=1 ⏎ P2,1,1,.5,4 ⏎ MX,3");
    rig.read_ahead().fires(4, 1, 1, [0.5, 0.5, 0.0]).finish().at(3.0, 0.5, 0.0);
    assert_eq!(rig.interpreter.variables().get("hit"), None);
}

#[test]
fn a_probe_whose_input_is_on_does_not_move() {
    let mut host = FakeHost::default();
    host.inputs[4] = true;
    let ran = run_as("PZ,-2,.5,4", host, Session::default(), options());
    ran.ends_at(0.0, 0.0, 0.0).warns("input 4 is on already");
    fabmo("PZ,-2,.5,13").fails_with("input must be 1-12");
}

#[test]
fn arrays_and_objects_are_families_of_variables() {
    fabmo("&t[1].x = 2⏎&i=1⏎&t[&i+1].x = 5⏎MX,&t[1].X⏎MY,&T[2].x").ends_at(2.0, 5.0, 0.0);
    fabmo("$atc.in = 3⏎$atc.in := 4⏎MX,$ATC.In").ends_at(3.0, 0.0, 0.0);
    fabmo("&p[].x = 2⏎MX,&p[0].x⏎MY,&p[mm].x").ends_at(2.0, 50.8, 0.0);
    fabmo("SU,1⏎&p[].x = 25.4⏎MX,&p[mm].x").ends_at(1.0, 0.0, 0.0);
    fabmo("MX,&none[1].x").fails_with("has no value");
    fabmo("&p[].x=1⏎MX,&p[].x").fails_with("only an assignment");
}

#[test]
fn dialogs_ask() {
    let text = "PAUSE \"Tool?\" + 3, &tool⏎MX,&tool";
    let ran = answered(text, &[typed("2")]);
    ran.ends_at(2.0, 0.0, 0.0);
    assert_eq!(ran.host.asked[0].text, "Tool?3");
    let ran = answered("DIALOG \"Go?\", CANCELTEXT=\"Quit\"⏎MX,1", &[press(Button::Cancel)]);
    ran.ended(Status::Stopped).ends_at(0.0, 0.0, 0.0);
    assert_eq!(ran.host.asked[0].text, "Go?\nCancel: Quit");
    fabmo("DIALOG \"wait\", TIMER=2⏎MX,1").ends_at(1.0, 0.0, 0.0);
}

#[test]
fn fail_ends_the_run_with_its_text() {
    fabmo("MX,1⏎FAIL \"stuck\"").ends_at(1.0, 0.0, 0.0).fails_at(2, "stuck");
}

#[test]
fn values_stand_in_another_order() {
    fabmo("VS,1,2,3,4,5,6,7⏎MX,%(71)").ends_at(1.0, 0.0, 0.0);
    fabmo("VA,,,1,,,,,,3⏎MX,%(3)⏎MY,%(9)").ends_at(1.0, 3.0, 1.0);
    fabmo("MX,%(106)").fails_with("not known here");
}

#[test]
fn sc_0_speaks_of_the_table_base_until_sc_1() {
    let before = "MX,2 ⏎ ZX ⏎ SC,0 ⏎ &a=%(1) ⏎ MX,3";
    let ran = fabmo(&format!("{before} ⏎ SC,1 ⏎ &b=%(1) ⏎ MX,-1"));
    assert_eq!([ran.variable("a"), ran.variable("b")], ["2", "1"]);
    assert_eq!(ran.session.position[Axis::X], 25.4);
    let kept = fabmo(before).session;
    assert_eq!(kept.position[Axis::X], 3.0 * 25.4);
    assert_eq!(kept.frame.working_zero[Axis::X], 50.8, "the run is over");
    let ran = fabmo("MX,2 ⏎ SC,0 ⏎ VA,5 ⏎ &a=%(1) ⏎ MX,3 ⏎ SC,1 ⏎ &b=%(1)");
    assert_eq!([ran.variable("a"), ran.variable("b")], ["2", "6"]);
    fabmo("MX,2 ⏎ ZX ⏎ SC,0 ⏎ SC,0 ⏎ SC,1 ⏎ MX,0 ⏎ &b=%(1)").ends_at(0.0, 0.0, 0.0);
}

#[test]
fn su_takes_its_unit_as_a_word() {
    for unit in ["mm", "1", "\"MM\"", "millimeters"] {
        fabmo(&format!("SU,{unit} ⏎ MX,25.4")).ends_at(1.0, 0.0, 0.0);
    }
    for unit in ["in", "0", "Inches"] {
        fabmo(&format!("SU,mm ⏎ SU,{unit} ⏎ MX,2")).ends_at(2.0, 0.0, 0.0);
    }
    fabmo("SU,feet").fails_at(1, "one of 0, IN");
}

#[test]
fn macros_lie_in_the_folder_of_the_profile_too() {
    let files = [("macros/macro_75.sbp", "MX,2"), ("Custom75.sbc", "MX,9")];
    let host =
        FakeHost { files: files.map(|(n, t)| (n.into(), t.into())).into(), ..FakeHost::default() };
    run_as("C75", host, Session::default(), options()).ends_at(2.0, 0.0, 0.0);
}
