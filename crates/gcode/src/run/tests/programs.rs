//! Expressions, parameters, O-words, how runs go on.

use super::*;

#[test]
fn a_loop_is_counted_as_the_nearest_whole_number() {
    // 0.3 / 0.1 lies a hair below 3; halves go to the even number, as with LinuxCNC.
    let turns = |count: &str, expected: f64| {
        let ran = run(&format!("G21⏎O1 repeat [{count}]⏎G91 G0 X1⏎O1 endrepeat"));
        assert_eq!(ran.session.position[Axis::X], expected, "{count}");
    };
    turns("0.3 / 0.1", 3.0);
    turns("2.4", 2.0);
    turns("2.7", 3.0);
    turns("2.5", 2.0);
    turns("1.5", 2.0);
    turns("0 - 1", 0.0);
}

#[test]
fn expressions_are_calculated() {
    for (text, value) in [
        ("1+2*3", "7.000000"),
        ("2**3**2", "64.000000"),
        ("[1+2]*3", "9.000000"),
        ("7 MOD 3", "1.000000"),
        ("-7 MOD 3", "2.000000"),
        ("SIN[30]", "0.500000"),
        ("ATAN[1]/[-1]", "135.000000"),
        ("SQRT[16]-ABS[-3]", "1.000000"),
        ("FIX[-2.5]", "-3.000000"),
        ("FUP[2.1]", "3.000000"),
        ("ROUND[2.5]", "3.000000"),
        ("1 EQ 1.0000001", "1.000000"),
        ("1 LT 2 AND 0", "0.000000"),
        ("1 OR 0 XOR 1", "0.000000"),
        ("LN[EXP[2]]", "2.000000"),
        ("-[3]", "-3.000000"),
        ("10-2-3", "5.000000"),
        ("12/3/2", "2.000000"),
        ("EXISTS[#<q>]", "0.000000"),
        ("ACOS[0]+ASIN[1]+TAN[45]", "181.000000"),
    ] {
        prints(&format!("#<_r>=[{text}]"), value);
    }
    fails("G0 X[1/0]", "R003 2:4 division by zero");
    fails("G0 X[SQRT[-1]]", "R004 2:4");
    fails("G0 X#<depth>", "G013 2:4 #<depth> has no value");
    fails("G0 X#9999", "G012 2:4");
    fails("#5420=1", "G012 2:1");
    fails("G0 X#[1.5]", "G012 2:4");
}

#[test]
fn parameters() {
    prints("#1=5⏎#2=[#1+1]⏎#<_r>=##1", "0.000000");
    prints("#5=7⏎#1=5⏎#<_r>=##1", "7.000000");
    prints("#1=1⏎#1=2 #<_r>=#1", "1.000000");
    prints("G20 G0 X2⏎G21⏎#<_r>=#5420", "50.800000");
    prints("G10 L2 P3 X4⏎#<_r>=#5261", "4.000000");
    prints("G0 Y3⏎#<_r>=#<_y>", "3.000000");
    prints("#5221=10⏎G0 X1⏎#<_r>=#<_abs_x>", "11.000000");
    prints("#<a>=1⏎O1 sub⏎#<_r>=EXISTS[#<a>]⏎O1 endsub⏎O1 call", "0.000000");
    prints("#31=8⏎O1 sub⏎#<_r>=[#31 + #1]⏎O1 endsub⏎O1 call [2]", "10.000000");
    others("#1=2.5⏎(PRINT,a #1 %d#1 %.2f#1 #<nix> 50%)", "print=a 2.500000 2 2.50 ###### 50%");
    others(
        "(DEBUG,x=#<_x>)⏎(MSG, hello)⏎(plain)",
        "message=x=0.000000 message=hello message=plain",
    );
}

#[test]
fn flow_of_control() {
    path("O1 sub⏎G0 X#1 Y#2⏎O1 endsub⏎O1 call [1] [2]⏎O1 call [3]", "J1,2,0 J3,0,0");
    path("#1=0⏎O1 while [#1 LT 3]⏎#1=[#1+1]⏎G0 X#1⏎O1 endwhile", "J1,0,0 J2,0,0 J3,0,0");
    path("#1=0⏎O1 do⏎#1=[#1+1]⏎G0 X#1⏎O1 while [#1 LT 2]", "J1,0,0 J2,0,0");
    path("G91⏎O1 repeat [3]⏎G0 X1⏎O1 endrepeat", "J1,0,0 J2,0,0 J3,0,0");
    path(
        "G91⏎O1 repeat [2]⏎O2 repeat [2]⏎G0 X1⏎O2 endrepeat⏎G0 Y1⏎O1 endrepeat",
        "J1,0,0 J2,0,0 J2,1,0 J3,1,0 J4,1,0 J4,2,0",
    );
    for (value, place) in [(1, "J1,0,0"), (2, "J2,0,0"), (3, "J3,0,0"), (4, "J9,0,0")] {
        let text = "O1 if [#1 EQ 1]⏎G0 X1⏎O1 elseif [#1 EQ 2]⏎G0 X2⏎O1 elseif [#1 EQ 3]⏎G0 X3⏎O1 else⏎G0 X9⏎O1 endif";
        path(&format!("#1={value}⏎{text}"), place);
    }
    path(
        "#1=0⏎O1 while [1]⏎#1=[#1+1]⏎O2 if [#1 EQ 2]⏎O1 continue⏎O2 endif⏎O3 if [#1 GT 3]⏎O1 break⏎O3 endif⏎G0 X#1⏎O1 endwhile",
        "J1,0,0 J3,0,0",
    );
    path(
        "G91⏎O1 repeat [5]⏎G0 X1⏎O2 if [#<_x> GT 1]⏎O1 break⏎O2 endif⏎O1 endrepeat⏎G0 Y1",
        "J1,0,0 J2,0,0 J2,1,0",
    );
    path(
        "O1 sub⏎O2 if [#1]⏎O1 return [5]⏎O2 endif⏎G0 X1⏎O1 endsub [7]⏎O1 call [1]⏎G0 Y#<_value>⏎O1 call⏎G0 Y#<_value>",
        "J0,5,0 J1,5,0 J1,7,0",
    );
    path("M98 P7 L2⏎M2⏎O7⏎G91 G0 X1⏎M99", "J1,0,0 J2,0,0");
    path("O<a> sub⏎M73⏎G91 G20⏎G0 X1⏎O<a> endsub⏎O<A> call⏎G0 X1", "J25.4,0,0 J1,0,0");
    fails("O1 call", "G015 2:1 there is no subroutine O1");
    fails("O1 return", "G014");
    fails("O1 sub⏎O1 call⏎O1 endsub⏎O1 call", "R007");
    fails("O1 while [1/0]⏎O1 endwhile", "R003");
    let ran = run("O1 while [1]⏎O1 endwhile");
    assert_eq!((ran.status, ran.codes().as_str()), (Status::Limit, "R014"));
}

#[test]
fn subroutines_in_files() {
    let mut host = FakeHost::default();
    host.files.insert("hole.ngc".into(), "O<hole> sub\nG0 X#1\nO<hole> endsub\nM2\n".into());
    host.files.insert("7.ngc".into(), "G0 Y7\nM99\n".into());
    host.files.insert("bad.ngc".into(), "O<bad> sub\nG0 X\nO<bad> endsub\n".into());
    let text = "G21⏎O<hole> call [4]⏎M98 P7⏎O<hole> call [5]⏎O<bad> call";
    let ran = run_with(text, host, metric(), Options::default());
    assert_eq!(ran.path(), "J4,0,0 J4,7,0 J5,7,0");
    let error = ran.error.unwrap();
    assert_eq!((error.code.as_str(), &*error.place.file, error.place.line), ("G005", "bad.ngc", 2));
}

#[test]
fn a_check_goes_on_behind_an_error() {
    let options = Options { keep_going: true, ..Options::default() };
    let text = "G21⏎G1 X1⏎G1 X2⏎F10 G2 X5 R1⏎G0 X⏎G2 X9 I2⏎G999⏎G0 Y1";
    let ran = run_with(text, FakeHost::default(), metric(), options);
    // A word without a number and an unknown code were told by the reader.
    assert_eq!((ran.codes().as_str(), ran.status), ("G016 R018", Status::Ok));
    assert_eq!(ran.end(), "9,1,0");
}

#[test]
fn a_program_ends_itself_with_a_reason() {
    fails("#1=4⏎(ABORT, too deep by #1)⏎G0 X1", "G024 3:1 too deep by 4.000000");
}

#[test]
fn a_probe_that_meets_nothing_is_told_at_its_own_line() {
    fails("G38.2 Z-10 F100⏎#1=2⏎G0 X1", "G018 2:1 G38.2 ended without");
}

#[test]
fn one_mistake_is_told_once() {
    let options = Options { keep_going: true, ..Options::default() };
    // The reader told the bad word; nothing is said of the lines that relied on its G0.
    let ran = run_with("G21⏎G0 X⏎X2⏎Y3", FakeHost::default(), metric(), options.clone());
    assert_eq!((ran.codes().as_str(), ran.path().as_str()), ("", ""));
    let mut session = metric();
    session.settings.axis_count = 3;
    let ran = run_with("G21⏎G0 X1 A0⏎X2⏎Y3⏎G0 X1⏎Y2", FakeHost::default(), session, options);
    assert_eq!((ran.codes().as_str(), ran.path().as_str()), ("R011", "J1,0,0 J1,2,0"));
}

#[test]
fn a_mistake_before_the_line_to_begin_at_is_passed() {
    let from = Some(kerf_program::GoTo { line: 3, settings: true });
    let options = Options { keep_going: true, from, ..Options::default() };
    let ran = run_with("G21⏎#1=[1/0] G91⏎G0 X1", FakeHost::default(), metric(), options);
    assert_eq!((ran.path().as_str(), ran.status), ("J1,0,0", Status::Ok));
}

#[test]
fn a_step_that_waits_has_no_effect() {
    let text = "G21⏎G0 X1⏎M0⏎G91 M64 P1 G0 X1⏎M66 P0 L0⏎G0 X#5399⏎T2 M6⏎G38.3 X20 F100⏎M2";
    let calm = run(text);
    assert!(calm.error.is_none(), "{:?}", calm.error);
    for busy in [1, 2, 3, 7] {
        let host = FakeHost { busy, ..FakeHost::default() };
        let ran = run_with(text, host, metric(), Options::default());
        assert_eq!(ran.commands, calm.commands, "{busy}");
        assert_eq!(ran.host.asked, calm.host.asked);
    }
}

#[test]
fn a_block_that_holds_the_program_is_carried_out_first() {
    let cases = [
        ("G0 Z50 M0", 2),
        ("G4 P1 M60", 1),
        ("G2 X2 I1 M0", 2),
        ("G81 X3 Z-7 R5 M0", 5),
        ("M0", 1),
    ];
    for (block, moves) in cases {
        let text = format!("G21 F100⏎G1 Z-5⏎#1=1⏎{block} #1=[#1+1] (MSG, look)⏎(PRINT,#1)⏎G0 X99");
        let said = |button| {
            let host = FakeHost { answers: vec![Answer::Button(button)], ..FakeHost::default() };
            run_with(&text, host, metric(), Options::default())
        };
        let ran = said(Button::Cancel);
        let path = ran.path();
        assert_eq!(
            (ran.status, path.split(' ').count()),
            (Status::Stopped, moves),
            "{block}: {path}"
        );
        let asked: Vec<&str> = ran.host.asked.iter().map(|asked| asked.text.as_str()).collect();
        assert_eq!(asked, ["look"], "{block}");
        assert_eq!(ran.others().contains("wait=1"), block.starts_with("G4"), "{block}");
        let ran = said(Button::OK);
        let told = ran.others();
        assert!(told.contains("message=look ") && told.ends_with("print=2.000000"), "{told}");
        assert_eq!(ran.path().split(' ').count(), moves + 1, "{block}: {}", ran.path());
    }
}

#[test]
fn a_block_that_holds_is_answered_at_its_own_line() {
    let mut interpreter = crate::Interpreter::new(
        crate::testing::program("G21 F100⏎G0 X1 M0⏎G0 X2"),
        metric(),
        Options::default(),
    );
    let (mut host, mut out) = (FakeHost::default(), Vec::new());
    // The block, and what it waits for: the machine still moves.
    for _ in 0..4 {
        host.busy = 1;
        if interpreter.step(&mut host, &mut out) == kerf_program::Step::Waiting {
            break;
        }
    }
    assert_eq!(interpreter.call_stack().last().map(|at| at.line), Some(2));
    assert_eq!(host.asked.len(), 0);
}
