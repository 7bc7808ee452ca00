//! Rows of the Profiler ledger about tool paths.

use kerf_drawing::{Drawing, Editor, Group, Shape, script};
use kerf_geom::{Point2, Polyarc};
use kerf_toolpath::{CutPath, DrawnJob, Pass, Warning, job, read, write};

const SQ100: &str = "line 0,0 100,0 100,100 0,100 close";
const CLOCKWISE: &str = "line 0,0 0,100 100,100 100,0 close";

fn drawing(text: &str) -> Drawing {
    let mut editor = Editor::default();
    for (_, operation) in script(text).unwrap() {
        editor.apply(&operation).unwrap();
    }
    editor.drawing
}

fn made(text: &str) -> (DrawnJob, Vec<Warning>) {
    job(&drawing(text)).unwrap()
}

/// The paths of a drawing about which there is nothing to say but what its tags leave, and that it crosses itself.
fn paths(text: &str) -> Vec<CutPath> {
    let (job, warnings) = made(text);
    let expected = ["its tag of", "it crosses itself at"];
    let others =
        warnings.iter().filter(|told| !expected.iter().any(|it| told.text.starts_with(it)));
    assert_eq!(others.collect::<Vec<_>>(), Vec::<&Warning>::new());
    job.paths
}

fn only(text: &str) -> Polyarc {
    let mut paths = paths(text);
    assert_eq!(paths.len(), 1);
    paths.remove(0).shape.path.clone()
}

fn told(text: &str) -> (usize, String) {
    let (job, warnings) = made(text);
    let words: Vec<_> = warnings.iter().map(ToString::to_string).collect();
    (job.paths.len(), words.join("; "))
}

fn near(value: f64, expected: f64, within: f64) {
    assert!((value - expected).abs() <= within, "{value} is not {expected}");
}

fn at(place: Option<Point2>, x: f64, y: f64) {
    let place = place.unwrap();
    assert!(place.distance(Point2::new(x, y)) < 1e-3, "{place:?} is not {x},{y}");
}

fn box_of(path: &Polyarc) -> [f64; 4] {
    let bounds = path.bounds();
    [bounds.min.x, bounds.min.y, bounds.max.x, bounds.max.y].map(|v| (v * 1e6).round() / 1e6 + 0.0)
}

#[test]
fn pro_toolpath_offset_pos() {
    let path = only(&format!("{SQ100}; set black offset=5"));
    assert_eq!(box_of(&path), [-5.0, -5.0, 105.0, 105.0]);
    near(path.signed_area(), 12078.54, 0.01);
    near(path.length(), 431.416, 1e-3);
    at(path.start(), 0.0, -5.0);
}

#[test]
fn pro_toolpath_offset_neg() {
    let path = only(&format!("{SQ100}; set black offset=-5"));
    assert_eq!(box_of(&path), [5.0, 5.0, 95.0, 95.0]);
    near(path.signed_area(), 8100.0, 1e-6);
}

#[test]
fn pro_toolpath_offset_hole() {
    let path = only(&format!("{CLOCKWISE}; set black offset=5"));
    assert_eq!(box_of(&path), [5.0, 5.0, 95.0, 95.0]);
    near(path.signed_area(), -8100.0, 1e-6);
}

#[test]
fn pro_toolpath_offset_open() {
    let line = |offset: f64| only(&format!("line 0,0 100,0; set black offset={offset}"));
    assert_eq!(box_of(&line(5.0)), [0.0, -5.0, 100.0, -5.0]);
    assert_eq!(box_of(&line(-5.0)), [0.0, 5.0, 100.0, 5.0]);
}

#[test]
fn pro_toolpath_offset_arc() {
    for (offset, radius) in [(5.0, 30.0), (-5.0, 20.0)] {
        let path = only(&format!("circle 0,0 25; set black offset={offset}"));
        assert_eq!(path.vertices.len(), 2);
        assert!(path.vertices.iter().all(|v| (v.bulge - 1.0).abs() < 1e-9));
        near(path.bounds().max.x, radius, 1e-9);
    }
}

#[test]
fn pro_toolpath_offset_gone() {
    let (paths, told) =
        told(&format!("{CLOCKWISE}; circle 300,0 5; select 2; group red; set black offset=60"));
    assert_eq!(
        (paths, told.as_str()),
        (1, "shape 1 at 0,0: too small for an offset of 60 mm: no path")
    );
}

#[test]
fn pro_toolpath_double() {
    let found = paths("line 0,0 100,0; set black offset=0.3 double=on");
    let ys: Vec<_> = found.iter().map(|path| box_of(&path.shape.path)[1]).collect();
    assert_eq!(ys, [-0.3, 0.3]);
}

#[test]
fn pro_toolpath_double_zero() {
    let path = only("line 0,0 100,0; set black double=on");
    assert_eq!(box_of(&path), [0.0, 0.0, 100.0, 0.0]);
}

#[test]
fn pro_toolpath_double_closed() {
    for shape in [SQ100, CLOCKWISE] {
        let found = paths(&format!("{shape}; set black offset=0.5 double=on"));
        let boxes: Vec<_> = found.iter().map(|path| box_of(&path.shape.path)).collect();
        assert_eq!(boxes, [[0.5, 0.5, 99.5, 99.5], [-0.5, -0.5, 100.5, 100.5]]);
    }
}

#[test]
fn pro_toolpath_tag() {
    let path = only(&format!("{SQ100}; set black tag=5"));
    assert!(!path.closed);
    at(path.start(), 5.0, 0.0);
    at(path.end(), 0.0, 0.0);
    near(path.length(), 395.0, 1e-9);
}

#[test]
fn pro_toolpath_tag_zero() {
    let path = only(&format!("{SQ100}; set black tag=0"));
    assert!(path.closed);
    near(path.length(), 400.0, 1e-9);
}

#[test]
fn pro_toolpath_tag_offset() {
    let path = only(&format!("{SQ100}; set black offset=5 tag=5"));
    at(path.start(), 5.0, -5.0);
    at(path.end(), 0.0, -5.0);
    near(path.length(), 426.416, 1e-3);
}

#[test]
fn pro_toolpath_tag_long() {
    let (paths, told) = told(&format!("{SQ100}; set black tag=500"));
    assert_eq!(paths, 0);
    assert!(told.contains("the tag of 500 mm is longer than its path of 400.000 mm"), "{told}");
}

#[test]
fn pro_toolpath_leadin_order() {
    let path = only(&format!("{SQ100}; set black offset=5 tag=5 lead-in=10,90"));
    at(path.start(), -5.0, -15.0);
    at(Some(path.vertices[1].at), 5.0, -5.0);
}

#[test]
fn pro_toolpath_leadin_plunge() {
    let path = only(&format!("{SQ100}; set black offset=5 lead-in=10,90"));
    at(path.start(), -10.0, -15.0);
    let square = Polyarc::rectangle(Point2::new(0.0, 0.0), Point2::new(100.0, 100.0));
    near(square.nearest(path.start().unwrap()).unwrap().1, 18.03, 0.01);
}

#[test]
fn pro_toolpath_leadin_gouge() {
    let (paths, told) = told(&format!("{CLOCKWISE}; set black offset=5 lead-in=10,90"));
    assert_eq!(paths, 1, "the path is made all the same");
    assert!(told.starts_with("shape 1 at 0,0: its lead-in cuts into it"), "{told}");
    let path = only(&format!("{CLOCKWISE}; start 1 0,50; set black offset=5 lead-in=10,90"));
    at(path.start(), 15.0, 40.0);
}

#[test]
fn a_lead_into_a_neighbour_is_told() {
    let (_, told) = told(&format!("{SQ100}; rect -40,-40 -8,-8; set black offset=5 lead-in=10,90"));
    assert!(told.contains("its lead-in cuts into shape 2"), "{told}");
}

#[test]
fn pro_toolpath_leadout_indep() {
    let length = |leads: &str| only(&format!("{SQ100}; set black {leads}")).length() - 400.0;
    near(length("lead-in=10,90 lead-out=5,45"), 15.708 + 3.927, 1e-3);
    near(length("lead-in=10,90"), 15.708, 1e-3);
    near(length("lead-out=5,45"), 3.927, 1e-3);
}

#[test]
fn pro_toolpath_order() {
    let path = only(&format!("{SQ100}; set black offset=5 tag=5 lead-in=10,90"));
    let arcs = path.segments().filter(|segment| segment.arc().is_some()).count();
    assert_eq!((path.vertices.len(), arcs), (10, 5), "lead, four sides, 3 + 1 corners");
    at(path.start(), -5.0, -15.0);
    at(path.end(), 0.0, -5.0);
}

#[test]
fn pro_toolpath_generate() {
    let text = format!("{SQ100}; circle 50,50 20; set black offset=2; array block 2x3 gap 5,5");
    let (first, second) = (write(&made(&text).0), write(&made(&text).0));
    assert_eq!(first, second);
}

#[test]
fn pro_toolpath_separate() {
    let source = drawing(&format!("{SQ100}; set black offset=5"));
    let (job, _) = job(&source).unwrap();
    assert_eq!(source.shapes[0].path.vertices.len(), 4);
    let (back, _) = read(write(&job).as_bytes());
    near(back.paths[0].shape.path.signed_area(), 12078.54, 0.01);
}

#[test]
fn pro_toolpath_selfloop() {
    let text = "line 0,0 100,0 100,50 50,50 50,-50";
    let path = only(&format!("{text}; set black offset=5"));
    let base = drawing(text).shapes[0].path.clone();
    assert!(!path.closed);
    let places: Vec<_> =
        (0..200).filter_map(|n| path.place_after(path.length() * f64::from(n) / 199.0)).collect();
    let beside = |place: Point2| base.segments().any(|s| (s.distance(place) - 5.0).abs() < 1e-6);
    assert!(places.iter().all(|place| beside(place.at)));
    near(path.length(), base.length() + 3.0 * 2.5 * std::f64::consts::PI, 1e-6);
}

#[test]
fn pro_toolpath_selfloop_warn() {
    // The offset succeeds: it is to be looked at all the same, and once for both of its passes.
    let text = "line 100,100 200,100 200,150 150,150 150,50";
    let (paths, words) = told(&format!("{text}; set black offset=5 rough=2"));
    assert_eq!(paths, 2);
    assert_eq!(
        words.matches("shape 1 at 100,100: it crosses itself at 150,100").count(),
        1,
        "{words}"
    );
    assert_eq!(told(text), (1, String::new()));
    let (paths, told) = told("line 0,0 100,100 100,0 0,100 close; set black offset=5");
    assert_eq!(paths, 0);
    assert!(
        told.starts_with("shape 1 at 0,0: offset failed: it crosses itself at 50,50"),
        "{told}"
    );
}

#[test]
fn pro_toolpath_offset_3d() {
    let square = Polyarc::rectangle(Point2::new(0.0, 0.0), Point2::new(100.0, 100.0));
    let shape = Shape::with_heights(square.clone(), vec![0.0, -10.0, -10.0, 0.0]);
    let mut source = Drawing::of([shape]);
    source.groups[0].offset_mm = 5.0;
    let (job, warnings) = job(&source).unwrap();
    assert_eq!(warnings, []);
    let shape = &job.paths[0].shape;
    let height = |x: f64, y: f64| {
        let (place, far) = shape.path.nearest(Point2::new(x, y)).unwrap();
        near(far, 0.0, 1e-9);
        shape.height_at(&place)
    };
    near(height(105.0, 50.0), -10.0, 1e-9);
    near(height(50.0, -5.0), -5.0, 1e-9);
}

#[test]
fn pro_toolpath_offset_3d_refuse() {
    let corners = [(0.0, 0.0), (100.0, 100.0), (100.0, 0.0), (0.0, 100.0)];
    let path = Polyarc::lines(corners.map(|(x, y)| Point2::new(x, y)), true);
    let mut source = Drawing::of([Shape::with_heights(path, vec![0.0, -1.0, -2.0, -3.0])]);
    source.groups[0].offset_mm = 5.0;
    let (job, warnings) = job(&source).unwrap();
    assert!(
        job.paths.is_empty()
            && warnings[0].to_string().starts_with("shape 1 at 0,0: offset failed")
    );
}

#[test]
fn pro_group_rough() {
    let found = paths(&format!("{SQ100}; set black offset=3 rough=0.5"));
    let seen: Vec<_> = found.iter().map(|p| (p.pass, box_of(&p.shape.path)[0])).collect();
    assert_eq!(seen, [(Pass::Rough, -3.5), (Pass::Final, -3.0)]);
}

#[test]
fn pro_group_status_on() {
    assert_eq!(paths(&format!("{SQ100}; point 5,5")).len(), 2);
}

#[test]
fn pro_group_status_off() {
    let found = paths("point 1,0; point 2,0; point 3,0; select 2; group red; set red on=off");
    let starts: Vec<_> = found.iter().map(|path| path.shape.start().x).collect();
    assert_eq!(starts, [1.0, 3.0]);
}

#[test]
fn traversal_shapes_are_followed_as_they_are() {
    let text = format!("{SQ100}; set black traversal=on offset=5 tag=5 lead-in=10,90");
    let found = paths(&text);
    assert_eq!((found.len(), found[0].pass), (1, Pass::Traversal));
    assert_eq!(box_of(&found[0].shape.path), [0.0, 0.0, 100.0, 100.0]);
}

#[test]
fn pro_array_basic() {
    let (job, _) = made("rect 0,0 100,50; array block 2x3 gap 10,20");
    assert_eq!(job.paths.len(), 6);
    let mut bounds = kerf_geom::Bounds2::default();
    job.paths.iter().for_each(|path| bounds.merge(&path.shape.path.bounds()));
    assert_eq!((bounds.size().x, bounds.size().y), (320.0, 120.0));
}

#[test]
fn pro_array_job() {
    let (job, _) = made("rect 0,0 100,50; array block 2x3 gap 10,20; array job 2x1 gap 0,40");
    let mut rows: Vec<_> = job.paths.iter().map(|path| path.shape.start().y).collect();
    rows.dedup();
    assert_eq!((job.paths.len(), rows), (12, vec![0.0, 70.0, 160.0, 230.0]));
}

#[test]
fn pro_array_inner() {
    let (job, _) = made("circle 50,25 5; rect 0,0 100,50; array block 1x2");
    let seen: Vec<_> = job.paths.iter().map(|path| path.from).collect();
    assert_eq!(seen, [1, 2, 1, 2]);
}

#[test]
fn pro_array_numbering() {
    let (job, _) = made("circle 50,25 5; rect 0,0 100,50; array block 2x3; array job 2x1");
    assert_eq!(job.paths.len(), 24);
}

#[test]
fn arrays_without_bound_are_refused() {
    let mut source = drawing(SQ100);
    source.arrays.block.rows = 100_000;
    source.arrays.block.columns = 100_000;
    let error = job(&source).unwrap_err().to_string();
    assert!(error.contains("10000000000 paths"), "{error}");
}

#[test]
fn pro_files_rsm() {
    let (mut job, _) = made("rect 0,0 100,50; set black offset=3 height=-2; array block 2x3");
    job.origin = Some(Point2::new(300.0, 200.0));
    job.finish = Some(Point2::new(25.0, 20.0));
    job.start = 5;
    let (back, read) = read(write(&job).as_bytes());
    assert_eq!(read.findings, []);
    assert_eq!(back.paths.len(), 6);
    assert_eq!((back.origin, back.finish, back.start), (job.origin, job.finish, 5));
    assert_eq!(back.paths, job.paths);
    assert_eq!(back.drawing.settings(Group::Black), job.drawing.settings(Group::Black));
}
