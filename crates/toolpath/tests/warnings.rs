//! Warnings that a person should look at before cutting.

use crate::families;
use kerf_drawing::{Drawing, Editor, Shape, script};
use kerf_geom::{Bounds2, Point2, Transform2, Vec2};
use kerf_program::job::Plunge;
use kerf_toolpath::{Heights, job, off_table, too_flat};

fn drawn(words: &str) -> Drawing {
    let mut editor = Editor::default();
    for (_, operation) in script(words).unwrap() {
        editor.apply(&operation).unwrap();
    }
    editor.drawing
}

fn check(words: &str, expected: &[&str]) {
    let (_, warnings) = job(&drawn(words)).unwrap();
    let told: Vec<_> = warnings.iter().map(ToString::to_string).collect();
    assert_eq!(told, expected, "{words}");
}

const NEAR: &str = "they lie nearer than the tool is wide; move them apart or take a smaller tool";

#[test]
fn parts_nearer_than_the_tool_is_wide_are_told() {
    let two = |gap: f64| {
        format!("rect 0,0 50,50; rect {},0 {},50; set black offset=3", 50.0 + gap, 100.0 + gap)
    };
    check(&two(6.0), &[]);
    let both = [
        format!("shape 1 at 0,0: its cut takes from shape 2: {NEAR}"),
        format!("shape 2 at 55.9,0: its cut takes from shape 1: {NEAR}"),
    ];
    check(&two(5.9), &[&both[0], &both[1]]);
    // Without an offset nobody knows how wide the tool is.
    check("rect 0,0 50,50; rect 51,0 90,50", &[]);
}

#[test]
fn a_hole_too_near_the_edge_is_told() {
    let plate = "rect 0,0 50,50; circle 25,25 10; directions auto; set black offset=3";
    check(plate, &[]);
    // The cut of the hole stays inside it; a cut on the wrong side of it does not.
    let wrong = "rect 0,0 50,50; circle 25,12 10; set black offset=3";
    check(wrong, &[&format!("shape 2 at 35,12: its cut takes from shape 1: {NEAR}")]);
}

#[test]
fn parts_that_overlap_are_told() {
    let crossed = "rect 0,0 50,50; rect 40,40 90,90";
    check(crossed, &["shape 1 at 0,0: it crosses shape 2: the parts overlap"]);
    check(&format!("{crossed}; select 2; group red; set red on=off"), &[]);
}

#[test]
fn open_lines_across_a_part_are_told_like_closed_shapes() {
    let across = "rect 0,0 50,50; line 40,40 90,90";
    check(
        across,
        &["shape 2 at 40,40: it is open and is cut across shape 1: move it, or cut it less deep"],
    );
    // A groove that is less deep than the part, a line that is not cut, and one that ends at the edge.
    check(&format!("{across}; select 2; group red; set red height=-2"), &[]);
    check(&format!("{across}; select 2; group red; set red on=off"), &[]);
    check("rect 0,0 50,50; line 50,40 90,90", &[]);
    check("line 0,0 50,50; line 0,50 50,0", &[]);
}

#[test]
fn what_leaves_the_table_is_told_once() {
    let table = Bounds2::of(Point2::default(), Point2::new(100.0, 80.0));
    let told = |words: &str| {
        let (job, _) = job(&drawn(words)).unwrap();
        off_table(&job, &table).iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    assert!(told("rect 0,0 100,80").is_empty());
    let left = "shape 1 at 0,-3: leaves the table: 3.000 mm at the left, 3.000 mm at the front";
    assert_eq!(told("rect 0,0 50,50; set black offset=3"), [left]);
    let right = told("rect 0,0 50,50; array block 1x4 gap 10,0");
    assert_eq!(right, ["shape 1 at 60,0: leaves the table: 10.000 mm at the right"]);
}

/// Checks the notes on the helices of a drawing, and the tool's way down to the path of its first shape.
fn check_helix(words: &str, expected: &[&str], plunge: Plunge) {
    check(words, expected);
    let (job, _) = job(&drawn(words)).unwrap();
    let written = kerf_toolpath::read(kerf_toolpath::write(&job).as_bytes()).0;
    for job in [job, written] {
        let paths = job.paths.iter().enumerate();
        let (first, _) = paths.min_by_key(|(place, path)| (path.from, *place)).unwrap();
        assert_eq!(job.machine_job("a job".into()).shapes[first].plunge, plunge, "{words}");
    }
}

const fn helix(radius_mm: f64) -> Plunge {
    Plunge::Helix { radius_mm, angle_deg: 3.0 }
}

const RAMP: Plunge = Plunge::Ramp { angle_deg: 3.0 };

#[test]
fn a_helix_without_room_is_made_smaller_or_a_ramp() {
    let asked = |radius: f64, at: &str| {
        format!(
            "rect 0,0 20,20; select 1; reverse; set black plunge=helix,{radius},3 height=-4; start 1 {at}"
        )
    };
    // Clockwise, to the right of travel: inside, from wall to wall.
    check_helix(&asked(8.0, "0,10"), &[], helix(8.0));
    let told = |asked: f64, at: &str, shape: &str, instead: &str| {
        let text = format!("its helix of {asked} mm would cut into {shape}: {instead}");
        format!("shape 1 at {at}: {text}")
    };
    let wide = told(11.0, "0,10", "it", "one of 10 mm is cut instead");
    check_helix(&asked(11.0, "0,10"), &[&wide], helix(10.0));
    let low = told(8.0, "0,2", "it", "one of 2 mm is cut instead");
    check_helix(&asked(8.0, "0,2"), &[&low], helix(2.0));
    let none = told(8.0, "0,1.9", "it", "it goes down along its path instead");
    check_helix(&asked(8.0, "0,1.9"), &[&none], RAMP);
    // A neighbour in the way.
    let other =
        |circle: &str| format!("{}; circle {circle}; select 2; group red", asked(8.0, "0,10"));
    check_helix(&other("12,10 1"), &[], helix(8.0));
    let red = told(8.0, "0,10", "shape 2", "one of 6 mm is cut instead");
    check_helix(&other("15,10 3"), &[&red], helix(6.0));
}

#[test]
fn a_way_down_that_would_go_round_too_often_is_told_once_for_all_copies() {
    let told = |words: &str| -> Vec<String> {
        let (job, _) = job(&drawn(words)).unwrap();
        too_flat(&job, &Heights::default()).iter().map(ToString::to_string).collect()
    };
    let at = |angle: &str| {
        format!("rect 5,6 5.5,6.5; set black height=-4 plunge={angle}; array block 3x2 gap 9,9")
    };
    // 4 mm down in 1,000 rounds of 2 mm, or of a circle of 0.3 mm.
    let text = "degrees it would go down in more than 1000 rounds: it goes down at";
    let ramp = format!("shape 1 at 5,6: at 0.1 {text} 0.115 degrees instead");
    assert_eq!(told(&at("ramp,0.1")), [ramp]);
    assert_eq!(told(&at("ramp,0.115")), Vec::<String>::new());
    let helix = format!("shape 1 at 5,6: at 0.1 {text} 0.122 degrees instead");
    assert_eq!(told(&at("helix,0.3,0.1")), [helix]);
    assert_eq!(told(&at("straight")), Vec::<String>::new());
}

#[test]
fn a_helix_keeps_the_tool_off_its_neighbours() {
    let two = |radius: f64, gap: f64, more: &str| {
        let (left, right) = (50.0 + gap, 100.0 + gap);
        format!(
            "rect 0,0 50,50; start 1 50,25; rect {left},0 {right},50; select 2; group red; \
             set black offset=3 plunge=helix,{radius},3 height=-4{more}"
        )
    };
    let told = |asked: f64, shape: &str, instead: &str| {
        format!("shape 1 at 53,25: its helix of {asked} mm would cut into {shape}: {instead}")
    };
    check_helix(&two(3.0, 12.0, ""), &[], helix(3.0));
    let less = told(4.0, "shape 2", "one of 3 mm is cut instead");
    check_helix(&two(4.0, 12.0, ""), &[&less], helix(3.0));
    let none = told(4.0, "shape 2", "it goes down along its path instead");
    check_helix(&two(4.0, 7.9, ""), &[&none], RAMP);
    // To the other side there is the part itself.
    let part = told(4.0, "it", "it goes down along its path instead");
    check_helix(&two(-4.0, 12.0, ""), &[&part], RAMP);
    // The neighbour in an array, and a job that follows only after the first.
    let array = "rect 0,0 50,50; start 1 50,25; array block 1x2 gap 12,0; \
                 set black offset=3 plunge=helix,4,3 height=-4";
    let next = told(4.0, "shape 1 of the block 62,0 away", "one of 3 mm is cut instead");
    check_helix(array, &[&next], helix(3.0));
    // Nothing goes round that is not cut, or cut at heights of its own.
    let straight =
        "shape 1 at 50,25: a 3D path is entered straight down, without the helix of its group";
    check_helix(&two(4.0, 12.0, "; set black height=3d"), &[straight], helix(4.0));
}

#[test]
fn a_helix_in_a_pocket_stays_in_it() {
    let pocket = |way: &str, radius: f64| {
        format!(
            "rect 0,0 60,60; select 1; pocket tool=6 overlap=2{way} group=blue; \
             set blue plunge=helix,{radius},3 height=-4; set black on=off"
        )
    };
    // Over the rings beside it, which are cleared in any case.
    check_helix(&pocket("", 4.0), &[], helix(4.0));
    // With the wall on the right of travel there is no room.
    let told = "shape 2 at 3,30: its helix of 4 mm would cut into shape 1: it goes down along its path instead";
    let (job, warnings) = job(&drawn(&pocket(" climb", 4.0))).unwrap();
    assert!(warnings.iter().any(|warning| warning.to_string() == told), "{warnings:?}");
    assert_eq!(job.machine_job("a job".into()).shapes[0].plunge, RAMP);
}

/// Whatever is asked, a tool on its way down comes no nearer to a contour than on its path.
#[test]
fn no_helix_cuts_into_a_contour() {
    let mut smaller = 0;
    for seed in 0..40 {
        let mut drawing = drawn("rect 0,0 9,9; set black offset=2 plunge=helix,6,3 height=-4");
        let shapes = (0..3).map(|k| {
            let to = Transform2::moved(Vec2::new(88.0 * f64::from(k), 0.0));
            families::polyarc(3 * seed + k as u64).0.similar(&to)
        });
        drawing.shapes = shapes.map(|path| Shape::flat(path).into()).collect();
        let (job, _) = job(&drawing).unwrap();
        for path in &job.paths {
            smaller += usize::from(path.room_mm.is_some());
            let circle = job.helix(path).unwrap_or_default();
            let places =
                circle.segments().flat_map(|s| (0..40).map(move |k| s.at(f64::from(k) / 40.0)));
            for place in places {
                let far = |shape: &Shape| shape.path.nearest(place).map_or(9.0, |(_, far)| far);
                let least = drawing.shapes.iter().map(|shape| far(shape)).fold(9.0, f64::min);
                assert!(least >= 2.0 - 1e-3, "{seed}: {least} at {place:?}");
            }
        }
    }
    assert!(smaller > 20, "{smaller}");
}

#[test]
fn a_3d_path_that_should_be_entered_by_a_ramp_is_told() {
    let told = |way: &str| {
        format!(
            "shape 1 at 0,0: a 3D path is entered straight down, without the {way} of its group"
        )
    };
    check("line 0,0 50,0; set black height=3d plunge=ramp,3", &[&told("ramp")]);
    check("line 0,0 50,0; set black height=3d plunge=helix,2,3", &[&told("helix")]);
    check("line 0,0 50,0; set black height=3d plunge=straight", &[]);
    check("line 0,0 50,0; set black height=-3 plunge=ramp,3", &[]);
}

#[test]
fn what_is_drawn_twice_is_told_once() {
    let twice = |number: usize, at: &str| {
        format!("shape {number} at {at}: it is drawn twice, as shape 1 is: erase one of them")
    };
    // The other way round, from another corner, with an offset and without.
    let two = "rect 0,0 50,50; line 50,50 0,50 0,0 50,0 close; select 2; reverse";
    check(two, &[&twice(2, "50,50")]);
    check(&format!("{two}; set black offset=-3"), &[&twice(2, "50,50")]);
    check("line 0,0 9,0; line 9,0 0,0", &[&twice(2, "9,0")]);
    check("point 1,1; point 1,1; point 1,1", &[&twice(2, "1,1"), &twice(3, "1,1")]);
    // Cut by two groups, once each; and not quite the same.
    check("rect 0,0 50,50; select all; copy-to red", &[]);
    check("line 0,0 9,0; line 0,0 9,0.01; line 0,0,0.1 9,0", &[]);
    let (_, warnings) = job(&drawn("point 0,0; select all; array rect 10x10 spacing 0,0")).unwrap();
    assert_eq!(warnings.len(), 21);
    assert_eq!(warnings[20].text, "it and 78 more are drawn twice");
}

#[test]
fn neighbours_in_an_array_that_cut_into_each_other_are_told() {
    let plate =
        |gap: &str| format!("rect 0,0 50,50; set black offset=3; array block 2x3 gap {gap}");
    let next = |by: &str| {
        let text = "in the array its cut takes from shape 1 of the block";
        format!("shape 1 at 0,0: {text} {by} away: make the gap larger")
    };
    check(&plate("6,6"), &[]);
    check(&plate("5.9,6"), &[&next("55.9,0")]);
    check(&plate("6,5"), &[&next("0,55")]);
    // The gap between jobs counts as well.
    let jobs =
        "rect 0,0 50,50; set black offset=3; array block 1x2 gap 10,0; array job 1x2 gap 4,0";
    check(jobs, &[&next("54,0")]);
    // Blocks that overlap without an offset: their outlines cross.
    check("rect 0,0 50,50; array block 1x2 gap 0,0", &[]);
    check("rect 0,0 50,50; array block 1x2 gap -10,0", &[&next("40,0")]);
}

#[test]
fn arrays_whose_copies_lie_on_each_other_are_refused() {
    let mut drawing = drawn("rect 0,0 50,50; array block 1x2 gap 40,0");
    assert!(job(&drawing).is_ok());
    drawing.arrays.block.column_gap_mm = -50.0;
    let told = job(&drawing).unwrap_err().to_string();
    assert!(told.contains("the columns of the block array is -50 mm"), "{told}");
}
