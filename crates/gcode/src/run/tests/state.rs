//! Modes, offsets, stops, dialects.

use super::*;

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
    let ran = run("G21⏎(MSG,turn it over)⏎M0⏎G0 X1⏎M1⏎T3 M6⏎T3 M6⏎M60⏎M30⏎G0 X9");
    let asked: Vec<&str> = ran.host.asked.iter().map(|q| q.text.as_str()).collect();
    assert_eq!(asked, ["program stop (M0)", "put in tool 3", "program stop (M60)"]);
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
fn inputs_answer_in_5399() {
    let mut host = FakeHost::default();
    host.inputs[3] = true;
    let ran = run_with("G21⏎M66 P2 L0⏎G0 X#5399⏎M66 P4 L3 Q5", host, metric(), Options::default());
    assert_eq!(ran.path(), "J1,0,0");
    assert_eq!(ran.host.asked.iter().map(|q| q.until).collect::<Vec<_>>(), [Some((5, true))]);
}
