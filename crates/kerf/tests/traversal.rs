//! Shapes that only lead the head, and the way between shapes.

use crate::shop::{Did, Shop};
use serde_json::Value;

/// The events of a job on the standard machine, and its travel as places of the head.
fn trace(script: &str) -> Vec<Value> {
    let shop = Shop::new(&[]);
    let drawn = shop.command().args(["draw", "--do", script, "-o", "job.rsg"]).output().unwrap();
    Did::of(drawn).exits(0);
    shop.kerf("toolpath job.rsg").exits(0);
    let run = shop.kerf("trace job.rsm --config sim --units mm --ramps profiler");
    run.exits(0);
    run.events()
}

fn moves(events: &[Value]) -> Vec<&Value> {
    events.iter().filter(|event| event["e"] == "move").collect()
}

fn number(event: &Value, name: &str) -> f64 {
    event[name].as_f64().unwrap()
}

fn place(event: &Value) -> [f64; 3] {
    ["x", "y", "z"].map(|axis| number(&event["to"], axis))
}

fn switched(events: &[Value], name: &str) -> bool {
    events.iter().any(|event| event["e"] == "output" && event["name"] == name)
}

#[test]
fn pro_group_traversal_2d() {
    let events = trace("line 0,0 200,0; set black traversal=on");
    let moves = moves(&events);
    assert!(moves.iter().all(|event| place(event)[2] == -10.0), "{moves:?}");
    let line = moves.iter().find(|event| place(event)[0] == 200.0).unwrap();
    assert_eq!(number(line, "speed"), 200.0);
    // 200 mm with 1,000 mm/s² and a peak of 200 mm/s.
    assert!((number(line, "t1") - number(line, "t0") - 1.2).abs() < 1e-3);
    assert!(!switched(&events, "tool1") && !switched(&events, "cut1"));
}

#[test]
fn pro_group_traversal_3d() {
    let shop = Shop::new(&[("a.nc", "G71\nG0 X0 Y0 Z0\nG1 X50 Z-3 F500\nG1 X100 Z0\n")]);
    let script = "select all; set black traversal=on height=3d";
    let drawn = shop.command().args(["draw", "a.nc", "--do", script, "-o", "job.rsg"]).output();
    Did::of(drawn.unwrap()).exits(0);
    let run = shop.kerf("trace job.rsg --config sim --units mm");
    run.exits(0);
    let events = run.events();
    let heights: Vec<f64> = moves(&events).iter().map(|event| place(event)[2]).collect();
    let along: Vec<f64> = heights.windows(3).find(|z| z[1] == -23.0).unwrap().to_vec();
    assert_eq!(along, [-20.0, -23.0, -20.0], "{heights:?}");
    assert!(!switched(&events, "cut1"));
}

#[test]
fn pro_group_traversal_detour() {
    let script = "line -50,0 0,0; line 0,0 0,100 200,100; line 200,100 200,150; select 2; group red; \
                  set red traversal=on; select all; move 100,100";
    let events = trace(script);
    let moves = moves(&events);
    let at = |x: f64, y: f64| move |event: &&Value| place(event)[..2] == [x, y];
    let from = moves.iter().rposition(|e| at(100.0, 100.0)(e)).unwrap();
    let to = moves.iter().position(|e| at(300.0, 200.0)(e)).unwrap();
    let between: Vec<[f64; 3]> = moves[from..=to].iter().map(|event| place(event)).collect();
    assert_eq!(between, [[100.0, 100.0, -10.0], [100.0, 200.0, -10.0], [300.0, 200.0, -10.0]]);
}

#[test]
fn pro_group_link_default() {
    let events = trace("line 0,0 100,0; line 100,50 0,50");
    let moves = moves(&events);
    let link = moves.iter().find(|event| place(event) == [100.0, 50.0, -10.0]).unwrap();
    assert_eq!(link["kind"], "jog");
    assert!((number(link, "t1") - number(link, "t0") - 0.45).abs() < 1e-3);
    let before = moves.iter().position(|event| event == link).unwrap() - 1;
    assert_eq!(place(moves[before]), [100.0, 0.0, -10.0]);
}
