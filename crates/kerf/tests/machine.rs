//! `kerf machine` as a user meets it.

use std::path::Path;
use std::process::{Command, Output};

fn kerf(data: &Path, arguments: &[&str]) -> Output {
    command(data, "machine", arguments)
}

fn command(data: &Path, name: &str, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_kerf"));
    command.arg(name).args(arguments).env("KERF_DATA", data).output().unwrap()
}

fn told(data: &Path, arguments: &[&str]) -> String {
    let output = kerf(data, arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

fn refused(data: &Path, arguments: &[&str], part: &str) {
    let output = kerf(data, arguments);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    assert!(message.contains(part), "{arguments:?}: {message}");
}

/// A command that was understood and could not be done.
fn fails(data: &Path, arguments: &[&str], part: &str) {
    let output = kerf(data, arguments);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{arguments:?}: {message}");
    assert!(message.contains(part), "{arguments:?}: {message}");
}

#[test]
fn pro_misc_config_save() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("new");
    told(&data, &["use", "sim"]);
    told(&data, &["set", "zpos.top_mm", "-12"]);
    assert_eq!(told(&data, &["get", "zpos.top_mm"]), "-12\n");
    assert_eq!(told(&data, &["get", "zpos.bottom_mm"]), "-30\n");
    refused(&data, &["set", "zpos.top_mm", "-25"], "zpos.surface_mm (-20) is above zpos.top_mm");
    assert_eq!(told(&data, &["get", "zpos.top_mm"]), "-12\n", "a refused value changes nothing");
}

#[test]
fn pro_axes_axes() {
    let folder = tempfile::tempdir().unwrap();
    let axes = told(folder.path(), &["axes", "--config", "sim"]);
    let names: Vec<&str> = axes.lines().skip(1).filter_map(|line| line.split(' ').next()).collect();
    assert_eq!(names, ["x", "y", "z", "w"]);
}

#[test]
fn pro_motors_fixed() {
    let folder = tempfile::tempdir().unwrap();
    for (axis, motor) in [("motors.x", "\"x\"\n"), ("motors.y", "\"y\"\n"), ("motors.z", "\"z\"\n")]
    {
        assert_eq!(told(folder.path(), &["get", axis]), motor);
    }
    refused(
        folder.path(),
        &["set", "motors.y", "x"],
        "motors.y must be y, which cannot be changed",
    );
}

#[test]
fn pro_motors_assign() {
    let folder = tempfile::tempdir().unwrap();
    told(folder.path(), &["set", "motors.w", "R"]);
    told(folder.path(), &["set", "motors.y2", "W"]);
    let axes = told(folder.path(), &["axes"]);
    assert!(axes.contains("\ny    Y W ") && axes.contains("\nw    R "), "{axes}");
    refused(folder.path(), &["set", "motors.x2", "W"], "motor W drives two axes");
}

#[test]
fn a_mistake_in_a_file_is_told_with_line_and_hint() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("m.toml");
    std::fs::write(&file, "axes = 3\n[delays]\nend = 4\n").unwrap();
    let output = kerf(folder.path(), &["check", file.to_str().unwrap()]);
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(
        text.contains("m.toml:3:1: there is no setting delays.end [K002] did you mean"),
        "{text}"
    );
}

/// Output of `kerf io`.
fn io(data: &Path, arguments: &[&str]) -> String {
    let output = command(data, "io", arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn pro_io_diag_write() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(io(folder.path(), &["set", "tool2", "1"]), "output port B = 0x04\n");
    assert_eq!(io(folder.path(), &["get", "tool2"]), "1\n");
    assert_eq!(io(folder.path(), &["set", "tool2", "0"]), "output port B = 0x00\n");
    let trace = folder.path().join("io.vcd");
    io(folder.path(), &["set", "tool2", "1", "--vcd", trace.to_str().unwrap()]);
    let text = std::fs::read_to_string(trace).unwrap();
    let of = |name: &str| {
        let is_it =
            |line: &&str| line.starts_with("$var") && line.contains(&format!(" {name} $end"));
        let declared = text.lines().find(is_it).unwrap();
        declared.split(' ').nth(3).unwrap().to_owned()
    };
    let (_, body) = text.split_once("$dumpvars").unwrap();
    assert!(body.lines().any(|line| line == format!("1{}", of("tool2"))), "{text}");
    assert!(body.lines().any(|line| line == format!("b00000100 {}", of("port_b"))), "{text}");
}

#[test]
fn pro_io_diag_write__not_while_a_job_runs() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("data");
    std::fs::write(folder.path().join("a.sbp"), "PAUSE 30\n").unwrap();
    let kerf = env!("CARGO_BIN_EXE_kerf");
    let start = || {
        std::process::Command::new(kerf)
            .args(["run", "a.sbp", "--pace", "real", "--quiet", "--data", "data"])
            .current_dir(folder.path())
            .spawn()
            .unwrap()
    };
    let mut job = start();
    let set = || {
        let set = ["io", "set", "tool2", "1", "--data", data.to_str().unwrap()];
        std::process::Command::new(kerf).args(set).output().unwrap()
    };
    let refused = (0..600).any(|_| {
        std::thread::sleep(std::time::Duration::from_millis(50));
        // A run that found the machine owned for the moment of a setting is started again.
        if job.try_wait().unwrap().is_some() {
            job = start();
        }
        !set().status.success()
    });
    job.kill().unwrap();
    job.wait().unwrap();
    assert!(refused, "the run owns the machine");
}

#[test]
fn pro_io_diag_step() {
    let folder = tempfile::tempdir().unwrap();
    let told = io(folder.path(), &["step", "x", "+", "--config", "sim"]);
    assert_eq!(told, "x step 1 (port A 0x03, 0x01), x +0.0040\n");
    let told = io(folder.path(), &["step", "x", "-", "--config", "sim"]);
    assert_eq!(told, "x step 0 (port A 0x02, 0x00), x -0.0040\n");
}

#[test]
fn pro_io_diag_read() {
    let folder = tempfile::tempdir().unwrap();
    assert_eq!(io(folder.path(), &["set", "in.xhome", "1"]), "input port A = 0x04\n");
    assert!(io(folder.path(), &["list"]).contains("input  A2  xhome             1 "));
}

#[test]
fn pro_io_levels__of_single_inputs() {
    let folder = sim();
    let data = folder.path();
    told(
        data,
        &["set", "ports.invert_a", "[false, false, false, false, false, true, false, false]"],
    );
    assert_eq!(io(data, &["get", "in.bdel"]), "1\n", "an open pin");
    assert_eq!(io(data, &["set", "in.bdel", "1"]), "input port A = 0x00\n");
    assert_eq!(io(data, &["set", "in.bdel", "0"]), "input port A = 0x20\n");
}

#[test]
fn pro_io_pci_i_elec__a_pin_that_is_grounded() {
    let folder = sim();
    let data = folder.path();
    told(data, &["set", "ports.card", "pci"]);
    let part = data.join("a.sbp");
    std::fs::write(&part, "MX,1\nMX,0\n").unwrap();
    let run = || command(data, "run", &[part.to_str().unwrap(), "--quiet"]).status.code();
    assert_eq!((io(data, &["get", "in.estop"]).as_str(), run()), ("0\n", Some(0)), "it is open");
    assert_eq!(io(data, &["set", "in.estop", "0"]), "input port A = 0x40\n");
    assert!(io(data, &["list"]).contains("input  A6  estop             1 "));
    assert_eq!(run(), Some(3));
    assert_eq!(io(data, &["set", "in.estop", "1"]), "input port A = 0x00\n");
    assert_eq!(run(), Some(0));
}

/// An input that is set by hand is that of the machine that runs.
#[test]
fn nothing_moves_while_the_emergency_stop_is_set() {
    let folder = sim();
    let data = folder.path();
    std::fs::write(data.join("a.sbp"), "MX,1\n").unwrap();
    let part = data.join("a.sbp");
    let run = || command(data, "run", &[part.to_str().unwrap(), "--quiet"]);
    assert_eq!(io(data, &["set", "in.estop", "1"]), "input port A = 0x40\n");
    for output in [run(), kerf(data, &["move", "to", "10,10"]), kerf(data, &["home", "x"])] {
        let message = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(3), "{message}");
        assert!(message.contains("emergency stop"), "{message}");
    }
    assert!(told(data, &["pos"]).starts_with("x  0.000 not homed\ny  0.000 "));
    assert_eq!(io(data, &["get", "in.estop"]), "1\n");
    io(data, &["set", "in.estop", "0"]);
    assert_eq!(run().status.code(), Some(0));
    // Home switches are where they are, whatever was set.
    io(data, &["set", "in.xhome", "0"]);
    assert!(told(data, &["home", "x"]).ends_with(" steps\n"));
}

#[test]
fn pro_io_pci_o_elec__help() {
    let folder = tempfile::tempdir().unwrap();
    let map = io(folder.path(), &["map", "--card", "pci", "--notes"]);
    assert!(map.contains("output      23        xstep              A1  step\n"), "{map}");
    assert!(map.contains("# Outputs: open collector through 1 kOhm"));
}

#[test]
fn pro_io_vcd() {
    let folder = tempfile::tempdir().unwrap();
    let (part, trace) = (folder.path().join("a.sbp"), folder.path().join("a.vcd"));
    std::fs::write(&part, "SO,1,1\nMX,10\nSO,1,0\n").unwrap();
    let words = [part.to_str().unwrap(), "--config", "sim", "-q", "--vcd", trace.to_str().unwrap()];
    assert!(command(folder.path(), "run", &words).status.success());
    let text = std::fs::read_to_string(&trace).unwrap();
    assert!(text.starts_with("$version kerf $end\n$timescale 1 ns $end\n"));
    assert!(text.contains("$var wire 1 \" xstep $end") && text.lines().count() > 2 * 2500);
}

/// A data folder with the machine SIM (readings, SIM).
fn sim() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    told(folder.path(), &["use", "sim"]);
    folder
}

#[test]
fn homing_tells_each_step() {
    let folder = sim();
    assert!(told(folder.path(), &["pos"]).starts_with("x  0.000 not homed\n"));
    let steps = told(folder.path(), &["home", "x"]);
    let lines: Vec<&str> = steps.lines().collect();
    assert!(lines[0].ends_with(" x      0.000 to  -121.250, up to 50.000/s"), "{steps}");
    assert!(lines.last().unwrap().starts_with("x -"), "{steps}");
    assert!(told(folder.path(), &["pos"]).starts_with("x  0.000 homed\ny  0.000 not homed\n"));
    assert!(told(folder.path(), &["home", "x"]).ends_with("x 0 steps\n"), "as it was left");
    let without = tempfile::tempdir().unwrap();
    for (axes, why) in [("x", "axis x has no home switch"), ("", "name axes by their letters")] {
        let output = kerf(without.path(), &["home", axes]);
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success() && message.contains(why), "{message}");
        assert!(output.stdout.is_empty(), "no switch, no search");
    }
    fails(without.path(), &["home"], "no axis of this machine has a home switch");
    fails(folder.path(), &["home", "xw"], "axis w has no home switch");
}

#[test]
fn moves_by_hand_go_on_where_the_last_ended() {
    let folder = sim();
    told(folder.path(), &["set", "job.origin_mm", "300,200"]);
    told(folder.path(), &["move", "to", "10,20,-5"]);
    assert!(told(folder.path(), &["pos"]).starts_with("x  310.000 not homed\ny  220.000 "));
    told(folder.path(), &["move", "to", "5,,1", "--relative"]);
    let slanted = told(folder.path(), &["move", "to", "30,40", "--relative"]);
    let speed = |axis: &str| -> f64 {
        let line = slanted.lines().find(|line| line.contains(&format!("s  {axis} "))).unwrap();
        let (_, speed) = line.rsplit_once("up to ").unwrap();
        speed.trim_end_matches("/s").parse().unwrap()
    };
    assert!((speed("x") / speed("y") - 0.75).abs() < 1e-3, "each axis has its part: {slanted}");
    told(folder.path(), &["move", "to", "-30,-40", "--relative"]);
    told(folder.path(), &["move", "hold", "x+", "--for", "1"]);
    assert!(told(folder.path(), &["pos"]).starts_with("x  365.000 "));
    let cut = told(folder.path(), &["move", "cut-to", "100,0", "--cut"]);
    assert!(cut.contains(", cut\n"), "{cut}");
    assert!(told(folder.path(), &["pos"]).starts_with("x  400.000 not homed\ny  200.000 "));
    let output = kerf(folder.path(), &["move", "to", "9000,0"]);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1));
    assert!(message.contains("Out of bounds: x would reach 9300.000"), "{message}");
}

#[test]
fn homing_that_fails_says_what_failed_and_what_to_look_at() {
    let folder = sim();
    let look = |input: &str| {
        let switch = format!("look at the switch on input {input} (homing)");
        format!("; nothing moves on; {switch}, and at the length of the axis (axis.length)")
    };
    told(folder.path(), &["set", "sim.switch_at", "[\"none\", -3, 3]"]);
    fails(folder.path(), &["home", "x"], &format!("x home not found{}", look("xhome")));
    told(folder.path(), &["set", "sim.switch_at", "[-3, -3, 3]"]);
    told(folder.path(), &["set", "sim.hysteresis", "9e9"]);
    fails(
        folder.path(),
        &["home", "z"],
        &format!("z home not found: its switch stays on{}", look("zhome")),
    );
    let two = sim();
    told(two.path(), &["use", "router-96x48"]);
    told(two.path(), &["set", "homing.separate_x", "true"]);
    fails(
        two.path(),
        &["home", "x"],
        &format!("x home not found with motor W alone{}", look("xhome")),
    );
}

#[test]
fn a_cut_by_hand_that_is_stopped_says_why() {
    let folder = tempfile::tempdir().unwrap();
    told(folder.path(), &["use", "plasma"]);
    let output = kerf(folder.path(), &["move", "cut-to", "100,0", "--cut"]);
    let out = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(3), "{out}");
    assert!(out.contains("? Paused: surface not found → Quit (default)\n"), "{out}");
}

#[test]
fn moves_by_hand_go_one_way() {
    let folder = sim();
    for (way, why) in [("x+x-", "x is named twice"), ("x+x+", "x is named twice"), ("", "as x+")] {
        refused(folder.path(), &["move", "hold", way], why);
    }
    refused(folder.path(), &["origin", "1,2,3"], "give X,Y or here");
    refused(folder.path(), &["move", "cut-to", "1,2,3"], "give X,Y");
    refused(folder.path(), &["move", "home", ""], "name axes by their letters");
    assert!(told(folder.path(), &["pos"]).starts_with("x  0.000 not homed\n"));
}

#[test]
fn pro_move_arrows_pct__range() {
    let folder = sim();
    for percent in ["0", "101"] {
        refused(folder.path(), &["move", "hold", "x+", "--speed", percent], "1..=100");
        refused(folder.path(), &["move", "hold", "x+", "--accel", percent], "1..=100");
    }
}

#[test]
fn pro_zpos_set() {
    let folder = sim();
    told(folder.path(), &["move", "to", ",,-12"]);
    assert_eq!(told(folder.path(), &["zset", "top"]), "zpos.top_mm = -12\n");
    assert_eq!(told(folder.path(), &["get", "zpos.top_mm"]), "-12\n");
    let text = std::fs::read_to_string(folder.path().join("machine.toml")).unwrap();
    assert!(text.contains("top_mm = -12\n") && text.contains("surface_mm = -20\n"));
    refused(folder.path(), &["zset", "surface", "-8"], "zpos.surface_mm (-8) is above zpos.top_mm");
}

#[test]
fn pro_zpos_set__refused_before_it_moves() {
    let folder = sim();
    for (height, z, why) in [
        ("surface", "-8", "zpos.surface_mm (-8) is above zpos.top_mm"),
        ("top", "-35", "zpos.top_mm"),
        ("bottom", "-200", "zpos.bottom_mm"),
    ] {
        refused(folder.path(), &["zset", height, z], why);
        assert!(told(folder.path(), &["pos"]).contains("z  0.000 "), "{height} {z}");
    }
}

#[test]
fn pro_zpos_adjust() {
    let folder = sim();
    assert_eq!(
        told(folder.path(), &["zset", "bottom", "--by", "-0.5"]),
        "zpos.bottom_mm = -30.5\n"
    );
    assert_eq!(told(folder.path(), &["zset", "bottom", "--by", "+0.5"]), "zpos.bottom_mm = -30\n");
}

#[test]
fn pro_zpos_home_before_set() {
    let folder = sim();
    let homed =
        |told: String| told.lines().any(|line| line.starts_with("z ") && line.ends_with(" steps"));
    assert!(!homed(told(folder.path(), &["zset", "top", "-11"])));
    told(folder.path(), &["set", "homing.at_job_start", "z"]);
    let steps = told(folder.path(), &["zset", "bottom", "-32"]);
    assert!(homed(steps.clone()) && steps.ends_with("zpos.bottom_mm = -32\n"), "{steps}");
}

#[test]
fn pro_height_prop_typical() {
    let folder = tempfile::tempdir().unwrap();
    let shown = told(folder.path(), &["list", "height"]);
    for line in [
        "height.speed_mm_s = 30 ",
        "height.accel_mm_s2 = 400 ",
        "height.x_set_point = 150 ",
        "height.y_set_point = 150 ",
        "height.k = 20 ",
        "height.scale_mm = 0.038 ",
        "height.display_accuracy_mm = 0.1 ",
        "height.port = 3 ",
        "height.baud = 9600 ",
    ] {
        assert!(shown.contains(&format!("\n{line}")), "{line} in {shown}");
    }
}

#[test]
fn pro_height_prop_kform__shown() {
    let folder = tempfile::tempdir().unwrap();
    let suggested = |scale: &str| {
        let file = folder.path().join("sim.toml");
        std::fs::write(&file, told(folder.path(), &["profiles", "sim"])).unwrap();
        let file = file.to_str().unwrap();
        told(folder.path(), &["set", "height.scale_mm", scale, "--config", file]);
        told(folder.path(), &["list", "height.k", "--config", file])
    };
    let shown = suggested("0.04");
    assert!(shown.contains("(10 suits this Z axis, half of it is 5)"), "{shown}");
    assert!(suggested("0.038").contains("(9.5 suits this Z axis"));
}

#[test]
fn pro_height_prop_port() {
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path();
    told(data, &["set", "options.devices", "/dev/a,/dev/b,/dev/c,/dev/pts/9"]);
    told(data, &["set", "height.port", "4"]);
    assert!(told(data, &["list", "height.port"]).contains("(/dev/pts/9)"));
    for (port, why) in [("0", "1 to 4"), ("5", "1 to 4"), ("1", "same serial port"), ("2", "same")]
    {
        refused(data, &["set", "height.port", port], why);
    }
    assert_eq!(told(data, &["get", "height.port"]), "4\n");
}
