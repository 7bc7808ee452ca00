//! Rows that need a disk, several files or exit codes.

use crate::shop::Shop;

#[test]
fn sbp_io_open_absolute() {
    let shop = Shop::new(&[("parts/x.txt", ""), ("other/y.txt", ""), ("other/myfolder/z.txt", "")]);
    let open = |path: &str| {
        let program = format!("OPEN \"{path}\" FOR OUTPUT AS #1\nWRITE #1; \"A\"\nCLOSE #1\n");
        shop.write("parts/a.sbp", program.as_bytes());
    };
    let posix = shop.file("other/out.txt").display().to_string();
    open(&posix);
    shop.kerf("run parts/a.sbp").exits(1).complains("outside the folders that may be used");
    shop.kerf("run parts/a.sbp --allow-path other").exits(0);
    assert_eq!(shop.read("other/out.txt"), "A\n");
    open("C:\\myfolder\\myfile.sbp");
    shop.kerf("run parts/a.sbp").exits(1).complains("--allow-path");
    shop.kerf("run parts/a.sbp --allow-path other").exits(0);
    assert_eq!(shop.read("other/myfolder/myfile.sbp"), "A\n");
}

#[test]
fn sbp_ctl_run() {
    let probe = "ON INPUT(1,1) GOTO HIT\nMZ,-3\nPRINT \"nothing\"\nEND\nHIT:\nPRINT %(3)\n";
    let shop = Shop::new(&[
        ("probe.sbp", probe),
        ("plate.txt", "# a plate\nunits in\ninput 1 on in box *,*,-5 *,*,-.6\n"),
        ("ball.txt", "units in\ninput 1 on in sphere 0,0,-2 .5\n"),
        ("post.txt", "input 1 on in cylinder 0,0 10 -50 -25.4\n"),
        ("late.txt", "input 1 on at 1\n"),
        ("bad.txt", "input 1 on\n\ninput 77 off at 2\n"),
        ("wait.sbp", "M2,4,0\nPRINT %(51)\nM2,8,0\nPRINT %(51)\nM2,1,0\nPRINT %(51)\n"),
        ("far.txt", "units in\ninput 1 on in box 5,*,* *,*,*\n"),
        ("ok.sbp", "MX,1\n"),
        ("failed.sbp", "MX,1/0\n"),
    ]);
    // By place: where a probe going down meets a plate, a ball, a post.
    for (script, z) in [("plate", -0.6), ("ball", -1.5), ("post", -1.0)] {
        let did = shop.kerf(&format!("run probe.sbp --start fresh --script {script}.txt"));
        let text = did.exits(0).out();
        let told: f64 = text.lines().next().and_then(|line| line.trim().parse().ok()).unwrap();
        assert!((told - z).abs() < 0.2 && told <= z, "{script}: {told}");
    }
    shop.kerf("run wait.sbp --start fresh --script far.txt").exits(0).says("0\n1\n0\n");
    // By time.
    shop.kerf("run probe.sbp --start fresh --script late.txt").exits(0).says("-0.");
    let bad = shop.kerf("run probe.sbp --script bad.txt");
    bad.exits(2).complains("bad.txt, line 1: ").complains("bad.txt, line 3: inputs are numbered");
    // Events as JSON lines, and nothing else.
    for (file, status, code) in [("ok.sbp", "ok", 0), ("failed.sbp", "failed", 1)] {
        let did = shop.kerf(&format!("run {file} --start fresh --trace -"));
        let out = did.exits(code).out();
        let events: Vec<serde_json::Value> =
            out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        assert_eq!(events[0]["e"], "start");
        let end = events.last().unwrap();
        assert_eq!((end["e"].as_str(), end["status"].as_str()), (Some("end"), Some(status)));
    }
    shop.kerf("run ok.sbp --start fresh --trace - --stop-at .1").exits(3);
    shop.kerf("run ok.sbp --machine mill").exits(2).complains("no machine 'mill'");
}

#[test]
fn sbp_io_input_headless() {
    let program = "INPUT \"Depth?\" &d\nMSGBOX(Go?,YesNo,x)\nPAUSE\nMZ,&d\n";
    let shop = Shop::new(&[
        ("a.sbp", program),
        ("all.txt", "-.25\nYes\nOK\n"),
        ("lines.txt", "3:OK\n2:No\n1:-.5\n"),
        ("cancel.txt", "-.25\nYes\nCancel\n"),
    ]);
    let depth = |answers: &str| {
        let did = shop.kerf(&format!("trace a.sbp --answers {answers}"));
        did.exits(0);
        let answers: Vec<_> = did.all("ask").iter().map(|a| a["answer"].to_string()).collect();
        (answers.join(" "), did.all("move")[0]["to"]["z"].as_f64().unwrap())
    };
    assert_eq!(depth("all.txt"), ("\"-.25\" \"Yes\" \"OK\"".into(), -0.25));
    assert_eq!(depth("lines.txt"), ("\"-.5\" \"No\" \"OK\"".into(), -0.5));
    shop.kerf("run a.sbp --answers cancel.txt").exits(3);
}

#[test]
fn sbp_file_check() {
    let shop = Shop::new(&[
        ("good.sbp", "FP,part.sbp\nGOTO OUT\nMX,9\nOUT:\n"),
        ("part.sbp", "JZ,.5\nM3,4,3,-.25\n"),
        ("limit.sbp", "VL,0,10\nSF,1\nMX,12\n"),
        ("label.sbp", "GOTO NOWHERE\n"),
        ("nested.sbp", "FP,bad.sbp\n"),
        ("bad.sbp", "M23,1\n"),
    ]);
    let good = shop.kerf("check good.sbp");
    good.exits(0).says("good.sbp: ").says(" s, cutting X 0 … 4, Y 0 … 3, Z -0.25 … 0.5 in");
    for (file, code) in [("limit", "M001"), ("label", "R005"), ("nested", "S002")] {
        shop.kerf(&format!("check {file}.sbp")).exits(1).says(code);
    }
    assert_eq!(shop.names().len(), 6, "nothing is written");
}

#[test]
fn sbp_io_getusrpath() {
    let shop = Shop::new(&[("a.sbp", "GetUsrPath, &p\nPRINT &p\n")]);
    let told = shop.kerf("run a.sbp --quiet").exits(0).out();
    assert_eq!(told, shop.kerf("registry get uUsrPath").exits(0).out());
    let folder = std::path::Path::new(told.trim_end());
    assert!(folder.is_absolute() && folder.is_dir() && !told.ends_with("/\n"), "{told}");
}

#[test]
fn sbp_io_getapppath() {
    let shop = Shop::new(&[("a.sbp", "GetAppPath, &p\nPRINT &p\n")]);
    let told = shop.kerf("run a.sbp --quiet").exits(0).out();
    assert_eq!(told, shop.kerf("registry get uAppPath").exits(0).out());
    assert!(std::path::Path::new(told.trim_end()).join("journal.db").is_file(), "{told}");
}

#[test]
fn sbp_io_getpartfilename() {
    let shop =
        Shop::new(&[("parts/a.sbp", "MX,1\n"), ("f.sbp", "GetPartFileName, &f\nPRINT &f\n")]);
    shop.kerf("run parts/a.sbp").exits(0);
    // A one-liner is no part file; the last one is told with its full path, wherever one is now.
    let out = shop.command().args(["send", "--quiet", "GetPartFileName, &f", "PRINT &f"]).output();
    let told = String::from_utf8(out.unwrap().stdout).unwrap();
    let path = std::fs::canonicalize(shop.file("parts/a.sbp")).unwrap();
    assert_eq!(told.trim_end(), path.display().to_string());
}

#[test]
fn sbp_io_setspindle() {
    let shop =
        Shop::new(&[("on.sbp", "SetSpindleStatus, 1\n"), ("bad.sbp", "SetSpindleStatus, 2\n")]);
    let status = || shop.kerf("registry get SpindleStatus").exits(0).out();
    assert_eq!(status(), "0\n");
    shop.kerf("run on.sbp").exits(0);
    assert_eq!(status(), "1\n");
    shop.kerf("run bad.sbp").exits(1).complains("must be 0 or 1");
}

#[test]
fn each_run_asks_for_the_spindle_anew() {
    let shop = Shop::new(&[
        ("cut.sbp", "SO,1,1\nMX,1\nSO,1,0\nSO,1,1\nMX,0\nSO,1,0\n"),
        ("cut.nc", "M3 S9000\nG1 X1 F100\nM5\n"),
        ("left.sbp", "SO,1,1\nMX,1\n"),
        ("on.sbp", "SetSpindleStatus, 1\n"),
        ("both.sbp", "SetSpindleStatus, 1\nSO,1,1\nMX,1\n"),
    ]);
    let asked = |file: &str| {
        let run = shop.kerf(&format!("run {file}")).exits(0).out();
        run.matches("The spindle is about to start").count()
    };
    let status = || shop.kerf("registry get SpindleStatus").exits(0).out();
    for file in ["cut.sbp", "cut.nc", "left.sbp", "cut.sbp"] {
        assert_eq!(asked(file), 1, "{file}");
        assert_eq!(status(), "0\n", "the end of {file} has switched it off");
    }
    assert_eq!(asked("both.sbp"), 0, "the program said that it is active");
    asked("on.sbp");
    assert_eq!(asked("cut.sbp"), 1, "what was said before Kerf was started is forgotten");
}

#[test]
fn sbp_io_setusrval() {
    let shop =
        Shop::new(&[("a.sbp", "SetUsrVal, hello\n"), ("b.sbp", "GetUsrVal, &v\nPRINT &v\n")]);
    shop.kerf("run a.sbp").exits(0);
    shop.kerf("run b.sbp --quiet").exits(0).says("hello");
    shop.kerf("send UD").exits(0).says("uValue: hello");
    shop.kerf("reg get ShopBot/UserData/uValue").exits(0).says("hello");
}

#[test]
fn sbp_val_vn_prs() {
    let shop = Shop::new(&[]);
    shop.kerf("samples --machines").exits(0).says("prs.sbd").says("prt.sbd");
    let wired = |file: &str| {
        shop.kerf(&format!("run {file}")).exits(0);
        let out = shop.kerf("send UV").exits(0).out();
        let line = out.lines().find(|line| line.starts_with("VN")).unwrap().to_owned();
        line.split(',').skip(4).take(3).collect::<Vec<_>>().join(",")
    };
    assert_eq!((wired("prs.sbd"), wired("prt.sbd")), ("0,2,2".into(), "0,0,1".into()));
}

#[test]
fn sbp_file_fs_mask() {
    let shop = Shop::new(&[
        ("proj1.sbp", ""),
        ("proj12.sbp", ""),
        ("project.sbp", ""),
        ("notes.txt", ""),
        ("doors/a.sbp", ""),
    ]);
    let list = |mask: &str| shop.kerf(&format!("parts --mask {mask}")).exits(0).out();
    assert_eq!(list("proj??.sbp"), "  data/\n  doors/\n  proj12.sbp\n".replace("  data/\n", ""));
    assert!(list("*.*").contains("notes.txt"));
    shop.kerf("parts doors").exits(0).says("a.sbp");
    shop.kerf("parts nowhere").exits(2).complains("there is no folder nowhere");
    shop.write("mask.sbp", b"FS,,proj??.sbp\nUV\n");
    shop.kerf("send FS,,proj??.sbp UV").exits(0).says(",proj??.sbp\n");
}

#[test]
fn sbp_lang_ext() {
    let shop = Shop::new(&[
        ("demo.sbp", "MX,1\n"),
        ("mine.sbd", "VS,3,2\nPRINT %(71);\" \";%(73)\n"),
        ("demo.txt", ""),
    ]);
    assert_eq!(shop.kerf("parts").exits(0).out(), "  demo.sbp\n  mine.sbd\n");
    shop.kerf("run demo.sbp").exits(0);
    shop.kerf("run mine.sbd --quiet").exits(0).says("3 2");
}

#[test]
fn sbp_file_fp_headerinfo() {
    let shop = Shop::new(&[
        ("door.sbp", "'Contact: Ann\n'Material: birch, 18 mm\n\nMX,1\n'Notes: no\n"),
        ("plain.sbp", "'a comment\nMX,1\n"),
    ]);
    assert_eq!(shop.kerf("parts").exits(0).out(), "! door.sbp\n  plain.sbp\n");
    let told = shop.kerf("parts --headers").exits(0).out();
    assert!(told.contains("      Material: birch, 18 mm\n") && !told.contains("Notes"), "{told}");
    let json = shop.kerf("parts --format json").exits(0).json();
    assert_eq!(json["files"][0]["header"], "Contact: Ann\nMaterial: birch, 18 mm");
    assert!(json["files"][1]["header"].is_null());
}
