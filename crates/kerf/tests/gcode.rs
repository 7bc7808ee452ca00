//! The command on G-code, as on part files.

use crate::shop::Shop;

const PART: &str = "\
G21 G90 (all in mm)
#1 = 4
G1 F600
X1
X2
O100 sub
  X9
O100 endsub
X3
X#1
";

fn shop() -> Shop {
    Shop::new(&[("a.nc", PART), ("calls.sbp", "FG,a.nc\nMX,20\n"), ("box.nc", "G21\nG0X1\n")])
}

#[test]
fn a_run_begins_at_a_line() {
    let shop = shop();
    let run = shop.kerf("run a.nc --units mm --from-line 9");
    run.exits(1).complains("X without a motion");
    let run = shop.command().args(["run", "a.nc", "--from-line", "9 settings"]).output().unwrap();
    let said = String::from_utf8(run.stdout).unwrap();
    assert!(said.contains("2 moves") && said.contains("X 0 … 0.157"), "{said}");
    shop.kerf("run a.nc --from-line 99").exits(2).complains("has 10 lines");
    shop.kerf("run a.nc --from-line 7").exits(1).complains("line 7 lies in a subroutine");
}

#[test]
fn a_cut_without_a_feed_is_an_error_and_the_rest_is_checked() {
    let shop = Shop::new(&[
        ("bare.nc", "G21\nG0 X1\nG1 X2\nX3\nG2 X9 I2\n"),
        ("calls.sbp", "FP,bare.nc\nMX,1\n"),
        ("mixed.sbp", "MS,2\nG1 X1\nMY,1\n"),
    ]);
    for dialect in ["sb3", "linuxcnc", "grbl"] {
        let check = shop.kerf(&format!("check bare.nc --dialect {dialect}"));
        check.exits(1).says("3 | G1 X2").says("G016").says("give F in it or before it");
        check.says("R018");
        assert_eq!(check.out().matches("G016").count(), 1, "{}", check.out());
    }
    shop.kerf("run bare.nc").exits(1).complains("a cutting move without a feed");
    shop.kerf("run calls.sbp").exits(1).complains("a cutting move without a feed");
    let mixed = shop.kerf("trace mixed.sbp");
    mixed.exits(0);
    assert_eq!(mixed.all("move")[0]["speed"], 2.0, "OpenSBP's speeds hold");
    let converted = shop.kerf("convert bare.nc bare.sbp");
    converted.exits(1).complains("R018");
    shop.write("bare.nc", b"G21\nG0 X1\nG1 X2\n");
    shop.kerf("convert bare.nc bare.sbp").exits(0);
}

#[test]
fn a_run_is_stepped_through() {
    let shop = shop();
    shop.write("answers", b"Step\n4 settings\nStep\nRun\n");
    let run = shop.kerf("run a.nc --step --answers answers");
    run.exits(0)
        .says("? G21 G90 (all in mm) → Step\n? #1 = 4 → 4 settings\n? X1 → Step\n? X2 → Run\n")
        .says("4 moves");
    shop.write("answers", b"Step\nQuit\n");
    shop.kerf("run a.nc --step --answers answers").exits(3);
}

#[test]
fn a_part_file_steps_through_g_code() {
    let shop = shop();
    shop.write("answers", b"Step\n9 settings\nRun\n");
    let run = shop.kerf("run calls.sbp --answers answers");
    run.exits(0).says("? X3 → Run").says("3 moves");
}

#[test]
fn tabs_in_g_code_are_spoken_of() {
    let shop = shop();
    shop.kerf("run box.nc --tabs").exits(0).complains("tabs are not left in G-code");
}

/// A laser's raster: the power changes with each line, and the head does not stop.
#[test]
fn s_in_every_line_takes_no_time() {
    use std::fmt::Write as _;
    let mut texts = [String::from("G21 F3000\nM4 S1\n"), String::from("G21 F3000\nM4 S1\n")];
    for i in 1..200 {
        for (text, power) in texts.iter_mut().zip(["", " S"]) {
            let power = if power.is_empty() { String::new() } else { format!("{power}{}", i % 50) };
            writeln!(text, "G1 X{}{power}", f64::from(i) * 0.2).unwrap();
        }
    }
    let shop = Shop::new(&[("plain.nc", &texts[0]), ("raster.nc", &texts[1])]);
    for ramps in ["shopbot", "profiler", "optimal"] {
        let [plain, raster] = ["plain", "raster"].map(|name| {
            let did = shop.kerf(&format!("time {name}.nc --format json --ramps {ramps}"));
            let told: serde_json::Value = serde_json::from_str(&did.exits(0).out()).unwrap();
            told["total"].as_f64().unwrap()
        });
        assert!((plain - raster).abs() < 1e-6, "{ramps}: {plain} s, with S {raster} s");
    }
    let trace = shop.kerf("trace raster.nc").exits(0).out();
    assert!(trace.lines().filter(|l| l.contains("\"spindle\"")).count() >= 196);
}

#[test]
fn g_code_between_the_lines_may_compute() {
    let shop =
        Shop::new(&[("mixed.sbp", "#1=[2+1]\nG20 G1 X#1 F60\nMX,4\nG1 Y[#1*2]\nPRINT %(2)\n")]);
    shop.kerf("run mixed.sbp").exits(0).says("6").says("3 moves");
    shop.write("o.sbp", b"O1 call\n");
    shop.kerf("check o.sbp").exits(1).says("a file of its own");
}

/// A block that tells something, switches something and then waits.
#[test]
fn a_block_may_stop_the_spindle_and_the_program_with_a_message() {
    let text = "G21 F100\nM3 S100\nG1 X1\nM5 M0 (MSG, flip it)\nS5 M66 P3 L0 (MSG, b)\nG1 X2\n";
    let shop = Shop::new(&[("flip.nc", text)]);
    shop.kerf("run flip.nc").exits(0).says("flip it").says("2 moves");
}

#[test]
fn fmt_knows_g_code() {
    let shop = shop();
    assert_eq!(shop.kerf("fmt --check a.nc box.nc").exits(1).out(), "box.nc\n");
    shop.kerf("fmt box.nc").exits(0);
    assert_eq!(shop.read("box.nc"), "G21\nG0 X1\n");
}
