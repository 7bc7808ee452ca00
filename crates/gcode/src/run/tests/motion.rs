//! Moves, arcs, cycles, curves, compensation.

use super::*;

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
    let generic = Options { dialect: Dialect::Generic, ..Options::default() };
    let ran = run_with("G21 F100⏎G2 X10 I5 K0.", FakeHost::default(), metric(), generic);
    assert_eq!(ran.end(), "10,0,0");
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
    for dialect in [Dialect::Generic, Dialect::Grbl] {
        let options = Options { dialect, ..Options::default() };
        let ran = run_with("G21⏎G0 X1⏎G1 X2", FakeHost::default(), metric(), options);
        assert_eq!(
            (ran.error.as_ref().unwrap().code.as_str(), ran.path().as_str()),
            ("G016", "J1,0,0")
        );
    }
}

#[test]
fn lines_among_opensbp_have_its_speeds() {
    let options = Options { speeds_known: true, ..Options::default() };
    let ran = run_with("G21⏎G1 X1⏎X2", FakeHost::default(), metric(), options);
    assert_eq!((ran.codes().as_str(), ran.path().as_str()), ("G016", "L1,0,0 L2,0,0"));
    assert_eq!(feeds(&ran), [Feed::Axis; 2]);
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
fn offsets_to_the_present_place_read_what_the_words_of_moves_do() {
    let options = Options {
        proportion: [2.0, 2.0, 1.0],
        temporary_zero_mm: [10.0, 4.0, 0.0],
        ..Options::default()
    };
    for offset in ["G92 X5 Y0", "G10 L20 P1 X5 Y0"] {
        let program = format!("G21 F100⏎G1 X1 Y1⏎{offset}⏎G1 X5 Y1⏎G1 X6");
        let ran = run_with(&program, FakeHost::default(), metric(), options.clone());
        assert_eq!(ran.path(), "L12,6,0 L12,8,0 L14,8,0", "{offset}");
    }
    let shifted = "G21 F100⏎G52 X5⏎G1 X5 Y1⏎G52 X0⏎G1 X10";
    let ran = run_with(shifted, FakeHost::default(), metric(), options);
    assert_eq!(ran.path(), "L30,6,0", "ten units are ten units");
}

#[test]
fn a_file_that_is_mirrored_is_cut_as_its_mirror_image() {
    let program = "G21 F100⏎G41.1 D2 G1 X10 Y10⏎G1 Y30⏎G2 X20 Y40 I10⏎G1 X40⏎G1 Y10⏎G40 G1 X60 Y0⏎\
                   G3 X70 Y10 R10⏎G2 I5";
    let ends = |proportion: [f64; 3]| {
        let options = Options { proportion, ..Options::default() };
        let ran = run_with(program, FakeHost::default(), metric(), options);
        let commands = ran.commands.iter().filter_map(|c| match &c.command {
            Command::Line(line) => Some((line.to, 0.0, [0.0; 2])),
            Command::Arc(arc) => Some((arc.to, arc.sweep_rad, arc.centre)),
            _ => None,
        });
        commands.collect::<Vec<_>>()
    };
    let usual = ends([1.0; 3]);
    assert!(usual.iter().filter(|(_, sweep, _)| *sweep != 0.0).count() >= 3);
    for (x, y) in [(-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
        let mirrored = ends([x, y, 1.0]);
        assert_eq!(mirrored.len(), usual.len());
        for ((to, sweep, centre), (image, turned, middle)) in usual.iter().zip(&mirrored) {
            let places = [(to.0[0], image.0[0], x), (to.0[1], image.0[1], y)];
            let centres = [(centre[0], middle[0], x), (centre[1], middle[1], y)];
            for (place, image, by) in places.into_iter().chain(centres) {
                assert!((place * by - image).abs() < 1e-9, "{place} at {image}");
            }
            assert!((sweep * x * y - turned).abs() < 1e-9, "{sweep} as {turned}");
        }
    }
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
