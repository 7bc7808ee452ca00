//! PRINT, PLAY, SHELL.

use super::{run_answered, typed};
use crate::Status;
use crate::testing::{FakeHost, run, run_with};
use kerf_program::{Command, ShellCall};

/// Checks what a program prints, line ends as `|`.
#[track_caller]
fn prints(text: &str, expected: &str) {
    let ran = run(text);
    ran.ended(Status::Ok);
    assert_eq!(ran.printed().replace('\n', "|"), expected, "{text}");
}

#[test]
fn sbp_io_print_window() {
    prints("PRINT \"Hello\"", "Hello|");
}

#[test]
fn sbp_io_print_comma() {
    prints("PRINT \"a\", \"b\", 3", "a     b     3|");
}

#[test]
fn sbp_io_print_comma_splits() {
    prints(
        "&firstvar = \"My number\" ⏎ PRINT &firstvar, \" = 123,456 \"",
        "My number      = 123     456 |",
    );
}

#[test]
fn sbp_io_print_comma_semierr() {
    run("PRINT \"a\", \"b\"; \"c\"").fails_at(1, "semicolon");
    prints("PRINT \"a\", \"b\";", "a     b");
}

#[test]
fn sbp_io_print_semi() {
    prints("&firstvar = \"My number\" ⏎ PRINT &firstvar; \" = 123,456 \"", "My number = 123,456 |");
}

#[test]
fn sbp_io_print_semi_comma() {
    prints("PRINT \"a\"; \"b\", \"c\"", "ab,c|");
}

#[test]
fn sbp_io_print_nolf() {
    prints("PRINT \"A\"; ⏎ PRINT \"B\"", "AB|");
    prints("&x=2 ⏎ PRINT &x; ⏎ PRINT \"B\"", "2B|");
}

#[test]
fn sbp_io_print_empty() {
    prints("PRINT ⏎ PRINT \"x\"", "|x|");
}

#[test]
fn sbp_io_print_undefined() {
    prints("PRINT &zz", "&zz|");
    prints("PRINT \"a \" & &Zz", "a &Zz|");
}

#[test]
fn print_waits_for_the_motion_before_it() {
    let host = FakeHost { busy: 3, ..FakeHost::default() };
    let ran = run_with("MX,1 ⏎ PRINT %(1) ⏎ MX,2", host, crate::Session::default());
    assert_eq!((ran.order().as_str(), ran.host.busy), ("1, print 1, 2", 0));
}

#[test]
fn sbp_io_play() {
    let ran = run("PLAY C:\\WINDOWS\\Media\\tada.wav ⏎ MX,1");
    assert_eq!(ran.order(), "sound C:\\WINDOWS\\Media\\tada.wav, 1");
    assert_eq!(run("&s=ta ⏎ PLAY \"x\" & &s & \".wav\"").order(), "sound xta.wav");
}

#[test]
fn sbp_io_play_pause() {
    assert_eq!(run("PLAY tada.wav ⏎ PAUSE 2 ⏎ MX,1").order(), "sound tada.wav, wait 2, 1");
}

#[test]
fn sbp_io_shell() {
    for line in ["SHELL, \"echo hi > out.txt\"", "SHELL \"echo hi > out.txt\""] {
        let call = ShellCall { line: "echo hi > out.txt".into(), display: 1, wait: false };
        assert_eq!(run(line).host.shells, [call], "{line}");
    }
}

#[test]
fn sbp_io_shell_vars() {
    for (line, expected) in [
        ("SHELL, \"echo \" & &n", "echo 5"),
        ("SHELL, \"echo &n\"", "echo 5"),
        ("SHELL, \"MyVars.exe [&]n = &n\"", "MyVars.exe &n = 5"),
        ("SHELL, \"echo &other\"", "echo &other"),
    ] {
        assert_eq!(run(&format!("&n=5 ⏎ {line}")).host.shells[0].line, expected, "{line}");
    }
}

#[test]
fn sbp_io_shell_display() {
    for display in [0, 1, 2, 3, 4, 6] {
        assert_eq!(run(&format!("SHELL, \"x\",{display}")).host.shells[0].display, display);
    }
    for display in ["5", "7", "-1", "1.5"] {
        let ran = run(&format!("SHELL, \"x\",{display}"));
        ran.fails_at(1, "display option");
        assert!(ran.host.shells.is_empty());
    }
}

#[test]
fn sbp_io_shell_async() {
    for (line, wait) in [
        ("SHELL, \"x\"", false),
        ("SHELL, \"x\",1,ASYNC", false),
        ("SHELL, \"x\",,SYNC", true),
        ("SHELL, \"x\",1,sync", true),
    ] {
        assert_eq!(run(line).host.shells[0].wait, wait, "{line}");
    }
}

#[test]
fn sbp_io_input_notext() {
    let ran = run_answered("INPUT &d ⏎ MX,&d", &[typed("2")]);
    ran.ended(Status::Ok).ends_at(2.0, 0.0, 0.0);
    assert_eq!(
        (ran.host.asked[0].title.as_str(), ran.host.asked[0].text.as_str()),
        ("test.sbp", "")
    );
}

#[test]
fn comments_are_messages_for_the_operator() {
    let ran = run("'Hello ⏎ '");
    assert_eq!(ran.commands.len(), 1);
    assert_eq!(ran.commands[0].command, Command::Message { text: "Hello".into() });
}
