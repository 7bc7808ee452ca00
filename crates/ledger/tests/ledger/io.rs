//! Files of the user, questions and what is shown: what needs files, a clock or several runs.

use kerf_ledger::{Run, run, sbp};

/// Runs with a file `data.txt`.
fn reading(data: &str, program: &str) -> Run {
    let open = "OPEN \"data.txt\" FOR INPUT AS #1";
    sbp(&format!("{open} ⏎ {program}")).file("data.txt", data).run()
}

#[test]
fn sbp_io_open_output() {
    let write = "OPEN \"myfile.sbp\" FOR OUTPUT as #1 ⏎ WRITE #1; \"A\" ⏎ CLOSE #1";
    let run = sbp(write).after(write).run();
    assert_eq!(run.file("myfile.sbp"), "A\n");
}

#[test]
fn sbp_io_open_append() {
    let append = "OPEN \"out.txt\" FOR APPEND AS #1 ⏎ WRITE #1; \"B\"";
    assert_eq!(sbp(append).file("out.txt", "A\n").run().file("out.txt"), "A\nB\n");
    assert_eq!(run(append).file("out.txt"), "B\n");
}

#[test]
fn sbp_io_open_relative() {
    let open = |slash: char| {
        sbp(&format!("OPEN \"sub{slash}out.txt\" FOR OUTPUT AS #1 ⏎ WRITE #1; \"A\""))
            .file("sub/other.txt", "")
            .run()
    };
    assert_eq!(open('\\').file("sub/out.txt"), "A\n");
    assert_eq!(open('/').file("sub/out.txt"), "A\n");
    // A folder that is not there yet is made, as the tool changers of real machines need it; read is none.
    let made = run("OPEN \"none\\now\\out.txt\" FOR OUTPUT AS #1 ⏎ WRITE #1; \"A\"");
    assert_eq!(made.file("none/now/out.txt"), "A\n");
    let named = run("OPEN \"C:\\SbParts\\Now\\x.txt\" FOR APPEND AS #1 ⏎ WRITE #1; \"A\"");
    assert_eq!(named.file("Now/x.txt"), "A\n");
    run("OPEN \"none\\out.txt\" FOR INPUT AS #1").status("failed");
    run("OPEN \"..\\none\\out.txt\" FOR OUTPUT AS #1").status("failed");
}

#[test]
fn sbp_io_open_variable() {
    let run = run("&f=\"out.txt\" ⏎ OPEN &f FOR OUTPUT AS #2 ⏎ WRITE #2; \"A\"");
    assert_eq!(run.file("out.txt"), "A\n");
}

#[test]
fn sbp_io_close_all() {
    let run = run("OPEN \"a.txt\" FOR OUTPUT AS #1 ⏎ OPEN \"b.txt\" FOR OUTPUT AS #2 ⏎ \
         WRITE #1; \"x\" ⏎ WRITE #2; \"y\" ⏎ CLOSE ⏎ WRITE #2; \"z\"");
    run.fails(6, "F003");
    assert_eq!(run.file("a.txt") + &run.file("b.txt"), "x\ny\n");
}

#[test]
fn sbp_io_close_auto() {
    for end in ["END", "ENDALL", "MX,&none"] {
        let run = run(&format!("OPEN \"out.txt\" FOR OUTPUT AS #1 ⏎ WRITE #1; \"A\" ⏎ {end}"));
        assert_eq!(run.file("out.txt"), "A\n", "{end}");
    }
}

#[test]
fn sbp_io_inputfile() {
    reading("1, abc\n2\n", "INPUT #1, &a, &b ⏎ INPUT #1, &c ⏎ PRINT &a;&b;&c").prints(&["1abc2"]);
}

#[test]
fn sbp_io_print_nolf() {
    run("PRINT \"A\"; ⏎ PRINT \"B\"").prints(&["AB"]);
    run("&x=1 ⏎ PRINT &x; ⏎ PRINT \"B\"").prints(&["1B"]);
}

#[test]
fn sbp_io_input_default() {
    run("&default=5 ⏎ INPUT \"Displaying default value - \": &default, &newvar ⏎ MX,&newvar")
        .ends_at([5.0])
        .asks(&["Displaying default value - "]);
}

#[test]
fn arithmetic_that_is_typed_into_input_is_calculated_where_a_number_is_needed() {
    let asks = "INPUT \"How deep?\" &d ⏎ MZ,-&d ⏎ IF &d > .5 THEN MX,&d*2 ⏎ MY,&d ⏎ PRINT &d";
    sbp(asks).answers(&["3/4"]).run().ends_at([1.5, 0.75, -0.75]).prints(&["3/4"]);
    sbp(asks).answers(&["12+11/16"]).run().ends_at([25.375, 12.6875, -12.6875]);
    sbp("INPUT \"X, Y\" &x, &y ⏎ M2,&x,&y").answers(&["1/4, (1+2)/4"]).run().ends_at([0.25, 0.75]);
    sbp("INPUT \"How deep?\" &d ⏎ MZ,&d").answers(&["3/4 in"]).run().fails(2, "R002");
    sbp("INPUT \"Date?\" &d ⏎ PRINT &d").answers(&["3/4/2026"]).run().prints(&["3/4/2026"]);
}

/// The first question: its buttons, and its default.
fn buttons(run: &Run) -> (Vec<String>, String) {
    let ask = run.events("ask").next().expect("a question");
    let words = ask["buttons"].as_array().expect("buttons").iter();
    let words = words.map(|w| w.as_str().unwrap_or_default().to_owned()).collect();
    (words, ask["default"].as_str().unwrap_or_default().to_owned())
}

#[test]
fn sbp_io_msgbox_basic() {
    let run =
        sbp("MSGBOX ( Do you want to open the keypad?, YesNo, Start Keypad?) ⏎ PRINT &msganswer")
            .answers(&["Yes"])
            .run();
    run.asks(&["Do you want to open the keypad?"]).prints(&["Yes"]);
    assert_eq!(run.events("ask").next().unwrap()["title"], "Start Keypad?");
    assert_eq!(buttons(&run).0, ["Yes", "No"]);
}

#[test]
fn sbp_io_msgbox_defaultbtn() {
    assert_eq!(buttons(&run("MSGBOX(t,276,x)")), (vec!["Yes".into(), "No".into()], "No".into()));
    assert_eq!(buttons(&run("MSGBOX(t,515,x)")).1, "Cancel");
    assert_eq!(buttons(&run("MSGBOX(t,771,x)")).1, "Yes");
    run("MSGBOX(t,276,x) ⏎ PRINT &msganswer").prints(&["No"]);
}

#[test]
fn sbp_io_play_pause() {
    let run = run("PLAY tada.wav ⏎ PAUSE 2 ⏎ MX,1");
    let start = run.ends_at([1.0]).events("move").next().unwrap()["t0"].as_f64().unwrap();
    assert!((start - 2.0).abs() < 1e-6, "{run}");
}

#[test]
fn sbp_io_setusrvalclrd() {
    let file = "GetUsrValClrd, &v ⏎ IF &v = \"\" THEN MX,1 ⏎ SetUsrValClrd, used ⏎ FP,in.sbp";
    let case = sbp(file).file("in.sbp", "GetUsrValClrd, &w ⏎ PRINT &w");
    case.after(file).run().ends_at([1.0]).prints(&["used"]);
}
