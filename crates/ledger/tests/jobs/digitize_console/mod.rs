//! Area `digitize`: the keys and functions of digitizing on SIM, with what moves traced.

mod functions;
mod keys;

use kerf_digitize::Kind;
use kerf_drawing::{Group, Shape};
use kerf_geom::{Point2, Polyarc, Segment};
use kerf_ledger::hand_console::HandConsole;
use kerf_trace::Event;
use kerf_wire::Look;
use std::sync::Arc;

/// Digitizing, with the job origin at (300,200) and the tool there.
fn begun() -> HandConsole {
    let placed = HandConsole::at(300.0, 200.0, -5.0);
    let mut console = placed.with(|machine| machine.job.origin_mm = [300.0, 200.0]);
    console.press("Func 70 Enter");
    console
}

fn to(console: &mut HandConsole, place: &str) {
    console.press(&format!("Func 20 Enter {} Enter", place.replace(',', " Enter ")));
}

/// Drives to points and records them: `L0,0 A5,-5`.
fn record(console: &mut HandConsole, points: &str) {
    for point in points.split_whitespace() {
        let (kind, place) = point.split_at(1);
        to(console, place);
        if console.shows()[0].ends_with("Arc") != (kind == "A") {
            console.press("-");
        }
        console.press("Enter");
    }
    if console.shows()[0].ends_with("Arc") {
        console.press("-");
    }
}

fn with(points: &str) -> HandConsole {
    let mut console = begun();
    record(&mut console, points);
    console
}

/// The points as they were recorded: `L0,0 A5,-5`.
fn points(console: &HandConsole) -> String {
    let digitized = console.digitized().expect("digitizing");
    let shown = |point: &kerf_digitize::Point| {
        let letter = if point.kind == Kind::Arc { 'A' } else { 'L' };
        format!("{letter}{},{}", point.stand.at.x, point.stand.at.y)
    };
    digitized.points().iter().map(shown).collect::<Vec<_>>().join(" ")
}

fn cur(console: &HandConsole) -> String {
    console.shows()[1].clone()
}

/// Place of the tool, from the job origin.
fn tool(console: &HandConsole) -> [f64; 2] {
    let [x, y, _] = console.position();
    [x - 300.0, y - 200.0]
}

fn near(a: [f64; 2], b: [f64; 2]) -> bool {
    (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-6
}

/// Ends of the lines and arcs of the last move, from the job origin, arcs with their way.
fn ways(console: &HandConsole) -> Vec<String> {
    let r = |v: f64| (v * 1e3).round() / 1e3 + 0.0;
    let end = |x: f64, y: f64| format!("{},{}", r(x - 300.0), r(y - 200.0));
    let told = |event: &Event| match event {
        Event::Move(made) => Some(end(made.to.x, made.to.y)),
        Event::Arc(arc) => Some(format!(
            "{} about {} to {}",
            arc.dir,
            end(arc.centre.x, arc.centre.y),
            end(arc.made.to.x, arc.made.to.y)
        )),
        _ => None,
    };
    console.trace().events.iter().filter_map(told).collect()
}

#[test]
fn pro_console_f70() {
    assert_eq!(begun().shows(), ["Digitize: 2D Point", "Cur=0 of 0"]);
}

#[test]
fn pro_digitize_mode() {
    let mut console = HandConsole::default();
    console.press("Func 70 Enter Enter");
    console.hold(6, 2.05);
    let [x, y, _] = console.position();
    assert!(x > 90.0 && y == 0.0, "{x}");
    console.press("Func 20 Enter 100 Enter 0 Enter Enter Func 8 Enter");
    let shape = console.shapes.last().unwrap();
    let ends = (shape.path.start().unwrap(), shape.path.end().unwrap());
    assert_eq!(ends, (Point2::new(0.0, 0.0), Point2::new(100.0, 0.0)));
    assert!(!shape.is_closed());
}

#[test]
fn pro_digitize_drive() {
    let mut console = begun();
    to(&mut console, "33.3,44.4");
    console.press("Enter");
    assert_eq!(points(&console), "L33.3,44.4");
}

#[test]
fn pro_digitize_arc_adjacent() {
    let mut console = with("L0,0 A5,-5");
    to(&mut console, "8,-4");
    console.press("- Enter");
    assert_eq!(console.shows(), ["arc point needs an", "end point"]);
    assert_eq!(points(&console), "L0,0 A5,-5");
    console.press("Enter Func 8 Enter");
    assert_eq!(console.shows(), ["point 2: arc point", "has one end only"]);
    let mut first = with("A5,-5 L10,0");
    first.press("Func 9 Enter");
    assert_eq!(first.shows(), ["point 1: arc point", "has one end only"]);
    assert!(console.shapes.is_empty() && first.shapes.is_empty());
}

#[test]
fn pro_digitize_closedopen() {
    let mut console = with("L0,0 L100,0 L0,100");
    console.press("Func 9 Enter Enter Func 8 Enter");
    let [closed, open] = &console.shapes[..] else { panic!("{:?}", console.shapes) };
    assert!(closed.is_closed() && !open.is_closed());
    assert_eq!((closed.path.segment_count(), open.path.segment_count()), (3, 2));
}

#[test]
fn pro_digitize_current() {
    let mut console = with("L1,0 L2,0 L3,0 L4,0 L5,0");
    console.press("File File");
    to(&mut console, "3,9");
    console.press("Func 0 Enter");
    assert_eq!(cur(&console), "Cur=4 of 6");
    assert_eq!(points(&console), "L1,0 L2,0 L3,0 L3,9 L4,0 L5,0");
}

#[test]
fn pro_digitize_step() {
    let mut console = with("L1,0 L2,0 L3,0 L4,0 L5,0");
    assert_eq!(cur(&console), "Cur=5 of 5");
    console.press("File File");
    assert_eq!((cur(&console).as_str(), tool(&console)), ("Cur=3 of 5", [3.0, 0.0]));
    console.press("Start");
    assert_eq!((cur(&console).as_str(), tool(&console)), ("Cur=4 of 5", [4.0, 0.0]));
}

#[test]
fn pro_digitize_append_end() {
    let mut console = with("L1,0 L2,0 L3,0 L4,0 L5,0");
    console.press("File File Enter");
    assert_eq!(console.shows()[0], "not at end");
    console.press("Enter");
    assert_eq!(console.shows(), ["Digitize: 2D Point", "Cur=3 of 5"]);
    console.press("Start Start");
    record(&mut console, "L6,0");
    assert_eq!(cur(&console), "Cur=6 of 6");
}

#[test]
fn pro_digitize_modify() {
    let mut console = with("L0,0 L10,0 L20,0");
    console.press("File");
    to(&mut console, "10,2");
    console.press("- Func 3 Enter");
    assert_eq!(
        (points(&console).as_str(), cur(&console).as_str()),
        ("L0,0 A10,2 L20,0", "Cur=2 of 3")
    );
}

fn sq100() -> Arc<Shape> {
    let corners = [(0., 0.), (100., 0.), (100., 100.), (0., 100.)];
    Shape::flat(Polyarc::lines(corners.map(|(x, y)| Point2::new(x, y)), true)).into()
}

#[test]
fn pro_digitize_load() {
    let mut console = begun();
    console.shapes =
        vec![Shape::flat(Polyarc::circle(Point2::new(500.0, 0.0), 50.0)).into(), sq100()];
    to(&mut console, "-3,50");
    console.press("Func 10 Enter");
    assert_eq!(cur(&console), "Cur=1 of 4");
    assert_eq!(points(&console), "L0,0 L100,0 L100,100 L0,100");
    // Arcs become arc points at their middle.
    to(&mut console, "447,0");
    console.press("Func 10 Enter");
    let digitized = console.digitized().unwrap();
    let kinds: Vec<_> = digitized.points().iter().map(|point| point.kind).collect();
    assert_eq!(kinds, [Kind::Line, Kind::Arc, Kind::Line, Kind::Arc, Kind::Line]);
    let middle = digitized.points()[1].stand.at;
    assert!((middle.x - 500.0).abs() < 1e-9 && (middle.y.abs() - 50.0).abs() < 1e-9, "{middle:?}");
}

#[test]
fn pro_digitize_two_d() {
    let mut console = with("L0,0");
    console.hold(0, 0.1);
    record(&mut console, "L10,0");
    let heights: Vec<_> =
        console.digitized().unwrap().points().iter().map(|point| point.stand.z_mm).collect();
    assert!(heights[1] < heights[0]);
    console.press("Func 8 Enter");
    assert_eq!(console.shapes[0].z_mm, None);
}

#[test]
fn pro_digitize_three_d() {
    let mut console = begun();
    console.press("Func 12 Enter Func 20 Enter 0 Enter 0 Enter -20 Enter Enter");
    console.press("Func 20 Enter 10 Enter 0 Enter -23 Enter Enter -");
    assert_eq!(console.shows(), ["no arcs in 3D: make", "them lines"]);
    console.press("Enter Func 8 Enter");
    assert_eq!(console.shapes[0].z_mm, Some(vec![0.0, -3.0]));
    // As it stands in the file.
    let job = kerf_toolpath::DrawnJob::default()
        .edited(&kerf_drawing::Drawing::of([(*console.shapes[0]).clone()]));
    let (read, _) = kerf_toolpath::read(kerf_toolpath::write(&job).as_bytes());
    assert_eq!(read.paths[0].shape.z_mm, Some(vec![0.0, -3.0]));
}

#[test]
fn pro_digitize_smooth() {
    let mut console = begun();
    for n in 0..72 {
        let angle = f64::from(n) * std::f64::consts::TAU / 72.0;
        let (x, y) = (100.0 + 50.0 * angle.cos(), 100.0 + 50.0 * angle.sin());
        record(&mut console, &format!("L{x:.3},{y:.3}"));
    }
    console.press("Func 9 Enter");
    let drawing = kerf_drawing::Drawing::of([(*console.shapes[0]).clone()]);
    let job = kerf_toolpath::DrawnJob { start: 1, ..Default::default() }.edited(&drawing);
    let mut cuts = |factor: f64| -> f64 {
        console.machine.program.smoothing.factor = factor;
        let trace = console.run(job.machine_job("digitized.rsm".into()));
        let cut = |event: &Event| match event {
            Event::Move(made)
                if made.from.z == made.to.z && made.kind == kerf_program::MoveKind::Cut =>
            {
                Some(made.t1 - made.t0)
            }
            _ => None,
        };
        trace.events.iter().filter_map(cut).sum()
    };
    // 314 mm at 100 mm/s; with a stop at each of the 72 points it takes 9.5 s.
    let (smooth, plain) = (cuts(0.6), cuts(0.0));
    assert!(smooth < 4.5, "{smooth}");
    assert!(plain > 7.0, "{plain}");
}
