//! The rows of the area `lang`: lines, separators, parameters, expressions, variables, labels.

use super::{run_files, run_with};
use crate::testing::{FakeHost, Ran, run};
use crate::{Interpreter, Options, Session, Status, Step, Value, read};
use kerf_diag::Code;
use kerf_program::{Command, MoveKind};

/// Returns the text that `PRINT` shows for an expression.
fn shown(expression: &str) -> String {
    run(&format!("&A={expression} ⏎ PRINT &A")).ended(Status::Ok).printed().trim_end().to_string()
}

/// Checks lines that assign an expression and print the variable.
#[track_caller]
fn shows(cases: &[(&str, &str)]) {
    for (expression, text) in cases {
        assert_eq!(shown(expression), *text, "{expression}");
    }
}

/// Checks that a program fails with a text and moves nothing.
#[track_caller]
fn refuses(program: &str, part: &str) {
    let ran = run(program);
    ran.ended(Status::Failed).fails_with(part).ends_at(0.0, 0.0, 0.0);
}

/// The warnings of reading a file.
fn warnings(text: &str) -> Vec<(Code, u32)> {
    let text = text.split('⏎').map(str::trim).collect::<Vec<_>>().join("\n");
    let program = read("test.sbp".into(), text.as_bytes());
    program.diagnostics.iter().map(|d| (d.code, d.place.line)).collect()
}

fn from(x: f64, y: f64, z: f64, program: &str) -> Ran {
    run(&format!("J3,{x},{y},{z} ⏎ {program}"))
}

#[test]
fn sbp_lang_baseline() {
    let fresh =
        [(25, "0"), (21, "0"), (22, "0"), (1, "0"), (6, "0"), (27, "3"), (23, "0.25"), (28, "1")];
    for (number, value) in fresh {
        assert_eq!(shown(&format!("%({number})")), value, "%({number})");
    }
    shows(&[("%(71)", "2"), ("%(73)", "1"), ("%(76)", "6"), ("%(78)", "3")]);
    let s = Session::default().settings;
    assert_eq!((s.cutter.pocket_overlap_percent, s.limits.check, s.warning_s), (10.0, false, 0.0));
}

#[test]
fn sbp_lang_textfile() {
    let lines = ["'a", "MX,1", "", "MY,2"];
    let expected = run(&lines.join(" ⏎ ")).moves();
    assert_eq!(expected.len(), 2);
    for end in ["\r\n", "\n", "\r"] {
        for mark in ["", "\u{feff}"] {
            let text = format!("{mark}{}{end}", lines.join(end));
            assert_eq!(run(&text).moves(), expected, "{end:?} {mark:?}");
        }
    }
    refuses("MX,1\n\0MY,2", "not a text file");
}

#[test]
fn sbp_lang_one_cmd_line() {
    refuses("MX,1 MY,2", "second command");
    assert_eq!(warnings("MX,1 MY,2"), [(Code::OneCommandPerLine, 1)]);
    run("MX,1 ⏎ MY,2").ends_at(1.0, 2.0, 0.0);
}

#[test]
fn sbp_lang_case() {
    run("mx,1 ⏎ My,2 ⏎ goto Done ⏎ MX,9 ⏎ DONE: ⏎ &Abc=3 ⏎ MZ,&aBC").ends_at(1.0, 2.0, 3.0);
}

#[test]
fn sbp_lang_whitespace() {
    let program = read("t".into(), b"\t  MX,  1\n\n   MY,2  ");
    assert!(program.diagnostics.is_empty());
    run("\t  MX,  1 ⏎ ⏎    MY,2  ").ends_at(1.0, 2.0, 0.0);
    run("M2\t3,4").ends_at(3.0, 4.0, 0.0);
}

#[test]
fn sbp_lang_comment_apos() {
    run("'only text ⏎ JZ, .5  'pulls the bit up ⏎ MX,2'tight").ends_at(2.0, 0.0, 0.5);
}

#[test]
fn sbp_lang_comment_rem() {
    run("REM MX,5 ⏎ REM ⏎ MX,1").ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
    refuses("REMARK,1", "unknown");
}

#[test]
fn sbp_lang_comment_inert() {
    run("'MZ,-3 and END ⏎ MX,1").ends_at(1.0, 0.0, 0.0);
}

#[test]
fn sbp_lang_comment_in_quotes() {
    assert_eq!(run("PRINT \"it's on\"").printed(), "it's on\n");
    assert_eq!(run("PRINT it's on").printed(), "it\n");
}

#[test]
fn sbp_lang_comment_display() {
    let ran = run("'Rough pass ⏎ MX,5 'not shown");
    let shown = ran.commands.iter().filter_map(|c| match &c.command {
        Command::Message { text } => Some((text.to_string(), c.at.line)),
        Command::Line(_) => Some(("moves".into(), c.at.line)),
        _ => None,
    });
    assert_eq!(
        shown.collect::<Vec<_>>(),
        [("Rough pass".to_string(), 1), ("moves".to_string(), 2)]
    );
}

#[test]
fn sbp_lang_sep_comma() {
    run("M2,  3, 4.2").ends_at(3.0, 4.2, 0.0);
}

#[test]
fn sbp_lang_sep_space() {
    run("M2  3, 4.2").ends_at(3.0, 4.2, 0.0);
    run("M2 -3,4").ends_at(-3.0, 4.0, 0.0);
}

#[test]
fn sbp_lang_sep_missing() {
    refuses("M23, 4.2", "unknown command");
    assert_eq!(warnings("MX,1 ⏎ M23, 4.2"), [(Code::UnknownCommand, 2)]);
    for line in ["M2;3;4", "M3;1,2,3", "M4;1", "M5;", "M6:1,2", "J2.5", "MX;1", "CC;4"] {
        refuses(line, "separator");
        assert_eq!(warnings(&format!("MX,1 ⏎ {line}")), [(Code::UnknownCommand, 2)], "{line}");
    }
}

#[test]
fn sbp_lang_sep_double_comma() {
    from(1.0, 1.0, 0.0, "M2,, 4.2").ends_at(1.0, 4.2, 0.0);
}

#[test]
fn sbp_lang_sep_space_comma() {
    from(1.0, 1.0, 0.0, "M2 , 4.2").ends_at(1.0, 4.2, 0.0);
}

#[test]
fn sbp_lang_sep_comma_one() {
    from(1.0, 1.0, 0.0, "M2, 4.2").ends_at(4.2, 1.0, 0.0);
}

#[test]
fn sbp_lang_sep_space_one() {
    from(1.0, 1.0, 0.0, "M2  4.2").ends_at(4.2, 1.0, 0.0);
}

#[test]
fn sbp_lang_param_blank() {
    from(1.0, 2.0, 3.0, "M3,,5").ends_at(1.0, 5.0, 3.0);
    let ran = run("VS,,.5 ⏎ PRINT %(71);\" \";%(73)");
    assert_eq!(ran.printed(), "2 0.5\n");
    let ran = run("CC,4,,,,,-.1");
    ran.ends_at(0.0, 0.0, 0.0);
    assert_eq!(ran.moves()[0].1, [0.0, 0.0, -0.1]);
}

#[test]
fn sbp_lang_param_trailing() {
    run("SR ⏎ SA, ⏎ VA,,,.5,,,,,0,,,").ended(Status::Ok).ends_at(0.0, 0.0, 0.5);
    refuses("SA,1", "takes no values");
    refuses("MX,1,2", "takes 1 value");
}

#[test]
fn sbp_lang_expr_param() {
    run("MX, 12+11/16").ends_at(12.6875, 0.0, 0.0);
    run("M2, 2*3, (1+2)/4").ends_at(6.0, 0.75, 0.0);
}

#[test]
fn sbp_lang_expr_neg_fraction() {
    run("MZ, -2-7/32").ends_at(0.0, 0.0, -2.21875);
    run("MZ, -(2+7/32)").ends_at(0.0, 0.0, -2.21875);
    run("MZ, -2+7/32").ends_at(0.0, 0.0, -1.78125);
}

#[test]
fn sbp_lang_expr_ops() {
    shows(&[
        ("2+3*4^2/8-1", "7"),
        ("-2^2", "-4"),
        ("(2+3)*4", "20"),
        ("10-3-2", "5"),
        ("7\\2", "3"),
        ("7 MOD 4", "3"),
        ("8/4/2", "1"),
        ("2*6/3*4", "16"),
        ("2^3^2", "64"),
        ("2^-1", "0.5"),
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
        ("RND>=0 AND RND<1", "-1"),
    ]);
    refuses("MX,FOO(1)", "FOO");
    refuses("&a=FOO(1)", "FOO");
    refuses("&a=2*FOO(1)", "FOO");
    refuses("IF FOO(1) = 1 THEN MX,1", "FOO");
    refuses("&a=5*x", "x");
}

#[test]
fn sbp_lang_expr_radians() {
    let near = |expression: &str, value: f64, by: f64| {
        let ran = run(&format!("&A={expression}"));
        let number = ran.session.variables.get("A").and_then(Value::number).unwrap();
        assert!((number - value).abs() < by, "{expression} {number}");
    };
    near("SIN(90*.017453)", 1.0, 1e-6);
    near("ATN(1)*57.2958", 45.0001, 1e-3);
}

#[test]
fn sbp_lang_expr_logic() {
    shows(&[
        ("3>2", "-1"),
        ("3<2", "0"),
        ("NOT 0", "-1"),
        ("(1=1) AND (2=3)", "0"),
        ("(1=1) OR (2=3)", "-1"),
    ]);
}

#[test]
fn sbp_lang_expr_errors() {
    for (line, part) in [
        ("MX,1/0", "division by zero"),
        ("MX,SQR(-1)", "square root"),
        ("MX,3*", ""),
        ("MX,\"abc\"", "number"),
        ("&a=0 ⏎ MX,5\\&a", "division by zero"),
        ("&a=1e300 ⏎ MX,&a*&a", "finite"),
    ] {
        refuses(line, part);
    }
}

#[test]
fn sbp_lang_var_name() {
    run("&Z_depth=1 ⏎ &a1=2 ⏎ MX,&Z_depth+&a1").ends_at(3.0, 0.0, 0.0);
    run("&5AX_gauge=2 ⏎ MX,&5ax_gauge").ends_at(2.0, 0.0, 0.0);
    for line in ["&a\\b=1", "&a*b=1", "&a:b=1"] {
        refuses(line, "character not allowed in a variable name");
    }
}

#[test]
fn sbp_lang_var_case() {
    let ran = run("&MyVar=1 ⏎ &MYVAR=&myvar+1 ⏎ PRINT &Myvar");
    assert_eq!(ran.printed(), "2\n");
    assert_eq!(ran.session.variables.list().into_keys().collect::<Vec<_>>(), ["MYVAR"]);
}

#[test]
fn sbp_lang_var_assign() {
    for depth in ["-0.52", "-0.75"] {
        let ran = run(&format!("&Zdepth = {depth} ⏎ MZ, &Zdepth ⏎ JZ,1 ⏎ MZ, &Zdepth"));
        ran.ends_at(0.0, 0.0, depth.parse().unwrap());
        assert_eq!(ran.moves()[0].1, ran.moves()[2].1);
    }
}

#[test]
fn sbp_lang_var_assign_expr() {
    let ran =
        run("&MyVariable = 5.0 ⏎ &MyNewVariable = &MyVariable * 2.31-2 ⏎ PRINT &MyNewVariable");
    assert_eq!(ran.printed(), "9.55\n");
}

#[test]
fn sbp_lang_var_variant() {
    assert_eq!(run("&a=5 ⏎ &a=\"five\" ⏎ PRINT &a").printed(), "five\n");
    run("&b=\"2\" ⏎ MX,&b*2").ends_at(4.0, 0.0, 0.0);
    refuses("&c=abc ⏎ MX,&c", "number");
}

#[test]
fn sbp_lang_var_single() {
    shows(&[("1/3", "0.3333333"), ("16777217", "16777216")]);
}

#[test]
fn sbp_lang_var_loop_test() {
    let count = "&n=0 ⏎ &i=0 ⏎ L: ⏎ &n=&n+1 ⏎ &i=&i+.1 ⏎ IF &i<.95 THEN GOTO L";
    let ran = run(count);
    assert_eq!(
        (ran.variable("n"), ran.variable("i").parse::<f64>().unwrap() <= 1.000_001),
        ("10".into(), true)
    );
    assert!(ran.variable("i").starts_with('1'));
    run("&n=0 ⏎ L: ⏎ &n=&n+1 ⏎ IF &n = 20 THEN MX,1 ⏎ IF &n < 30 THEN GOTO L")
        .ends_at(1.0, 0.0, 0.0);
}

#[test]
fn sbp_lang_str_unquoted() {
    assert_eq!(run("&MyString =   test string   ⏎ PRINT &MyString").printed(), "test string\n");
}

#[test]
fn sbp_lang_str_quoted() {
    assert_eq!(run("&MyString = \"test  string\" ⏎ PRINT &MyString").printed(), "test  string\n");
}

#[test]
fn sbp_lang_str_unquoted_expr() {
    shows(&[
        ("3+4", "7"),
        ("3/8 ply", "3/8 ply"),
        ("Table Surface", "Table Surface"),
        ("\"3+4\"", "3+4"),
    ]);
    refuses("&a = \"3+4\" ⏎ MX,&a", "number");
}

#[test]
fn sbp_lang_str_case() {
    let ran = run("&m = Yes ⏎ IF &m = \"YES\" THEN MX,1 ⏎ PRINT &m");
    assert_eq!(ran.ends_at(1.0, 0.0, 0.0).printed(), "Yes\n");
}

#[test]
fn sbp_lang_str_concat() {
    let name = "&firstname = Bill ⏎ &newstring = \"My name is \" & &firstname ⏎ PRINT &newstring";
    assert_eq!(run(name).printed(), "My name is Bill\n");
    assert_eq!(run("&n=3 ⏎ &s=\"Hole \" & &n & \" of 4\" ⏎ PRINT &s").printed(), "Hole 3 of 4\n");
}

#[test]
fn sbp_lang_str_concat_sysvar() {
    assert_eq!(run("MX,2.5 ⏎ &s = \"X=\" & %(1) ⏎ PRINT &s").printed(), "X=2.5\n");
}

#[test]
fn sbp_lang_var_persist() {
    let first = run("&Zup=.75");
    let second = run_with("JZ,&Zup", FakeHost::default(), first.session);
    second.ends_at(0.0, 0.0, 0.75);
    refuses("JZ,&Zup", "no value");
    run_files("&a=1 ⏎ FP,in.sbp ⏎ MX,&a", &[("in.sbp", "&a=&a+1")]).ends_at(2.0, 0.0, 0.0);
}

#[test]
fn sbp_lang_var_limit() {
    let lines: Vec<_> = (1..=105).map(|n| format!("&v{n}={n}")).collect();
    let ran = run(&lines.join(" ⏎ "));
    assert_eq!((ran.session.variables.count(), ran.variable("V105")), (105, "105".into()));
    assert_eq!(ran.told().matches("more than 100 variables").count(), 1);
    assert!(ran.told().starts_with("101:"), "{}", ran.told());
}

#[test]
fn sbp_lang_var_undefined_num() {
    run("MX,&nope").fails_at(1, "variable &NOPE has no value").ends_at(0.0, 0.0, 0.0);
    refuses("MX,&nope+1", "variable &NOPE has no value");
}

#[test]
fn sbp_lang_var_undefined_text() {
    assert_eq!(run("PRINT &nope").printed(), "&nope\n");
}

#[test]
fn sbp_lang_var_in_text() {
    let ran = run("&t=18 ⏎ MSGBOX (Is thickness &t mm? [&]t, YesNo, CHECK)");
    assert_eq!(ran.host.asked[0].text, "Is thickness 18 mm? &t");
}

#[test]
fn sbp_lang_sysvar_syntax() {
    run("J3,0,3,0 ⏎ &Y_now = %(2) ⏎ MX,%(2)+1").ends_at(4.0, 3.0, 0.0);
    assert_eq!(run("J3,0,3,0 ⏎ PRINT %(2)").printed(), "3\n");
}

#[test]
fn sbp_lang_sysvar_computed() {
    let mut host = FakeHost::default();
    host.inputs[1] = true;
    let ran = run_with("&p=1 ⏎ &a=%(50+&p) ⏎ MX,&a", host, Session::default());
    ran.ends_at(1.0, 0.0, 0.0);
}

#[test]
fn sbp_lang_sysvar_units() {
    assert_eq!(run("MX,1 ⏎ PRINT %(1) ⏎ VD,,,1 ⏎ PRINT %(1)").printed(), "1\n25.4\n");
}

#[test]
fn sbp_lang_sysvar_unknown() {
    refuses("&a=%(500)", "no system variable 500");
    for number in [24, 26, 45, 59, 64, 65, 69, 70, 110] {
        let ran = run(&format!("&a=%({number}) ⏎ IF &a = \"\" THEN MX,1"));
        ran.ended(Status::Ok).ends_at(1.0, 0.0, 0.0);
        assert!(ran.told().contains(&format!("{number}")), "{number}: {}", ran.told());
    }
}

#[test]
fn sbp_lang_sysvar_readonly() {
    refuses("%(1)=5", "read-only");
}

#[test]
fn sbp_lang_label() {
    run("Start: ⏎ MX,1").ends_at(1.0, 0.0, 0.0);
    run("Start: 'here ⏎ MX,1").ends_at(1.0, 0.0, 0.0);
    refuses("Start: MX,1", "");
}

#[test]
fn sbp_lang_label_case_indent() {
    run("GOTO done ⏎ MX,9 ⏎    DONE: ⏎ MX,1").ends_at(1.0, 0.0, 0.0);
}

#[test]
fn sbp_lang_label_spaces() {
    let program = "GOTO SECOND PLUNGE ⏎ MX,9 ⏎ SECOND PLUNGE: ⏎ MX,1";
    run(program).ends_at(1.0, 0.0, 0.0);
    assert!(warnings(program).is_empty());
}

#[test]
fn sbp_lang_label_duplicate() {
    let program = "A: ⏎ &n=1 ⏎ GOTO B ⏎ A: ⏎ &n=2 ⏎ B:";
    assert_eq!(warnings(program), [(Code::RepeatedLabel, 4)]);
    assert_eq!(run(program).variable("n"), "1");
    assert_eq!(run("GOTO A ⏎ &n=0 ⏎ A: ⏎ &n=1 ⏎ END ⏎ A: ⏎ &n=2").variable("n"), "1");
}

#[test]
fn sbp_lang_label_scope() {
    let ran = run_files("FP,in.sbp ⏎ Here: ⏎ MX,1", &[("in.sbp", "GOTO Here")]);
    ran.ended(Status::Failed).fails_with("label HERE not found");
    assert_eq!(ran.error.as_ref().map(|e| e.place.file.to_string()), Some("in.sbp".into()));
}

#[test]
fn sbp_lang_setup_lines() {
    let ran = run("VS,1.25,.45 ⏎ VC,.25 ⏎ SA ⏎ MX,1 ⏎ PRINT %(71);\" \";%(73);\" \";%(23)");
    assert_eq!(ran.printed(), "1.25 0.45 0.25\n");
    assert_eq!(ran.session.settings.speeds, Session::default().settings.speeds);
}

#[test]
fn sbp_lang_first_example() {
    let ran = run(
        "JZ, .5 ⏎ J2, 10, 10 ⏎ MZ, -.25 ⏎ M2, 20, 10 ⏎ M2, 20, 5 ⏎ M2, 10, 5 ⏎ M2, 10, 10 ⏎ JZ, .5",
    );
    let expected = [
        (MoveKind::Jog, [0.0, 0.0, 0.5]),
        (MoveKind::Jog, [10.0, 10.0, 0.5]),
        (MoveKind::Cut, [10.0, 10.0, -0.25]),
        (MoveKind::Cut, [20.0, 10.0, -0.25]),
        (MoveKind::Cut, [20.0, 5.0, -0.25]),
        (MoveKind::Cut, [10.0, 5.0, -0.25]),
        (MoveKind::Cut, [10.0, 10.0, -0.25]),
        (MoveKind::Jog, [10.0, 10.0, 0.5]),
    ];
    assert_eq!(ran.moves(), expected);
}

#[test]
fn doubtful_spellings_of_real_files_run() {
    run("&a=1 ⏎ IF(&a=1)THEN MX,1").ends_at(1.0, 0.0, 0.0);
    run("&a=2 ⏎ IF &a => 2 THEN MX,1").ends_at(1.0, 0.0, 0.0);
    run("GOTO X: ⏎ MX,9 ⏎ X: ⏎ MX,1").ends_at(1.0, 0.0, 0.0);
    run("&x= ⏎ IF &x = \"\" THEN MX,1").ends_at(1.0, 0.0, 0.0);
    run("IF &zup = \"\" THEN &zup = 2 ⏎ MX,&zup").ends_at(2.0, 0.0, 0.0);
    run("&a := 3 ⏎ &a := 4 ⏎ MX,&a").ends_at(3.0, 0.0, 0.0);
    run("GOTO nowhere").ended(Status::Failed).fails_with("not found");
    run("MX,1 ⏎ END ⏎ GOTO nowhere").ended(Status::Ok);
    run("&a=1 ⏎ IF &a > 5 THEN MX, 9").ends_at(0.0, 0.0, 0.0);
}

/// A million lines are read and run to the last point, and the last line has its number.
#[test]
fn sbp_lang_size() {
    run("MX,1").ends_at(1.0, 0.0, 0.0);
    let mut text = String::new();
    for i in 1..=1_000_000_u32 {
        let (x, z) = (i % 1000, i / 100_000);
        text.push_str(&format!("M3,{x},{}.5,-.{z}\n", i % 977));
    }
    let program = read("size.sbp".into(), text.as_bytes());
    assert_eq!((program.lines.len(), program.numbers.len()), (1_000_000, 3_000_000));
    let mut interpreter = Interpreter::new(program, Session::default(), Options::default());
    let (mut host, mut commands) = (FakeHost::default(), Vec::new());
    let (mut lines, mut last) = (0, None);
    while !matches!(interpreter.step(&mut host, &mut commands), Step::Done(..)) {
        lines += commands.iter().filter(|c| matches!(c.command, Command::Line(_))).count();
        last = commands.last().map(|c| c.at.line).or(last);
        commands.clear();
    }
    assert_eq!((lines, last), (1_000_000, Some(1_000_000)));
    let session = interpreter.into_session();
    let at = session.settings.to_user(session.frame.working(session.position)).first3();
    assert!((at[0], at[1]) == (0.0, 529.5) && (at[2] + 0.1).abs() < 1e-9, "{at:?}");
}
