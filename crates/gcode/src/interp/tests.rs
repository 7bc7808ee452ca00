#![allow(clippy::unwrap_used)]

use crate::testing::{FakeHost, Ran, metric, run, run_with};
use crate::{Dialect, Options, Session, Tool};
use kerf_program::{Answer, Axes, Axis, Button, Command, Feed, Status};

/// The motion of a program in millimetres.
#[track_caller]
fn path(text: &str, expected: &str) {
    let ran = run(&format!("G21 F100⏎{text}"));
    assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
    assert_eq!(ran.path(), expected, "{text}");
}

/// The code of the error that ends a program.
#[track_caller]
fn fails(text: &str, expected: &str) {
    let ran = run(&format!("G21 F100⏎{text}"));
    let found = ran
        .error
        .as_ref()
        .map(|e| format!("{} {}:{} {}", e.code, e.place.line, e.place.column, e.message));
    assert!(
        found.as_ref().is_some_and(|f| f.starts_with(expected)),
        "{text}: {found:?} is not {expected}"
    );
    assert_eq!(ran.status, Status::Failed);
}

/// What is given beside motion.
#[track_caller]
fn others(text: &str, expected: &str) {
    let ran = run(&format!("G21 F100⏎{text}"));
    assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
    assert_eq!(ran.others(), expected, "{text}");
}

fn prints(text: &str, expected: &str) {
    others(&format!("{text}⏎(PRINT,#<_r>)"), &format!("print={expected}"));
}

fn feeds(ran: &Ran) -> Vec<Feed> {
    let feeds = ran.commands.iter().filter_map(|c| match &c.command {
        Command::Line(l) => Some(l.feed),
        Command::Arc(a) => Some(a.feed),
        _ => None,
    });
    feeds.collect()
}

#[test]
fn straight_moves() {
    path("G0 X1 Y2 Z3⏎G1 X4⏎Y5", "J1,2,3 L4,2,3 L4,5,3");
    path("G91 G0 X1⏎X1 Y1⏎G90 X0", "J1,0,0 J2,1,0 J0,1,0");
    path("G1 X1⏎X1", "L1,0,0");
    path("G0 @10 ^90⏎^180⏎G91 @5", "J0,10,0 J-10,0,0 J-15,0,0");
    path("G20 G0 X1⏎G21 X1⏎G70 X2⏎G71 X2", "J25.4,0,0 J1,0,0 J50.8,0,0 J2,0,0");
}

#[test]
fn arcs_by_centre_and_by_radius() {
    path("G2 X20 Y-20 I0 J-20", "A20,-20,0@0,-20:-90");
    path("G2 X20 Y-20 R20", "A20,-20,0@0,-20:-90");
    path("G3 X20 Y-20 R20", "A20,-20,0@20,0:90");
    path("G2 X20 Y-20 R-20", "A20,-20,0@20,0:-270");
    path("G3 I5", "A0,0,0@5,0:360");
    path("G3 I5 Z-3 P3", "A0,0,-3@5,0:1080");
    path("G90.1 G0 X10⏎G2 X0 Y-10 I0 J0", "J10,0,0 A0,-10,0@0,0:-90");
    path("G2 X10 I5⏎X20 I5", "A10,0,0@5,0:-180 A20,0,0@15,0:-180");
    path("G2 X10 I5⏎I3", "A10,0,0@5,0:-180 A10,0,0@13,0:-360");
}

#[test]
fn arcs_that_are_none() {
    fails("G2 X10 Y10 I10 J10", "R018 2:1 an arc without a radius");
    fails(
        "G2 X10 Y0 I2",
        "R018 2:1 the end is not on the circle: radius 2.0000 mm at the start, 8.0000 at the end",
    );
    fails("G2 X10 R4", "R018 2:1 the radius 4.0000 mm is too short");
    fails("G2 X0 R4", "R018 2:1 an arc by radius that ends");
    fails("G2 X10", "G008 2:1 an arc without centre");
    fails("G2 X10 R5 I5", "G007 2:1 R together");
    fails("G2 X10 I5 K1", "G023 2:1 K does not lie");
    fails("G2 I5 P1.5", "R009 2:1");
    fails("G90.1 G2 X10 I5", "G008 2:1 half a centre");
}

#[test]
fn arcs_beside_xy_are_chords_within_the_tolerance() {
    for (code, u, v, text) in [
        ("G18", 2, 0, "G2 X10 Z10 I0 K10"),
        ("G19", 1, 2, "G3 Y10 Z10 J10 K0"),
        ("G18", 2, 0, "G3 I10 Y5"),
    ] {
        let ran = run(&format!("G21 F100 {code}⏎{text}"));
        assert!(ran.error.is_none(), "{:?}", ran.error);
        let places: Vec<Axes> = ran
            .commands
            .iter()
            .filter_map(|c| match &c.command {
                Command::Line(l) => Some(l.to),
                _ => None,
            })
            .collect();
        assert!(places.len() > 20, "{code}: {}", places.len());
        let centre = if text.contains("I10") { [0.0, 10.0] } else { [10.0, 0.0] };
        let mut before = Axes::default();
        for to in places {
            let radius = |p: Axes| (p.0[u] - centre[0]).hypot(p.0[v] - centre[1]);
            assert!((radius(to) - 10.0).abs() < 1e-9, "{to:?}");
            let middle = before.zip(to, |a, b| (a + b) / 2.0);
            assert!(radius(middle) > 10.0 - 0.005 - 1e-9, "{middle:?}");
            before = to;
        }
    }
}

#[test]
fn feeds_are_per_minute_and_modal() {
    let ran = run("G21 F120⏎G1 X5⏎X6⏎G1 A9⏎G93 G1 X7 F2⏎G94 F60 X8⏎G95 S1000 F0.1 X9⏎G0 X0");
    let expected = [
        Feed::Path(2.0),
        Feed::Path(2.0),
        Feed::Path(2.0),
        Feed::Time(30.0),
        Feed::Path(1.0),
        Feed::Path(0.1 / 60.0 * 1000.0),
        Feed::Axis,
    ];
    assert_eq!(feeds(&ran), expected, "{:?}", ran.error);
    let inches = run("G20 F120⏎G1 X5");
    assert_eq!(feeds(&inches), [Feed::Path(50.8)]);
}

#[test]
fn cutting_needs_a_feed() {
    fails("F0⏎G1 X1", "G016 3:1");
    fails("G93 G1 X1 F2⏎X2", "G016 3:1 no F in this block");
    fails("G93⏎G94⏎G1 X1", "G016 4:1");
    let generic = Options { dialect: Dialect::Generic, ..Options::default() };
    let ran = run_with("G21⏎G1 X1⏎X2", FakeHost::default(), metric(), generic);
    assert_eq!((ran.codes().as_str(), ran.path().as_str()), ("G016", "L1,0,0 L2,0,0"));
    assert_eq!(feeds(&ran), [Feed::Axis; 2]);
}

#[test]
fn coordinate_systems() {
    path("G10 L2 P2 X10 Y20⏎G55 G0 X1⏎G54 X1", "J11,0,0 J1,0,0");
    path("G0 X5⏎G10 L20 P1 X0⏎X1", "J5,0,0 J6,0,0");
    path("G0 X5⏎G92 X0⏎X1⏎G92.2⏎X1⏎G92.3⏎X1⏎G92.1⏎X1", "J5,0,0 J6,0,0 J1,0,0 J6,0,0 J1,0,0");
    path("G52 X10⏎G0 X1⏎G52 X0⏎X1", "J11,0,0 J1,0,0");
    path("G10 L2 P1 R90⏎G0 X10⏎Y5⏎G3 X10 Y5 I-1", "J0,10,0 J-5,10,0 A-5,10,0@-5,9:360");
    path("G10 L2 P1 R90⏎G0 X10⏎G10 L20 P1 X3 Y4⏎G0 X4 Y4", "J0,10,0 J0,11,0");
    path("G10 L2 P9 X7⏎G59.3 G0 X1⏎G53 G0 X1", "J8,0,0 J1,0,0");
    path("G43.1 Z12⏎G0 Z1⏎G49⏎Z1", "J0,0,13 J0,0,1");
    path("G10 L1 P3 Z40⏎G43 H3⏎G0 Z0", "J0,0,40");
    path("G0 X1 Y2⏎G28.1⏎G0 X9 Y9 Z9⏎G28 Z10⏎G28", "J1,2,0 J9,9,9 J9,9,10 J9,9,0 J1,2,0");
    path("G20⏎G10 L2 P1 X1⏎G21⏎G0 X1", "J26.4,0,0");
    fails("G10 L2 P10 X0", "R009");
    fails("G10 L7 P1 X0", "R009 2:1 G10 L7");
    fails("G91⏎G53 G0 X1", "G007");
    fails("G53 G2 X1 I1", "G007");
}

#[test]
fn the_frame_tells_where_zero_is_and_follows_another_language() {
    let ran = run("G21⏎G10 L2 P1 X10⏎G92 Y5");
    assert_eq!(ran.session.frame.working_zero.first3(), [10.0, -5.0, 0.0]);
    let mut session = metric();
    session.frame.working_zero = Axes::xyz(100.0, 0.0, 0.0);
    let ran = run_with("G21 G0 X1", FakeHost::default(), session, Options::default());
    assert_eq!(ran.path(), "J101,0,0");
    assert_eq!(ran.session.state.systems[0].offset[Axis::X], 100.0);
}

#[test]
fn canned_cycles() {
    path(
        "G0 Z10⏎G98⏎G81 X1 Y1 R2 Z-1⏎X2⏎G80",
        "J0,0,10 J1,1,10 J1,1,2 L1,1,-1 J1,1,10 J2,1,10 J2,1,2 L2,1,-1 J2,1,10",
    );
    path(
        "G0 Z10⏎G99 G81 X1 R2 Z-1⏎X2",
        "J0,0,10 J1,0,10 J1,0,2 L1,0,-1 J1,0,2 J2,0,2 L2,0,-1 J2,0,2",
    );
    path("G91 G99 G81 X1 R1 Z-2 L2", "J0,0,1 J1,0,1 L1,0,-1 J1,0,1 J2,0,1 L2,0,-1 J2,0,1");
    path(
        "G99⏎G83 X0 R1 Z-1.2 Q1",
        "J0,0,1 L0,0,0 J0,0,1 J0,0,0.254 L0,0,-1 J0,0,1 J0,0,-0.746 L0,0,-1.2 J0,0,1",
    );
    path("G99⏎G73 X0 R1 Z-1.2 Q1", "J0,0,1 L0,0,0 J0,0,0.254 L0,0,-1 J0,0,-0.746 L0,0,-1.2 J0,0,1");
    path("G99⏎G85 X1 R1 Z-1", "J0,0,1 J1,0,1 L1,0,-1 L1,0,1");
    path("G17 G99⏎G18 G81 X1 Y-2 R3 Z1", "J0,3,0 J1,3,1 L1,-2,1 J1,3,1");
    others(
        "M3 S9⏎G82 X1 R1 Z-1 P0.5⏎G84 X1⏎G86 X2",
        "rpm=9 clockwise out1=1 wait=0.5 wait=0.5 counterclockwise clockwise wait=0.5 off out1=0 clockwise out1=1",
    );
    fails("G81 X1 Z-1", "G008 2:1 G81 without R");
    fails("G81 X1 R1", "G008 2:1 G81 without Z");
    fails("G81 X1 R-2 Z-1", "R009 2:1 R lies below Z");
    fails("G83 X1 R2 Z-1", "G008 2:1 G83 without Q");
    fails("G84 X1 R2 Z-1", "G008 2:1 G84 while the spindle stands");
    fails("G81 X1 R1 Z-1⏎G80 X2", "G009 3:1 X without a motion");
}

#[test]
fn splines_stay_within_the_tolerance() {
    let ran = run("G21 F100⏎G5 X10 Y0 I0 J10 P0 Q10⏎G5 X20 P0 Q-10");
    assert!(ran.error.is_none(), "{:?}", ran.error);
    assert_eq!(ran.end(), "20,0,0");
    let top = ran.commands.iter().fold((0.0f64, 0.0f64), |(high, low), c| match &c.command {
        Command::Line(l) => (high.max(l.to[Axis::Y]), low.min(l.to[Axis::Y])),
        _ => (high, low),
    });
    assert!((top.0 - 7.5).abs() < 0.01 && (top.1 + 7.5).abs() < 0.01, "{top:?}");
    // A quadratic curve is a parabola: y = x (10 − x) / 5 at these control points.
    let ran = run("G21 F100⏎G5.1 X10 I5 J10");
    for c in &ran.commands {
        if let Command::Line(l) = &c.command {
            let (x, y) = (l.to[Axis::X], l.to[Axis::Y]);
            assert!((y - x * (10.0 - x) / 5.0).abs() < 1e-9, "{x} {y}");
        }
    }
    // With weights 1, √½, 1 a quadratic rational curve is a quarter circle.
    let ran = run("G21 F100⏎G0 X10⏎G5.2 X10 Y10 P0.70710678118 L3⏎X0 Y10 P1⏎G5.3⏎G1 X0");
    assert!(ran.error.is_none(), "{:?}", ran.error);
    for c in &ran.commands[2..] {
        if let Command::Line(l) = &c.command {
            let radius = l.to[Axis::X].hypot(l.to[Axis::Y]);
            assert!((radius - 10.0).abs() < 1e-6, "{l:?}");
        }
    }
    fails("G5 X1 P1 Q1", "G008 2:1 G5 needs");
    fails("G5.1 X1", "G008 2:1 G5.1 needs");
    fails("G18 G5.1 X1 I1 J1", "G023");
    fails("G5.2 X1 Y1⏎G1 X2", "G008 3:1 G5.2 without G5.3");
    fails("G5.3", "G008 2:1 G5.3 without G5.2");
}

#[test]
fn spindle_coolant_and_modes() {
    others(
        "M3 S1000⏎S2000⏎S2000⏎M4⏎M5",
        "rpm=1000 clockwise out1=1 rpm=2000 counterclockwise off out1=0",
    );
    others("M7 M8⏎M9", "mist=true,flood=true mist=false,flood=false");
    others("M49⏎M48⏎M50 P0", "overrides=false,false overrides=true,true overrides=false,true");
    others(
        "G61⏎G61.1⏎G64 P0.1⏎G64 P0.1 Q0.2",
        "ExactPath ExactStop Blend { tolerance_mm: Some(0.1), merge_mm: Some(0.1) } Blend { tolerance_mm: Some(0.1), merge_mm: Some(0.2) }",
    );
    others("G4 P1.5", "wait=1.5");
    others("M64 P0⏎M65 P0⏎M68 E1 Q50", "out1=1 out1=0 pwm2=50");
    others(
        "S100 M3⏎M70⏎S200 M5⏎M72",
        "rpm=100 clockwise out1=1 rpm=200 off out1=0 rpm=100 clockwise out1=1",
    );
    fails("M64 P12", "R009");
    fails("M72", "G014");
    let laser = Options { laser: true, ..Options::default() };
    let ran = run_with("G21⏎M4 S500", FakeHost::default(), metric(), laser);
    assert_eq!(ran.others(), "rpm=500 dynamic out1=1");
}

#[test]
fn stops_ask_the_operator() {
    let ran = run("G21⏎(MSG,turn it over)⏎M0⏎G0 X1⏎M1⏎T3 M6⏎T3 M6⏎M30⏎G0 X9");
    let asked: Vec<&str> = ran.host.asked.iter().map(|q| q.text.as_str()).collect();
    assert_eq!(asked, ["program stop (M0)", "put in tool 3"]);
    assert_eq!((ran.path().as_str(), ran.status), ("J1,0,0", Status::Ok));
    let host = FakeHost { answers: vec![Answer::Button(Button::Cancel)], ..FakeHost::default() };
    let ran = run_with("G21 G0 X1⏎M0⏎G0 X2", host, metric(), Options::default());
    assert_eq!((ran.path().as_str(), ran.status), ("J1,0,0", Status::Stopped));
}

#[test]
fn the_end_of_a_program() {
    path("G0 X1⏎M2⏎X2", "J1,0,0");
    let ran = run("%⏎G21 G0 X1⏎%⏎X2");
    assert_eq!(ran.path(), "J1,0,0");
    let ran = run("G21 M3 S1 M8⏎M30");
    assert_eq!(
        ran.others(),
        "rpm=1 clockwise out1=1 mist=false,flood=true off out1=0 mist=false,flood=false"
    );
    let ran = run("G0 X1⏎M99");
    assert_eq!(ran.status, Status::Limit);
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
fn words_that_nothing_uses() {
    fails("X1", "G009 2:1 X without a motion");
    fails("G1 X1 K2", "G009 2:1 nothing in this block uses K");
    fails("G0 X1 P2", "G009");
    fails("U5", "G009 2:1 there is no axis U");
    fails("M3 Q1", "G009");
    let generic = Options { dialect: Dialect::Generic, ..Options::default() };
    let ran = run_with("G21⏎G0 X1 D5", FakeHost::default(), metric(), generic);
    assert_eq!((ran.codes().as_str(), ran.path().as_str()), ("G009", "J1,0,0"));
    let mut session = metric();
    session.settings.axis_count = 3;
    let ran = run_with("G21⏎G0 A1", FakeHost::default(), session, Options::default());
    assert_eq!(ran.codes(), "R011");
}

#[test]
fn dialects() {
    let grbl = |text: &str| {
        let options = Options { dialect: Dialect::Grbl, ..Options::default() };
        run_with(text, FakeHost::default(), Session::default(), options)
    };
    assert_eq!(grbl("G0 X1").path(), "J1,0,0");
    assert_eq!(grbl("G0 X1").codes(), "");
    assert_eq!(grbl("$H⏎$100=250⏎G0 X1").codes(), "G020");
    for text in
        ["G81 X1 Z-1 R1", "G41 D1", "M6", "M98 P1", "#1=[2]⏎X[1]", "O1 call", "G59.1", "G64", "G98"]
    {
        assert_eq!(grbl(text).codes(), "G019", "{text}");
    }
    let ran = run_with("G0 X1", FakeHost::default(), Session::default(), Options::default());
    assert_eq!((ran.path().as_str(), ran.codes().as_str()), ("J25.4,0,0", "G021"));
    let ran = run("$H");
    assert_eq!((ran.codes().as_str(), ran.status), ("G020", Status::Failed));
}

#[test]
fn block_delete_and_optional_stop() {
    path("/G0 X1⏎G0 Y1", "J1,0,0 J1,1,0");
    let options = Options { block_delete: 1, optional_stop: true, ..Options::default() };
    let ran = run_with("G21⏎/G0 X1⏎/2 G0 X2⏎G0 Y1⏎M1", FakeHost::default(), metric(), options);
    assert_eq!((ran.path().as_str(), ran.host.asked.len()), ("J2,0,0 J2,1,0", 1));
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
fn inputs_answer_in_5399() {
    let mut host = FakeHost::default();
    host.inputs[3] = true;
    let ran = run_with("G21⏎M66 P2 L0⏎G0 X#5399⏎M66 P4 L3 Q5", host, metric(), Options::default());
    assert_eq!(ran.path(), "J1,0,0");
    assert_eq!(ran.host.asked.iter().map(|q| q.until).collect::<Vec<_>>(), [Some((5, true))]);
}

#[test]
fn file_parameters_scale_and_shift() {
    let options = Options {
        proportion: [2.0, 2.0, 1.0],
        temporary_zero_mm: [10.0, 4.0, 0.0],
        ..Options::default()
    };
    let ran = run_with("G21 F100⏎G1 X1 Y1⏎G2 X3 I1", FakeHost::default(), metric(), options);
    assert_eq!(ran.path(), "L12,6,0 A16,6,0@14,6:-180");
    let uneven = Options { proportion: [2.0, 1.0, 1.0], ..Options::default() };
    let ran = run_with("G21 F100⏎G2 X20 I10", FakeHost::default(), metric(), uneven);
    let highest = ran.commands.iter().filter_map(|c| match &c.command {
        Command::Line(l) => Some(l.to[Axis::Y]),
        _ => None,
    });
    assert!((highest.fold(0.0, f64::max) - 10.0).abs() < 0.005);
    assert_eq!(ran.end(), "40,0,0");
}

#[test]
fn compensation_of_lines_and_arcs() {
    let with_tool = |text: &str| {
        let mut session = metric();
        session.state.tools.insert(1, Tool { diameter_mm: 2.0, ..Tool::default() });
        run_with(
            &format!("G21 F100⏎T1 M6⏎{text}"),
            FakeHost::default(),
            session,
            Options::default(),
        )
    };
    let check = |text: &str, expected: &str| {
        let ran = with_tool(text);
        assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
        assert_eq!(ran.path(), expected, "{text}");
    };
    // An outside corner is rounded, an inside corner cut short.
    check(
        "G41⏎G1 X10⏎Y-10⏎X0⏎G40⏎G0 X0 Y0",
        "L10,1,0 A11,0,0@10,0:-90 L11,-10,0 A10,-11,0@10,-10:-90 L0,-11,0 J0,0,0",
    );
    check("G42⏎G1 X10⏎X20⏎Y-10⏎G40", "L10,-1,0 L19,-1,0 L19,-10,0");
    // A tangent arc keeps its centre.
    check("G41⏎G1 X10⏎G3 X20 Y10 J10⏎G1 Y20⏎G40", "L10,1,0 A19,10,0@10,10:90 L19,20,0");
    check("G42⏎G1 X10⏎G3 X20 Y10 J10⏎G1 Y20⏎G40", "L10,-1,0 A21,10,0@10,10:90 L21,20,0");
    // Z moves keep their place between the others.
    check("G41⏎G1 X10⏎Z-1⏎X20⏎Y10⏎G40", "L10,1,0 L10,1,-1 L19,1,-1 L19,10,-1");
    check("G41.1 D4⏎G1 X10⏎G40", "L10,2,0");
    check("G42 D1⏎G1 X10 Y0⏎G2 X20 I5⏎G40", "L10,-1,0 A11,0,0@10,0:90 A19,0,0@15,0:-180");
    let codes = |text: &str| with_tool(text).codes();
    assert_eq!(codes("G41⏎G1 X0.5"), "G017");
    assert_eq!(codes("G41⏎G41"), "G017");
    assert_eq!(codes("G18⏎G41"), "G017");
    assert_eq!(codes("G41⏎G55"), "G017");
    assert_eq!(codes("G41⏎G1 X10⏎G3 X10.5 Y0.5 J0.5"), "G017");
    assert_eq!(codes("G41⏎G1 X10⏎X10.5⏎Y10"), "G017");
    assert_eq!(codes("G41⏎G1 X10⏎G40⏎G2 X12 I1"), "G017");
    check("G41⏎G1 X10⏎G40⏎G0 Z1⏎X10", "L10,1,0 J10,0,1");
    check("G41⏎G1 X10⏎G40⏎G0 X10 Y0", "L10,1,0 J10,0,0");
    assert_eq!(codes("G41⏎G1 X10⏎X20⏎Y0.5⏎X10"), "G017");
    assert_eq!(codes("G41 D7⏎G1 X10⏎G40"), "W014");
}
