//! INPUT and MSGBOX.

use super::{press, run_answered, typed};
use crate::Status;
use crate::testing::{Ran, run};
use kerf_program::{Button, Question};

fn asked(ran: &Ran) -> &Question {
    &ran.host.asked[0]
}

#[test]
fn sbp_io_input_one() {
    run_answered("INPUT \"Depth?\" &d ⏎ MZ,&d", &[typed("-.25")]).ends_at(0.0, 0.0, -0.25);
    let again = run_answered("&d=7 ⏎ INPUT \"Depth?\" &d", &[typed(" deep ")]);
    assert_eq!(again.variable("d"), "deep");
}

#[test]
fn sbp_io_input_many() {
    let ran = run_answered("INPUT \"Enter X and Y\" &x, &y ⏎ M2,&x,&y", &[typed("3, 4")]);
    ran.ended(Status::Ok).ends_at(3.0, 4.0, 0.0);
    let names = |n: usize| (1..=n).map(|i| format!("&v{i}")).collect::<Vec<_>>().join(",");
    let ten = run_answered(&format!("INPUT \"x\" {}", names(10)), &[typed("1,2,3,4,5,6,7,8,9,10")]);
    assert_eq!(ten.variable("v10"), "10");
    run(&format!("INPUT \"x\" {}", names(11))).fails_at(1, "at most ten");
    let more = run_answered("INPUT \"xy\" &x, &y", &[typed("1,2,3")]);
    assert!(more.told().contains("only the first 2"), "{}", more.told());
}

#[test]
fn sbp_io_input_empty_one() {
    let ran = run_answered("INPUT \"?\" &d ⏎ IF &d = \"\" THEN MX,1", &[typed("")]);
    ran.ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
    assert_eq!(ran.variable("d"), "");
}

#[test]
fn sbp_io_input_missing() {
    for answer in ["3", "3,", ",4"] {
        let ran = run_answered("&x=1 ⏎ INPUT \"xy\" &x, &y ⏎ MX,9", &[typed(answer)]);
        ran.fails_at(2, "expected 2 values").ends_at(0.0, 0.0, 0.0);
        assert_eq!(ran.variable("x"), "1");
    }
}

#[test]
fn sbp_io_input_empty_many() {
    let ran = run_answered("&x=1 ⏎ INPUT \"xy\" &x, &y ⏎ MX,9", &[typed(" ")]);
    ran.ended(Status::Stopped).ends_at(0.0, 0.0, 0.0);
    assert_eq!((ran.variable("x").as_str(), ran.variable("y").as_str()), ("1", "(none)"));
}

#[test]
fn sbp_io_input_cancel() {
    let ran = run_answered("INPUT \"?\" &x ⏎ MX,9", &[press(Button::Cancel)]);
    ran.ended(Status::Stopped).ends_at(0.0, 0.0, 0.0);
    assert!(ran.told().starts_with("1: terminated by the user"), "{}", ran.told());
}

#[test]
fn sbp_io_input_dynamic() {
    let line = "INPUT \"You Entered - \" & &variable & \" Is this Correct? Y or N\"; &test1";
    let ran = run_answered(&format!("&variable=7 ⏎ {line}"), &[typed("Y")]);
    assert_eq!(asked(&ran).text, "You Entered - 7 Is this Correct? Y or N");
    assert_eq!(ran.variable("test1"), "Y");
}

#[test]
fn sbp_io_input_default() {
    let line = "&default=5 ⏎ INPUT \"Displaying default value - \": &default, &newvar";
    let ran = run(line);
    assert_eq!((asked(&ran).prefill.as_str(), ran.variable("newvar").as_str()), ("5", "5"));
    assert_eq!(run_answered(line, &[typed("6")]).variable("newvar"), "6");
}

#[test]
fn sbp_io_input_combined() {
    for between in [";:", "; :", ";: "] {
        let ran = run(&format!("&n=1 ⏎ &default=2 ⏎ INPUT \"Hole \" & &n{between}&default, &new"));
        assert_eq!((asked(&ran).text.as_str(), asked(&ran).prefill.as_str()), ("Hole 1", "2"));
        assert_eq!(ran.variable("new"), "2");
    }
}

#[test]
fn sbp_io_msgbox_basic() {
    let line = "MSGBOX ( Do you want to open the keypad?, YesNo, Start Keypad?)";
    let ran = run_answered(line, &[press(Button::Yes)]);
    let question = asked(&ran);
    assert_eq!(question.text, "Do you want to open the keypad?");
    assert_eq!(question.title, "Start Keypad?");
    assert_eq!(question.buttons, [Button::Yes, Button::No]);
    assert_eq!(ran.variable("msganswer"), "Yes");
}

/// Checks the words on the buttons of a style and which one ENTER presses.
#[track_caller]
fn shows(style: &str, words: &str, icon: u16, default: &str) {
    let ran = run(&format!("MSGBOX(t,{style},x)"));
    let question = asked(&ran);
    let shown: Vec<_> = question.buttons.iter().map(|b| b.word()).collect();
    assert_eq!((shown.join(" ").as_str(), question.icon), (words, icon), "{style}");
    assert_eq!((shown[question.default], ran.variable("msganswer").as_str()), (default, default));
}

#[test]
fn sbp_io_msgbox_buttons() {
    for (number, word, words, default) in [
        ("0", "okonly", "OK", "OK"),
        ("1", "OkCancel", "OK Cancel", "OK"),
        ("2", "ABORTRETRYIGNORE", "Abort Retry Ignore", "Abort"),
        ("3", "YesNoCancel", "Yes No Cancel", "Yes"),
        ("4", "yesno", "Yes No", "Yes"),
        ("5", "RetryCancel", "Retry Cancel", "Retry"),
    ] {
        shows(number, words, 0, default);
        shows(word, words, 0, default);
    }
}

#[test]
fn sbp_io_msgbox_icons() {
    for (number, word, icon) in [
        ("16", "Critical", 16),
        ("32", "question", 32),
        ("48", "Exclamation", 48),
        ("64", "Information", 64),
    ] {
        shows(number, "OK", icon, "OK");
        shows(word, "OK", icon, "OK");
    }
}

#[test]
fn sbp_io_msgbox_defaultbtn() {
    shows("276", "Yes No", 16, "No");
    shows("515", "Yes No Cancel", 0, "Cancel");
    shows("771", "Yes No Cancel", 0, "Yes");
}

#[test]
fn sbp_io_msgbox_invalid() {
    for style in ["7", "999", "Maybe", "", "-1", "1.5", "&nothing"] {
        shows(style, "OK", 0, "OK");
    }
}

#[test]
fn sbp_io_msgbox_comma() {
    let ran = run("MSGBOX(a, b, YesNo, t)");
    let question = asked(&ran);
    assert_eq!((question.text.as_str(), question.title.as_str()), ("a", "YesNo"));
    assert_eq!(question.buttons, [Button::OK]);
}

#[test]
fn sbp_io_msgbox_strings() {
    for line in [
        "&m=\"X is \" & %(1) ⏎ MSGBOX(&m,OKOnly,Info)",
        "MSGBOX(\"X is \" & %(1),0,Info)",
        "&x=2 ⏎ MSGBOX(X is &x,0,Info)",
    ] {
        assert_eq!(asked(&run(&format!("MX,2 ⏎ {line}"))).text, "X is 2", "{line}");
    }
    let ran = run("MSGBOX(The &axis axis [&]b,0,t)");
    assert_eq!(asked(&ran).text, "The &axis axis &b");
}

#[test]
fn sbp_io_msgbox_parens() {
    let ran = run("MSGBOX(Update Z? (Yes-Update: No-Keep ,YesNoCancel,\"\")");
    assert_eq!(asked(&ran).text, "Update Z? (Yes-Update: No-Keep");
    assert_eq!((asked(&ran).buttons.len(), asked(&ran).title.as_str()), (3, ""));
    let open = run("MSGBOX ( Cutting Tile T50, 0, Punch It Chewie!");
    assert_eq!(asked(&open).title, "Punch It Chewie!");
}

#[test]
fn sbp_io_msgbox_answers() {
    for (style, word) in
        [(0, "OK"), (1, "Cancel"), (2, "Abort"), (2, "Retry"), (2, "Ignore"), (3, "Yes"), (3, "No")]
    {
        let text = format!("MSGBOX(t,{style},x) ⏎ IF &msganswer = {word} THEN MX,1");
        let ran = run_answered(&text, &[typed(&word.to_lowercase())]);
        ran.ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
    }
    run_answered("MSGBOX(t,4,x) ⏎ MX,1", &[typed("Perhaps")]).fails_at(1, "answer Yes or No");
    run_answered("MSGBOX(t,4,x) ⏎ MX,1", &[press(Button::OK)]).fails_at(1, "no button of this box");
}

#[test]
fn a_message_box_does_not_end_the_run_when_cancelled() {
    let ran = run_answered("MSGBOX(t,1,x) ⏎ MX,1", &[press(Button::Cancel)]);
    ran.ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
}
