//! Smoothing of tool paths when they are made.

use crate::shop::{Did, Shop};

/// A shop with a drawing of a polygon of 72 sides, radius 50, offset 5.
fn shop() -> Shop {
    let shop = Shop::new(&[]);
    let place = |k: u32| {
        let turn = std::f64::consts::TAU * f64::from(k) / 72.0;
        format!("{},{}", 100.0 + 50.0 * turn.cos(), 100.0 + 50.0 * turn.sin())
    };
    let places: Vec<String> = (0..72).map(place).collect();
    let script = format!("line {} close; set black offset=5", places.join(" "));
    let drawn = shop.command().args(["draw", "--do", &script, "-o", "job.rsg"]).output().unwrap();
    Did::of(drawn).exits(0);
    shop
}

#[test]
fn pro_smoothing_pathgen() {
    let shop = shop();
    let segments = |factor: &str| {
        shop.kerf(&format!("toolpath job.rsg --smoothing {factor}")).exits(0);
        let shapes = shop.kerf("draw job.rsm --list");
        shapes.exits(0);
        let shape: serde_json::Value =
            serde_json::from_str(shapes.out().lines().next().unwrap()).unwrap();
        let reach = shape["bounds"]["max"]["x"].as_f64().unwrap();
        assert!((reach - 155.0).abs() < 0.06, "{reach}");
        shape["points"].as_array().unwrap().len()
    };
    assert!(segments("0.6") < 10);
    assert_eq!(segments("0"), 144);
}

/// The factor of the machine changes between making the tool path and the start; the file says which made it.
#[test]
fn pro_smoothing_recreate() {
    let shop = shop();
    shop.kerf("machine use sim").exits(0);
    shop.kerf("toolpath job.rsg").exits(0);
    let warning = || {
        let did = shop.kerf("run job.rsm --quiet");
        let err = did.exits(0).err();
        let (_, rest) = err.split_once("tool path made with other smoothing values: ")?;
        Some(rest.split(';').next().unwrap().to_owned())
    };
    let set = |factor: &str| {
        shop.kerf(&format!("machine set smoothing.factor {factor}")).exits(0);
    };
    assert_eq!(warning(), None);
    set("0.3");
    let told = Some("the factor was 0.6 and is 0.3 now".to_owned());
    assert_eq!(warning(), told);
    // It is told at each start, until the path is made anew.
    assert_eq!(warning(), told);
    shop.kerf("toolpath job.rsg --start kept").exits(0);
    assert_eq!(warning(), None);
    set("0.6");
    assert_eq!(warning(), Some("the factor was 0.3 and is 0.6 now".to_owned()));
}
