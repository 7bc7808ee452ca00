//! Values that the machine remembers between commands, and the commands that show it.

use crate::shop::{Did, Shop};

/// Carries out lines as `kerf send` does.
fn send(shop: &Shop, lines: &[&str]) -> Did {
    let mut command = shop.command();
    Did::of(command.arg("send").arg("--quiet").args(lines).output().unwrap())
}

/// Output of a program that goes on from where the last one ended.
fn prints(shop: &Shop, what: &str) -> String {
    shop.write("print.sbp", format!("PRINT {what}\n").as_bytes());
    let out = shop.kerf("run print.sbp --quiet").exits(0).out();
    out.trim_end().to_owned()
}

#[test]
fn sbp_val_persist() {
    let shop = Shop::new(&[("a.sbp", "VC,.5\nVS,9\n")]);
    send(&shop, &["VC,.375"]).exits(0);
    send(&shop, &["VS,3"]).exits(0);
    assert_eq!(prints(&shop, "%(23);\" \";%(71)"), "0.375 3");
    shop.kerf("run a.sbp").exits(0);
    assert_eq!(prints(&shop, "%(23);\" \";%(71)"), "0.5 3", "what VS sets in a file ends with it");
}

#[test]
fn v_commands_and_machine_set_are_views_of_one_file() {
    let shop = Shop::new(&[("a.sbp", "VC,.5\nMX,1\n")]);
    std::fs::create_dir_all(shop.file("data")).unwrap();
    shop.write("data/machine.toml", b"# mine\n[cutter]\ndiameter_mm = 6.35 # a quarter\n");
    assert_eq!(prints(&shop, "%(23)"), "0.25");
    shop.kerf("run a.sbp --quiet").exits(0);
    assert_eq!(
        shop.read("data/machine.toml"),
        "# mine\n[cutter]\ndiameter_mm = 12.7 # a quarter\n"
    );
    shop.kerf("machine set cutter.diameter_mm 3.175").exits(0);
    assert_eq!(prints(&shop, "%(23)"), "0.125");
    shop.kerf("run a.sbp --quiet --units mm --ramps profiler").exits(0);
    let file = shop.read("data/machine.toml");
    assert_eq!(file, "# mine\n[cutter]\ndiameter_mm = 0.5 # a quarter\n", "no option is kept");
    shop.write("data/machine.toml", b"[cutter]\ndiameter = 1\n");
    shop.kerf("run a.sbp").exits(1).complains("machine.toml:2:1: there is no setting");
}

/// Every command is a process of its own. A tool path that was made with other values is told of and
/// changes nothing.
#[test]
fn pro_smoothing_saved__over_a_restart_and_another_drawing() {
    let shop = Shop::new(&[]);
    let machine =
        |words: &str| shop.kerf(&format!("machine {words}")).exits(0).out().trim().to_owned();
    let draw = |what: &str, file: &str| {
        let mut command = shop.command();
        Did::of(command.args(["draw", "--do", what, "-o", file]).output().unwrap()).exits(0);
    };
    draw("rect 10,10 30,30", "square.rsg");
    shop.kerf("toolpath square.rsg -o square.rsm").exits(0);
    machine("set smoothing.factor 0.8");
    machine("set smoothing.stop_angle_deg 2");
    draw("circle 20,20 5", "other.rsg");
    shop.kerf("toolpath other.rsg -o other.rsm").exits(0);
    shop.kerf("run other.rsm").exits(0);
    shop.kerf("run square.rsm").exits(0).complains("the factor was 0.6 and is 0.8 now");
    assert_eq!(machine("get smoothing.factor"), "0.8");
    assert_eq!(machine("get smoothing.stop_angle_deg"), "2");
}

#[test]
fn sbp_cmd_zt_persist() {
    let shop = Shop::new(&[]);
    send(&shop, &["ZT", "MX,5", "ZX"]).exits(0);
    assert_eq!(prints(&shop, "%(1);\" \";%(6)"), "0 5");
}

/// Starts a long motion that takes its time, kills the process in the middle, and tells what the next
/// command says.
fn killed_in_motion(shop: &Shop) {
    let mut command = shop.command();
    let mut child = command.args(["send", "--pace", "real", "SW,0", "MX,100"]).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(700));
    child.kill().unwrap();
    child.wait().unwrap();
}

#[test]
fn sbp_cmd_zt_persist__killed_in_motion() {
    let shop = Shop::new(&[]);
    send(&shop, &["ZT", "SetUsrVal, 7"]).exits(0);
    killed_in_motion(&shop);
    let did = send(&shop, &["UD"]);
    did.exits(0).complains("not verified").says("position not verified: X Y Z");
    let again = send(&shop, &["UD"]);
    again.complains("not verified: X Y Z").says("position not verified: X Y Z").says("uValue: 7");
    send(&shop, &["ZT"]).exits(0);
    assert!(!send(&shop, &["UD"]).out().contains("not verified"), "zeroed again");
}

/// Begins a command that takes as long as the machine does, and kills it on its way.
fn kill(shop: &Shop, args: &str) {
    let mut child = shop.command().args(args.split_whitespace()).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(1500));
    child.kill().unwrap();
    child.wait().unwrap();
}

/// Two long cuts on a metric machine with home switches, whose job goes on from where it was.
fn two_lines() -> Shop {
    let shop = Shop::new(&[]);
    shop.kerf("machine use sim").exits(0);
    let lines = ["draw", "--do", "line 0,0 100,0; line 100,50 0,50", "-o", "t.rsg"];
    Did::of(shop.command().args(lines).output().unwrap()).exits(0);
    shop.kerf("toolpath t.rsg -o t.rsm").exits(0);
    shop
}

#[test]
fn what_a_person_does_with_the_machine_after_a_kill_is_where_it_is() {
    let shop = two_lines();
    let mut whole = shop.command();
    let whole =
        Did::of(whole.args(["run", "t.rsm", "--trace", "-", "--start", "fresh"]).output().unwrap());
    let mut child = shop.command().args(["run", "t.rsm", "--pace", "real"]).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(5300));
    child.kill().unwrap();
    child.wait().unwrap();
    shop.kerf("machine pos").exits(0).complains("not verified").complains("t.rsm was cut short");
    shop.kerf("machine origin here").exits(1).complains("home it first");
    shop.kerf("machine home").exits(0);
    let pos = shop.kerf("machine pos");
    pos.exits(0).says("x  0.000 homed").says("z  0.000 homed");
    // It has no switch to be homed with.
    pos.complains("not verified: C\n");
    shop.kerf("machine move to 7,3").exits(0);
    shop.kerf("machine pos").exits(0).says("x  7.000 homed");
    shop.kerf("machine origin here").exits(0).says("[7, 3]");
    shop.kerf("machine origin 0,0").exits(0);
    // What is typed meanwhile asks the world, too, and is none of the run.
    send(&shop, &["UD", "PAUSE 0.1", "GetUsrVal, &v"]).exits(0);
    // It goes on from there, and cuts what it would have cut.
    let rest = shop.kerf("run --resume --trace -");
    rest.exits(0);
    let cuts = |did: &Did| -> Vec<String> {
        let moves = did.out();
        let cut = |e: &serde_json::Value| e["e"] == "move" && e["kind"] == "cut" && e["line"] == 2;
        let events = moves.lines().filter_map(|line| serde_json::from_str(line).ok());
        events.filter(cut).map(|e: serde_json::Value| e["to"].to_string()).collect()
    };
    assert!(!cuts(&rest).is_empty());
    assert_eq!(cuts(&rest), cuts(&whole));
    shop.kerf("machine pos").exits(0).says("x  0.000 homed");
}

/// Location of X at which the machine stands.
fn x(shop: &Shop) -> String {
    send(shop, &["&x=%(1)", "PRINT &x"]).exits(0).out()
}

#[test]
fn a_new_run_after_a_kill_in_motion_asks_where_the_machine_is() {
    let files =
        [("a.sbp", "MSGBOX(\"Cut?\", YesNo)\nMX,1\n"), ("n.nc", "G20 G0 X2\n"), ("yes", "Yes\n")];
    let shop = Shop::new(&files);
    shop.write("no", b"No\nContinue\n");
    shop.write("right", b"location=Continue\nYes\n");
    killed_in_motion(&shop);
    let stands = x(&shop);
    // Nobody answers, and an answer that was meant for the program says nothing of the machine.
    for args in ["run a.sbp", "run a.sbp --answers no", "run a.sbp --answers yes", "run n.nc"] {
        let run = shop.kerf(&format!("{args} --trace t"));
        run.exits(3).complains("not verified").complains("location=Continue");
        assert!(!shop.read("t").contains("\"e\":\"move\""), "{args} moved");
    }
    assert_eq!(x(&shop), stands);
    shop.kerf("run a.sbp --answers right").exits(0);
    assert_eq!(x(&shop), "1\n");
    let again = shop.kerf("run n.nc");
    assert!(!again.exits(0).err().contains("not verified"), "it was said: {}", again.err());
}

#[test]
fn a_zero_that_is_set_after_a_kill_says_where_the_machine_is() {
    let shop = Shop::new(&[("a.sbp", "MX,1\n")]);
    killed_in_motion(&shop);
    send(&shop, &["ZT"]).exits(0);
    shop.kerf("run a.sbp").exits(0);
    assert_eq!(x(&shop), "1\n");
}

#[test]
fn a_move_by_hand_that_was_killed_leaves_the_location_in_doubt() {
    let shop = two_lines();
    shop.kerf("machine home").exits(0);
    shop.kerf("machine pos").exits(0).says("x  0.000 homed");
    kill(&shop, "machine move --real to 500,500,-5");
    for _ in 0..2 {
        shop.kerf("machine pos").exits(0).says("x  0.000 not homed").complains("not verified");
    }
    let cuts = || shop.kerf("run t.rsm --trace -");
    cuts().exits(3).complains("not verified").complains("location=Continue");
    assert_eq!(cuts().all("move").len(), 0, "nothing moves before somebody says where it is");
    // What is told to be said is taken, also of axes that could be homed.
    shop.write("right", b"location=Continue\n");
    shop.kerf("run t.rsm --answers right").exits(0);
    kill(&shop, "machine move --real to 900,900,-5");
    shop.kerf("machine home").exits(0);
    let pos = shop.kerf("machine pos");
    pos.says("x  0.000 homed").complains("not verified: C\n");
}

#[test]
fn who_asks_while_a_run_is_under_way_is_told_that_it_is() {
    let shop = two_lines();
    let mut child = shop.command().args(["run", "t.rsm", "--pace", "real"]).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(3000));
    let pos = shop.kerf("machine pos");
    pos.exits(0).complains("another Kerf runs the machine");
    assert!(!pos.err().contains("cut short") && !pos.err().contains("ended"), "{}", pos.err());
    shop.kerf("machine origin here").exits(1).complains("another Kerf runs the machine");
    child.kill().unwrap();
    child.wait().unwrap();
}

#[test]
fn sbp_cmd_sa_sr_default() {
    let shop = Shop::new(&[("a.sbp", "PRINT %(21)")]);
    assert_eq!(prints(&shop, "%(21)"), "0");
    send(&shop, &["SR"]).exits(0);
    assert_eq!(prints(&shop, "%(21)"), "1");
}

#[test]
fn what_only_looks_starts_from_zeros_unless_told() {
    let shop = Shop::new(&[("a.sbp", "MX,2"), ("mm.toml", "units = \"mm\"")]);
    send(&shop, &["VD,,,1", "MX,50", "SR"]).exits(0);
    let fresh = shop.kerf("trace a.sbp");
    assert_eq!(
        (&fresh.events()[0]["units"], fresh.all("move")[0]["to"]["x"].as_f64()),
        (&"in".into(), Some(2.0))
    );
    let kept = shop.kerf("trace a.sbp --start kept");
    assert_eq!(
        (&kept.events()[0]["units"], kept.all("move")[0]["to"]["x"].as_f64()),
        (&"mm".into(), Some(52.0))
    );
    shop.kerf("run a.sbp --start fresh").exits(0).says("cut 2 in");
    assert_eq!(prints(&shop, "%(1)"), "50", "a fresh start leaves nothing");
}

#[test]
fn options_hold_for_one_run_only() {
    let shop =
        Shop::new(&[("a.sbp", "MX,25.4"), ("c.toml", "units = \"mm\"\n[speeds.cut]\nxy = 10.0")]);
    shop.kerf("run a.sbp --config c.toml").exits(0).says("cut 25.4 mm");
    assert_eq!(prints(&shop, "%(1);\" \";%(71)"), "1 2");
    shop.kerf("run a.sbp --units mm").exits(0);
    assert_eq!(prints(&shop, "%(25)"), "0");
}

#[test]
fn sbp_cmd_si() {
    let shop = Shop::new(&[]);
    send(&shop, &["MX,1", "MY,2"]).exits(0);
    assert_eq!(prints(&shop, "%(1);\" \";%(2)"), "1 2");
    let jump = send(&shop, &["&n=0", "AGAIN:", "&n=&n+1", "IF &n<3 THEN GOTO AGAIN", "PRINT &n"]);
    jump.exits(0).says("3");
    send(&shop, &["GOTO A"]).exits(1).complains("only in part files");
    send(&shop, &["UV"]).exits(0).says("VS,2,1");
}

#[test]
fn sbp_cmd_si_tempfile() {
    let shop = Shop::new(&[("parts/a.sbp", "")]);
    send(&shop, &["MX,1", "MY, 2 'here"]).exits(0);
    assert_eq!(shop.read("temp_code.sbp"), "MX,1\nMY, 2 'here\n");
    send(&shop, &["--parts", "parts", "MZ,3"]).exits(0);
    assert_eq!(shop.read("parts/temp_code.sbp"), "MZ,3\n");
}

#[test]
fn sbp_sys_list__as_the_machine_was_left() {
    let shop = Shop::new(&[]);
    send(&shop, &["MX,1.5", "VC,.375"]).exits(0);
    shop.kerf("sysvars")
        .exits(0)
        .says("\n 23         0.375  user units")
        .says("  1           1.5  ");
    shop.kerf("sysvars --start fresh").exits(0).says("\n 23          0.25  user units");
    assert_eq!(shop.names(), ["temp_code.sbp"], "looking changes nothing");
}

#[test]
fn sbp_file_samples() {
    let shop = Shop::new(&[("parts/S_box.sbp", "'mine\n")]);
    shop.kerf("samples parts").exits(0).says("is there already");
    assert_eq!(shop.read("parts/S_box.sbp"), "'mine\n");
    shop.kerf("samples new").exits(0);
    let names: Vec<_> = std::fs::read_dir(shop.file("new")).unwrap().collect();
    assert!(names.len() >= 5, "{names:?}");
    for name in names {
        let name = name.unwrap().file_name().into_string().unwrap();
        assert!(name.starts_with("S_") && name.ends_with(".sbp"), "{name}");
        // A sample that asks is looked at with 0 for an answer, which is a note.
        let checked = shop.kerf(&format!("check new/{name}"));
        checked.exits(0);
        let clean = checked.out().contains("nothing wrong") || checked.out().contains("\n1 note\n");
        assert!(clean, "{}", checked.out());
        let run = shop.kerf(&format!("run new/{name} --start fresh"));
        run.exits(0).says("ran to its end");
        assert!(!run.out().contains("cut 0 in"), "{name} cuts: {}", run.out());
    }
}

#[test]
fn sbp_io_play_missing__how_long_a_sound_is() {
    let shop = Shop::new(&[("no.wav", "RIFF")]);
    let mut wav =
        b"RIFF\0\0\0\0WAVEfmt \x10\0\0\0\x01\0\x01\0\x40\x1f\0\0\x40\x1f\0\0\x01\0\x08\0data"
            .to_vec();
    wav.extend(12_000_u32.to_le_bytes());
    wav.resize(wav.len() + 12_000, 128);
    shop.write("f.wav", &wav);
    assert_eq!(shop.kerf("wavlength f.wav").exits(0).out(), "1.5\n");
    shop.kerf("wavlength no.wav").exits(1).complains("no .wav file");
    shop.kerf("wavlength missing.wav").exits(2).complains("cannot read");
}

#[test]
fn without_a_named_data_folder_the_same_run_twice_is_the_same() {
    let shop = Shop::new(&[("a.sbp", "SR\nMX,1\nPRINT %(1)")]);
    let once = || {
        let mut kerf = std::process::Command::new(env!("CARGO_BIN_EXE_kerf"));
        kerf.args(["run", "a.sbp"]).current_dir(shop.path()).env_remove("KERF_DATA");
        let told = kerf.env("HOME", shop.path()).env_remove("XDG_DATA_HOME").output().unwrap();
        String::from_utf8(told.stdout).unwrap()
    };
    let first = once();
    assert!(first.starts_with("1\n"), "{first}");
    assert_eq!(once(), first);
}

#[test]
fn offsets_and_parameters_of_g_code_are_kept() {
    let shop = Shop::new(&[
        ("a.nc", "G20 G10 L2 P2 X2 Y1\n#500=4\n"),
        ("b.nc", "G20 G55 G0 X0 Y0\n(PRINT,at #500)\n"),
    ]);
    shop.kerf("run a.nc --quiet").exits(0);
    shop.kerf("run b.nc --quiet").exits(0).says("at 4");
    assert_eq!(prints(&shop, "%(6);\" \";%(7)"), "2 1");
    // What only looks begins afresh and leaves nothing.
    let fresh = shop.kerf("trace b.nc");
    assert!(fresh.all("print")[0]["text"].to_string().contains("at 0"), "{}", fresh.out());
    shop.kerf("run b.nc --quiet").exits(0).says("at 4");
}

#[test]
fn sbp_cmd_si_gcode() {
    let shop = Shop::new(&[]);
    send(&shop, &["G1 X1 F60", "MY,2"]).exits(0);
    assert_eq!(prints(&shop, "%(1);\" \";%(2)"), "1 2");
    // Modes last from line to line.
    send(&shop, &["G91 G1 X1 F60"]).exits(0);
    send(&shop, &["X1"]).exits(0);
    assert_eq!(prints(&shop, "%(1);\" \";%(2)"), "3 2");
}

#[test]
fn sbp_cmd_si_replay() {
    let shop = Shop::new(&[]);
    shop.kerf("send --again").exits(1).complains("nothing was sent before");
    send(&shop, &["SR", "MX,1"]).exits(0);
    shop.kerf("send --again --quiet").exits(0);
    shop.kerf("send --again --quiet").exits(0);
    assert_eq!(prints(&shop, "%(1)"), "3");
    assert_eq!(shop.read("temp_code.sbp"), "SR\nMX,1\n", "they can be read and edited");
}

#[test]
fn sbp_cmd_rr__in_a_later_session() {
    let shop = Shop::new(&[("a.sbp", "MX,50\n")]);
    send(&shop, &["SR", "RZ"]).exits(0);
    send(&shop, &["MX,1"]).exits(0);
    shop.kerf("run a.sbp --quiet").exits(0);
    send(&shop, &["MX,-50", "MY,2"]).exits(0);
    send(&shop, &["RI"]).exits(0);
    send(&shop, &["RR,1,3"]).exits(0);
    assert_eq!(prints(&shop, "%(1);\" \";%(2)"), "1 8");
    shop.kerf("registry get Recorded").exits(0).says("MX,1\nMX,-50\nMY,2\n");
    send(&shop, &["RS,rows"]).exits(0).says("? rows.sbp");
    assert_eq!(shop.read("rows.sbp"), "MX,1\nMX,-50\nMY,2\n");
}

#[test]
fn sbp_out_off_exit() {
    let shop = Shop::new(&[("on.sbp", "SO,3,1\nMX,1\n")]);
    let on = send(&shop, &["VN,,,,,,,,,,,,,,,,,1", "SO,3,1", "UD"]);
    on.exits(0).says("outputs on: 3");
    send(&shop, &["UD"]).exits(0).says("outputs on: none");
    assert_eq!(shop.kerf("registry get OutPutSwitches").out(), "0\n");
}

/// A fresh machine is another one: what happens to it says nothing of the one of the data folder.
#[test]
fn what_is_in_doubt_of_a_fresh_machine_stays_with_it() {
    let shop = Shop::new(&[("a.sbp", "MX,5\n"), ("yes", "location=Continue\n")]);
    send(&shop, &["MX,1"]).exits(0);
    for event in ["stall@1=1", "cable@1=0"] {
        shop.kerf(&format!("run a.sbp --start fresh --input {event}"));
        shop.kerf("run a.sbp --start fresh").exits(0);
        let kept = shop.kerf("run a.sbp").exits(0).err();
        assert!(!kept.contains("not verified"), "{event}: {kept}");
        send(&shop, &["MX,1"]).exits(0);
    }
    shop.kerf("run a.sbp --input stall@1=1").exits(1);
    send(&shop, &["MX,1"]).exits(0).complains("not verified");
    shop.kerf("run a.sbp --start fresh").exits(0);
    shop.kerf("run a.sbp").exits(3).complains("not verified");
    shop.kerf("run a.sbp --answers yes").exits(0);
}

/// Whatever is not heeded is refused, and the run can still be taken up.
#[test]
fn options_of_another_run_are_refused_where_one_is_taken_up() {
    let shop = Shop::new(&[("a.sbp", "MX,5\nMX,9\n")]);
    shop.kerf("run a.sbp --hold-at 3").exits(3);
    for (option, names) in [
        ("--input 3@1=1", "--input is not heeded when a run is taken up"),
        ("--units mm --set N=2", "--units, --set are not heeded"),
        ("--from-line 2", "--from-line is"),
        ("--config sim", "--config is"),
        ("--offset-job 2", "--offset-job is"),
        ("--script s", "--script is"),
    ] {
        shop.kerf(&format!("run --resume {option}")).exits(2).complains(names);
    }
    let heeded = "--trace t --picture p.svg --vcd v --readings r --pace fast --start kept --quiet";
    shop.kerf(&format!("run --resume {heeded} --override 50@4")).exits(0);
    assert_eq!(prints(&shop, "%(1)"), "9");
}
