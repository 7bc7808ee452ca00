//! Machines of the data folder: those that come with Kerf, and what is set in them.

use crate::shop::{Did, Shop};

#[test]
fn what_is_set_can_be_read_again() {
    let shop = Shop::new(&[]);
    shop.kerf("machine set cutter.safe_z_mm 1e19").exits(0);
    shop.kerf("machine get cutter.safe_z_mm").exits(0).says("1e19");
    shop.kerf("send VL,0,1e20").exits(0);
    shop.kerf("machine list limits").exits(0).says("e2");
    shop.kerf("machine set cutter.safe_z_mm nan").exits(2);
    shop.kerf("machine get cutter.safe_z_mm").exits(0).says("1e19");
}

#[test]
fn another_machine_leaves_the_one_before_beside_it() {
    let shop = Shop::new(&[]);
    shop.kerf("machine use plasma").exits(0);
    assert!(!shop.kerf("machine use sim").exits(0).err().contains("kept"), "Kerf has it anyway");
    for (n, delay) in [("", "7"), ("-2", "8")] {
        shop.kerf(&format!("machine set delays.end_s {delay}")).exits(0);
        let name = format!("machine.toml.before{n}");
        shop.kerf("machine use laser-pwm").exits(0).complains(&name);
        let kept = shop.read(&format!("data/{name}"));
        assert!(kept.contains(&format!("end_s = {delay}")), "{kept}");
    }
}

#[test]
fn every_machine_that_comes_with_kerf_finds_its_home() {
    for profile in kerf_machine::profile::PROFILES {
        let shop = Shop::new(&[]);
        shop.kerf(&format!("machine use {}", profile.name)).exits(0);
        // Twice: from where it was switched on, and from home.
        for _ in 0..2 {
            shop.kerf("machine home").exits(0);
        }
        shop.kerf("machine pos").exits(0).says("x  0.000 homed").says("z  0.000 homed");
    }
}

#[test]
fn settings_that_are_changed_at_the_same_moment_are_all_changed() {
    let keys =
        ["end_s", "air_tool_s", "bottom_s", "router_start_s"].map(|it| format!("delays.{it}"));
    let shop = Shop::new(&[]);
    for round in 1..6 {
        let value = format!("{}", f64::from(round) / 8.0);
        let set = |key: &String| shop.command().args(["machine", "set", key, &value]).spawn();
        let begun: Vec<_> = keys.iter().map(set).collect();
        begun.into_iter().for_each(|set| assert!(set.unwrap().wait().unwrap().success()));
        for key in &keys {
            assert_eq!(shop.kerf(&format!("machine get {key}")).out().trim(), value, "{key}");
        }
    }
}

#[test]
fn settings_that_are_saved_can_be_loaded() {
    let shop = Shop::new(&[]);
    shop.kerf("machine set axes 2").exits(2).complains("axes must be 3 to 6, not 2");
    shop.kerf("machine set axes 3").exits(0);
    for line in ["US,saved", "UR,saved"] {
        shop.kerf(&format!("send {line}")).exits(0);
    }
}

#[test]
fn every_machine_that_comes_with_kerf_makes_tool_paths_and_runs_them() {
    let shop = Shop::new(&[]);
    let line = ["draw", "--do", "line 0,0 100,0", "-o", "t1.rsg"];
    Did::of(shop.command().args(line).output().unwrap()).exits(0);
    for profile in kerf_machine::profile::PROFILES {
        let name = profile.name;
        // A torch feels for the sheet, and there is none.
        let (code, end) = match name {
            "plasma" => (3, "surface not found"),
            _ => (0, "ran to its end"),
        };
        shop.kerf(&format!("toolpath t1.rsg --config {name} -o t1.rsm")).exits(0);
        shop.kerf(&format!("run t1.rsm --config {name} --start fresh")).exits(code).says(end);
        shop.kerf(&format!("time t1.rsm --config {name}")).exits(code).says("total");
    }
    let low = "toolpath t1.rsg --z-surface -20 --z-bottom -19 -o t2.rsm";
    shop.kerf(low).exits(2).complains("Z bottom not above it");
}
