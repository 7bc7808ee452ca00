//! Files of the user, PRINT, INPUT, MSGBOX and the other ways to ask and tell.

use kerf_ledger::{Run, at, run, sbp};

/// What a program leaves in `out.txt`.
#[track_caller]
fn writes(program: &str, expected: &str) {
    let run = run(&format!("OPEN \"out.txt\" FOR OUTPUT AS #1 ⏎ {program} ⏎ CLOSE #1"));
    run.is_ok();
    assert_eq!(run.file("out.txt"), expected, "{run}");
}

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
fn sbp_io_open_input() {
    run("MX,1 ⏎ OPEN \"none.txt\" FOR INPUT AS #1").fails(2, "F001");
    reading("5\n", "INPUT #1, &a ⏎ MX,&a").ends_at([5.0]);
}

#[test]
fn sbp_io_open_append() {
    let append = "OPEN \"out.txt\" FOR APPEND AS #1 ⏎ WRITE #1; \"B\"";
    assert_eq!(sbp(append).file("out.txt", "A\n").run().file("out.txt"), "A\nB\n");
    assert_eq!(run(append).file("out.txt"), "B\n");
}

#[test]
fn sbp_io_open_number() {
    let all: Vec<String> =
        (1..=9).map(|n| format!("OPEN \"f{n}.txt\" FOR OUTPUT AS #{n}")).collect();
    run(&all.join(" ⏎ ")).is_ok();
    run("OPEN \"f.txt\" FOR OUTPUT AS #10").fails(1, "F007");
    run("OPEN \"f.txt\" FOR OUTPUT AS #0").fails(1, "F007");
    run("OPEN \"f.txt\" FOR OUTPUT AS #1 ⏎ OPEN \"g.txt\" FOR OUTPUT AS #1").fails(2, "F007");
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
    run("OPEN \"none\\out.txt\" FOR OUTPUT AS #1").status("failed");
}

#[test]
fn sbp_io_open_variable() {
    let run = run("&f=\"out.txt\" ⏎ OPEN &f FOR OUTPUT AS #2 ⏎ WRITE #2; \"A\"");
    assert_eq!(run.file("out.txt"), "A\n");
}

#[test]
fn sbp_io_close_one() {
    run("OPEN \"a.txt\" FOR OUTPUT AS #1 ⏎ OPEN \"b.txt\" FOR OUTPUT AS #2 ⏎ CLOSE #1 ⏎ \
         WRITE #2; \"x\" ⏎ WRITE #1; \"x\"")
    .fails(5, "F003");
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
fn sbp_io_inputfile_eof() {
    reading("1\n", "INPUT #1, &a ⏎ INPUT #1, &b").fails(3, "F004");
}

#[test]
fn sbp_io_inputfile_quoted() {
    reading("\"a, b\",3\n", "INPUT #1, &x, &y ⏎ PRINT &x ⏎ PRINT &y").prints(&["a, b", "3"]);
}

#[test]
fn sbp_io_write_comma() {
    writes("&v = 23.5 ⏎ Write #1, \"M2\", &v, &v", "M2, 23.5, 23.5\n");
}

#[test]
fn sbp_io_write_comma_inquotes() {
    writes("WRITE #1, \"a,b\"", "a, b\n");
    let run = run("OPEN \"out.txt\" FOR OUTPUT AS #1 ⏎ WRITE #1, \"a,b\"");
    assert!(run.events("diag").any(|d| d["severity"] == "warning" && d["line"] == 2), "{run}");
}

#[test]
fn sbp_io_write_semi() {
    writes("&someVar=23.5 ⏎ Write #1; \"&myVar = \"; &someVar", "&myVar = 23.5\n");
}

#[test]
fn sbp_io_write_semi_commas() {
    writes("&v=23.5 ⏎ Write #1; \"M2, \"; &v; \", \"; &v", "M2, 23.5, 23.5\n");
}

#[test]
fn sbp_io_write_nolf() {
    writes("WRITE #1; \"A\"; ⏎ WRITE #1; \"B\"", "AB\n");
    writes("WRITE #1, \"A\"; ⏎ WRITE #1, \"B\"", "AB\n");
}

#[test]
fn sbp_io_write_sysvar() {
    writes("M2,1,2 ⏎ WRITE #1, %(1), %(2)*2", "1, 4\n");
}

#[test]
fn sbp_io_write_numfmt() {
    writes("&a=2.50 ⏎ &b=1/3 ⏎ &c=100000 ⏎ WRITE #1, &a, &b, &c", "2.5, 0.3333333, 100000\n");
}

#[test]
fn sbp_io_write_undefined() {
    writes("WRITE #1; &nope", "&nope\n");
}

#[test]
fn sbp_io_print_comma_splits() {
    run("&firstvar = \"My number\" ⏎ PRINT &firstvar, \" = 123,456 \"")
        .prints(&["My number      = 123     456 "]);
}

#[test]
fn sbp_io_print_comma_semierr() {
    run("PRINT \"a\", \"b\"; \"c\"").status("failed");
    run("PRINT \"a\", \"b\"; ⏎ PRINT \"c\"").prints(&["a     bc"]);
}

#[test]
fn sbp_io_print_semi() {
    run("&firstvar = \"My number\" ⏎ PRINT &firstvar; \" = 123,456 \"")
        .prints(&["My number = 123,456 "]);
}

#[test]
fn sbp_io_print_semi_comma() {
    run("PRINT \"a\"; \"b\", \"c\"").prints(&["ab,c"]);
}

#[test]
fn sbp_io_print_nolf() {
    run("PRINT \"A\"; ⏎ PRINT \"B\"").prints(&["AB"]);
    run("&x=1 ⏎ PRINT &x; ⏎ PRINT \"B\"").prints(&["1B"]);
}

#[test]
fn sbp_io_print_empty() {
    run("PRINT ⏎ PRINT \"x\"").prints(&["", "x"]);
}

#[test]
fn sbp_io_print_undefined() {
    run("PRINT &zz").prints(&["&zz"]);
}

#[test]
fn sbp_io_print_file() {
    writes("PRINT #1, \"a\", \"b\"", "a     b\n");
}

#[test]
fn sbp_io_input_one() {
    let run = sbp("&d=9 ⏎ INPUT \"Depth?\" &d ⏎ MZ,&d").answers(&["-.25"]).run();
    run.ends_at([0.0, 0.0, -0.25]).asks(&["Depth?"]);
}

#[test]
fn sbp_io_input_many() {
    sbp("INPUT \"Enter X and Y\" &x, &y ⏎ M2,&x,&y").answers(&["3, 4"]).run().ends_at([3.0, 4.0]);
    let eleven: Vec<String> = (1..=11).map(|n| format!("&v{n}")).collect();
    run(&format!("INPUT \"many\" {}", eleven.join(", "))).status("failed");
}

#[test]
fn sbp_io_input_notext() {
    sbp("INPUT &d ⏎ MX,&d").answers(&["2"]).run().asks(&[""]).ends_at([2.0]);
}

#[test]
fn sbp_io_input_empty_one() {
    sbp("INPUT \"x\" &d ⏎ IF &d = \"\" THEN MX,1").answers(&[""]).run().ends_at([1.0]);
}

#[test]
fn sbp_io_input_missing() {
    sbp("INPUT \"xy\" &x, &y").answers(&["3"]).run().status("failed").says("2");
}

#[test]
fn sbp_io_input_cancel() {
    let run = sbp("INPUT \"x\" &x ⏎ MX,1").answers(&["Cancel"]).run();
    run.says("terminated").visits::<3>(&[]);
}

#[test]
fn sbp_io_input_dynamic() {
    sbp("&variable=7 ⏎ INPUT \"You Entered - \" & &variable & \" Is this Correct? Y or N\"; &t ⏎ PRINT &t")
        .answers(&["Y"])
        .run()
        .asks(&["You Entered - 7 Is this Correct? Y or N"])
        .prints(&["Y"]);
}

#[test]
fn sbp_io_input_default() {
    run("&default=5 ⏎ INPUT \"Displaying default value - \": &default, &newvar ⏎ MX,&newvar")
        .ends_at([5.0])
        .asks(&["Displaying default value - "]);
}

#[test]
fn sbp_io_input_combined() {
    for mark in [";:", "; :"] {
        run(&format!("&n=1 ⏎ &d=2 ⏎ INPUT \"Hole \" & &n{mark} &d, &new ⏎ MX,&new"))
            .ends_at([2.0])
            .asks(&["Hole 1"]);
    }
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
fn sbp_io_msgbox_buttons() {
    let kinds: [(&str, &[&str]); 6] = [
        ("OKOnly", &["OK"]),
        ("OKCancel", &["OK", "Cancel"]),
        ("AbortRetryIgnore", &["Abort", "Retry", "Ignore"]),
        ("YesNoCancel", &["Yes", "No", "Cancel"]),
        ("YesNo", &["Yes", "No"]),
        ("RetryCancel", &["Retry", "Cancel"]),
    ];
    for (number, (word, expected)) in kinds.iter().enumerate() {
        for style in [number.to_string(), (*word).to_owned(), word.to_lowercase()] {
            let (words, default) = buttons(&run(&format!("MSGBOX(t,{style},x)")));
            assert_eq!(
                (words, default.as_str()),
                (expected.iter().map(|w| (*w).to_owned()).collect(), expected[0]),
                "{style}"
            );
        }
    }
}

#[test]
fn sbp_io_msgbox_defaultbtn() {
    assert_eq!(buttons(&run("MSGBOX(t,276,x)")), (vec!["Yes".into(), "No".into()], "No".into()));
    assert_eq!(buttons(&run("MSGBOX(t,515,x)")).1, "Cancel");
    assert_eq!(buttons(&run("MSGBOX(t,771,x)")).1, "Yes");
    run("MSGBOX(t,276,x) ⏎ PRINT &msganswer").prints(&["No"]);
}

#[test]
fn sbp_io_msgbox_invalid() {
    for style in ["7", "999", "Maybe", ""] {
        assert_eq!(buttons(&run(&format!("MSGBOX(t,{style},x)"))).0, ["OK"], "{style}");
    }
}

#[test]
fn sbp_io_msgbox_strings() {
    at([2.0], "&m=\"X is \" & %(1) ⏎ MSGBOX(&m,OKOnly,Info)").asks(&["X is 2"]);
    at([2.0], "MSGBOX(\"X is \" & %(1),0,Info)").asks(&["X is 2"]);
}

#[test]
fn sbp_io_msgbox_parens() {
    let run = run("MSGBOX(Update Z? (Yes-Update: No-Keep ,YesNoCancel,\"\")");
    run.asks(&["Update Z? (Yes-Update: No-Keep"]);
    assert_eq!(run.events("ask").next().unwrap()["title"], "");
    assert_eq!(buttons(&run).0, ["Yes", "No", "Cancel"]);
}

#[test]
fn sbp_io_play() {
    run("PLAY C:\\WINDOWS\\Media\\tada.wav ⏎ MX,1").ends_at([1.0]);
}

#[test]
fn sbp_io_play_pause() {
    let run = run("PLAY tada.wav ⏎ PAUSE 2 ⏎ MX,1");
    let start = run.ends_at([1.0]).events("move").next().unwrap()["t0"].as_f64().unwrap();
    assert!((start - 2.0).abs() < 1e-6, "{run}");
}

#[test]
fn sbp_io_setusrval_var() {
    run("&a=2.5 ⏎ SetUsrVal, &a ⏎ GetUsrVal, &b ⏎ MX,&b").ends_at([2.5]);
    run("SetUsrVal, hello ⏎ GetUsrVal &v ⏎ PRINT &v").prints(&["hello"]);
}

#[test]
fn sbp_io_setusrvalclrd() {
    let file = "GetUsrValClrd, &v ⏎ IF &v = \"\" THEN MX,1 ⏎ SetUsrValClrd, used ⏎ FP,in.sbp";
    let case = sbp(file).file("in.sbp", "GetUsrValClrd, &w ⏎ PRINT &w");
    case.after(file).run().ends_at([1.0]).prints(&["used"]);
}

#[test]
fn sbp_io_getusrval() {
    run("GetUsrVal, &v ⏎ IF &v = \"\" THEN MX,1").ends_at([1.0]);
}
