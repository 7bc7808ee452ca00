//! Engraving from the drawing to the machine.

use crate::shop::{Did, Shop};
use serde_json::Value;

const PLATE: &str = "line 0,0 100,0 100,60 0,60 close; engrave all tool=5 overlap=0.1 group=red; ";

/// Height of the material's surface on the simulated machine, mm.
const SURFACE: f64 = -20.0;

/// The moves of a job as the simulated machine makes them, in millimetres above its home.
fn moves(script: &str) -> Vec<Value> {
    let shop = Shop::new(&[]);
    let drawn = shop.command().args(["draw", "--do", script, "-o", "job.rsg"]).output().unwrap();
    Did::of(drawn).exits(0);
    shop.kerf("toolpath job.rsg -o job.rsm").exits(0);
    let run = shop.kerf("trace job.rsm --config sim --units mm");
    run.exits(0);
    let is_move = |event: &&Value| event["e"] == "move" || event["e"] == "arc";
    run.events().iter().filter(is_move).cloned().collect()
}

fn z(event: &Value) -> f64 {
    event["to"]["z"].as_f64().unwrap()
}

fn is_cut(event: &Value) -> bool {
    event["kind"] == "cut"
}

/// Number of times that the tool goes from the air into the material.
fn plunges(moves: &[Value]) -> usize {
    moves.windows(2).filter(|pair| z(&pair[0]) > SURFACE && z(&pair[1]) < SURFACE).count()
}

#[test]
fn pro_engrave_connect() {
    let one = moves(&format!("{PLATE} set red height=-2"));
    let raises =
        one.windows(2).filter(|pair| z(&pair[0]) < SURFACE && z(&pair[1]) > SURFACE).count();
    assert_eq!((plunges(&one), raises), (1, 1));
    // Two chambers with a neck that is too narrow for the tool.
    let chambers = "line 0,0 40,0 40,18 60,18 60,0 100,0 100,40 60,40 60,22 40,22 40,40 0,40 close; \
                    engrave all tool=5 overlap=0.1 depth=2 group=red";
    assert_eq!(plunges(&moves(chambers)), 2);
}

#[test]
fn pro_engrave_depth() {
    let at_depth = |script: &str| -> Vec<f64> {
        let mut depths: Vec<f64> =
            moves(&format!("{PLATE}{script}")).iter().filter(|m| is_cut(m)).map(z).collect();
        depths.dedup();
        depths
    };
    assert_eq!(at_depth("set red height=-2"), [-22.0]);
    assert_eq!(at_depth("set red height=-2 pass=1"), [-21.0, -22.0]);
}

/// Steepest way down of the cutting moves below the surface, millimetres down per millimetre along.
fn steepest(script: &str) -> f64 {
    let all = moves(script);
    let at = |event: &Value, axis: &str| event["to"][axis].as_f64().unwrap();
    let steep = |pair: &[Value]| {
        let way = ["x", "y"].map(|axis| at(&pair[1], axis) - at(&pair[0], axis));
        let (down, along) = (z(&pair[0]) - z(&pair[1]), way[0].hypot(way[1]));
        if is_cut(&pair[1]) && z(&pair[1]) < SURFACE && down > 1e-6 { down / along } else { 0.0 }
    };
    all.windows(2).map(steep).fold(0.0, f64::max)
}

#[test]
fn ramps_and_helices_go_down_gently_in_every_pass() {
    assert!(steepest(&format!("{PLATE} set red height=-2")) > 1000.0);
    for plunge in ["ramp,3", "helix,2,3"] {
        let steep = steepest(&format!("{PLATE} set red height=-2 plunge={plunge}"));
        // The chord of a helix is shorter than its arc.
        let most = 3.0_f64.to_radians().tan() * std::f64::consts::FRAC_PI_2;
        assert!(steep > 0.0 && steep <= most + 1e-3, "{plunge}: {steep}");
        let passes = moves(&format!("{PLATE} set red height=-2 pass=1 plunge={plunge}"));
        let depths: Vec<f64> = passes.iter().map(z).collect();
        assert!(depths.contains(&-22.0) && depths.contains(&-21.0));
    }
}

/// The picture that `kerf preview` draws of what a script makes.
fn pictured(script: &str, file: &str) -> String {
    let shop = Shop::new(&[]);
    let drawn = shop.command().args(["draw", "--do", script, "-o", "job.rsg"]).output().unwrap();
    Did::of(drawn).exits(0);
    shop.kerf("toolpath job.rsg -o job.rsm").exits(0);
    shop.kerf(&format!("preview {file} -o job.svg --units mm")).exits(0);
    shop.read("job.svg")
}

#[test]
fn a_picture_of_an_engraving_is_as_wide_as_its_tool() {
    for file in ["job.rsg", "job.rsm"] {
        let engraved = pictured(&format!("{PLATE} set red height=-2"), file);
        assert!(engraved.contains("red, tool 1, 5 mm wide"), "{file}");
        assert!(engraved.contains("stroke-width=\"5\""), "{file}");
        assert!(!engraved.contains("(default)"), "{file}");
        let told = pictured(&format!("{PLATE} set red height=-2 cutter=3"), file);
        assert!(told.contains("red, tool 1, 3 mm wide") && told.contains("stroke-width=\"3\""));
    }
}
