//! The command line beside a `kerf serve`, and what becomes of that.

use crate::shop;
use crate::shop::console::Console;
use crate::shop::{Did, Shop, until};

fn shop() -> Shop {
    let shop = Shop::new(&[("rel.sbp", "M2,1,0\n")]);
    shop.kerf("send SW,0 --quiet").exits(0);
    shop
}

#[cfg(unix)]
#[test]
fn a_server_that_lets_others_in_knows_whoever_sits_here() {
    let shop = shop();
    let console = Console::begin(&shop, &["--lan"]);
    let (plain, token) = console.url.split_once("/?token=").unwrap();
    let on = |what: &str, url: &str| shop.kerf(&format!("{what} --server {url}"));
    // By the token in the data folder, or the one in the address.
    on("registry set uValue a", plain).exits(0);
    let elsewhere = shop.file("elsewhere");
    let away = format!("registry get uValue --data {}", elsewhere.display());
    on(&away, plain).exits(1).complains("open the address that kerf serve printed");
    on(&away, &console.url).exits(0).says("a\n");
    on(&away, &format!("{plain}/?token=guess")).exits(1).complains("is not paired");
    on("send MX,1", plain).exits(1).complains("arm it first");
    assert_eq!(token.len(), 64);
}

#[cfg(unix)]
#[test]
fn sbp_ctl_api__the_command_line_goes_through_it() {
    let shop = shop();
    shop.write("ask.sbp", b"INPUT \"How far?\" &x\nPRINT \"going to \"; &x\nMX,&x\nGetUsrVal &u\nPRINT &u\nPAUSE\nMY,1\n");
    shop.write("answers.txt", b"3\nOK\n");
    shop.write("long.sbp", b"MX,4000\n");
    shop.write("wrong.sbp", b"QQ,1\n");
    let console = Console::begin(&shop, &[]);
    let on = |what: &str| shop.kerf(&format!("{what} --server {}", console.url));
    on("registry set ShopBot/UserData/uValue a|b").exits(0);
    on("registry get uValue").exits(0).says("a|b\n");
    on("registry get").says("uValue=a|b").says("Status=0");
    on("registry get nothing").exits(1).complains("nothing has no value");
    on("run ask.sbp --answers answers.txt").exits(1).complains("arm it first");
    on("run ask.sbp --answers answers.txt --arm").exits(0).says("going to 3\n").says("a|b\n");
    let at = console.ask("GET /api/state", "")["motion"]["at"]["working"].clone();
    assert!(
        (at[0].as_f64().unwrap() - 76.2).abs() < 1e-6
            && (at[1].as_f64().unwrap() - 25.4).abs() < 1e-6
    );
    on("run wrong.sbp --arm").exits(1);
    on("run nowhere.sbp --arm").exits(1);
    on("registry set uValue").exits(0);
    on("registry get uValue").exits(1);
    // Ctrl-C stops the machine of the server; nobody answers whether it goes on.
    let mut command = shop.command();
    let url = &console.url;
    let mut running = command.args(["run", "long.sbp", "--arm", "--server", url]).spawn().unwrap();
    while console.ask("GET /api/state", "")["machine"]["state"] != "running" {
        assert!(running.try_wait().unwrap().is_none(), "it ended by itself");
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    let id = nix::unistd::Pid::from_raw(running.id() as i32);
    nix::sys::signal::kill(id, nix::sys::signal::Signal::SIGINT).unwrap();
    assert_eq!(running.wait().unwrap().code(), Some(3));
    assert_eq!(console.ask("GET /api/state", "")["job"]["ended"], "stopped");
}

#[cfg(unix)]
#[test]
fn a_script_whose_server_was_started_anew_does_not_wait_for_ever() {
    use nix::sys::signal::{Signal, kill};
    let shop = shop();
    shop.write("wait.sbp", b"MX,1\nPAUSE 500\n");
    let mut console = Console::begin(&shop, &[]);
    let address = console.url.strip_prefix("http://").unwrap().to_owned();
    let mut command = shop.command();
    command.args(["run", "wait.sbp", "--arm", "--server", &console.url]);
    let mut running = command.stderr(std::process::Stdio::piped()).spawn().unwrap();
    until("the run", || console.ask("GET /api/state", "")["job"]["run"] == 1);
    std::thread::sleep(std::time::Duration::from_millis(300));
    // It looks away while that happens, as one does that waits for an answer at a terminal.
    let id = nix::unistd::Pid::from_raw(running.id() as i32);
    kill(id, Signal::SIGSTOP).unwrap();
    console.child.kill().unwrap();
    console.child.wait().unwrap();
    let anew = Console::begin(&shop, &["--listen", &address]);
    kill(id, Signal::SIGCONT).unwrap();
    let mut over = None;
    until("its end", || {
        over = over.or(running.try_wait().unwrap());
        over.is_some()
    });
    assert_eq!(over.unwrap().code(), Some(1));
    drop(anew);
}

#[test]
fn a_server_heeds_what_it_is_told_of_a_run_and_the_rest_is_refused() {
    let shop = shop();
    shop.write("one.sbp", b"MX,1\nPRINT %(1)\n");
    shop.write("down.sbp", b"PRINT %(3)\nMX,1\n");
    let lines = ["draw", "--do", "line 0,0 100,0; line 100,50 0,50", "-o", "lines.rsg"];
    Did::of(shop.command().args(lines).output().unwrap()).exits(0);
    shop.kerf("toolpath lines.rsg -o lines.rsm").exits(0);
    let console = Console::begin(&shop, &[]);
    let on = |what: &str| shop.kerf(&format!("{what} --arm --quiet --server {}", console.url));
    // FP's parameters, in the unit that a person reads, and line by line.
    on("run one.sbp --proportion 3,1,1 --repeat 2").exits(0).says("3\n3\n");
    on("run down.sbp --plunge -0.25 --repeat 2").exits(0).says("-0.25\n-0.5\n");
    shop.write("steps", b"step=Quit\n");
    assert_eq!(on("run one.sbp --step --answers steps").exits(3).out(), "? MX,1 → Quit\n");
    assert_eq!(on("run one.sbp --step").exits(0).out(), "? MX,1 → Run (default)\n1\n");
    // A job from another shape on, beside itself.
    let moves = || console.ask("GET /api/state", "")["job"]["summary"]["moves"].clone();
    on("run lines.rsm").exits(0);
    let whole = moves();
    on("run lines.rsm --from-line 2").exits(0);
    assert!(moves().as_u64() < whole.as_u64(), "{} of {whole}", moves());
    on("run lines.rsm --from-line 3").exits(1).complains("the paths 1 to 2");
    on("run lines.rsm --offset-job 5").exits(0);
    let bounds = console.ask("GET /api/state", "")["job"]["summary"]["bounds"].clone();
    assert_eq!(bounds[0][1].as_f64().map(f64::round), Some(-5.0), "{bounds}");
    // Nobody would heed the rest.
    for (option, name) in [
        ("--hold-at 1 --resume-at 2", "--hold-at, --resume-at are"),
        ("--override 50@1", "--override is"),
        ("--config sim", "--config is"),
        ("--input 3@1=1", "--input is"),
        ("--set N=2", "--set is"),
        ("--units mm", "--units is"),
        ("--trace t", "--trace is"),
        ("--allow-errors", "--allow-errors is"),
        ("--ramps optimal", "--ramps is"),
        ("--machine grbl:nowhere", "--machine is"),
        ("--from-line 2", "--from-line begins a part file only here"),
        ("--offset-job 1", "only a job is offset"),
    ] {
        on(&format!("run one.sbp {option}")).exits(2).complains(name);
    }
    on("run lines.rsm --tabs").exits(2).complains("--tabs is of part files");
    on("run lines.rsm --repeat 2").exits(2).complains("job.repeats");
    let send = |what: &str| shop.kerf(&format!("send {what} --server {}", console.url));
    send("UD --start fresh").exits(2).complains("--start is not heeded");
    send("--again").exits(2).complains("--again is not heeded");
}

/// Location of X at which the server believes the machine to stand, inches.
fn served_x(console: &Console) -> f64 {
    let at = console.ask("GET /api/state", "")["motion"]["at"]["working"][0].clone();
    at.as_f64().unwrap() / 25.4
}

#[cfg(unix)]
#[test]
fn what_another_kerf_does_beside_a_server_is_where_the_machine_stands() {
    let shop = shop();
    let console = Console::begin(&shop, &[]);
    let state = || console.ask("GET /api/state", "");
    console.carry_out("MX,1");
    until("the server's own move", || (served_x(&console) - 1.0).abs() < 1e-9);
    until("idle", || state()["machine"]["state"] == "idle");
    shop.kerf("send MX,4").exits(0);
    until("the other's move", || (served_x(&console) - 4.0).abs() < 1e-9);
    assert_eq!(state()["machine"]["armed"], false, "whoever armed it looks first");
    // From there it goes on, also at once.
    shop.kerf("send MX,5").exits(0);
    console.carry_out("MY,2");
    until("the move along Y", || {
        state()["motion"]["at"]["working"][1].as_f64().is_some_and(|y| (y - 50.8).abs() < 1e-6)
    });
    until("idle", || state()["machine"]["state"] == "idle");
    shop.write("x.sbp", b"PRINT %(1);\" \";%(2)\n");
    shop.kerf("run x.sbp --quiet").exits(0).says("5 2\n");
    // One that is killed in motion leaves it in doubt here, too.
    let mut other = shop.command().args(["send", "--pace", "real", "MX,500"]).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(700));
    other.kill().unwrap();
    other.wait().unwrap();
    until("the doubt", || state()["machine"]["why"].to_string().contains("not verified"));
}

#[test]
fn sbp_ext_tr__stands_above_an_added_tool() {
    let shop = shop();
    let ini = "[R]\nName = Ruler\nCommand = echo > ran.txt\n[Q]\nName = Quick\nCommand = echo > ran.txt\n";
    shop.write("data/virtualtools.ini", ini.as_bytes());
    shop.kerf("send TR,12000 --allow-shell --trace -").exits(0).says("\"rpm\":12000");
    assert!(!shop.file("ran.txt").exists());
    shop.kerf("send TQ --allow-shell").exits(0);
    assert!(shop.file("ran.txt").exists(), "another letter is the tool's");
}

#[test]
fn sbp_ctl_addin() {
    let shop = shop();
    std::fs::create_dir_all(shop.file("data")).unwrap();
    let kerf = shop.command().get_program().to_string_lossy().into_owned();
    // The tool runs beside the machine and sends it commands.
    let ini = format!(
        "[Q]\nName = Stepper\nWait = 0\nCommand = sleep .3; {kerf} send MX,2 2> sent.txt; echo\n"
    );
    shop.write("data/virtualtools.ini", ini.as_bytes());
    let console = Console::begin(&shop, &["--allow-shell"]);
    let send = |what: &str| {
        let mut command = shop.command();
        Did::of(command.args(["send", what, "--server", &console.url]).output().unwrap())
    };
    send("MX,1").exits(1).complains("disarmed");
    let commands = console.ask("GET /api/commands", "");
    assert!(commands.to_string().contains("Stepper"), "it is in the menu");
    console.carry_out("TQ");
    let begun = std::time::Instant::now();
    let x = || console.ask("GET /api/state", "")["motion"]["at"]["working"][0].as_f64().unwrap();
    while (x() - 50.8).abs() > 1e-6 {
        let sent = std::fs::read_to_string(shop.file("sent.txt")).unwrap_or_default();
        assert!(begun.elapsed().as_secs() < 20, "it never moved: {sent}");
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
    drop(console);
}

#[cfg(unix)]
#[test]
fn a_server_that_is_to_end_stops_its_machine_first() {
    use nix::sys::signal::{Signal, kill};
    shop::hear_hangups();
    for signal in [Signal::SIGTERM, Signal::SIGHUP, Signal::SIGINT] {
        let shop = shop();
        shop.write("long.sbp", b"JZ,1\nMS,1,1\nMX,5000\n");
        let mut console = Console::begin(&shop, &[]);
        console.carry_out("FP,long.sbp");
        let state = || console.ask("GET /api/state", "");
        while state()["motion"]["at"]["working"][0].as_f64().unwrap() < 30.0 {}
        kill(nix::unistd::Pid::from_raw(console.child.id() as i32), signal).unwrap();
        assert_eq!(console.child.wait().unwrap().code(), Some(0), "{signal}");
        let log = shop.read("data/SbSys.log");
        assert!(log.contains("NORMAL,Total Time"), "{signal}: {log}");
        let did = shop.kerf("run rel.sbp --quiet");
        assert!(
            !did.err().contains("not verified"),
            "{signal}: where it stands is known: {}",
            did.err()
        );
    }
}

#[test]
fn a_terminal_that_has_gone_is_no_panic() {
    let shop = shop();
    let (gone, stderr) = std::io::pipe().unwrap();
    drop(gone);
    let status = shop.command().args(["run", "nowhere.sbp"]).stderr(stderr).status().unwrap();
    assert_eq!(status.code(), Some(2));
}

#[test]
fn what_a_server_runs_is_told_as_any_run_is() {
    let shop = shop();
    shop.write("good.sbp", b"MX,1\nMY,2\nJZ,.5\n");
    shop.write("bad.sbp", b"MX,1\nQQ,3\nM23,1\n");
    shop.write("stops.sbp", b"MX,1\nPAUSE 1\nMX,&none\n");
    shop.write("outer.sbp", b"MX,1\nFP,stops.sbp\n");
    shop.write("warns.sbp", b"MX,1\nGOTO A\nA:\nA:\n");
    let console = Console::begin(&shop, &[]);
    let on = |what: &str| shop.kerf(&format!("{what} --server {}", console.url));
    // The same words as here.
    let did = on("run good.sbp --arm");
    did.exits(0).says("ran to its end after").says("3 lines, 3 moves, 0 arcs\n");
    assert_eq!(did.out(), shop.kerf("run good.sbp --data other").out());
    assert_eq!(did.err(), "");
    assert_eq!(on("run good.sbp --arm --quiet").exits(0).out(), "");
    // Mistakes are shown with their place and the mend, and nothing starts.
    let did = on("run bad.sbp --arm");
    did.exits(1)
        .complains("error[S002]: unknown command QQ")
        .complains("bad.sbp:2:1")
        .complains("2 | QQ,3");
    did.complains("help: a command has two letters").complains("bad.sbp:3:1");
    assert!(!did.out().contains("after"), "{}", did.out());
    // An error of the run too, also that of a file that the file calls.
    for name in ["stops.sbp", "outer.sbp"] {
        let did = on(&format!("run {name} --arm"));
        did.exits(1).says("FAILED after").complains("error[R001]: variable &NONE has no value");
        did.complains("stops.sbp:3:4").complains("3 | MX,&none").complains("help: assign it");
        assert_eq!(did.err().matches("R001").count(), 1, "{}", did.err());
    }
    on("run warns.sbp --arm").exits(0).complains("warning[W001]").complains("warns.sbp:4:");
}

/// A move by hand goes through the server that has it, as whoever drives; what the server would not
/// know of is refused.
#[test]
fn a_machine_that_a_server_has_is_moved_by_the_server() {
    let shop = shop();
    shop.kerf("machine use sim").exits(0);
    let console = Console::begin(&shop, &[]);
    let at = || {
        let state = console.ask("GET /api/state", "");
        let axis = |n: usize| state["motion"]["at"]["machine"][n].as_f64().unwrap();
        [axis(0), axis(1), axis(2)].map(|v| (v * 100.0).round() / 100.0 + 0.0)
    };
    shop.kerf("machine move to 10,20,-5").exits(1).complains("arm it first");
    assert_eq!(at(), [0.0; 3]);
    shop.kerf("machine move to 10,20,-5 --flat --arm").exits(0);
    assert_eq!(at(), [10.0, 20.0, -5.0]);
    shop.kerf("machine move to 1,2 --relative --arm").exits(0);
    assert_eq!(at(), [11.0, 22.0, -5.0]);
    shop.kerf("machine move home y --arm").exits(0);
    assert_eq!(at()[..2], [11.0, 0.0]);
    shop.kerf("machine move hold x+ --arm").exits(2).complains("hold a key of its console");
    shop.kerf("machine move to 1,1 --machine plasma")
        .exits(2)
        .complains("--machine plasma is not heeded");
    let here = format!("set Z top, surface or bottom on its page Job at {}", console.url);
    shop.kerf("machine zset top -12").exits(1).complains(&here);
    shop.kerf("machine zset top --by=-1").exits(1).complains(&here);
    shop.kerf("machine origin here").exits(1).complains("a kerf serve has this machine");
    drop(console);
    // Nobody has it any more: it is moved here.
    shop.kerf("machine zset top --by=-1").exits(0);
    shop.kerf("machine move to 3,4").exits(0);
    shop.kerf("machine pos").says("x  3.000");
}

/// Bits that are set and motors that are stepped beside a server are those of its machine, and refused where it refuses.
#[test]
fn pro_io_diag_write__beside_a_server() {
    let shop = shop();
    shop.kerf("machine use sim").exits(0);
    let console = Console::begin(&shop, &[]);
    let ports = || console.ask("GET /api/state", "")["io"]["ports"].to_string();
    let none = r#"{"inputs":[0,0],"outputs":[0,0,0]}"#;
    shop.kerf("io set tool2 1").exits(1).complains("arm it first");
    assert_eq!(ports(), none);
    shop.kerf("io set tool2 1 --arm").exits(0).says("output port B = 0x04\n");
    assert_eq!(ports(), r#"{"inputs":[0,0],"outputs":[0,4,0]}"#);
    shop.kerf("io get tool2").exits(0).says("1\n");
    shop.kerf("io set tool2 0 --arm").exits(0).says("output port B = 0x00\n");
    shop.kerf("io get tool2").exits(0).says("0\n");
    shop.kerf("io set xstep 1 --arm").exits(1).complains("step it instead");
    shop.kerf("io set tool2 1 --machine plasma")
        .exits(2)
        .complains("--machine plasma is not heeded");
    // A switch is moved on a disarmed machine, too.
    shop.kerf("io set in.jig2 1").exits(0).says("input port B = 0x02\n");
    assert_eq!(ports(), r#"{"inputs":[0,2],"outputs":[0,0,0]}"#);
    shop.kerf("io set in.jig2 0").exits(0);
    shop.kerf("io set in.xhome 1").exits(1).complains("a home switch of the simulated machine");
    assert_eq!(ports(), none);
    // What runs keeps its outputs, and whoever drives at a page goes on driving.
    shop.write("waits.sbp", b"PAUSE 500\n");
    console.carry_out("FP,waits.sbp");
    until("it runs", || console.ask("GET /api/state", "")["machine"]["state"] == "running");
    shop.kerf("io set tool2 1").exits(1).complains("busy");
    assert_eq!(ports(), none);
}

#[test]
fn pro_io_diag_step__beside_a_server() {
    let shop = shop();
    shop.kerf("machine use sim").exits(0);
    let console = Console::begin(&shop, &[]);
    let x = || {
        let state = console.ask("GET /api/state", "");
        (state["motion"]["at"]["machine"][0].as_f64().unwrap() * 1e4).round() / 1e4
    };
    shop.kerf("io step x +").exits(1).complains("arm it first");
    assert_eq!(x(), 0.0);
    shop.kerf("io step x + --arm").exits(0).says("x step, x +0.0040\n");
    shop.kerf("io step x + --arm").exits(0);
    assert_eq!(x(), 0.008);
    shop.kerf("io step x - --arm").exits(0).says("x step, x -0.0040\n");
    assert_eq!(x(), 0.004);
    drop(console);
    shop.kerf("machine pos").says("x  0.004");
}
