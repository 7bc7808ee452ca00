//! Machines and jobs that cannot be: refused by name before anything moves, and what protects settings.

use crate::shop::Shop;

/// A shop with a machine that says this beside what the simulated one does, and a line to cut.
fn shop(lines: &str) -> Shop {
    let shop = Shop::new(&[]);
    let sim = shop.kerf("machine profiles sim").out();
    let mut machine = String::new();
    for (key, value) in lines.lines().filter_map(|line| line.split_once(" = ")) {
        machine += &format!("{key} {value}\n");
    }
    shop.write("machine.toml", sim.as_bytes());
    for line in machine.lines() {
        let (key, value) = line.split_once(' ').unwrap();
        set(&shop, key, value);
    }
    let did = shop.command().args(["draw", "--do", "line 0,0 100,0", "-o", "job.rsg"]).output();
    assert!(did.unwrap().status.success());
    shop.kerf("toolpath job.rsg").exits(0);
    shop
}

/// Puts a value into the file, as somebody does who edits it.
fn set(shop: &Shop, key: &str, value: &str) {
    let text = shop.read("machine.toml");
    let (section, name) = key.rsplit_once('.').unwrap_or(("", key));
    let head = format!("[{section}]\n");
    let line = format!("{name} = {value}\n");
    let kept: String = match text.split_once(&head) {
        Some((before, after)) => {
            let (own, rest) = after
                .split_once("\n[")
                .map_or((after, String::new()), |(own, rest)| (own, format!("\n[{rest}")));
            let own: String = own
                .lines()
                .filter(|it| !it.starts_with(&format!("{name} = ")))
                .map(|it| format!("{it}\n"))
                .collect();
            format!("{before}{head}{line}{own}{rest}")
        }
        None => format!("{text}\n{head}{line}"),
    };
    shop.write("machine.toml", kept.as_bytes());
}

/// Whatever would move the machine is refused, by name, and nothing has moved.
#[track_caller]
fn refused(lines: &str, part: &str) {
    let shop = shop(lines);
    for words in ["run job.rsm --trace out.jsonl", "trace job.rsm", "time job.rsm", "machine home"]
    {
        let did = shop.kerf(&format!("{words} --config machine.toml"));
        did.exits(2).complains(part).complains("machine.toml:");
        assert!(!did.out().contains("\"e\":\"move\""), "{}", did.out());
    }
    assert!(!shop.names().contains(&"out.jsonl".into()), "no run began");
    shop.kerf("machine check machine.toml").exits(1).says(part);
}

#[test]
fn two_axes_on_one_motor_are_refused() {
    refused("motors.x2 = \"q\"\nmotors.y2 = \"q\"", "motor Q drives two axes");
}

#[test]
fn a_pulse_longer_than_its_period_is_refused() {
    refused("motors.step_delay_ns = 100000", "a step pulse takes");
}

#[test]
fn z_bottom_above_z_top_is_refused() {
    refused("zpos.bottom_mm = -5", "zpos.bottom_mm (-5) is above zpos.surface_mm (-20)");
}

#[test]
fn a_laser_frequency_without_a_valid_pulse_is_refused() {
    let laser =
        "laser.cut_hz = 200000\nlaser.min_pulse_us = 6\nlaser.type = \"pwm\"\nlaser.use = true";
    refused(laser, "no valid laser pulse width");
}

#[test]
fn a_job_outside_the_limits_is_refused_before_the_first_move() {
    let shop = shop("");
    shop.kerf("toolpath job.rsm --origin 2450,0 -o far.rsm");
    let did = shop.kerf("trace far.rsm --config machine.toml");
    did.exits(1).says("shape 1 reaches X 2550.000");
    assert!(did.all("move").is_empty() && did.all("output").is_empty(), "{}", did.out());
    let did = shop.kerf("run far.rsm --config machine.toml --trace out.jsonl");
    did.exits(1).complains("Out of bounds: shape 1 reaches X 2550.000");
    assert!(!shop.read("out.jsonl").contains("\"e\":\"move\""));
}

#[test]
fn a_finish_position_outside_the_limits_is_named() {
    let shop = shop("");
    shop.kerf("toolpath job.rsm --finish 9999,0 -o far.rsm");
    let did = shop.kerf("run far.rsm --config machine.toml --trace out.jsonl");
    did.exits(1).complains("Out of bounds: the finish position reaches X 9999.000");
    did.complains("X goes from 0.000 to 2500.000");
    assert!(!did.err().contains("shape"), "{}", did.err());
    assert!(!shop.read("out.jsonl").contains("\"e\":\"move\""));
}

#[test]
fn what_a_waiting_job_refuses_is_shown() {
    let shop = shop("");
    shop.write("answers", b"zbottom 20\nabort\n");
    let did = shop.kerf("run job.rsm --config machine.toml --hold-at 0.2 --answers answers");
    did.exits(3).says("ZBottom would be at -10.000 mm, above ZSurface at -20.000 mm");
    shop.write("answers", b"# note\ncut 0\nresume\n");
    let did = shop.kerf("run job.rsm --config machine.toml --hold-at 0.2 --answers answers");
    did.exits(1).complains("line 2 of the answers: 'cut 0' tells a job that waits nothing");
}

#[test]
fn pro_options_password__kerf_machine_set() {
    let shop = Shop::new(&[]);
    shop.kerf_with("machine password", b"secret word\nsecret word\n").exits(0);
    shop.kerf("machine set delays.end_s 2").exits(2).complains("the settings are protected");
    shop.kerf("machine set delays.end_s 2 --password wrong").exits(2).complains("not the password");
    for words in ["machine zset top", "machine origin 1,2", "machine use sim"] {
        shop.kerf(words).exits(2).complains("the settings are protected");
    }
    // Looking and running are for everybody.
    shop.kerf("machine get delays.end_s").exits(0);
    shop.write("a.sbp", b"MX,1\n");
    shop.kerf("run a.sbp").exits(0);
    let before = shop.kerf("machine get delays.end_s").out();
    let mut given = shop.command();
    given.args(["machine", "set", "delays.end_s", "2", "--password", "secret word"]);
    assert!(given_ok(&mut given));
    let mut by_variable = shop.command();
    by_variable.args(["machine", "set", "delays.end_s", "3"]).env("KERF_PASSWORD", "secret word");
    assert!(given_ok(&mut by_variable));
    assert_ne!(shop.kerf("machine get delays.end_s").out(), before);
    // Kept as a salted hash, and changed by the one command that asks twice.
    let kept = shop.read("data/machine.toml");
    assert!(kept.contains("password = ") && !kept.contains("secret word"), "{kept}");
    let typed = shop.command().args(["machine", "set", "options.password", "x"]).output().unwrap();
    assert!(String::from_utf8_lossy(&typed.stderr).contains("kerf machine password"));
    let mut off = shop.command();
    assert!(given_ok(off.args(["machine", "password", "--off", "--password", "secret word"])));
    shop.kerf("machine set delays.end_s 4").exits(0);
}

#[test]
fn pro_options_password__lines_and_part_files() {
    let shop = Shop::new(&[]);
    shop.kerf_with("machine password", b"secretword\nsecretword\n").exits(0);
    let kept = shop.read("data/machine.toml");
    shop.write("sets.sbp", b"VC,.375\nVS,3\nSV\nMX,1\n");
    shop.write("a.sbp", b"MX,2\n");
    for line in ["VC,.375", "MS,3", "SF,0", "UR,simulated-96x48,0", "VR,,7"] {
        let mut typed = shop.command();
        let did = typed.args(["send", line]).output().unwrap();
        let told = String::from_utf8_lossy(&did.stderr);
        assert!(told.contains("the settings are protected"), "{line}: {told}");
        assert_eq!(did.status.code(), Some(2), "{line}");
    }
    shop.kerf("settings load simulated-96x48").exits(2).complains("the settings are protected");
    shop.kerf("send VC,.375 --password wrong").exits(2).complains("not the password");
    shop.kerf("run a.sbp --password wrong").exits(2).complains("not the password");
    // A file has the values that it sets, to its end.
    let ran = shop.kerf("run sets.sbp --trace -");
    ran.exits(0).says("\"speed\":3").says("these values end with the file");
    // What other software passes in while a file runs is typed, too.
    let kerf = shop.command().get_program().to_string_lossy().into_owned();
    let passes = format!("SHELL, \"{kerf} registry set uCommand VC,.5\",1,SYNC\nMX,2\n");
    shop.write("passes.sbp", passes.as_bytes());
    let passed = shop.kerf("run passes.sbp --allow-shell");
    passed.exits(1).complains("VC changes settings, and they are protected");
    shop.kerf("send MX,3").exits(0);
    assert_eq!(shop.read("data/machine.toml"), kept);

    shop.kerf("run sets.sbp --password secretword").exits(0);
    let set = shop.read("data/machine.toml");
    assert!(set.contains("diameter_mm = 9.525") && set.contains("76.2"), "{set}");
    shop.kerf("send VC,.5 --password secretword").exits(0);
    assert!(shop.read("data/machine.toml").contains("diameter_mm = 12.7"));
}

fn given_ok(command: &mut std::process::Command) -> bool {
    command.output().unwrap().status.success()
}

#[test]
fn a_new_password_is_asked_for_twice() {
    let shop = Shop::new(&[]);
    let differ = shop.kerf_with("machine password", b"secret word\nsecret wort\n");
    differ.exits(2).complains("the two passwords are not the same");
    shop.kerf_with("machine password", b"a\na\n").exits(2).complains("characters at least");
    shop.kerf("machine set delays.end_s 2").exits(0);
}

#[test]
fn pro_options_persist() {
    let shop = Shop::new(&[]);
    let all = [
        (
            "options.devices",
            "/dev/a,/dev/b,/dev/c,/dev/d",
            "[\"/dev/a\", \"/dev/b\", \"/dev/c\", \"/dev/d\"]",
        ),
        ("options.console", "true", "true"),
        ("options.console_port", "4", "4"),
        ("options.send_port", "1", "1"),
        ("options.send_baud", "38400", "38400"),
        ("options.firmware", "flash", "\"flash\""),
        ("options.warm_up", "30:1", "\"30:1\""),
        ("options.controller", "grbl:/dev/ttyS9", "\"grbl:/dev/ttyS9\""),
        ("options.filter_mm", "0.02", "0.02"),
        ("options.join_mm", "0.7", "0.7"),
        ("options.pick_radius_px", "12", "12"),
        ("options.window_expansion_percent", "20", "20"),
        ("misc.double_start", "true", "true"),
        ("intensity.port", "2", "2"),
    ];
    for (key, value, _) in all {
        assert_ne!(shop.kerf(&format!("machine get {key}")).out().trim(), value, "{key}");
        shop.kerf(&format!("machine set {key} {value}")).exits(0);
    }
    // Every command is a program start.
    for (key, _, kept) in all {
        assert_eq!(shop.kerf(&format!("machine get {key}")).out().trim(), kept, "{key}");
    }
    let listed = shop.kerf("machine list options").out();
    let named = listed.lines().filter(|line| line.starts_with("options.")).count();
    assert_eq!(
        named, 14,
        "the speed of the console is always the same, the password has a test: {listed}"
    );
}

#[test]
fn pro_options_irq() {
    let shop =
        Shop::new(&[("old.toml", "[options]\nirq = [4, 3, 5, 7]\ndevices = [\"/dev/pts/7\"]\n")]);
    let did = shop.kerf("machine check old.toml");
    did.exits(0).says("note: old.toml:2:1: options.irq is ignored");
    // A port is a device.
    let list = shop.kerf("machine list options.console_port --config old.toml");
    list.exits(0).says("(/dev/pts/7)");
}

#[test]
fn pro_options_doublestart__on_both_pages() {
    let shop = Shop::new(&[]);
    let listed = |value: &str| {
        let list = shop.kerf("machine list double_start").out();
        assert_eq!(list.matches(&format!("misc.double_start = {value} ")).count(), 2, "{list}");
        assert!(
            list.contains("# Miscellaneous") && list.contains("# Options of the program"),
            "{list}"
        );
    };
    listed("false");
    shop.kerf("machine set misc.double_start true").exits(0);
    listed("true");
}

#[test]
fn pro_laser_use__hides_its_settings() {
    let shop = Shop::new(&[]);
    let laser = || {
        let list = shop.kerf("machine list laser").out();
        list.lines().filter(|line| line.starts_with("laser.")).count()
    };
    assert_eq!(laser(), 2, "use and type");
    shop.kerf("machine set laser.use true").exits(2).complains("laser.type");
    shop.kerf("machine set laser.type cw").exits(0);
    shop.kerf("machine set laser.use true").exits(0);
    assert!(laser() > 10);
}

#[test]
fn pro_plasma_arc_input__in_the_list() {
    let shop = Shop::new(&[]);
    let name = || {
        let list = shop.kerf("io list").out();
        let line = list.lines().find(|line| line.starts_with("input  A5")).unwrap();
        line.split_whitespace().nth(2).unwrap().to_owned()
    };
    assert_eq!(name(), "end_bottom_delay");
    shop.kerf("machine set plasma.use true").exits(0);
    assert_eq!(name(), "arc");
}
