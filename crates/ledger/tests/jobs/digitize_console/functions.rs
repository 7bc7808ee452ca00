//! The functions of digitizing.

use super::*;

#[test]
fn pro_digitize_d0() {
    let mut console = with("L0,0 L10,0");
    console.press("File");
    to(&mut console, "5,5");
    console.press("Func 0 Enter");
    assert_eq!(
        (points(&console).as_str(), cur(&console).as_str()),
        ("L0,0 L5,5 L10,0", "Cur=2 of 3")
    );
}

#[test]
fn pro_digitize_d1() {
    let mut console = with("L0,0 L10,0");
    to(&mut console, "5,5");
    console.press("Func 1 Enter");
    assert_eq!(
        (points(&console).as_str(), cur(&console).as_str()),
        ("L0,0 L5,5 L10,0", "Cur=2 of 3")
    );
}

#[test]
fn pro_digitize_d2() {
    let mut console = with("L1,0 L2,0 L3,0 L4,0 L5,0");
    console.press("File File Func 2 Enter");
    assert_eq!(
        (points(&console).as_str(), cur(&console).as_str()),
        ("L1,0 L2,0 L4,0 L5,0", "Cur=3 of 4")
    );
    console.press("Start Func 2 Enter");
    assert_eq!(
        (points(&console).as_str(), cur(&console).as_str()),
        ("L1,0 L2,0 L4,0", "Cur=3 of 3")
    );
}

#[test]
fn pro_digitize_d3() {
    let mut console = with("L0,0 L10,0 L20,0 L30,0");
    console.press("File File");
    to(&mut console, "10,2");
    console.press("- Func 3 Enter");
    assert_eq!(points(&console), "L0,0 A10,2 L20,0 L30,0");
}

const ROUND: &str = "L0,0 A5,-5 L10,0 L10,10";

#[test]
fn pro_digitize_d4() {
    let mut console = with(ROUND);
    console.press("Func 5 Enter Func 4 Enter");
    let expected = ["ccw about 5,0 to 5,-5", "ccw about 5,0 to 10,0", "10,10"];
    assert_eq!(ways(&console), expected);
    assert_eq!((cur(&console).as_str(), tool(&console)), ("Cur=4 of 4", [10.0, 10.0]));
}

#[test]
fn pro_digitize_d5() {
    let mut console = with(ROUND);
    console.press("Func 5 Enter");
    assert_eq!(ways(&console), ["10,0", "cw about 5,0 to 5,-5", "cw about 5,0 to 0,0"]);
    assert_eq!(cur(&console), "Cur=1 of 4");
    assert!(near(tool(&console), [0.0, 0.0]));
}

#[test]
fn pro_digitize_d6() {
    let mut console = with("L0,0 L10,0 L20,0");
    console.press("File");
    to(&mut console, "30,40");
    console.press("Func 6 Enter");
    assert_eq!(ways(&console), ["10,0"]);
    let made = console.trace().events.iter().find_map(|event| match event {
        Event::Move(made) => Some((made.from.x - made.to.x).hypot(made.from.y - made.to.y)),
        _ => None,
    });
    assert!((made.unwrap() - 44.721).abs() < 1e-3, "{made:?}");
    assert_eq!(cur(&console), "Cur=2 of 3");
}

#[test]
fn pro_digitize_d7() {
    let mut console = with("L0,0 L10,0 L0,90");
    to(&mut console, "9,1");
    console.press("Func 7 Enter");
    assert_eq!((cur(&console).as_str(), tool(&console)), ("Cur=2 of 3", [10.0, 0.0]));
}

#[test]
fn pro_digitize_d8() {
    let mut console = with("L0,0 L10,0");
    console.shapes.push(sq100());
    console.press("Func 8 Enter");
    assert_eq!(console.shows(), ["Shape saved", "2 shapes"]);
    let shape = console.shapes.last().unwrap();
    assert_eq!((shape.path.length(), shape.is_closed(), shape.group), (10.0, false, Group::Black));
    console.press("Enter");
    assert_eq!((points(&console).as_str(), cur(&console).as_str()), ("L0,0 L10,0", "Cur=2 of 2"));
}

#[test]
fn pro_digitize_d9() {
    let mut console = with("L0,0 L10,0");
    console.press("Func 9 Enter");
    assert_eq!(console.shows(), ["closed: 3 points, or", "2 with an arc"]);
    assert!(console.shapes.is_empty());
    record(&mut console, "L0,10");
    console.press("Func 9 Enter");
    let triangle = &console.shapes[0];
    let closes = triangle.path.segment(2);
    let ends = (closes.start(), closes.end());
    assert_eq!(ends, (Point2::new(0.0, 10.0), Point2::new(0.0, 0.0)));
    assert!(matches!(closes, Segment::Line { .. }));
    let mut arc = with("L0,0 A5,-5 L10,0");
    arc.press("Func 9 Enter");
    assert_eq!(arc.shapes[0].path.segment_count(), 2);
}

#[test]
fn pro_digitize_d10() {
    let mut console = with("L0,0 L10,0");
    console.shapes.push(sq100());
    to(&mut console, "50,-3");
    console.press("Func 10 Enter");
    assert_eq!(console.shows(), ["Lose 2 points?", "Enter=yes Func=no"]);
    console.press("Func");
    assert_eq!(cur(&console), "Cur=2 of 2");
    console.press("Func 10 Enter Enter");
    assert_eq!(
        (points(&console).as_str(), cur(&console).as_str()),
        ("L0,0 L100,0 L100,100 L0,100", "Cur=1 of 4")
    );
    // Nothing is lost: nothing is asked.
    console.press("Func 10 Enter");
    assert_eq!(cur(&console), "Cur=1 of 4");
    let mut nothing = begun();
    nothing.press("Func 10 Enter");
    assert_eq!(nothing.shows(), ["there is no shape to", "load"]);
}

#[test]
fn pro_digitize_d11() {
    let mut console = begun();
    console
        .press("Func 12 Enter Enter Func 20 Enter 10 Enter 0 Enter -9 Enter Enter Func 11 Enter");
    assert_eq!(console.shows()[0], "Digitize: 2D Point");
    console.press("Func 8 Enter");
    assert_eq!(console.shapes[0].z_mm, None);
}

#[test]
fn pro_digitize_d12() {
    let mut console = begun();
    console.press("- Func 12 Enter");
    assert_eq!(console.shows()[0], "Digitize: 3D Point");
    console.press("Enter Func 20 Enter 10 Enter 0 Enter -9 Enter Enter Func 8 Enter");
    assert_eq!(console.shapes[0].z_mm, Some(vec![15.0, 11.0]));
}

#[test]
fn pro_digitize_d15() {
    let mut console = with("L1,0 L2,0 L3,0 L4,0 L5,0");
    console.press("Func 8 Enter Enter Func 15 Enter");
    assert_eq!(console.shows(), ["Lose 5 points?", "Enter=yes Func=no"]);
    console.press("Func");
    assert_eq!(cur(&console), "Cur=5 of 5");
    console.press("Func 15 Enter Enter");
    assert_eq!((cur(&console).as_str(), console.shapes.len()), ("Cur=0 of 0", 1));
}

#[test]
fn pro_digitize_d20() {
    let mut console = begun();
    console.press("Func 20 Enter 10 Enter 20 Enter");
    assert_eq!(console.position(), [310.0, 220.0, -5.0]);
    console.press("Func 20 Enter -301 Enter Enter");
    assert_eq!(console.shows()[0], "Out of bounds: x");
    assert_eq!(console.position(), [310.0, 220.0, -5.0]);
}

#[test]
fn pro_digitize_d21() {
    let mut console = begun();
    to(&mut console, "10,20");
    console.press("Func 21 Enter 1 Enter 0 Enter");
    assert_eq!(tool(&console), [11.0, 20.0]);
}

#[test]
fn functions_of_the_picture_are_asked_of_pages() {
    let mut console = begun();
    console.press("Func 30 Enter Func 31 Enter Func 32 Enter Func 33 Enter");
    assert_eq!(console.looks, [Look::Digitized, Look::Data, Look::Machine, Look::Out]);
    assert_eq!(cur(&console), "Cur=0 of 0");
}

#[test]
fn pro_digitize_d38() {
    let mut console = begun();
    console.press("Func 38 Enter 25 Enter");
    assert_eq!(console.shows(), ["Digitize: 2D Point", "Cur=0 of 0"]);
    let made = console.hold(6, 2.0).events.iter().find_map(|event| match event {
        Event::Move(made) => Some(made.speed),
        _ => None,
    });
    assert_eq!(made, Some(50.0));
    assert_eq!(console.machine.speeds.arrow_speed_percent, 25.0);
    console.press("Func 99 Enter Func 38 Enter");
    assert_eq!(cur(&console), "25", "the function of the console sets the same");
}

#[test]
fn pro_digitize_d39() {
    let mut console = begun();
    console.press("Func 38 Enter 100 Enter Func 39 Enter 50 Enter");
    // 500 mm/s²: in 0.2 s up to 100 mm/s and in as long down again, 20 mm.
    let before = console.position()[0];
    console.hold(6, 0.2);
    let way = console.position()[0] - before;
    assert!((way - 20.0).abs() < 0.1, "{way}");
    assert_eq!(console.machine.speeds.arrow_accel_percent, 50.0);
    console.press("Func 99 Enter Func 39 Enter");
    assert_eq!(cur(&console), "50", "the function of the console sets the same");
}

#[test]
fn pro_digitize_d40() {
    let mut console = begun();
    to(&mut console, "10,20");
    console.press("Func 40 Enter");
    assert_eq!(console.shows(), ["Digitize: 2D Point", "10.00 20.00 -5.00"]);
    console.hold(6, 0.1);
    assert_ne!(cur(&console), "10.00 20.00 -5.00");
    console.press("-");
    assert_eq!(console.shows(), ["Digitize: 2D Arc", "Cur=0 of 0"]);
}

#[test]
fn pro_digitize_d99() {
    let mut console = with("L0,0 L10,0");
    console.press("Func 99 Enter");
    assert_eq!(console.shows(), ["Lose 2 points?", "Enter=exit Func=no"]);
    console.press("Func");
    assert_eq!(console.shows(), ["Digitize: 2D Point", "Cur=2 of 2"]);
    console.press("Func 8 Enter Enter Func 99 Enter");
    assert_eq!(console.shows()[0], "JOB: Untitled");
    assert!(console.digitized().is_none());
}

#[test]
fn a_note_is_read_without_losing_points() {
    let mut console = with("L0,0");
    console.press("Func 9 Enter Enter Enter");
    assert_eq!(
        cur(&console),
        "Cur=2 of 2",
        "the first Enter puts the note away, the second records"
    );
}
