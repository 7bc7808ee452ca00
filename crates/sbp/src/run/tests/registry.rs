//! Values kept outside the program.

use super::{press, run_answered, run_files};
use crate::testing::{run, run_as, run_with};
use crate::{Options, Session, Status};
use kerf_program::{Button, QuestionKind};

#[test]
fn sbp_io_setusrval() {
    let first = run("SetUsrVal, hello");
    assert_eq!(first.host.stored["uValue"], "hello");
    let second = run_with("GetUsrVal, &v ⏎ PRINT &v", first.host, Session::default());
    assert_eq!(second.printed(), "hello\n");
}

#[test]
fn sbp_io_setusrval_var() {
    run("&a=2.5 ⏎ SetUsrVal, &a ⏎ GetUsrVal, &b ⏎ MX,&b").ends_at(2.5, 0.0, 0.0);
    run("SetUsrVal, 3 ⏎ GetUsrVal, &b ⏎ MX,&b").ends_at(3.0, 0.0, 0.0);
    assert_eq!(run("SetUsrVal, \"a b\"").host.stored["uValue"], "a b");
}

#[test]
fn sbp_io_setusrvalclrd() {
    let text = "GetUsrValClrd, &v ⏎ IF &v = \"\" THEN MX,1 ⏎ SetUsrValClrd, used ⏎ FP,n.sbp";
    let nested = [("n.sbp", "GetUsrValClrd, &seen")];
    let mut ran = run_files(text, &nested);
    ran.ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
    assert_eq!(ran.variable("seen"), "used");
    assert!(!ran.host.stored.contains_key("uValueClrd"));
    // What a run that never ended left behind is gone as well.
    ran.host.stored.insert("uValueClrd".into(), "stale".into());
    run_with(text, ran.host, Session::default()).ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
}

#[test]
fn sbp_io_getusrval() {
    let ran = run("GetUsrVal, &v ⏎ IF &v = \"\" THEN MX,1");
    ran.ends_at(1.0, 0.0, 0.0);
    assert_eq!(ran.variable("v"), "");
}

#[test]
fn sbp_io_getusrvalclrd() {
    assert_eq!(run("SetUsrValClrd, a ⏎ GetUsrValClrd, &v").variable("v"), "a");
    assert_eq!(run("GetUsrValClrd, &v").variable("v"), "");
}

#[test]
fn sbp_io_setspindle() {
    assert_eq!(run("SetSpindleStatus, 1").host.stored["SpindleStatus"], "1");
    assert_eq!(run("&on=0 ⏎ SetSpindleStatus, &on").host.stored["SpindleStatus"], "0");
    run("SetSpindleStatus, 2").fails_at(1, "0 or 1");
}

#[test]
fn sbp_io_getspindle() {
    assert_eq!(run("SetSpindleStatus, 1 ⏎ GetSpindleStatus, &s").variable("s"), "1");
    assert_eq!(run("GetSpindleStatus, &s").variable("s"), "0");
}

#[test]
fn sbp_io_spindle_dialog() {
    let ran = run("SO,1,1 ⏎ SO,1,0 ⏎ SO,1,1 ⏎ GetSpindleStatus, &s ⏎ SO,2,1");
    assert_eq!(ran.host.asked.len(), 1, "asked once, then it counts as active");
    assert_eq!((ran.host.asked[0].kind, ran.variable("s").as_str()), (QuestionKind::Spindle, "1"));
    assert!(run("SetSpindleStatus, 1 ⏎ SO,1,1").host.asked.is_empty());
    let again = run("SO,1,1 ⏎ SetSpindleStatus, 0 ⏎ SO,1,1");
    assert_eq!(again.host.asked.len(), 2);
    let ran = run_answered("SO,1,1 ⏎ MX,9", &[press(Button::Cancel)]);
    ran.ended(Status::Stopped).ends_at(0.0, 0.0, 0.0);
    let mut silent = Session::default();
    silent.settings.ask_spindle = false;
    assert!(run_with("SO,1,1", Default::default(), silent).host.asked.is_empty());
}

#[test]
fn sbp_io_getusrpath() {
    assert_eq!(run("GetUsrPath, &p").variable("p"), "/user");
}

#[test]
fn sbp_io_getapppath() {
    assert_eq!(run("GetAppPath, &p").variable("p"), "/app");
}

#[test]
fn sbp_io_getpartfilename() {
    let text = "GetPartFileName, &f ⏎ FP,b.sbp ⏎ GetPartFileName, &g ⏎ C6 ⏎ GetPartFileName, &h";
    let ran = run_files(text, &[("b.sbp", "MX,1"), ("custom6.sbc", "MX,2")]);
    let names = ["f", "g", "h"].map(|n| ran.variable(n));
    assert_eq!(names, ["test.sbp", "b.sbp", "b.sbp"]);
    // What is typed is no part file: the one of the last session is still told.
    let typed = Options { typed: true, ..Options::default() };
    let ran = run_as("GetPartFileName, &f", ran.host, Session::default(), typed);
    assert_eq!(ran.variable("f"), "b.sbp");
}

#[test]
fn sbp_io_regvalues_scope() {
    assert_eq!(run("SetUsrVal x ⏎ GetUsrVal &v").variable("v"), "x");
    run("GetUsrVal").fails_at(1, "argument is missing");
    run("GetUsrVal, v").fails_at(1, "variable is expected");
}
