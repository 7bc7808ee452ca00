//! The time of a file on a controller that was driven before: by its own settings, and by what its runs have shown.

use crate::bench::Bench;
use crate::shop::Shop;
use serde_json::Value;

/// A zigzag whose legs never come to their speed: its time is by the acceleration alone.
const ZIGZAG: &str = "MS,3\nSR\n&n = 0\nagain:\nM2,0.2,0.2\nM2,0.2,-0.2\n&n = &n + 1\nIF &n < 8 THEN GOTO again\nSA\n";

fn told_s(shop: &Shop, machine: &str) -> (f64, Value) {
    let did = shop.kerf(&format!("time zigzag.sbp --machine {machine} --format json"));
    did.exits(0);
    let told: Value = serde_json::from_str(&did.out()).unwrap();
    (told["total"].as_f64().unwrap(), told["learned"].clone())
}

#[test]
fn the_time_follows_a_setting_that_was_sent() {
    let shop = Shop::new(&[("zigzag.sbp", ZIGZAG)]);
    let bench = Bench::new(&[(120, 400.0), (121, 400.0)]);
    let machine = format!("grbl:{}", bench.port);
    let sends = |accel: u32| {
        shop.kerf(&format!("send $120={accel} $121={accel} --machine {machine}")).exits(0);
        told_s(&shop, &machine).0
    };
    let (quick_s, slow_s) = (sends(500), sends(125));
    assert!((slow_s / quick_s - 2.0).abs() < 0.02, "{quick_s} and {slow_s}");
}

#[test]
fn the_time_is_that_of_the_controller_with_what_its_runs_have_shown() {
    let shop = Shop::new(&[("zigzag.sbp", ZIGZAG)]);
    let bench = Bench::new(&[(120, 100.0), (121, 100.0)]);
    shop.kerf(&format!("machine save shop --machine grbl:{}", bench.port)).exits(0);
    shop.kerf("machine pace --machine shop").exits(0).says("no run here has shown anything yet");
    let never = shop.kerf("time zigzag.sbp --machine shop");
    never.exits(0).complains("the time is that of Kerf's own plan");
    assert!(bench.look(|fake| fake.lines.clone()).is_empty(), "whoever looks opens no port");

    let ran = shop.kerf("run zigzag.sbp --machine shop");
    ran.exits(0);
    let (by_runs_s, learned) = told_s(&shop, "shop");
    let says = "1 run here: motion takes ";
    let learned = learned.as_str().unwrap();
    assert!(
        learned.starts_with(says) && learned.ends_with(" times as long as estimated"),
        "{learned}"
    );
    shop.kerf("machine pace --machine shop").exits(0).says(says);

    shop.kerf("machine pace --forget --machine shop").exits(0);
    shop.kerf("machine pace --machine shop").exits(0).says("no run here has shown anything yet");
    let (by_settings_s, learned) = told_s(&shop, "shop");
    assert!(learned.is_null());
    // 16 legs of 7.18 mm at 100 mm/s² an axis: rounded a little, they take 0.4 s each.
    assert!((by_settings_s / 6.8 - 1.0).abs() < 0.1, "{by_settings_s}");
    assert!((by_runs_s / by_settings_s - 1.0).abs() < 0.06, "{by_runs_s} and {by_settings_s}");
    // Kerf's own plan takes less: what a run tells at its end is what the controller took.
    let took_s = told_after_s(&ran.out());
    assert!(took_s > 0.9 * by_settings_s, "{took_s} and {by_settings_s}");
}

/// The seconds of "ran to its end after 6.9 s".
fn told_after_s(told: &str) -> f64 {
    let words = told.strip_prefix("ran to its end after ").expect(told);
    words.split_once(" s\n").expect(told).0.parse().expect(told)
}
