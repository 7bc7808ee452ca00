//! Engraving and pockets in every drawing: the tool reaches all that it can reach and never leaves the area, in the
//! whole job and in a selection, however the shapes are drawn. `SEEDS` and `FROM` try other drawings.

use crate::families::Dice;
use crate::random::{check_cleared, random_case, seeds};
use kerf_drawing::{Drawing, Editor, Shape, script};
use kerf_geom::{Point2, Polyarc, Transform2, Vec2};
use kerf_pocket::Cutter;

/// The operation of a seed; `scope` is `all` or nothing.
fn operation(seed: u64, scope: &str, cutter: &Cutter) -> String {
    let (tool, overlap) = (cutter.diameter_mm(), cutter.diameter_mm() - cutter.step_mm());
    let tool = format!("{scope} tool={tool} overlap={overlap}");
    let finish = cutter.radius_mm() * [0.0, 0.3, 1.0][seed as usize % 3];
    match seed % 4 {
        0 => format!("engrave {tool}"),
        1 => format!("pocket {tool} climb"),
        2 => format!("pocket {tool} outward"),
        _ => format!("pocket {tool} zigzag={} finish={finish}", seed * 17),
    }
}

/// The paths that a script adds to shapes.
fn paths(shapes: &[Polyarc], text: &str) -> Vec<Polyarc> {
    let mut editor = Editor::of(Drawing::of(shapes.iter().cloned().map(Shape::flat)));
    for (_, operation) in script(text).unwrap() {
        editor.apply(&operation).unwrap_or_else(|error| panic!("{text}: {error}"));
    }
    editor.drawing.shapes[shapes.len()..].iter().map(|shape| shape.path.clone()).collect()
}

#[test]
fn the_whole_job_is_cleared_and_nothing_else() {
    for seed in seeds(12) {
        let (first, cutter) = random_case(seed);
        let (second, _) = random_case(seed + 1000);
        let beside = Transform2::moved(Vec2::new(
            first[0].bounds().max.x - second[0].bounds().min.x + 10.0,
            0.0,
        ));
        let second: Vec<Polyarc> = second.iter().map(|path| path.similar(&beside)).collect();
        let both = [first.as_slice(), &second].concat();
        let paths = paths(&both, &operation(seed, "all", &cutter));
        let left = |path: &&Polyarc| path.bounds().max.x < first[0].bounds().max.x;
        let (here, there): (Vec<_>, Vec<_>) = paths.iter().partition(left);
        let owned = |list: Vec<&Polyarc>| list.into_iter().cloned().collect::<Vec<_>>();
        check_cleared(&format!("seed {seed}, first"), &first, &owned(here), &cutter);
        check_cleared(&format!("seed {seed}, second"), &second, &owned(there), &cutter);
    }
}

#[test]
fn a_selection_is_cleared_and_nothing_else() {
    for seed in seeds(8) {
        let (region, cutter) = random_case(seed);
        let beside = Transform2::moved(Vec2::new(2.0 * region[0].bounds().size().x, 0.0));
        let copy: Vec<Polyarc> = region.iter().map(|path| path.similar(&beside)).collect();
        let both = [copy, region.clone()].concat();
        let chosen = format!("select {}-{}", region.len() + 1, both.len());
        let paths = paths(&both, &format!("{chosen}; {}", operation(seed, "", &cutter)));
        check_cleared(&format!("seed {seed}"), &region, &paths, &cutter);
    }
}

/// The same region drawn in another way, and the map from there back to the first.
fn drawn_anew(region: &[Polyarc], seed: u64) -> Vec<(&'static str, Vec<Polyarc>, Transform2)> {
    let mut dice = Dice::new(seed);
    let at = Point2::new(dice.between(-50.0, 50.0), dice.between(-50.0, 50.0));
    let axis = Vec2::new(dice.between(-1.0, 1.0), 1.0);
    let by = Vec2::new(dice.between(-5000.0, 5000.0), dice.between(-5000.0, 5000.0));
    let (turn, share) = (dice.between(-3.0, 3.0), dice.share());
    let same = Transform2::moved(Vec2::default());
    let mirror = Transform2::mirrored(at, axis);
    let mapped = |map: Transform2| region.iter().map(|path| path.similar(&map)).collect();
    let started =
        |path: &Polyarc| path.started_at(&path.place_after(path.length() * share).unwrap());
    vec![
        ("reversed", region.iter().map(Polyarc::reversed).collect(), same),
        ("started elsewhere", region.iter().map(started).collect(), same),
        ("mirrored", mapped(mirror), mirror),
        ("moved", mapped(Transform2::moved(by)), Transform2::moved(by * -1.0)),
        ("turned", mapped(Transform2::turned(at, turn)), Transform2::turned(at, -turn)),
    ]
}

#[test]
fn it_does_not_matter_how_a_region_is_drawn() {
    for seed in seeds(6) {
        let (region, cutter) = random_case(seed);
        let text = format!("select all; directions auto; {}", operation(seed, "all", &cutter));
        let length = |paths: &[Polyarc]| paths.iter().map(Polyarc::length).sum::<f64>();
        let plain = paths(&region, &text);
        for (how, anew, back) in drawn_anew(&region, seed) {
            let found: Vec<Polyarc> =
                paths(&anew, &text).iter().map(|path| path.similar(&back)).collect();
            check_cleared(&format!("seed {seed}, {how}"), &region, &found, &cutter);
            // Where the tour begins and which of two equal ways it takes depends on the start.
            let (new, old) = (length(&found), length(&plain));
            let turns = how == "turned" && text.contains("zigzag");
            assert!(
                turns || (new - old).abs() < 0.35 * old,
                "seed {seed}, {how}: {new}, not {old}"
            );
        }
    }
}

#[test]
fn it_does_not_matter_how_large_a_region_is() {
    for seed in seeds(4) {
        let (region, cutter) = random_case(seed);
        for scale in [0.1, 25.4] {
            let map = Transform2::scaled(Point2::default(), scale, scale);
            let large: Vec<Polyarc> = region.iter().map(|path| path.similar(&map)).collect();
            let overlap = cutter.diameter_mm() - cutter.step_mm();
            let cutter = Cutter::new(scale * cutter.diameter_mm(), scale * overlap).unwrap();
            let found = paths(&large, &operation(seed, "all", &cutter));
            check_cleared(&format!("seed {seed} × {scale}"), &large, &found, &cutter);
        }
    }
}

fn plate() -> (Vec<Polyarc>, Cutter, Vec<Polyarc>) {
    let region = vec![Polyarc::rectangle(Point2::default(), Point2::new(100.0, 60.0))];
    let cutter = Cutter::new(5.0, 0.1).unwrap();
    let found = paths(&region, &operation(0, "all", &cutter));
    (region, cutter, found)
}

#[test]
#[should_panic(expected = "largest_mm2")]
fn a_stroke_that_is_missing_is_noticed() {
    let (region, cutter, mut found) = plate();
    let last = found[0].vertices.len() - 3;
    found[0].vertices.truncate(last);
    check_cleared("cut short", &region, &found, &cutter);
}

#[test]
#[should_panic(expected = "out_mm")]
fn a_path_that_leaves_is_noticed() {
    let (region, cutter, found) = plate();
    let away = Transform2::moved(Vec2::new(0.001, 0.0));
    let moved: Vec<Polyarc> = found.iter().map(|path| path.similar(&away)).collect();
    check_cleared("moved", &region, &moved, &cutter);
}
