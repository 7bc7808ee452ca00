//! The registry that other software reads and writes, and commands that it passes in.

use crate::shop::console::Console;
use crate::shop::{Shop, until};

fn shop() -> Shop {
    let shop = Shop::new(&[("a.sbp", "SA\nMX,1\nMX,2\n")]);
    shop.kerf("send SW,0 --quiet").exits(0);
    shop
}

#[test]
fn sbp_ctl_reg_ucommand() {
    let shop = shop();
    shop.kerf("registry set ShopBot/UserData/uCommand MX,9").exits(0);
    shop.kerf("run a.sbp --quiet").exits(0);
    shop.kerf("sysvars").says("  1             2  ");
    // While a file runs it waits for its end.
    let mut command = shop.command();
    let args = ["send", "--pace", "real", "PAUSE 2", "MX,3"];
    let running = command.args(args).stdout(std::process::Stdio::piped()).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(900));
    shop.kerf("registry set ShopBot/UserData/uCommand MX,7").exits(0);
    let output = running.wait_with_output().unwrap();
    assert!(output.status.success());
    shop.kerf("sysvars").says("  1             7  ");
    shop.kerf("registry get uCommand").exits(1);
}

#[test]
fn sbp_ctl_reg_ucommand_form__refusals_are_logged() {
    let shop = shop();
    let mut command = shop.command();
    let args = ["send", "--pace", "real", "PAUSE 2", "MX,1"];
    let running = command.args(args).stderr(std::process::Stdio::piped()).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(900));
    shop.kerf("registry set uCommand GOTO,there").exits(0);
    let output = running.wait_with_output().unwrap();
    assert!(output.status.success());
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(told.contains("one command of two letters expected"), "{told}");
    let log = shop.kerf("log show").exits(0).out();
    let line = log.lines().find(|line| line.starts_with("uCommand,CUT,")).expect("an entry");
    assert!(line.contains(",one command of two letters expected not 'GOTO there',sim,"), "{line}");
    shop.kerf("log verify").exits(0);
}

#[test]
fn sbp_ctl_reg_ucommand__is_not_carried_out_behind_a_failed_file() {
    let shop = shop();
    shop.write("fails.sbp", b"PAUSE 2\nMX,1\nOPEN \"not there\" FOR INPUT AS #1\n");
    let mut command = shop.command();
    let args = ["run", "fails.sbp", "--start", "kept", "--pace", "real"];
    let running = command.args(args).stderr(std::process::Stdio::piped()).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(900));
    shop.kerf("registry set uCommand MX,7").exits(0);
    let output = running.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(1));
    shop.kerf("sysvars").says("  1             1  ");
    shop.kerf("log show").says("MX 7 was not carried out: what ran before did not come to its end");
}

#[test]
fn sbp_ctl_reg_ucommand__behind_a_run_that_was_taken_up() {
    let shop = shop();
    shop.write("long.sbp", b"MX,1\nPAUSE 3\nMX,2\n");
    shop.write("ok.txt", b"ok\n");
    let run = |args: &[&str]| {
        let mut command = shop.command();
        command.args(args).args(["--pace", "real"]).stdout(std::process::Stdio::null());
        let running = command.spawn().unwrap();
        std::thread::sleep(std::time::Duration::from_millis(1800));
        running
    };
    let mut killed = run(&["run", "long.sbp", "--start", "kept"]);
    killed.kill().unwrap();
    killed.wait().unwrap();
    let mut taken_up = run(&["run", "--resume", "--answers", "ok.txt"]);
    shop.kerf("registry set uCommand MX,7").exits(0);
    assert!(taken_up.wait().unwrap().success());
    shop.kerf("sysvars").says("  1             7  ");
}

#[test]
fn sbp_ctl_reg_ucommand_form__in_the_server() {
    let shop = shop();
    let console = Console::begin(&shop, &[]);
    let pass =
        |line: &str| shop.kerf(&format!("registry set uCommand {line} --server {}", console.url));
    let logged = |words: &str| until(words, || shop.read("data/SbSys.log").contains(words));
    pass("QQ,1").exits(1).complains("one command of two letters expected");
    logged(
        ",QQ 1 was passed in and not carried out: one command of two letters expected not 'QQ 1',sim,",
    );
    pass("MX,1").exits(1).complains("take control first");
    logged(",MX 1 was passed in and not carried out: nobody drives: take control first,sim,");
    shop.kerf("log verify").exits(0);
}

#[test]
fn sbp_ctl_reg() {
    let shop = shop();
    shop.kerf("reg set ShopBot/UserData/uValue 17").exits(0);
    assert_eq!(shop.kerf("reg get ShopBot/UserData/uValue").exits(0).out(), "17\n");
    assert_eq!(shop.kerf("reg get ShopBot/UserData/Status").exits(0).out(), "0\n");
}

#[test]
fn sbp_ctl_reg_paths() {
    let shop = shop();
    for key in ["uAppPath", "uUsrPath"] {
        let told = shop.kerf(&format!("registry get ShopBot/UserData/{key}")).exits(0).out();
        let folder = std::path::Path::new(told.trim_end());
        assert!(folder.is_absolute() && folder.is_dir(), "{key} {told}");
    }
}

#[test]
fn sbp_ctl_reg_paths__of_a_server() {
    let shop = shop();
    let console = Console::begin(&shop, &[]);
    let get = |key: &str| shop.kerf(&format!("registry get {key} --server {}", console.url));
    for key in ["uAppPath", "uUsrPath"] {
        let told = get(key).exits(0).out();
        let folder = std::path::Path::new(told.trim_end());
        assert!(folder.is_absolute() && folder.is_dir(), "{key} {told}");
    }
    assert_eq!(get("SpindleStatus").exits(0).out(), "0\n");
}

/// Waits until the file that other programs watch has these lines.
fn until_told(shop: &Shop, lines: &[&str]) {
    let file = shop.file("data").join("registry.txt");
    until(&lines.join(" "), || {
        let text = std::fs::read_to_string(&file).unwrap_or_default();
        lines.iter().all(|line| text.lines().any(|told| told == *line))
    });
}

#[test]
fn what_others_watch_is_true_of_a_machine_that_stands_and_after_a_kill() {
    let shop = shop();
    shop.write("wait.sbp", b"SO,2,1\nMSGBOX(Wait)\n");
    let mut console = Console::begin(&shop, &[]);
    console.carry_out("SO,3,1");
    until_told(&shop, &["Status=0", "OutPutSwitches=4"]);
    until("the same by HTTP", || console.ask("GET /api/registry/OutPutSwitches", "") == 4);
    console.carry_out("FP,wait.sbp");
    until_told(&shop, &["Status=9", "OutPutSwitches=6"]);
    console.child.kill().unwrap();
    console.child.wait().unwrap();
    let console = Console::begin(&shop, &[]);
    until_told(&shop, &["Status=0", "OutPutSwitches=0"]);
    drop(console);
}

#[test]
fn nobody_sets_what_the_machine_tells() {
    let shop = shop();
    shop.kerf("registry set ShopBot/UserData/Status 7")
        .exits(2)
        .complains("the machine tells Status");
    std::fs::write(shop.file("data").join("registry.in"), "Status=3\n=5\nuValue=8\n").unwrap();
    shop.kerf("send MX,1 --quiet").exits(0);
    assert_eq!(shop.kerf("registry get uValue").exits(0).out(), "8\n");
    let text = std::fs::read_to_string(shop.file("data").join("registry.txt")).unwrap();
    assert_eq!(text.matches("Status=").count(), 1, "{text}");
    assert!(text.lines().all(|line| !line.starts_with('=')), "{text}");
}
