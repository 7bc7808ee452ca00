use super::check as check_program;
use crate::syntax::read;
use crate::syntax::reader::shown::finding;
use kerf_program::settings::LinearUnit;

fn findings(text: &str, unit: LinearUnit) -> Vec<String> {
    let program = read("t.sbp".into(), text.replace('⏎', "\n").as_bytes());
    assert!(!program.has_errors(), "{:?}", program.diagnostics);
    check_program(&program, Some(unit)).iter().map(finding).collect()
}

/// Checks the findings of a text on a machine in inches; each begins with what is expected.
///
/// Notes of a missing unit guard are left out: nearly every snippet would have one.
#[track_caller]
fn check(text: &str, expected: &[&str]) {
    check_in(text, LinearUnit::Inch, expected);
}

#[track_caller]
fn check_in(text: &str, unit: LinearUnit, expected: &[&str]) {
    let mut found = findings(text, unit);
    found.retain(|f| !f.starts_with("W005"));
    let same = found.len() == expected.len()
        && found.iter().zip(expected).all(|(found, expected)| found.starts_with(expected));
    assert!(same, "{text}\n found {found:#?}\n expected {expected:#?}");
}

#[test]
fn jumps_to_missing_labels() {
    check("MX,1⏎GOTO Dnoe⏎Done:", &["W002 2:6+4 there is no label DNOE [did you mean DONE?]"]);
    check(
        "IF &a = \"\" THEN GOSUB Nowhere",
        &["W002 1:23+7 there is no label NOWHERE [a label is"],
    );
    check("GOTO Done⏎MX,1⏎DONE:", &["W018 2:1+4"]);
    check("ON INPUT(1,1) GOTO Hit⏎Hit:", &[]);
}

#[test]
fn lines_that_nothing_reaches() {
    check(
        "MX,1⏎END⏎⏎'note⏎MX,2⏎MX,3⏎A:⏎MX,4",
        &["W018 5:1+4 this line is never reached [line 2 goes"],
    );
    check("MX,1⏎END⏎A:⏎MX,2⏎RETURN", &[]);
    check("MX,1⏎GOTO A⏎END⏎MX,1⏎A:", &["W018 4:1+4 this line is never reached [line 3"]);
    check("IF &a=1 THEN END⏎MX,2⏎END", &[]);
    check("GOTO A⏎END⏎A:⏎MX,1⏎END", &[]);
}

#[test]
fn loops_that_never_move() {
    let endless = "W010 3:6+3 this loop over lines 1 to 3 never moves or ends";
    check("Top:⏎&n = 1⏎GOTO Top", &[endless]);
    check("Top:⏎GOTO Mid⏎Mid:⏎GOTO Top", &["W010 4:6+3"]);
    check("Top:⏎PRINT 1⏎IF &go = 1 THEN GOTO Top⏎&go = 1", &["W010 3:22+3"]);
    for quiet in [
        "Top:⏎MX,1⏎GOTO Top",
        "Top:⏎PAUSE 1⏎GOTO Top",
        "Top:⏎INPUT &a⏎GOTO Top",
        "&n=0⏎Top:⏎&n=&n+1⏎IF &n < 3 THEN GOTO Top",
        "Top:⏎IF %(51) = 0 THEN GOTO Top",
        "&n=0⏎Top:⏎&n=&n+1⏎IF &n > 3 THEN GOTO Out⏎GOTO Top⏎Out:",
        "ON INPUT(1,1) GOTO Hit⏎Top:⏎GOTO Top⏎Hit:",
        "Top:⏎GOSUB Step⏎GOTO Top⏎Step:⏎MX,1⏎RETURN",
        "Top:⏎IF RND > .9 THEN END⏎GOTO Top",
        "Top:⏎&n=1⏎GOTO Out⏎Out:",
    ] {
        check(quiet, &[]);
    }
}

#[test]
fn variables_that_nothing_sets() {
    check("MZ,&depth", &["W019 1:4+6 nothing in this file gives &DEPTH a value"]);
    check("&a=1⏎MX,&a+&b*2⏎MY,&b", &["W019 2:7+2 nothing in this file gives &B a value"]);
    for quiet in [
        "&depth = -.5⏎MZ,&depth",
        "INPUT \"Depth?\" &depth⏎MZ,&depth",
        "GOTO Set⏎Cut:⏎MZ,&depth⏎END⏎Set:⏎&depth = 1⏎GOTO Cut",
        "C#,90⏎MZ,&my_Zup",
        "FP,set.sbp⏎MZ,&depth",
        "IF &zup = \"\" THEN &zup = 0⏎MZ,&zup",
        "PRINT &nope",
        "MSGBOX(Go?,4,t)⏎IF &msganswer = Yes THEN MX,1",
        "GetUsrVal,&v⏎MX,&v",
        "OPEN \"d.txt\" FOR INPUT AS #1⏎INPUT #1,&x⏎MX,&x",
    ] {
        check(quiet, &[]);
    }
}

#[test]
fn counters_in_fractions() {
    check(
        "&i=0⏎L:⏎&i=&i+.1⏎MX,&i⏎IF &i = 1 THEN END⏎GOTO L",
        &["W009 5:4+6 &I counts in fractions and may miss this value"],
    );
    check("&z=0⏎L:⏎&z = &z - .3⏎MZ,&z⏎IF &z <> -3 THEN GOTO L", &["W009 5:4+8"]);
    for quiet in [
        "&i=0⏎L:⏎&i=&i+.1⏎MX,&i⏎IF &i < .95 THEN GOTO L",
        "&i=0⏎L:⏎&i=&i+1⏎MX,&i⏎IF &i = 20 THEN END⏎GOTO L",
        "&i=0⏎L:⏎&i=&i+.25⏎MX,&i⏎IF &i = 2 THEN END⏎GOTO L",
        "&i=.1⏎MX,&i⏎IF &i = .1 THEN END",
    ] {
        check(quiet, &[]);
    }
}

#[test]
fn unit_guards() {
    let note = |text: &str| findings(&format!("SO,1,1⏎{text}"), LinearUnit::Inch);
    let hint = "begin with IF %(25) = 1 THEN GOTO UNIT_ERROR (0 for files in mm)";
    let told = format!("W005 4:1+6 the file does not say whether it is in inches or mm [{hint}]");
    assert_eq!(note("'box⏎MZ,-1⏎M2,1,2"), [told]);
    assert!(note("MZ,-1⏎MY,2")[0].starts_with("W005 3:1+"), "Y alone cuts");
    for quiet in [
        "IF %(25)=1 THEN GOTO UNIT_ERROR⏎M3,1,2,-1⏎UNIT_ERROR:",
        "VD,,,1⏎M3,1,2,-1",
        "&u = %(25)⏎M3,1,2,-1",
        "M2,1,2",
        "MZ,-1⏎MZ,1⏎MX,1",
        "&a=1⏎M3,&a,&a,-1",
        "SR⏎M3,1,2,-1",
    ] {
        assert!(note(quiet).is_empty(), "{quiet} {:?}", note(quiet));
    }
}

#[test]
fn headers_in_another_unit() {
    let guard = "⏎IF %(25)=1 THEN GOTO UNIT_ERROR⏎M2,1,1⏎END⏎UNIT_ERROR:⏎CN,91";
    check(&format!("'SHOPBOT FILE IN INCHES{guard}"), &[]);
    check(
        &format!("'SHOPBOT FILE IN MM{guard}"),
        &[
            "W008 2:4+7 line 1 says mm, this lets only inches pass [%(25) is 0 for inches and 1 for mm]",
        ],
    );
    check(
        &format!("'UNITS:Inches{}", guard.replace("=1", "=0")),
        &["W008 2:4+7 line 1 says inches"],
    );
    check("'UNITS: MM⏎M2,1,1", &["W008 1:1+10 the file is in mm, the machine is set to inches"]);
    check_in("'UNITS: MM⏎M2,1,1", LinearUnit::Mm, &[]);
    check("'UNITS: MM⏎VD,,,1⏎M2,1,1", &[]);
    check("'Units are checked below⏎M2,1,1", &[]);
    check("M2,1,1⏎'UNITS: MM", &[]);
}

#[test]
fn jogs_below_the_surface() {
    check("JZ,-.5", &["W006 1:1+6 this jog goes below Z 0 at rapid speed"]);
    check("  J3,1,2,-.1 'down", &["W006 1:3+10"]);
    check("JZ,.5⏎J3,-1,-2,.2⏎MZ,-.5⏎SO,1,1⏎J2,-1,-1", &[]);
    check("SR⏎JZ,-.5", &[]);
    check("ON INPUT(1,1) GOTO Hit⏎JZ,-4⏎Hit:⏎ZZ", &[]);
}

#[test]
fn cutting_without_the_spindle() {
    check(
        "JZ,.5⏎MZ,-.25⏎M2,10,5⏎M2,0,0",
        &["W007 3:1+7 the file cuts but never turns the spindle on"],
    );
    check("M3,1,2,-.1", &["W007 1:1+10"]);
    for quiet in [
        "SO,1,1⏎MZ,-.25⏎M2,10,5",
        "C6⏎MZ,-.25⏎M2,10,5",
        "C#,6⏎MZ,-.25⏎M2,10,5",
        "FP,start.sbp⏎MZ,-.25⏎M2,10,5",
        "'Start the router⏎PAUSE⏎MZ,-.25⏎M2,10,5",
        "MZ,-.25⏎MZ,1⏎M2,10,5",
        "MZ,.25⏎M2,10,5",
        "M3 1,2,3",
    ] {
        check(quiet, &[]);
    }
    check("C90⏎MZ,-.25⏎M2,10,5", &["W007"]);
}

#[test]
fn a_called_file_relies_on_its_caller() {
    let program = read("t.sbp".into(), b"MZ,&depth\nM2,1,2\nM3,1,2,-1\nGOTO Nowhere");
    let found: Vec<String> = check_program(&program, None).iter().map(finding).collect();
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].starts_with("W002 4:6+7"), "{found:?}");
}

#[test]
fn speeds_in_the_old_order() {
    check(
        "VS, 1.25, .45, , 2.75, .80",
        &["W011 1:1+26 five values look like the order of older versions"],
    );
    check("VS,1,1,,,2", &[]);
    check("VS,3,3,3,3,18,18,18,18", &[]);
    check("VS,1,.5", &[]);
}

#[test]
fn plunges_that_go_up() {
    check("CG,,2,-2,0,-2,T,1,.25", &["W012 1:1+21 this plunge lifts the tool"]);
    check("CC,4,T,1,,,.1", &["W012"]);
    check("IF &a = \"\" THEN CP,4,1,1,T,1,,,.1", &["W012"]);
    check("CG,,2,-2,0,-2,T,1,-.25", &[]);
    check("CC,4", &[]);
    check("VC,,,,,,,,,,1⏎CC,4,T,1,,,.1", &[]);
}
