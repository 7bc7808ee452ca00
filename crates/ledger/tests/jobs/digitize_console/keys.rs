//! Each key of the console, and its effect.

use super::*;

#[test]
fn pro_digitize_key_file() {
    let mut console = with("L-9,0 L-8,0 L0,0 A5,-5 L10,0 L20,0 L30,0 L40,0 L50,0 L60,0 L70,0");
    console.press("Func 5 Enter Start Start Start Start");
    assert_eq!((cur(&console).as_str(), tool(&console)), ("Cur=5 of 11", [10.0, 0.0]));
    console.press("File");
    assert_eq!(ways(&console), ["cw about 5,0 to 5,-5"]);
    console.press("File");
    assert_eq!(ways(&console), ["cw about 5,0 to 0,0"]);
    console.press("Start Start Start File");
    assert_eq!(console.shows(), ["Digitize: 2D Point", "Cur=5 of 11"]);
    console.press("Func 5 Enter");
    let moves = console.moves.len();
    console.press("File");
    assert_eq!(console.moves.len(), moves, "there is nothing before the first point");
}

#[test]
fn pro_digitize_key_start() {
    let mut console = with("L0,0 L1,0 L2,0 L3,0 L4,0 L5,0 L6,0 L7,0 L8,0 L9,0 L10,0");
    let moves = console.moves.len();
    console.press("Start");
    assert_eq!((console.moves.len(), cur(&console).as_str()), (moves, "Cur=11 of 11"));
    console.press("File File File File File File Start");
    assert_eq!((cur(&console).as_str(), tool(&console)), ("Cur=6 of 11", [5.0, 0.0]));
}

#[test]
fn pro_digitize_key_stop__in_entries_and_idle() {
    let mut console = with("L0,0 L10,0");
    let before = (console.shows(), points(&console));
    console.press("Stop");
    assert_eq!((console.shows(), points(&console)), before);
    console.press("Func 4 0");
    assert_eq!(cur(&console), "40 Show position");
    console.press("Stop");
    assert_eq!(cur(&console), "4 Move to end");
    console.press("Func Func 20 Enter 1 2 Stop");
    assert_eq!(console.shows(), ["Move to X mm:", "1"]);
}

#[test]
fn pro_digitize_key_func() {
    let mut console = with("L0,0 L10,0");
    console.press("Func");
    assert_eq!(console.shows(), ["Enter function:", "0 Insert after"]);
    console.press("Func");
    assert_eq!(console.shows(), ["Digitize: 2D Point", "Cur=2 of 2"]);
    console.press("Func 2 Enter");
    assert_eq!(points(&console), "L0,0");
    let beeps = console.beeps();
    console.press("Func 13 Enter");
    assert_eq!((cur(&console).as_str(), console.beeps()), ("13 ?", beeps + 1));
}

#[test]
fn pro_digitize_key_pm() {
    let mut console = begun();
    console.press("-");
    assert_eq!(console.shows()[0], "Digitize: 2D Arc");
    console.press("-");
    assert_eq!(console.shows()[0], "Digitize: 2D Point");
}

#[test]
fn pro_digitize_key_enter() {
    let mut console = begun();
    console.press("Enter");
    assert_eq!(cur(&console), "Cur=1 of 1");
    to(&mut console, "10,0");
    console.press("- Enter");
    assert_eq!((cur(&console).as_str(), points(&console).as_str()), ("Cur=2 of 2", "L0,0 A10,0"));
}

#[test]
fn pro_digitize_key_digits() {
    let mut console = with("L0,0 L10,0");
    console.press("Func 20 Enter 100 Enter 100 Enter");
    let ways = [
        (6, [1, 0, 0]),
        (4, [-1, 0, 0]),
        (8, [0, 1, 0]),
        (2, [0, -1, 0]),
        (7, [-1, 1, 0]),
        (9, [1, 1, 0]),
        (1, [-1, -1, 0]),
        (3, [1, -1, 0]),
        (0, [0, 0, -1]),
        (5, [0, 0, 1]),
    ];
    for (digit, way) in ways {
        let before = console.position();
        console.hold(digit, 0.2);
        let after = console.position();
        let signs =
            [0, 1, 2].map(|axis| (after[axis] - before[axis]).partial_cmp(&0.0).unwrap() as i32);
        assert_eq!(signs, way, "{digit}");
        assert_eq!(
            (points(&console).as_str(), cur(&console).as_str()),
            ("L0,0 L10,0", "Cur=2 of 2")
        );
    }
}
