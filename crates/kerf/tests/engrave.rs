//! Engraving from the drawing to the machine.

#![allow(clippy::unwrap_used)]

mod shop;

use serde_json::Value;
use shop::{Did, Shop};

const PLATE: &str = "line 0,0 100,0 100,60 0,60 close; engrave all tool=5 overlap=0.1 group=red; \
                     set black on=off; ";

/// Where the simulated machine has the surface of the material.
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

/// How often the tool goes from the air into the material.
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
                    engrave all tool=5 overlap=0.1 group=red; set black on=off; set red height=-2";
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
