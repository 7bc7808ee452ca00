//! The subcommands as a person or a script uses them.

use crate::shop::Shop;

const BOX: &str = "JZ,.5\nJ2,1,1\nMZ,-.1\nMX,4\nMY,3\nMX,1\nMY,1\nJZ,.5\n";

#[test]
fn run_tells_what_it_came_to() {
    let shop = Shop::new(&[("box.sbp", BOX)]);
    let did = shop.kerf("run box.sbp");
    did.exits(0).says("ran to its end").says("8 lines, 8 moves, 0 arcs");
    did.says("cutting X 1 … 4, Y 1 … 3, Z -0.1 … 0.5 in");
    assert_eq!(shop.kerf("run box.sbp --quiet").exits(0).out(), "");
}

#[test]
fn run_prints_what_the_program_prints() {
    let shop =
        Shop::new(&[("a.sbp", "PRINT \"Hello\"\n'Wait for it\nPAUSE 2\nMSGBOX(Go?,YesNo,x)\n")]);
    let did = shop.kerf("run a.sbp");
    did.exits(0).says("Hello\n").says("· Wait for it (2.0 s)\n").says("? Go? → Yes (default)\n");
}

#[test]
fn exit_codes_tell_how_it_ended() {
    let shop = Shop::new(&[
        ("ok.sbp", "MX,1"),
        ("ended.sbp", "MX,1\nENDALL"),
        ("failed.sbp", "MX,1/0"),
        ("cancel.sbp", "PAUSE"),
        ("cancel.txt", "Cancel"),
        ("limit.sbp", "VL,0,10\nSF,1\nMX,12"),
    ]);
    for command in ["run --start fresh", "trace", "time", "preview -o x.svg"] {
        for (args, code) in [
            ("ok.sbp", 0),
            ("ended.sbp", 0),
            ("failed.sbp", 1),
            ("cancel.sbp --answers cancel.txt", 3),
            ("limit.sbp", 3),
            ("ok.sbp --stop-at .1", 3),
        ] {
            shop.kerf(&format!("{command} {args}")).exits(code);
        }
    }
}

#[test]
fn a_file_with_errors_does_not_start() {
    let shop = Shop::new(&[("a.sbp", "MX,1\nM23,1\nMY,1\nQQ,3\n")]);
    let did = shop.kerf("run a.sbp");
    did.exits(1).complains("a.sbp:2:1").complains("a.sbp:4:1").says("0 moves");
    let anyway = shop.kerf("trace a.sbp --allow-errors");
    anyway.exits(1);
    assert_eq!(anyway.all("move").len(), 0, "the stack with the error does not move");
    let later = Shop::new(&[("a.sbp", "MX,1\nPAUSE 1\nMY,1\nQQ,3\n")]);
    let anyway = later.kerf("trace a.sbp --allow-errors");
    assert_eq!(anyway.exits(1).all("move").len(), 1, "{}", anyway.out());
}

#[test]
fn what_a_preview_writes_stays_away_from_the_disk() {
    let program = "OPEN \"a.txt\" FOR OUTPUT AS #1\nWRITE #1; \"x\"\nCLOSE #1\n\
        OPEN \"a.txt\" FOR INPUT AS #1\nINPUT #1, &v\nCLOSE #1\nPRINT &v\nSetUsrVal, kept\n";
    let shop = Shop::new(&[("a.sbp", program)]);
    for command in ["trace a.sbp", "time a.sbp", "check a.sbp", "preview a.sbp -o data/a.svg"] {
        std::fs::create_dir_all(shop.file("data")).unwrap();
        shop.kerf(command).exits(0);
        assert_eq!(shop.names(), ["a.sbp"], "{command}");
        assert!(!shop.file("data/journal.db").exists(), "{command}");
    }
    let print = shop.kerf("trace a.sbp").all("print");
    assert_eq!(print[0]["text"], "x");
    shop.kerf("run a.sbp").exits(0);
    assert_eq!(shop.names(), ["a.sbp", "a.txt"]);
    assert_eq!(shop.read("a.txt"), "x\n");
    shop.write("b.sbp", b"GetUsrVal, &v\nPRINT &v\n");
    shop.kerf("run b.sbp").exits(0).says("kept\n");
}

#[test]
fn files_outside_the_part_folder_need_permission() {
    let shop = Shop::new(&[
        ("parts/a.sbp", "FP,../other/b.sbp\n"),
        ("parts/c.sbp", "FP,C:\\Jobs\\b.sbp\n"),
        ("other/b.sbp", "MX,7\n"),
        ("drive/jobs/B.SBP", "MX,8\n"),
    ]);
    shop.kerf("run parts/a.sbp").exits(1).complains("outside the folders that may be used");
    shop.kerf("run parts/c.sbp").exits(1).complains("outside the folders that may be used");
    let did = shop.kerf("trace parts/a.sbp --allow-path other");
    assert_eq!(did.exits(0).end()["bounds"]["max"]["x"], 7);
    let did = shop.kerf("trace parts/c.sbp --allow-path drive");
    assert_eq!(did.exits(0).end()["bounds"]["max"]["x"], 8);
}

#[test]
fn an_allowed_folder_that_is_not_there_is_refused_and_not_made() {
    let shop = Shop::new(&[("a.sbp", "OPEN \"C:\\new.txt\" FOR OUTPUT AS #1\n")]);
    for name in ["nowhere", "a.sbp"] {
        let did = shop.kerf(&format!("run a.sbp --allow-path {name}"));
        did.exits(2).complains(&format!("{name} is no folder: --allow-path names one"));
    }
    assert!(!shop.file("nowhere").exists());
}

#[cfg(unix)]
#[test]
fn a_link_does_not_lead_out_of_the_part_folder() {
    let shop = Shop::new(&[("parts/a.sbp", "FP,link/b.sbp\n"), ("other/b.sbp", "MX,7\n")]);
    std::os::unix::fs::symlink(shop.file("other"), shop.file("parts/link")).unwrap();
    shop.kerf("run parts/a.sbp").exits(1).complains("outside the folders that may be used");
}

#[test]
fn external_programs_need_permission_and_never_start_in_a_preview() {
    let shop = Shop::new(&[("a.sbp", "SHELL, \"echo hi > out.txt\",1,SYNC\n")]);
    shop.kerf("run a.sbp").exits(1).complains("--allow-shell");
    shop.kerf("trace a.sbp").exits(1);
    shop.kerf("trace a.sbp --allow-shell").exits(0);
    assert_eq!(shop.names(), ["a.sbp"]);
    shop.kerf("run a.sbp --allow-shell").exits(0);
    assert_eq!(shop.read("out.txt").trim(), "hi");
}

#[test]
fn own_custom_cuts_win_over_those_that_come_along() {
    let shop = Shop::new(&[("a.sbp", "C6\n"), ("data/custom/custom6.sbc", "MX,3\n")]);
    assert_eq!(shop.kerf("trace a.sbp").exits(0).end()["bounds"]["max"]["x"], 3);
    let shop = Shop::new(&[("a.sbp", "C6\nC7\n"), ("mine/Custom7.sbc", "MX,4\n")]);
    let did = shop.kerf("trace a.sbp --custom mine");
    let outputs = did.all("output");
    assert!(outputs.iter().any(|o| o["n"] == 1 && o["on"] == true), "{}", did.out());
    assert_eq!(did.exits(0).end()["bounds"]["max"]["x"], 4);
}

#[test]
fn options_reach_the_program() {
    let shop = Shop::new(&[
        ("a.sbp", "MX,&n\nPRINT %(25); &name\n"),
        ("b.sbp", "M2,1,1\n"),
        ("mm.toml", "units = \"mm\"\n[speeds.cut]\nxy = 10.0\n"),
    ]);
    let did = shop.kerf("trace a.sbp --set n=3 --set &name=x --units mm --vars");
    assert_eq!(
        (did.exits(0).end()["bounds"]["max"]["x"].as_f64(), did.end()["vars"]["N"].as_f64()),
        (Some(3.0), Some(3.0))
    );
    assert_eq!(
        (&did.all("print")[0]["text"], &did.events()[0]["units"]),
        (&"1x".into(), &"mm".into())
    );
    let end = |args: &str| shop.kerf(&format!("trace {args}")).end()["bounds"]["max"].clone();
    assert_eq!(end("b.sbp --proportion 2,3,1")["y"], 3);
    assert_eq!(end("b.sbp --config mm.toml")["x"], 1);
    let speed = |args: &str| shop.kerf(&format!("trace {args}")).all("move")[0]["speed"].clone();
    assert_eq!((speed("b.sbp --config mm.toml"), speed("b.sbp")), (10.into(), 2.into()));
}

#[test]
fn time_adds_up() {
    let program = "'New Path\n'Toolpath Name = Pocket\n'Tool Name = Mill\nMX,4\nPAUSE 3\n&Tool=2\nC9\n\
        'New Path\n'Toolpath Name = Outline\nJX,0\n";
    let shop = Shop::new(&[("a.sbp", program)]);
    let times = shop.kerf("time a.sbp --format json --set my_tool_change_time=7").exits(0).json();
    let sum: f64 =
        ["cut", "jog", "wait", "tool_change"].map(|k| times[k].as_f64().unwrap()).iter().sum();
    assert!((times["total"].as_f64().unwrap() - sum).abs() < 1e-6, "{times}");
    assert_eq!(times["wait"], 3);
    assert!((times["tool_change"].as_f64().unwrap() - 7.0) < 1.0, "{times}");
    let paths = times["toolpaths"].as_array().unwrap();
    assert_eq!(
        (paths.len(), &paths[0]["name"], &paths[0]["tool"]),
        (2, &"Pocket".into(), &"Mill".into())
    );
    assert_eq!(paths[1]["seconds"], times["jog"]);
    shop.kerf("time a.sbp").exits(0).says("cutting").says("Pocket  (Mill)");
}

#[test]
fn sbp_motion_time_est() {
    let shop = Shop::new(&[("a.sbp", "VS,2\nMX,4\n")]);
    let total = shop.kerf("time a.sbp --format json").json()["total"].as_f64().unwrap();
    assert!((total - 2.0914).abs() < 1e-4, "{total}");
    if cfg!(unix) {
        let start = std::time::Instant::now();
        shop.kerf("run a.sbp --pace real --quiet").exits(0);
        let took = start.elapsed().as_secs_f64();
        assert!((2.09..4.0).contains(&took), "{took}");
    }
}

#[test]
fn sbp_file_check() {
    let shop = Shop::new(&[
        ("good.sbp", "JZ,.5\nFP,inner.sbp\nMX,9\n"),
        ("inner.sbp", "MX,1/&n\n"),
        ("labels.sbp", "GOTO NOWHERE\n"),
        ("limits.sbp", "VL,0,10\nSF,1\nMX,5\nMX,12\n"),
    ]);
    shop.kerf("check good.sbp --set n=2").exits(0).says("good.sbp: ").says("cutting X 0 … 9");
    shop.kerf("check good.sbp").exits(1).says("inner.sbp:1:").says("called from good.sbp line 2");
    shop.kerf("check labels.sbp").exits(1).says("NOWHERE");
    shop.kerf("check limits.sbp").exits(1).says("limits.sbp:4:1").says("table limit is 10");
    let found = shop.kerf("check labels.sbp limits.sbp --format json").exits(1).json();
    let files: Vec<_> = found.as_array().unwrap().iter().map(|d| d["file"].clone()).collect();
    assert!(files.contains(&"labels.sbp".into()) && files.contains(&"limits.sbp".into()));
    for field in ["severity", "code", "file", "line", "column", "message", "hint"] {
        assert!(!found[0][field].is_null(), "{field}: {found}");
    }
}

#[test]
fn fmt_changes_files_or_only_tells() {
    let shop = Shop::new(&[("a.sbp", "mx, 1\r\n"), ("b.sbp", "MX,1\n")]);
    assert_eq!(shop.kerf("fmt --check a.sbp b.sbp").exits(1).out(), "a.sbp\n");
    assert_eq!(shop.read("a.sbp"), "mx, 1\r\n");
    shop.kerf("fmt a.sbp b.sbp").exits(0);
    assert_eq!(shop.read("a.sbp"), "MX,1\r\n");
    shop.kerf("fmt --check a.sbp b.sbp").exits(0);
    assert_eq!(shop.kerf_with("fmt -", b"mx,1 'caf\xc3\xa9\n").exits(0).out(), "MX,1 'café\n");
    shop.write("old.sbp", b"mx,1 'caf\xe9\n");
    shop.kerf("fmt old.sbp").exits(0);
    assert_eq!(std::fs::read(shop.file("old.sbp")).unwrap(), b"MX,1 'caf\xe9\n");
}

#[test]
fn explain_knows_every_code() {
    let shop = Shop::new(&[]);
    shop.kerf("explain s002").exits(0).says("S002: unknown command");
    shop.kerf("explain").exits(0).says("S002  unknown command").says("M001");
    shop.kerf("explain S999").exits(1).complains("no code S999");
}

#[test]
fn sbp_io_input_headless() {
    let program = "INPUT \"Depth?\" &d\nMSGBOX(Go?,YesNo,x)\nPAUSE\nPRINT &d; &msganswer\n";
    let shop = Shop::new(&[
        ("a.sbp", program),
        ("order.txt", "-.25\nNo\nOK\n"),
        ("lines.txt", "2:No\n1:-.5\n"),
        ("kinds.txt", "pause=Cancel\n-.75\n"),
        ("wrong.txt", "1\nMaybe\n"),
    ]);
    let printed = |answers: &str| {
        shop.kerf(&format!("trace a.sbp --answers {answers}")).all("print")[0]["text"].clone()
    };
    assert_eq!(printed("order.txt"), "-0.25No");
    assert_eq!(printed("lines.txt"), "-0.5No");
    let asked = shop.kerf("trace a.sbp --answers lines.txt").all("ask");
    assert_eq!((&asked[1]["scripted"], &asked[2]["scripted"]), (&true.into(), &false.into()));
    shop.kerf("trace a.sbp --answers kinds.txt").exits(3);
    let did = shop.kerf("run a.sbp --answers wrong.txt");
    did.exits(1).complains("'Maybe' is no button of this box (Yes, No)").complains("a.sbp:2:");
}

#[test]
fn sbp_io_open_absolute() {
    let shop = Shop::new(&[]);
    let root = shop.file("allowed");
    std::fs::create_dir_all(root.join("myfolder")).unwrap();
    let posix = format!("OPEN \"{}/myfolder/a.txt\" FOR OUTPUT AS #1\n", root.display());
    shop.write("parts/posix.sbp", posix.as_bytes());
    shop.write("parts/drive.sbp", b"OPEN \"C:\\myfolder\\b.txt\" FOR OUTPUT AS #1\n");
    for name in ["posix", "drive"] {
        let refused = shop.kerf(&format!("run parts/{name}.sbp"));
        refused.exits(1).complains("outside the folders that may be used");
        shop.kerf(&format!("run parts/{name}.sbp --allow-path allowed")).exits(0);
    }
    assert!(root.join("myfolder/a.txt").exists() && root.join("myfolder/b.txt").exists());
}

#[test]
fn sbp_lang_ext() {
    let shop = Shop::new(&[("demo.sbp", "MX,1"), ("mine.sbd", "VS,2,1\nPRINT %(71), %(73)\n")]);
    shop.kerf("run demo.sbp").exits(0);
    shop.kerf("run mine.sbd").exits(0).says("2     1\n");
}

#[test]
fn sbp_sys_048() {
    let shop = Shop::new(&[("a.sbp", "PRINT %(48)")]);
    let version = shop.kerf("--version").out();
    assert_eq!(shop.kerf("run a.sbp --quiet").out(), version);
}

#[test]
fn sbp_sys_049() {
    let shop = Shop::new(&[("a.sbp", "PRINT %(49)")]);
    assert_eq!(shop.kerf("run a.sbp --quiet").out(), "0\n");
}

#[cfg(unix)]
#[test]
fn ctrl_c_stops_with_a_ramp_and_lifts() {
    let shop = Shop::new(&[("a.sbp", "MX,100\n")]);
    let child = shop
        .command()
        .args(["run", "a.sbp", "--pace", "real"])
        .stdout(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(std::time::Duration::from_millis(700));
    let pid = child.id().to_string();
    std::process::Command::new("kill").args(["-INT", &pid]).status().unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(3));
    let out = String::from_utf8(output.stdout).unwrap();
    assert!(
        out.contains("STOPPED") && out.contains("2 moves") && out.contains("jogged 1 in"),
        "{out}"
    );
}

#[test]
fn the_optimal_ramps_follow_their_limits() {
    let shop = Shop::new(&[("a.sbp", "VS,4\nMX,4\nMY,4\n")]);
    let total = |options: &str| {
        let did = shop.kerf(&format!("time a.sbp --format json {options}"));
        did.exits(0).json()["total"].as_f64().unwrap()
    };
    let slow = total("--ramps optimal --axis-speed 50,50,50 --accel 100,100,100");
    let fast = total("--ramps optimal --axis-speed 50,50,50 --accel 1000,1000,1000");
    let loose = total("--ramps optimal --axis-speed 50,50,50 --accel 100,100,100 --tolerance 5");
    // 4 in at 50 mm/s, one ramp up and one down at 100 mm/s², twice: at least 2·(101.6/50 + .5) s.
    assert!((slow - 2.0 * (101.6 / 50.0 + 0.5)).abs() < 0.1, "{slow}");
    assert!(fast < slow && loose < slow, "{fast} {loose} {slow}");
    // Who tells what the axes can do wants it done.
    assert_eq!(total("--axis-speed 50,50,50 --accel 100,100,100"), slow);
    assert_eq!(total("--axis-speed 50,50,50 --accel 100,100,100 --tolerance 5"), loose);
    let other = shop.kerf("time a.sbp --ramps shopbot --accel 1,1,1");
    other
        .exits(2)
        .complains("--accel belongs to --ramps optimal or profiler, not to --ramps shopbot");
    let elsewhere = shop.kerf("time a.sbp --controller grbl --tolerance 1");
    elsewhere.exits(2).complains("--tolerance is Kerf's own; it does not belong to --controller");
    shop.kerf("time a.sbp --ramps fast").exits(2).complains("give shopbot, profiler or optimal");
    shop.kerf("time a.sbp --ramps profiler --jerk 1").exits(2).complains("--jerk belongs to");
    shop.kerf("time a.sbp --ramps profiler --stop-angle 181").exits(2).complains("from 0 to 180");
}

#[test]
fn the_registry_keeps_what_programs_and_people_set() {
    let shop =
        Shop::new(&[("a.sbp", "SetUsrVal, hello\n"), ("b.sbp", "GetUsrVal, &v\nPRINT &v\n")]);
    shop.kerf("registry get uValue").exits(1).complains("uValue has no value");
    shop.kerf("run a.sbp").exits(0);
    assert_eq!(shop.kerf("registry get ShopBot/UserData/uValue").exits(0).out(), "hello\n");
    shop.kerf("registry set uValue 7").exits(0);
    shop.kerf("run b.sbp").exits(0).says("7\n");
    shop.kerf("registry get").exits(0).says("uValue=7\n");
    shop.kerf("registry set uValue").exits(0);
    shop.kerf("registry get uValue").exits(1);
    assert_eq!(shop.kerf("registry get Status").exits(0).out(), "0\n");
}

#[test]
fn sbp_sys_list() {
    let shop = Shop::new(&[]);
    let list = shop.kerf("sysvars").exits(0).out();
    let row = |list: &str, number: &str| -> Vec<String> {
        let row = list.lines().find(|l| l.split_whitespace().next() == Some(number)).unwrap();
        row.split_whitespace().map(str::to_owned).collect()
    };
    assert_eq!(row(&list, "23")[1], "0.25");
    assert_eq!((row(&list, "25")[1].as_str(), row(&list, "71")[1].as_str()), ("0", "2"));
    let metric = shop.kerf("sysvars --units mm").exits(0).out();
    assert_eq!((row(&metric, "25")[1].as_str(), row(&metric, "71")[1].as_str()), ("1", "50.8"));
    let numbers = kerf_sbp::system_variables().count();
    assert_eq!(list.lines().count(), numbers);
}

#[test]
fn sbp_lang_size() {
    use std::fmt::Write;
    let shop = Shop::new(&[("one.sbp", "MX,1")]);
    assert_eq!(shop.kerf("trace one.sbp").exits(0).end()["bounds"]["max"]["x"], 1);
    let mut text = String::new();
    for k in 1..1_000_000 {
        writeln!(text, "M3,{},{},-.{}", k % 90, k / 20_000, k % 7).unwrap();
    }
    text.push_str("M3,99,0,0\n");
    shop.write("million.sbp", text.as_bytes());
    let did = shop.kerf("run million.sbp");
    did.exits(0).says("1000000 lines, 1000000 moves").says("X 0 … 99");
}

#[test]
fn convert_there_and_back_moves_the_same() {
    let shop = Shop::new(&[("box.sbp", BOX)]);
    shop.kerf("convert box.sbp box.nc").exits(0).says("box.nc: ");
    let text = shop.read("box.nc");
    assert!(text.starts_with("(Converted from box.sbp by kerf "), "{text}");
    assert!(text.contains("G0 Z0.5\nX1 Y1\nG1 Z-0.1 F60\nX4 F120\n"), "{text}");
    shop.kerf("convert box.nc back.sbp").exits(0);
    let ends = |file: &str| {
        let did = shop.kerf(&format!("trace {file}"));
        did.all("move").iter().map(|e| e["to"].clone()).collect::<Vec<_>>()
    };
    assert_eq!(ends("box.sbp"), ends("back.sbp"));
}

#[test]
fn convert_writes_over_nothing_unless_told() {
    let shop = Shop::new(&[("box.sbp", BOX), ("box.nc", "mine")]);
    shop.kerf("convert box.sbp box.nc").exits(2).complains("--force");
    assert_eq!(shop.read("box.nc"), "mine");
    shop.kerf("convert box.sbp box.nc --force --to grbl").exits(0);
    assert!(shop.read("box.nc").contains("for grbl"));
    shop.kerf("convert box.sbp box.dxf").exits(2).complains("to each other");
    shop.kerf("convert none.sbp x.nc").exits(2);
}

#[test]
fn convert_tells_what_the_other_language_cannot_say() {
    let shop = Shop::new(&[
        ("a.sbp", "J2,0,0\nSO,5,1\nMX,1\n"),
        ("turn.sbp", "VD,,4,,2\nJ2,0,0\nMA,90\n"),
        ("bad.sbp", "MX,1\nQQ,3\n"),
    ]);
    let did = shop.kerf("convert a.sbp a.nc --to grbl");
    did.exits(0).complains("warning[C001]").complains("a.sbp:2").complains("output 5 on");
    assert!(shop.read("a.nc").contains("(not in G-code: output 5 on)\n"));
    shop.kerf("convert turn.sbp turn.nc --to grbl").exits(1).complains("A to 90");
    shop.kerf("convert bad.sbp bad.nc").exits(1).complains("bad.sbp:2");
    assert!(!shop.file("turn.nc").exists() && !shop.file("bad.nc").exists());
}
