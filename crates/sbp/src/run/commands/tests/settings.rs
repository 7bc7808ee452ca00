//! S commands, by the rows of the ledger.
#![allow(clippy::unwrap_used, non_snake_case)]

use crate::testing::{FakeHost, Ran, check_as, rows, run, run_as, run_with};
use crate::{Options, Session};
use kerf_program::settings::Mode;
use kerf_program::{Answer, Button, Command, QuestionKind};

rows! {
    sbp_cmd_sa: "MX,3⏎SA⏎M2,3,7" => "at 3,7; 21=0";
    sbp_cmd_sr: "M2,3,7⏎SR⏎M2,3,7" => "at 6,14; 21=1", "M2,3,7⏎SR⏎M2,3,7⏎M2,3,7" => "at 9,21";
    a_session_starts_absolute: "" => "21=0; 22=0";
    sbp_cmd_sr_rounding: "SR⏎&n=0⏎L:⏎MX,.1⏎&n=&n+1⏎IF &n<10000 THEN GOTO L" => "1=1000; at 1000,0,0";
    sbp_cmd_st: "ZT⏎M3,5,4,1⏎Z3⏎ST" => "at 5,4,1; 1=5; 2=4; 3=1; moves 1";
    sbp_cmd_sl: "&a=1⏎SL⏎&b=&a" => "&b=", "&msganswer=OK⏎SL⏎&b=&msganswer" => "&b=";
    sbp_cmd_sc_other: "SC,1" => "error only SC,2 is defined", "SC" => "error only SC,2 is defined";
    leaving_preview_without_entering_it: "SM⏎MX,1" => "22=0; at 1,0,0";
    sbp_cmd_sp_track: "M2,1,1⏎SP⏎M2,5,5⏎&x=%(1)⏎&mode=%(22)⏎SM" => "&x=5; &mode=1; at 1,1,0; 1=1; 2=1; 22=0";
    sbp_cmd_sp_noeffect__in_the_language: "MX,1⏎SP⏎ZX⏎MX,4⏎VC,.5⏎VA,,9⏎SR⏎SM" => "at 1,0,0; base 1,0,0; 23=0.5; 21=1; 22=0";
    sbp_cmd_sp_start__in_the_language: "M3,1,1,2⏎VP,,,,,,,0⏎SP⏎&x=%(1)⏎&y=%(2)⏎&z=%(3)⏎SM" => "&x=0; &y=0; &z=2; at 1,1,2",
        "M2,1,1⏎SP⏎&x=%(1)" => "&x=1";
    sw_takes_seconds: "SW,-1" => "error 0 or greater", "SW,.5" => "no warning";
    sf_needs_its_value: "SF" => "error value expected", "SF,2" => "error one of 0, 1";
    outputs_are_1_to_12: "SO,13,1" => "error 1-12", "SO,0,1" => "error 1-12", "SO,12,1" => "139=1", "SO" => "error switch number expected";
    sbp_out_so: "SO,3,1" => "103=1", "SO,3,1⏎SO,3,0" => "103=0", "SO,3,1⏎SO,3" => "103=0";
    sbp_out_so4_manual: "SO,4,1" => "104=0; warning output 4 is automatic", "SO,4,-4⏎SO,4,1" => "104=1; 109=-4; no warning";
    modes_of_output_4: "" => "109=-1", "SO,4,-3" => "109=-3", "SO,3,-2" => "error modes of output 4", "SO,4,-5" => "error one of";
    tr_takes_speed_and_spindle: "TR" => "error speed expected", "TR,-1" => "error 0 or greater", "TR,12000,0" => "error 1-9";
    si_is_for_the_console: "SI" => "error needs the console";
}

fn commands(ran: &Ran) -> Vec<&Command> {
    ran.commands.iter().map(|c| &c.command).collect()
}

#[test]
fn sc_2_ends_the_stack_without_pull_up() {
    let ran = run("MX,5⏎SC,2⏎MX,10");
    let ends = commands(&ran).iter().position(|c| **c == Command::EndStack);
    assert_eq!(ends, Some(1), "{:?}", ran.commands);
    assert_eq!(ran.moves().len(), 2, "no pull-up");
}

#[test]
fn preview_given_again_clears_the_picture() {
    let clears = |text: &str| {
        run(text).commands.iter().filter(|c| c.command == Command::ClearPreview).count()
    };
    assert_eq!((clears("SP"), clears("SP⏎SP"), clears("SP⏎SM⏎SP")), (0, 1, 0));
}

#[test]
fn preview_is_told_with_its_mode() {
    let ran = run("SP⏎MX,1⏎SM");
    let modes = commands(&ran).into_iter().filter_map(|c| match c {
        Command::Settings(s) => Some(s.mode),
        _ => None,
    });
    assert_eq!(modes.collect::<Vec<_>>(), [Mode::Preview, Mode::Move]);
}

#[test]
fn a_run_that_ends_in_preview_can_return_later() {
    let first = run("M2,1,1⏎SP⏎M2,5,5").ends_at(5.0, 5.0, 0.0).session.clone();
    run_with("SM", FakeHost::default(), first).ends_at(1.0, 1.0, 0.0);
}

#[test]
fn sbp_cmd_sp_track__what_is_typed_stays_and_what_a_file_sets_does_not() {
    let typed = Options { typed: true, ..Options::default() };
    let files = [("a.sbp".into(), "VC,.75⏎VP,1⏎MX,3".replace('⏎', "\n"))].into();
    let host = FakeHost { files, ..FakeHost::default() };
    let text = "M2,1,1⏎SP⏎VC,.5⏎SR⏎ZX⏎VS,3⏎FP,a.sbp⏎&cutter=%(23)⏎SM";
    let ran = run_as(text, host, Session::default(), typed);
    ran.ends_at(1.0, 1.0, 0.0);
    assert_eq!(ran.variable("cutter"), "0.5");
    let session = ran.session.clone();
    assert_eq!(session.frame, Session::default().frame, "only locations return");
    let [cutter, distances, speed] = [23, 21, 71].map(|number| then(session.clone(), number));
    assert_eq!([cutter, distances, speed], ["0.5", "1", "3"]);
}

fn after(text: &str, options: Options) -> Session {
    run_as(text, FakeHost::default(), Session::default(), options).session
}

/// A system variable in the run after.
fn then(session: Session, number: u8) -> String {
    run_with(&format!("&v=%({number})"), FakeHost::default(), session).variable("v")
}

#[test]
fn sbp_cmd_sv() {
    let session = run("VS,4⏎SV⏎VS,6⏎MX,1").session;
    assert_eq!(then(session, 71), "4");
    assert_eq!(then(run("VS,4⏎VS,6⏎MX,1").session, 71), "2");
}

#[test]
fn sbp_cmd_sv_keyboard() {
    let typed = Options { typed: true, ..Options::default() };
    check_as(typed, "SV", "error only in part files");
}

#[test]
fn sbp_cmd_sv_limits() {
    for (file, kept) in [("SF,1⏎SV", true), ("SF,1", false), ("VL,,,,,,,,,1⏎SV", true)] {
        assert_eq!(run(file).session.settings.limits.check, kept, "{file}");
    }
    assert!(!run("VI,,,,,,,,,,,,0⏎SV").session.settings.driver.enabled);
    assert!(run("VI,,,,,,,,,,,,0").session.settings.driver.enabled);
    assert_eq!(then(run("VU,800⏎SV").session, 31), "800");
    assert_eq!(then(run("VU,800").session, 31), "400");
}

#[test]
fn typed_values_stay() {
    let typed = || Options { typed: true, ..Options::default() };
    assert_eq!(then(after("VS,4", typed()), 71), "4");
    assert!(after("SF,1", typed()).settings.limits.check);
}

#[test]
fn sw_without_a_value_returns_to_what_held_before() {
    let mut session = Session::default();
    session.settings.warning_s = 2.0;
    let file = "&before=%(24)⏎SW,0⏎SW,&before";
    let ran = run_with(file, FakeHost::default(), session);
    assert_eq!(ran.session.settings.warning_s, 2.0, "{:?}", ran.error);
}

#[test]
fn tr_gives_the_speed_to_the_spindle() {
    let speed = |text: &str| {
        run(text).commands.iter().find_map(|c| match c.command {
            Command::Spindle { number, rpm } => Some((number, rpm)),
            _ => None,
        })
    };
    assert_eq!(speed("TR,12000"), Some((1, 12000.0)));
    assert_eq!(speed("TR,18335,2"), Some((2, 18335.0)));
}

#[test]
fn sbp_io_spindle_dialog() {
    let asked = |text: &str, host: FakeHost| {
        let ran = run_with(text, host, Session::default());
        let kinds: Vec<_> = ran.host.asked.iter().map(|q| (q.kind, q.buttons.clone())).collect();
        (kinds, ran)
    };
    let question = (QuestionKind::Spindle, vec![Button::OK, Button::Cancel]);
    let (kinds, ran) = asked("SO,1,1⏎SO,1,0⏎SO,1,1", FakeHost::default());
    assert_eq!(kinds, [question], "asked once, then active");
    assert!(ran.host.outputs[1] && ran.host.stored["SpindleStatus"] == "1");

    let active = FakeHost {
        stored: [("SpindleStatus".to_string(), "1".to_string())].into(),
        ..FakeHost::default()
    };
    assert!(asked("SO,1,1", active).0.is_empty());
    assert!(asked("SO,2,1⏎SO,1,0", FakeHost::default()).0.is_empty(), "another output, off");

    let cancel = FakeHost { answers: vec![Answer::Button(Button::Cancel)], ..FakeHost::default() };
    let (_, ran) = asked("SO,1,1⏎MX,1", cancel);
    assert!(!ran.host.outputs[1] && ran.moves().is_empty(), "the file ends before it starts");

    let mut session = Session::default();
    session.settings.ask_spindle = false;
    assert!(run_with("SO,1,1", FakeHost::default(), session).host.asked.is_empty());
    let preview = Options { preview: true, ..Options::default() };
    let ran = run_as("SO,1,1", FakeHost::default(), Session::default(), preview);
    assert!(ran.host.asked.is_empty());
}

#[test]
fn the_keypad_takes_the_tool_where_the_operator_wants() {
    let host = FakeHost { strays_to: Some([25.4, 50.8, 0.0, 0.0, 0.0, 0.0]), ..Default::default() };
    let ran = run_with("SK,Move over the hole⏎&x=%(1)⏎SR⏎MX,1", host, Session::default());
    assert_eq!(ran.host.asked[0].kind, QuestionKind::Keypad);
    assert_eq!(ran.host.asked[0].text, "Move over the hole");
    assert_eq!(ran.variable("x"), "1");
    ran.ends_at(2.0, 2.0, 0.0);
    let preview = run("SP⏎SK⏎SM");
    assert!(preview.host.asked.is_empty());
}

#[test]
fn closing_the_keypad_switches_outputs_off_when_asked_to() {
    let outputs = |text: &str| run(text).host.outputs;
    assert!(outputs("SO,3,1⏎SK")[3]);
    assert!(!outputs("VD,,,,,,,,,,,,,,,,1⏎SO,3,1⏎SK")[3]);
}

#[test]
fn a_step_that_waits_for_the_spindle_question_has_no_effect() {
    let host = FakeHost { busy: 3, ..FakeHost::default() };
    let ran = run_with("MX,1⏎SO,1,1⏎SO,3,1", host, Session::default());
    let on: Vec<_> = commands(&ran)
        .into_iter()
        .filter(|c| matches!(c, Command::Output { on: true, .. }))
        .collect();
    assert_eq!(on.len(), 2, "{:?}", ran.commands);
}
