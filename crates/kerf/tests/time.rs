//! `kerf time`: what a file takes with a model of motion, or on another controller.

use crate::shop::Shop;

#[test]
fn the_profiler_stops_at_corners_and_not_in_smooth_curves() {
    let sides: String = (1..=72)
        .map(|k| f64::from(k) * std::f64::consts::TAU / 72.0)
        .map(|a| format!("M2,{:.6},{:.6}\n", 50.0 * a.cos(), 50.0 * a.sin()))
        .collect();
    let shop = Shop::new(&[("round.sbp", &format!("MS,100\nJ2,50,0\n{sides}"))]);
    let seconds = |options: &str| {
        let line = format!("time round.sbp --units mm --format json --ramps profiler {options}");
        shop.kerf(&line).exits(0).json()["cut"].as_f64().unwrap()
    };
    // Once round at 100 mm/s, with a ramp of 500 mm/s² at each end.
    let round = 100.0 * std::f64::consts::PI / 100.0 + 0.2;
    assert!((seconds("--axis-speed 200") - round).abs() < 0.01);
    assert!(seconds("--axis-speed 200 --smoothing 0") > 2.0 * round);
    assert!((seconds("--axis-speed 200 --smoothing 0 --stop-angle 6") - round).abs() < 0.01);
    // A quarter of 500 mm/s² on 50 mm: 79 mm/s.
    assert!(seconds("--axis-speed 200 --centripetal 25") > 1.2 * round);
}

/// A square of 100 mm, a pause in the middle of it.
const SQUARE: &str = "MS,100\nMX,100\nMY,100\nPAUSE 2\nMX,0\nMY,0\n";

#[test]
fn other_controllers_take_other_times() {
    let shop = Shop::new(&[("a.sbp", SQUARE)]);
    let times = |options: &str| {
        let line =
            format!("time a.sbp --units mm --format json --axis-speed 200 --accel 500 {options}");
        let told = shop.kerf(&line).exits(0).json();
        ["total", "cut", "wait"].map(|key| told[key].as_f64().unwrap())
    };
    let near = |got: f64, expected: f64| assert!((got - expected).abs() < 0.002, "{got}");
    // Exact stop: four times 100 mm at 100 mm/s and a ramp of 0.2 s.
    let [total, cut, wait] = times("--controller linuxcnc --blend 0 --release 2.10");
    near(cut, 4.8);
    assert_eq!((wait, total), (2.0, cut + 2.0));
    // Before 2.10 both moves before a stand take a ramp of 0.4 s at each end.
    near(times("--controller linuxcnc --blend 0")[1], 5.2);
    // Two corners are rounded, one is a stop because of the pause.
    let blended = times("--controller linuxcnc --release 2.10")[1];
    assert!(blended < 4.8 && blended > 4.7, "{blended}");
    let jumps = times("--controller grbl --junction-deviation 0.05")[1];
    assert!(jumps < blended, "{jumps}");
    near(times("--controller grbl --baud 0 --junction-deviation 0")[1], 4.8);
}

#[test]
fn options_of_other_controllers_belong_to_them() {
    let shop = Shop::new(&[("a.sbp", SQUARE)]);
    for (options, part) in [
        ("--blend 1", "--blend: no controller is named"),
        ("--controller grbl --blend 1", "--blend: it does not belong to --controller grbl"),
        ("--controller grbl --release 2.9", "--release: it does not belong to --controller grbl"),
        ("--controller linuxcnc --baud 1", "--baud: it does not belong to --controller linuxcnc"),
        ("--controller grbl --ramps optimal", "--ramps is Kerf's own"),
        ("--controller grbl --arc-tolerance 0", "greater than 0"),
    ] {
        shop.kerf(&format!("time a.sbp {options}")).exits(2).complains(part);
    }
}

#[test]
fn times_are_told_for_each_tool_path_with_waiting_and_tool_changes() {
    let program = "'Toolpath Name = Pocket\nMX,4\nPAUSE 2\nMY,4\n'Toolpath Name = Outline\nMX,0\n";
    let shop = Shop::new(&[("a.sbp", program)]);
    for options in ["", "--controller grbl", "--controller linuxcnc"] {
        let told = shop.kerf(&format!("time a.sbp --format json {options}")).exits(0).json();
        let paths = told["toolpaths"].as_array().unwrap();
        let seconds = |k: usize| paths[k]["seconds"].as_f64().unwrap();
        assert_eq!((paths.len(), &paths[0]["name"]), (2, &"Pocket".into()));
        assert!(seconds(0) > 6.0 && seconds(1) > 2.0, "{paths:?}");
        let total = told["total"].as_f64().unwrap();
        assert!((seconds(0) + seconds(1) - total).abs() < 1e-6);
    }
}

#[test]
fn inverse_time_and_degrees_are_as_long_as_the_program_says() {
    // Half a minute's share, then degrees by themselves, then both together.
    let program = "G21 G90 G93\nG1 X20 F30\nA90 F60\nX30 A180 F12\nG94 B45 F600\nM2\n";
    let config = "units = \"mm\"\naxes = 5\nrotary = [\"deg\", \"deg\", \"deg\"]\n";
    let shop = Shop::new(&[("a.nc", program), ("five.toml", config)]);
    let told = shop.kerf("trace a.nc --config five.toml").exits(0).all("move");
    for (made, seconds) in told.iter().zip([2.0, 1.0, 5.0, 4.5]) {
        let lasts = made["t1"].as_f64().unwrap() - made["t0"].as_f64().unwrap();
        // Ramps make it a little longer.
        assert!(lasts >= seconds - 1e-6 && lasts < seconds + 0.25, "{made}");
    }
}
