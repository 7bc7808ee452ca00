//! The language: lines, separators, expressions, variables, text.

use kerf_ledger::{at, run, sbp};

#[test]
fn sbp_lang_baseline() {
    run("PRINT %(25);%(21);%(22);%(27);\" \";%(23);\" \";%(28);\" \";%(71);\" \";%(73);\" \";%(76);\" \";%(78)")
        .ends_at([0.0; 6])
        .prints(&["0003 0.25 1 2 1 6 3"]);
}

#[test]
fn sbp_lang_textfile() {
    let lines = ["MX,1", "MY,2", "MZ,-.5", ""];
    let expected = [[1.0, 0.0, 0.0], [1.0, 2.0, 0.0], [1.0, 2.0, -0.5]];
    for end in ["\n", "\r\n", "\r"] {
        run(&lines.join(end)).is_ok().visits(&expected);
        run(&format!("\u{feff}{}", lines.join(end))).is_ok().visits(&expected);
    }
    run("MX,1\r\n\u{1a}\r\nMX,9\r\n").ends_at([1.0]).warns(2, "W013");
    run("MX,1\nMX,\0").fails(2, "S001").visits::<3>(&[]);
}

#[test]
fn sbp_lang_one_cmd_line() {
    run("MX,1 MY,2").status("failed").visits::<3>(&[]);
    run("MX,1 ⏎ MY,2").ends_at([1.0, 2.0]);
}

#[test]
fn sbp_lang_case() {
    run("mx,1 ⏎ My,2 ⏎ goto Done ⏎ MX,9 ⏎ DONE: ⏎ &Abc=3 ⏎ MZ,&aBC").ends_at([1.0, 2.0, 3.0]);
}

#[test]
fn sbp_lang_whitespace() {
    run("\t  MX,  1\n\n   MY,2  ").ends_at([1.0, 2.0]);
    run("M2\t3,4").ends_at([3.0, 4.0]);
}

#[test]
fn sbp_lang_comment_apos() {
    run("'only text ⏎ JZ, .5  'pulls the bit up ⏎ MX,2'tight")
        .visits(&[[0.0, 0.0, 0.5], [2.0, 0.0, 0.5]]);
}

#[test]
fn sbp_lang_comment_rem() {
    run("REM MX,5 ⏎ REM ⏎ MX,1").ends_at([1.0]);
    run("REMARK,1").fails(1, "S002");
}

#[test]
fn sbp_lang_comment_inert() {
    run("'MZ,-3 and END ⏎ MX,1").ends_at([1.0, 0.0, 0.0]);
}

#[test]
fn sbp_lang_comment_in_quotes() {
    run("PRINT \"it's on\"").prints(&["it's on"]);
    run("PRINT it's on").prints(&["it"]);
}

#[test]
fn sbp_lang_comment_display() {
    run("'Rough pass ⏎ MX,5 'not this").shows(&["Rough pass"]);
}

#[test]
fn sbp_lang_sep_comma() {
    run("M2,  3, 4.2").ends_at([3.0, 4.2]);
}

#[test]
fn sbp_lang_sep_space() {
    run("M2  3, 4.2").ends_at([3.0, 4.2]);
    run("M2 -3,4").ends_at([-3.0, 4.0]);
}

#[test]
fn sbp_lang_sep_missing() {
    run("M23, 4.2").fails(1, "S002").visits::<3>(&[]);
    for line in ["M3;1,2,3", "M4;1", "M2;3;4", "M5;", "M6:1,2", "J2.5", "MX;1", "C9;"] {
        run(&format!("{line} ⏎ MX,1")).fails(1, "S002").visits::<3>(&[]);
    }
}

#[test]
fn sbp_lang_sep_double_comma() {
    at([1.0, 1.0], "M2,, 4.2").ends_at([1.0, 4.2]);
}

#[test]
fn sbp_lang_sep_space_comma() {
    at([1.0, 1.0], "M2 , 4.2").ends_at([1.0, 4.2]);
}

#[test]
fn sbp_lang_sep_comma_one() {
    at([1.0, 1.0], "M2, 4.2").ends_at([4.2, 1.0]);
}

#[test]
fn sbp_lang_sep_space_one() {
    at([1.0, 1.0], "M2  4.2").ends_at([4.2, 1.0]);
}

#[test]
fn sbp_lang_param_blank() {
    at([1.0, 2.0, 3.0], "M3,,5").ends_at([1.0, 5.0, 3.0]);
    run("VS,,.5 ⏎ PRINT %(71);\" \";%(73)").prints(&["2 0.5"]);
    run("CC,4,,,,,-.1").visits(&[[0.0, 0.0, -0.1], [0.0, 0.0, -0.1], [0.0, 0.0, 0.0]]);
}

#[test]
fn sbp_lang_param_trailing() {
    run("SA,").is_ok().is_silent();
    run("VA,,,.5,,,,,0,,, ⏎ PRINT %(3)").is_ok().prints(&["0.5"]);
    run("SA,1").fails(1, "S009");
    run("MX,1,2").fails(1, "S009");
}

#[test]
fn sbp_lang_expr_param() {
    run("MX, 12+11/16").ends_at([12.6875]);
    run("M2, 2*3, (1+2)/4").ends_at([6.0, 0.75]);
}

#[test]
fn sbp_lang_expr_neg_fraction() {
    run("MZ, -2-7/32").ends_at([0.0, 0.0, -2.21875]);
    run("MZ, -(2+7/32)").ends_at([0.0, 0.0, -2.21875]);
    run("MZ, -2+7/32").ends_at([0.0, 0.0, -1.78125]);
}

#[test]
fn sbp_lang_expr_example() {
    run("MX,1.5*SQR(4.2)/(23-12.23) ⏎ &a = 1.5 * SQR(4.2)/(23-12.23) ⏎ PRINT &a")
        .ends_at([0.285_430_4])
        .prints(&["0.2854304"]);
}

/// Each expression, printed, reads so.
#[track_caller]
fn shows(cases: &[(&str, &str)]) {
    for (expression, expected) in cases {
        run(&format!("&A={expression} ⏎ PRINT &A")).is_ok().prints(&[expected]);
    }
}

#[test]
fn sbp_lang_expr_ops() {
    shows(&[
        ("2+3*4^2/8-1", "7"),
        ("-2^2", "-4"),
        ("(2+3)*4", "20"),
        ("10-3-2", "5"),
        ("8/4/2", "1"),
        ("7\\2", "3"),
        ("7 MOD 4", "3"),
    ]);
}

#[test]
fn sbp_lang_expr_funcs() {
    shows(&[
        ("SQR(16)", "4"),
        ("ABS(-2)", "2"),
        ("INT(-1.5)", "-2"),
        ("FIX(-1.5)", "-1"),
        ("SGN(-3)", "-1"),
        ("EXP(0)", "1"),
        ("LOG(1)", "0"),
        ("SIN(0)", "0"),
        ("COS(0)", "1"),
        ("TAN(0)", "0"),
        ("ATN(1)", "0.7853982"),
        ("ACOS(0)*2/PI", "1"),
        ("ASIN(1)*2/PI", "1"),
        ("ATAN(0)+SQRT(9)", "3"),
        ("ROUND(-2.5)", "-3"),
        ("FLOOR(-1.5)", "-2"),
        ("CEIL(-1.5)", "-1"),
    ]);
    run("&r=RND ⏎ IF &r < 0 THEN MX,9 ⏎ IF &r < 1 THEN MX,1").ends_at([1.0]);
    run("MX,NONSENSE(1)").fails(1, "S008").says("NONSENSE");
    run("&x=.5 ⏎ &a=2*ARCCOS(&x) ⏎ MX,1").fails(2, "S008").says("ARCCOS").visits::<3>(&[]);
    run("&a=5*x ⏎ MX,1")
        .fails(1, "S007")
        .says("the word x stands in a calculation")
        .visits::<3>(&[]);
    run("&a=ACOS(2) ⏎ MX,1").fails(1, "R004");
}

#[test]
fn lines_of_real_files_that_say_nothing_new_run() {
    run("&ZSAFE_TEMP ⏎ $kept ⏎ MX,1").ends_at([1.0]).warns(1, "W003").warns(2, "W003");
    run("CR,1,2,T,1,4,-.1,1,0,0,0 ⏎ MX,5").ends_at([5.0]);
    sbp("FP,b.sbp,1,1,1,0 ⏎ MY,2").file("b.sbp", "MX,1").run().ends_at([1.0, 2.0]);
}

#[test]
fn sbp_lang_expr_radians() {
    run("MX,SIN(90*.017453) ⏎ MY,ATN(1)*57.2958").ends_at([1.0, 45.0]);
}

#[test]
fn sbp_lang_expr_logic() {
    shows(&[
        ("(3>2)", "-1"),
        ("(3<2)", "0"),
        ("NOT 0", "-1"),
        ("(1=1) AND (2=3)", "0"),
        ("(1=1) OR (2=3)", "-1"),
    ]);
}

#[test]
fn sbp_lang_expr_errors() {
    run("MX,1/0").fails(1, "R003").stands_at([0.0]);
    run("MX,SQR(-1)").fails(1, "R004").stands_at([0.0]);
    run("MX,3*").fails(1, "S007").stands_at([0.0]);
    run("MX,\"abc\"").status("failed").stands_at([0.0]);
}

#[test]
fn sbp_lang_var_name() {
    run("&Z_depth=1 ⏎ &a1=2 ⏎ M2,&Z_depth,&a1").ends_at([1.0, 2.0]);
    run("&a\\b=1").fails(1, "S011");
    run("&a*b=1").fails(1, "S011");
    run("&a:b=1").fails(1, "S011");
}

#[test]
fn sbp_lang_var_case() {
    run("&MyVar=1 ⏎ &MYVAR=&myvar+1 ⏎ PRINT &Myvar").prints(&["2"]);
}

#[test]
fn sbp_lang_var_assign() {
    run("&Zdepth = -0.52 ⏎ MZ, &Zdepth").ends_at([0.0, 0.0, -0.52]);
}

#[test]
fn sbp_lang_var_assign_expr() {
    run("&MyVariable = 5.0 ⏎ &MyNewVariable = &MyVariable * 2.31-2 ⏎ PRINT &MyNewVariable")
        .prints(&["9.55"]);
}

#[test]
fn sbp_lang_var_variant() {
    run("&a=5 ⏎ &a=\"five\" ⏎ PRINT &a").prints(&["five"]);
    run("&b=\"2\" ⏎ MX,&b*2").ends_at([4.0]);
    run("&c=abc ⏎ MX,&c").fails(2, "R002");
}

#[test]
fn sbp_lang_var_single() {
    run("&a=1/3 ⏎ PRINT &a").prints(&["0.3333333"]);
    run("&a=16777217 ⏎ PRINT &a").prints(&["16777216"]);
}

#[test]
fn sbp_lang_var_loop_test() {
    run("&i=0 ⏎ &n=0 ⏎ L: ⏎ &i=&i+.1 ⏎ &n=&n+1 ⏎ IF &i<.95 THEN GOTO L ⏎ PRINT &n").prints(&["10"]);
    run("&n=0 ⏎ L: ⏎ &n=&n+1 ⏎ IF &n = 20 THEN GOTO Out ⏎ GOTO L ⏎ Out: ⏎ MX,&n").ends_at([20.0]);
}

#[test]
fn sbp_lang_str_unquoted() {
    run("&MyString = test string ⏎ PRINT &MyString").prints(&["test string"]);
}

#[test]
fn sbp_lang_str_quoted() {
    run("&MyString = \"test  string\" ⏎ PRINT &MyString").prints(&["test  string"]);
}

#[test]
fn sbp_lang_str_unquoted_expr() {
    shows(&[("3+4", "7"), ("3/8 ply", "3/8 ply"), ("Table Surface", "Table Surface")]);
    run("&a = \"3+4\" ⏎ PRINT &a ⏎ MX,&a").fails(3, "R002").prints(&["3+4"]);
}

#[test]
fn sbp_lang_str_case() {
    run("&m = Yes ⏎ IF &m = \"YES\" THEN MX,1 ⏎ PRINT &m").ends_at([1.0]).prints(&["Yes"]);
}

#[test]
fn sbp_lang_str_concat() {
    run("&firstname = Bill ⏎ &newstring = \"My name is \" & &firstname ⏎ PRINT &newstring")
        .prints(&["My name is Bill"]);
    run("&n=3 ⏎ &s=\"Hole \" & &n & \" of 4\" ⏎ PRINT &s").prints(&["Hole 3 of 4"]);
}

#[test]
fn sbp_lang_str_concat_sysvar() {
    run("MX,2.5 ⏎ &s = \"X=\" & %(1) ⏎ PRINT &s").prints(&["X=2.5"]);
}

#[test]
fn sbp_lang_var_persist() {
    sbp("JZ,&Zup").after("&Zup=.75").run().ends_at([0.0, 0.0, 0.75]);
    run("JZ,&Zup").fails(1, "R001");
    sbp("&a=1 ⏎ FP,in.sbp ⏎ MX,&a").file("in.sbp", "&a=&a+1").run().ends_at([2.0]);
}

#[test]
fn sbp_lang_var_undefined_num() {
    run("MX,&nope").fails(1, "R001").says("NOPE").visits::<3>(&[]);
}

#[test]
fn sbp_lang_var_undefined_text() {
    run("PRINT &nope").prints(&["&nope"]);
}

#[test]
fn sbp_lang_var_in_text() {
    run("&t=18 ⏎ MSGBOX (Is thickness &t mm?, YesNo, CHECK)").asks(&["Is thickness 18 mm?"]);
    run("&t=18 ⏎ MSGBOX (Is [&]t set?, YesNo, CHECK)").asks(&["Is &t set?"]);
}

#[test]
fn sbp_lang_sysvar_syntax() {
    at([0.0, 3.0, 0.0], "&Y_now = %(2) ⏎ MX,%(2)+1 ⏎ PRINT %(2)")
        .ends_at([4.0, 3.0])
        .prints(&["3"]);
}

#[test]
fn sbp_lang_sysvar_computed() {
    sbp("PAUSE .1 ⏎ &p=1 ⏎ &a=%(50+&p) ⏎ PRINT &a").input(1, 0.0, true).run().prints(&["1"]);
}

#[test]
fn sbp_lang_sysvar_units() {
    run("MX,1 ⏎ PRINT %(1) ⏎ VD,,,1 ⏎ PRINT %(1)").prints(&["1", "25.4"]);
}

#[test]
fn sbp_lang_sysvar_unknown() {
    run("&a=%(500)").fails(1, "R008").says("500");
    run("&a=%(64)").is_ok().warns(1, "W004");
}

#[test]
fn sbp_lang_sysvar_readonly() {
    run("%(1)=5").fails(1, "S014");
}

#[test]
fn sbp_lang_label() {
    run("GOTO Start ⏎ MX,9 ⏎ Start: 'here ⏎ MX,1").ends_at([1.0]);
    run("Start: MX,1").status("failed");
}

#[test]
fn sbp_lang_label_case_indent() {
    run("GOTO done\nMX,9\n   DONE:\nMX,1").ends_at([1.0]);
}

#[test]
fn sbp_lang_label_spaces() {
    run("GOTO SECOND PLUNGE ⏎ MX,9 ⏎ SECOND PLUNGE: ⏎ MX,1").ends_at([1.0]);
}

#[test]
fn sbp_lang_label_duplicate() {
    run("GOTO A ⏎ MX,9 ⏎ A: ⏎ MY,1 ⏎ END ⏎ A: ⏎ MY,2").ends_at([0.0, 1.0]).warns(6, "W001");
}

#[test]
fn sbp_lang_label_scope() {
    sbp("FP,in.sbp ⏎ A: ⏎ MX,1").file("in.sbp", "GOTO A").run().fails(1, "R005");
}

#[test]
fn sbp_lang_unknown_cmd() {
    run("MX,1 ⏎ MX,2 ⏎ QQ,1").fails(3, "S002").says("QQ");
}

#[test]
fn sbp_lang_setup_lines() {
    sbp("PRINT %(71)").after("VS,1.25,.45 ⏎ VC,.25 ⏎ SA ⏎ MX,1").run().prints(&["2"]);
    run("VS,1.25,.45 ⏎ VC,.25 ⏎ SA ⏎ MX,1 ⏎ PRINT %(71);\" \";%(73);\" \";%(23)")
        .prints(&["1.25 0.45 0.25"]);
}

#[test]
fn sbp_lang_move_preview_same() {
    let program = sbp("M2,1,2 ⏎ CC,2 ⏎ J3,4,4,1 ⏎ CR,2,1,O");
    let places = |run: &kerf_ledger::Run| -> Vec<serde_json::Value> {
        run.events("move").chain(run.events("arc")).map(|e| e["to"].clone()).collect()
    };
    assert_eq!(places(&program.clone().run()), places(&program.preview()));
}

/// Every sample file that comes with Kerf makes the same path as a preview, in Preview mode and on the machine.
#[test]
fn sbp_lang_move_preview_same__each_sample() {
    let path = |run: &kerf_ledger::Run| -> Vec<serde_json::Value> {
        let moved = run.events("move").chain(run.events("arc"));
        moved.map(|e| serde_json::json!([e["line"], e["kind"], e["to"]])).collect()
    };
    let mut moved = 0;
    for sample in kerf_files::SAMPLES {
        let program = sbp(sample.text);
        let made = path(&program.clone().run());
        moved += made.len();
        assert_eq!(made, path(&program.clone().preview()), "{} as a preview", sample.name);
        let drawn = sbp("SP ⏎ FP,sample.sbp ⏎ SM").file("sample.sbp", sample.text).run();
        assert_eq!(made, path(&drawn), "{} in Preview mode", sample.name);
    }
    assert!(moved > 100, "{moved} moves are no samples");
}

#[test]
fn sbp_lang_first_example() {
    run(
        "JZ, .5 ⏎ J2, 10, 10 ⏎ MZ, -.25 ⏎ M2, 20, 10 ⏎ M2, 20, 5 ⏎ M2, 10, 5 ⏎ M2, 10, 10 ⏎ JZ, .5",
    )
    .is_ok()
    .visits(&[
        [0.0, 0.0, 0.5],
        [10.0, 10.0, 0.5],
        [10.0, 10.0, -0.25],
        [20.0, 10.0, -0.25],
        [20.0, 5.0, -0.25],
        [10.0, 5.0, -0.25],
        [10.0, 10.0, -0.25],
        [10.0, 10.0, 0.5],
    ]);
}
