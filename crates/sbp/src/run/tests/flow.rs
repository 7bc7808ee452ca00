//! Sequence, jumps, subroutines, conditions, pauses.

use super::{press, run_answered, run_files};
use crate::testing::{FakeHost, run, run_with};
use crate::{Session, Status};
use kerf_program::{Button, Command, QuestionKind};

#[test]
fn sbp_flow_sequence() {
    run("MX,1 ⏎ MY,1").ended(Status::Ok).ends_at(1.0, 1.0, 0.0);
}

#[test]
fn sbp_flow_end() {
    run("MX,1 ⏎ END ⏎ MX,9").ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
}

#[test]
fn sbp_flow_end_nested() {
    let ran = run_files("FP,B.sbp ⏎ MY,2", &[("B.sbp", "MX,1 ⏎ END ⏎ MX,9")]);
    ran.ended(Status::Ok).ends_at(1.0, 2.0, 0.0);
}

#[test]
fn sbp_flow_endall() {
    for word in ["ENDALL", "END ALL"] {
        let ran = run_files("FP,B.sbp ⏎ MY,2", &[("B.sbp", &format!("MX,1 ⏎ {word} ⏎ MX,9"))]);
        ran.ended(Status::Ended).ends_at(1.0, 0.0, 0.0);
    }
}

#[test]
fn sbp_flow_exit_shopbot() {
    run("MX,1 ⏎ EXIT SHOPBOT ⏎ MX,9").ended(Status::Ended).ends_at(1.0, 0.0, 0.0);
}

#[test]
fn sbp_flow_goto() {
    run("&n=0 ⏎ Top: ⏎ &n=&n+1 ⏎ IF &n<3 THEN GOTO Top ⏎ GOTO Out ⏎ MX,9 ⏎ Out: ⏎ MX,&n")
        .ended(Status::Ok)
        .ends_at(3.0, 0.0, 0.0);
}

#[test]
fn a_line_that_jumps_to_itself_loops() {
    run("MX,1 ⏎ A: ⏎ GOTO A ⏎ MX,9").ended(Status::Limit).ends_at(1.0, 0.0, 0.0);
}

/// A loop in which nothing changes is told as that, long before the bound of lines.
#[test]
fn a_loop_in_which_nothing_changes_is_endless() {
    let endless = |text: &str| {
        let ran = run(text);
        ran.error.is_some_and(|error| error.message.contains("endless loop"))
    };
    assert!(endless("A: ⏎ GOTO A"));
    assert!(endless("MX,1 ⏎ A: ⏎ ' round ⏎ &x = 5 ⏎ IF &x > 3 THEN GOTO A"));
    assert!(endless("A: ⏎ GOTO B ⏎ B: ⏎ IF 1 = 2 THEN MX,1 ⏎ GOTO A"));
    for changes in ["MX,1 ⏎ MX,0", "&x = &x + 1", "&x = RND(1)", "&x = %(1)", "PRINT 1", "$x = 1"]
    {
        assert!(!endless(&format!("&x = 0 ⏎ A: ⏎ {changes} ⏎ GOTO A")), "{changes}");
    }
    assert!(!endless("ON INPUT(3,1) GOTO Hit ⏎ A: ⏎ GOTO A ⏎ Hit:"), "an input ends it");
    // As many lines may do nothing as a file has.
    let blank = " ⏎ ".repeat(300);
    run(&format!("&n = 0 ⏎ A: ⏎ {blank} &n = &n + 1 ⏎ IF &n < 3 THEN GOTO A ⏎ MX,&n"))
        .ended(Status::Ok)
        .ends_at(3.0, 0.0, 0.0);
}

#[test]
fn sbp_flow_goto_colon() {
    run("GOTO Out: ⏎ MX,9 ⏎ Out: ⏎ MX,1").ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
    let read = crate::read("t".into(), b"GOTO Out:\nOut:");
    let told: Vec<_> = read.diagnostics.iter().map(|d| (d.place.line, d.hint.as_str())).collect();
    assert_eq!(told, [(1, "write GOTO Out")]);
}

#[test]
fn sbp_flow_goto_missing() {
    run("MX,1 ⏎ GOTO Nowhere ⏎ MX,9").fails_at(2, "label NOWHERE not found").ends_at(1.0, 0.0, 0.0);
    run("IF 1 = 2 THEN GOTO Nowhere ⏎ MX,1").ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
}

#[test]
fn sbp_flow_gosub() {
    let ran = run("GOSUB A ⏎ MX,1 ⏎ END ⏎ A: ⏎ MY,2 ⏎ RETURN");
    ran.ended(Status::Ok).ends_at(1.0, 2.0, 0.0);
    assert_eq!(ran.moves()[0].1, [0.0, 2.0, 0.0]);
}

#[test]
fn sbp_flow_gosub_nested() {
    let nested = "GOSUB A ⏎ END ⏎ A: ⏎ MX,1 ⏎ GOSUB B ⏎ MY,1 ⏎ RETURN ⏎ B: ⏎ MZ,1 ⏎ RETURN";
    let ran = run(nested);
    let ends: Vec<_> = ran.moves().iter().map(|m| m.1).collect();
    assert_eq!(ends, [[1.0, 0.0, 0.0], [1.0, 0.0, 1.0], [1.0, 1.0, 1.0]]);
    let deep = "&n=0 ⏎ GOSUB A ⏎ MX,&n ⏎ END ⏎ A: ⏎ &n=&n+1 ⏎ IF &n<150 THEN GOSUB A ⏎ RETURN";
    run(deep).ended(Status::Ok).ends_at(150.0, 0.0, 0.0);
    run("A: ⏎ GOSUB A").fails_with("GOSUB nested deeper than 10000");
    let left =
        "&n=0 ⏎ A: ⏎ &n=&n+1 ⏎ GOSUB B ⏎ END ⏎ B: ⏎ IF &n<30000 THEN GOTO A ⏎ MX,&n ⏎ RETURN";
    run(left).ended(Status::Ok).ends_at(30000.0, 0.0, 0.0);
}

#[test]
fn sbp_flow_return_stray() {
    run("MX,1 ⏎ RETURN ⏎ MX,9").fails_at(2, "RETURN without GOSUB");
    let nested = run_files("GOSUB A ⏎ END ⏎ A: ⏎ FP,B.sbp ⏎ RETURN", &[("B.sbp", "RETURN")]);
    nested.fails_at(1, "RETURN without GOSUB");
}

#[test]
fn sbp_flow_fall_into_sub() {
    run("MX,1 ⏎ A: ⏎ MY,2 ⏎ RETURN").fails_at(4, "END before").ends_at(1.0, 2.0, 0.0);
    run("MX,1 ⏎ END ⏎ A: ⏎ MY,2 ⏎ RETURN").ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
}

#[test]
fn sbp_flow_if_command() {
    run("&c=3 ⏎ IF &c > 2 THEN MX,1 ⏎ IF &c < 2 THEN MY,1").ends_at(1.0, 0.0, 0.0);
}

#[test]
fn sbp_flow_if_assign() {
    run("&c=3 ⏎ IF &c = 3 THEN &d = 5 ⏎ MX,&d").ends_at(5.0, 0.0, 0.0);
}

#[test]
fn sbp_flow_if_goto() {
    run("IF 1 = 1 THEN GOTO L ⏎ MX,9 ⏎ L: ⏎ MX,1").ends_at(1.0, 0.0, 0.0);
}

#[test]
fn sbp_flow_if_other_actions() {
    run("IF 1=1 THEN GOSUB S ⏎ END ⏎ S: ⏎ MX,1 ⏎ IF 1=1 THEN RETURN ⏎ MX,9")
        .ended(Status::Ok)
        .ends_at(1.0, 0.0, 0.0);
    let mut host = FakeHost::default();
    host.inputs[1] = true;
    let ran = run_with("IF %(51)=1 THEN PAUSE 3", host, Session::default());
    assert_eq!(ran.order(), "wait 3");
    run("IF 1=1 THEN END ⏎ MX,9").ended(Status::Ok).ends_at(0.0, 0.0, 0.0);
    run("IF 1=1 THEN ENDALL ⏎ MX,9").ended(Status::Ended).ends_at(0.0, 0.0, 0.0);
    assert_eq!(run("IF 1=1 THEN PRINT \"a\"").printed(), "a\n");
}

#[test]
fn sbp_flow_if_ops() {
    run("IF %(1)+1 = 1 THEN MX,2").ends_at(2.0, 0.0, 0.0);
    run("&a=2 ⏎ IF &a*2 > 3 THEN MX,1").ends_at(1.0, 0.0, 0.0);
}

#[test]
fn sbp_flow_if_neq() {
    run("&u=1 ⏎ IF &u <> %(25) THEN MX,1").ends_at(1.0, 0.0, 0.0);
    run("&u=1 ⏎ IF &u <> 0 THEN MX,1 ⏎ IF &u <> 1 THEN MY,1").ends_at(1.0, 0.0, 0.0);
    run("&u=1 ⏎ IF &u <= 1 THEN MX,1 ⏎ IF &u >= 2 THEN MY,1").ends_at(1.0, 0.0, 0.0);
}

#[test]
fn sbp_flow_if_arrow() {
    // Files out there use it, so it is accepted with a warning that shows the usual spelling.
    for (condition, x) in
        [("&a => &b", 1.0), ("&b => &a", 0.0), ("&b =< &a", 1.0), ("&a =< &b", 0.0)]
    {
        let text = format!("&a=2 ⏎ &b=1 ⏎ IF {condition} THEN MX,1");
        run(&text).ended(Status::Ok).ends_at(x, 0.0, 0.0);
    }
    let program = crate::read("t".into(), b"IF &a => &b THEN MX,1");
    assert_eq!(program.diagnostics.len(), 1);
    assert!(!program.has_errors() && program.diagnostics[0].hint.contains(">="));
    // The dialect of the manuals refuses it, as they do.
    for condition in ["&a => &b", "&a =< &b"] {
        let text = format!("&a=2\n&b=1\nIF {condition} THEN MX,1");
        let strict = crate::read_as("t".into(), text.as_bytes(), crate::Dialect::Strict);
        let errors: Vec<_> = strict.diagnostics.iter().filter(|d| d.is_error()).collect();
        assert_eq!(errors.iter().map(|d| d.place.line).collect::<Vec<_>>(), [3], "{condition}");
    }
}

#[test]
fn old_spellings_are_errors_in_the_dialect_strict() {
    for line in [
        "IF &a => &b THEN MX,1",
        "IF &a == 1 THEN MX,1",
        "GOTO A:\nA:",
        "MSGBOX (\"now\"",
        "&a = 3*",
        "PRINT \"a\" &b",
        "A:\nA:",
        "&ALONE",
    ] {
        let read = |dialect| crate::read_as("t".into(), line.as_bytes(), dialect);
        let usual = read(crate::Dialect::Sb3);
        assert!(
            !usual.has_errors() && usual.diagnostics.len() == 1,
            "{line}: {:?}",
            usual.diagnostics
        );
        assert!(read(crate::Dialect::Strict).has_errors(), "{line}");
    }
    assert!(
        !crate::read_as("t".into(), b"IF &a >= 1 THEN MX,1", crate::Dialect::Strict).has_errors()
    );
}

#[test]
fn sbp_flow_if_andor() {
    run("&a=1 ⏎ &b=2 ⏎ IF (&a=1) AND (&b=2) THEN MX,1 ⏎ IF NOT (&a=2) THEN MY,1")
        .ends_at(1.0, 1.0, 0.0);
    run("&a=1 ⏎ &b=2 ⏎ IF &a=1 AND &b=2 THEN MX,1 ⏎ IF &a=2 OR &b=1 THEN MY,1")
        .ends_at(1.0, 0.0, 0.0);
}

#[test]
fn sbp_flow_if_string() {
    for word in ["\"yes\"", "Yes", "YES"] {
        run(&format!("&msganswer = Yes ⏎ IF &msganswer = {word} THEN MX,1")).ends_at(1.0, 0.0, 0.0);
    }
    run("IF &zup = \"\" THEN &zup=2 ⏎ MX,&zup").ends_at(2.0, 0.0, 0.0);
    run("&a = Yes ⏎ IF &a = No THEN MX,1").ends_at(0.0, 0.0, 0.0);
}

#[test]
fn sbp_flow_if_mixed() {
    run("&a=\"10\" ⏎ IF &a > 9 THEN MX,1").ends_at(1.0, 0.0, 0.0);
    let ran = run("&b=abc ⏎ IF &b > 9 THEN MX,1");
    ran.ends_at(1.0, 0.0, 0.0);
    assert!(ran.told().contains("compared as text"), "{}", ran.told());
}

#[test]
fn sbp_flow_if_nothen() {
    run("&a=1 ⏎ IF &a = 1 MX,1").fails_at(2, "THEN expected");
    run("&a=1 ⏎ ELSE ⏎ MX,1").fails_at(2, "unknown statement ELSE");
}

#[test]
fn sbp_flow_pause_timed() {
    for (text, seconds) in [("PAUSE 3", "3"), ("PAUSE .25", "0.25"), ("PAUSE,2", "2")] {
        let ran = run(&format!("MX,1 ⏎ {text} ⏎ MX,2"));
        assert_eq!(ran.order(), format!("1, wait {seconds}, 2"));
    }
    run("PAUSE -1").fails_at(1, "0 or more seconds");
}

#[test]
fn sbp_flow_pause_timed_msg() {
    let ran = run("'Finished the first Cut-Out ⏎ PAUSE 5");
    let texts: Vec<_> = ran.commands.iter().map(|c| &c.command).collect();
    assert_eq!(texts[0], &Command::Message { text: "Finished the first Cut-Out".into() });
    assert_eq!(texts[1], &Command::Wait { seconds: 5.0 });
    assert!(ran.host.asked.is_empty());
}

#[test]
fn sbp_flow_pause_plain() {
    let ran = run("MX,1 ⏎ PAUSE ⏎ MX,2");
    ran.ended(Status::Ok).ends_at(2.0, 0.0, 0.0);
    let [question] = &ran.host.asked[..] else { panic!("one question expected") };
    assert_eq!(question.kind, QuestionKind::Pause);
    assert_eq!((&question.buttons[..], question.default), (&[Button::OK, Button::Cancel][..], 0));
}

#[test]
fn sbp_flow_pause_plain_msg() {
    for (text, shown) in [
        ("' Is the Vacuum Pump on? ⏎ PAUSE", "Is the Vacuum Pump on?"),
        ("REM Ready ⏎ PAUSE", "Ready"),
        ("MX,1 ⏎ PAUSE", "Continue?"),
        ("PAUSE", "Continue?"),
        ("MX,1 'note ⏎ PAUSE", "Continue?"),
        ("'far ⏎ ⏎ PAUSE", "Continue?"),
        ("'first ⏎ 'second ⏎ IF 1=1 THEN PAUSE", "second"),
    ] {
        assert_eq!(run(text).host.asked[0].text, shown, "{text}");
    }
}

#[test]
fn sbp_flow_pause_cancel() {
    let ran = run_answered("MX,1 ⏎ PAUSE ⏎ MX,9", &[press(Button::Cancel)]);
    ran.ended(Status::Stopped).ends_at(1.0, 0.0, 0.0);
    assert!(ran.told().starts_with("2: terminated by the user"), "{}", ran.told());
    let mut host = super::host_with(&[("b.sbp", "PAUSE ⏎ MX,9")]);
    host.answers = vec![press(Button::Cancel)];
    run_with("FP,b.sbp ⏎ MX,9", host, Session::default())
        .ended(Status::Stopped)
        .ends_at(0.0, 0.0, 0.0);
}

#[test]
fn sbp_flow_pause_until() {
    let ran = run("'Wait ⏎ PAUSE UNTIL 5, 1 ⏎ MX,1");
    assert_eq!(ran.host.asked[0].until, Some((5, true)));
    assert_eq!(ran.host.asked[0].text, "Wait");
    ran.ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
    run_answered("PAUSE UNTIL 5,1 ⏎ MX,9", &[press(Button::Cancel)]).ended(Status::Stopped);
    run("PAUSE UNTIL 13,1").fails_at(1, "1 to 12");
    run("PAUSE UNTIL 5,2").fails_at(1, "1 or 0");
}

#[test]
fn sbp_flow_pause_until_0() {
    let ran = run("PAUSE UNTIL 5, 0 ⏎ MX,1");
    assert!(ran.host.asked.is_empty(), "it is open already");
    let mut host = FakeHost::default();
    host.inputs[5] = true;
    let ran = run_with("PAUSE UNTIL 5, 0 ⏎ MX,1", host, Session::default());
    assert_eq!(ran.host.asked[0].until, Some((5, false)));
}

#[test]
fn sbp_flow_warning_off() {
    assert_eq!(run("MX,1 ⏎ WARNING OFF ⏎ PAUSE 2 ⏎ MX,2").order(), "1, warning off, wait 2, 2");
}
