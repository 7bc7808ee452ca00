//! A command line with a mistake in it: what is wrong is named, and how to mend it.

use crate::shop::console::Console;
use crate::shop::{Did, Shop};
use std::net::TcpListener;

const BOX: &str = "JZ,.5\nJ2,1,1\nMZ,-.1\nMX,4\nMY,3\nMX,1\nMY,1\nJZ,.5\n";

fn shop() -> Shop {
    Shop::new(&[("box.sbp", BOX)])
}

#[test]
fn numbers_below_zero_are_refused_where_they_mean_nothing() {
    let shop = shop();
    let not_negative = "give a number, 0 or greater";
    for (args, message) in [
        ("time box.sbp --ramps optimal --jerk=-1,-1,-1", "give numbers, 0 or greater"),
        ("time box.sbp --ramps optimal --jerk -1,-1,-1", "give numbers, 0 or greater"),
        ("run box.sbp --accel -1", "give numbers greater than 0"),
        ("run box.sbp --stop-at=-3", not_negative),
        ("run box.sbp --hold-at=-1", not_negative),
        ("run box.sbp --hold-at -1", not_negative),
        ("run box.sbp --hold-at 1 --resume-at -1", not_negative),
        ("time box.sbp --ramps optimal --tolerance -1", not_negative),
        ("time box.sbp --ramps profiler --smoothing -1", not_negative),
        ("convert a.dxf b.sbp --depth -0.1", not_negative),
        ("convert a.dxf b.sbp --safe-height -1", not_negative),
        ("convert a.dxf b.sbp --scale -1", "give a number greater than 0"),
        ("convert a.png b.sbp --size -1,2", "give two lengths"),
        ("plot box.sbp -o a.svg --from -1", not_negative),
        ("run box.sbp --override -5@3", "10 to 200 percent"),
        ("run box.sbp --repeat -1", "-1 is not in 1.."),
        ("run box.sbp --max-lines -1", "invalid"),
        ("io watch --for -1", not_negative),
    ] {
        let did = shop.kerf(args);
        did.exits(2).complains(message);
        assert!(!did.err().contains("tip:"), "{args}\n{}", did.err());
    }
    shop.kerf("trace box.sbp --plunge -.1 --sheet -20,0.05 --proportion -1,1,1").exits(0);
}

#[test]
fn a_machine_that_is_not_there_is_refused_with_the_nearest() {
    let shop = shop();
    for args in [
        "run box.sbp --machine router96x48",
        "time box.sbp --machine router96x48",
        "serve --machine router96x48 --listen 127.0.0.1:0",
        "machine show --machine router96x48",
        "machine set zpos.top_mm 3 --machine router96x48",
        "machine use router96x48",
        "toolpath box.rsg --machine router96x48",
        "io list --machine router96x48",
    ] {
        let did = shop.kerf(args);
        did.exits(2).complains("router96x48").complains("did you mean router-96x48?");
        did.complains("`kerf machine profiles` lists them");
    }
    let did = shop.kerf("run box.sbp --machine nowhere.toml");
    did.exits(2).complains("there is no machine 'nowhere.toml': no such file");
    shop.kerf("machine set zpos.top_mm 3 --config sim")
        .exits(2)
        .complains("profiles sim > mine.toml");
}

#[test]
fn one_option_names_every_machine() {
    let shop = shop();
    shop.kerf("machine set delays.end_s 7 --data shop").exits(0);
    shop.kerf("machine save slow --data shop").exits(0);
    let delay = |args: &str| {
        let did = shop.kerf(&format!("machine get delays.end_s --data shop {args}"));
        did.exits(0).out()
    };
    assert_eq!(delay("--machine slow"), "7\n");
    shop.kerf("machine set delays.end_s 3 --machine slow --data shop").exits(0);
    assert_eq!([delay("--machine slow"), delay("--machine sim")], ["3\n", "7\n"]);
    shop.kerf("machine use slow --data shop").exits(0);
    assert_eq!(delay(""), "3\n");
    shop.write("one.sbp", b"MX,1\n");
    shop.write("mine.toml", shop.kerf("machine profiles plasma").out().as_bytes());
    for name in ["sim", "slow", "mine.toml", "laser-pwm"] {
        for command in ["run one.sbp", "send VD", "time one.sbp", "check one.sbp", "machine pos"] {
            shop.kerf(&format!("{command} --machine {name} --data shop")).exits(0);
        }
    }
}

#[test]
fn a_name_of_a_machine_that_cannot_be_is_refused_with_the_mend() {
    let shop = shop();
    let check = |args: &str, why: &str| {
        shop.kerf(args).exits(2).complains(why);
    };
    check("run box.sbp --machine grbl", "grbl needs its port");
    check("time box.sbp --machine marlin:COM3", "there is no driver 'marlin', only grbl");
    check("run box.sbp --machine sim --machine grbl:COM3", "are two machines: leave one out");
    check("machine home --machine plasma --machine knife", "are two machines");
    check("run box.sbp --config sim --machine plasma", "are two machines");
    check("run box.sbp --home", "--home is for a controller: name it with --machine grbl:PORT");
    for name in ["sim", "plasma", "grbl:COM3", "a/b", "mine.toml"] {
        check(&format!("machine save {name}"), "cannot be the name of a saved machine");
    }
}

#[test]
fn a_controller_that_is_not_there_is_told_by_every_command_that_drives_one() {
    let shop = shop();
    shop.write("one.sbp", b"MX,1\n");
    for command in [
        "run one.sbp",
        "send MX,1",
        "serve",
        "machine home",
        "machine move origin",
        "io list",
        "io set out.2 1",
        "get in.1",
        "set out.2=1",
    ] {
        let did = shop.kerf(&format!("{command} --machine grbl:COM33 --data shop"));
        did.exits(1).complains("there is no serial port COM33");
    }
}

#[test]
fn the_data_folder_is_named_before_and_behind_the_subcommand() {
    let shop = shop();
    shop.kerf("registry set uValue there --data other").exits(0);
    for args in ["registry --data other get uValue", "registry get uValue --data other"] {
        assert_eq!(shop.kerf(args).exits(0).out(), "there\n", "{args}");
    }
    shop.kerf("run box.sbp --data other --quiet").exits(0);
    shop.kerf("log show --data other").exits(0).says("box.sbp,CUT");
    shop.kerf("log verify --data other").exits(0);
    for args in ["machine get zpos.top_mm", "io list", "settings list", "sysvars", "parts"] {
        shop.kerf(&format!("{args} --data other")).exits(0);
    }
}

#[test]
fn a_server_with_a_mistake_does_not_start() {
    let shop = shop();
    let serve = |args: &str| shop.kerf(&format!("serve --listen 127.0.0.1:0 {args}"));
    serve("nofile.sbp").exits(2).complains("cannot read").complains("nofile.sbp");
    serve("--parts nodir").exits(2).complains("nodir").complains("--parts names");
    serve("--parts box.sbp").exits(2).complains("box.sbp").complains("--parts names");
    shop.write("other/deep.sbp", b"MX,1\n");
    serve("other/deep.sbp --parts none").exits(2);
    serve("box.sbp --parts other").exits(2).complains("is not in the part folder");
    let taken = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = taken.local_addr().unwrap();
    let did = shop.kerf(&format!("serve --listen {address}"));
    did.exits(1).complains(&format!(
        "{address} is in use, perhaps by another kerf serve: --listen 127.0.0.1:"
    ));
    let did = shop.kerf("serve --listen 203.0.113.7:8710 --lan");
    did.exits(1).complains("203.0.113.7").complains("this computer has no such address");
}

#[test]
fn a_served_file_is_named_from_here_or_from_the_part_folder() {
    let shop = Shop::new(&[("parts/deep/box.sbp", BOX)]);
    for name in ["deep/box.sbp", "parts/deep/box.sbp"] {
        let console = Console::begin(&shop, &["--parts", "parts", name]);
        let opened = console.ask("GET /api/state", "")["opened"]["name"].clone();
        assert_eq!(opened, "deep/box.sbp", "{name}");
    }
}

#[test]
fn a_refused_line_is_shown_itself() {
    let shop = shop();
    shop.kerf("send MX,1").exits(0);
    let mut kerf = shop.command();
    let did = Did::of(kerf.args(["send", "GOTO A"]).output().unwrap());
    did.exits(1).complains("1 | GOTO A");
    assert!(!did.err().contains("1 | MX,1"), "{}", did.err());
    let mut kerf = shop.command();
    let did = Did::of(kerf.args(["send", "MX,3", "QQ,3"]).output().unwrap());
    did.exits(1).complains("2 | QQ,3");
    // What was refused is not kept: it cannot be sent again.
    assert_eq!(shop.read("temp_code.sbp"), "MX,1\n");
}

/// SP of one call draws what the next ones send, a file too, until SM; what is set stays, locations come back.
#[test]
fn sbp_cmd_sp__holds_for_the_next_send() {
    let shop = Shop::new(&[("a.sbp", "SA\nMX,2\nMY,3\n")]);
    let send = |line: &str| shop.kerf(&format!("send {line} --trace -"));
    let stands = |x: &str| {
        shop.kerf("machine pos").exits(0).says(&format!("x  {x} not homed"));
    };
    assert_eq!(send("SP").exits(0).all("mode")[0]["mode"], "preview");
    let drawn = send("FP,a.sbp");
    assert_eq!((drawn.end()["cut"].clone(), drawn.end()["t"].clone()), (5.into(), 0.into()));
    assert_eq!(send("MX,9").end()["cut"], 7, "from where the drawing stands");
    send("VC,.5").exits(0);
    stands("0.000");
    send("SM").exits(0);
    assert!(shop.kerf("sysvars").out().contains("0.5  user units            cutter diameter"));
    let moved = send("FP,a.sbp");
    assert_eq!(moved.end()["cut"], 5);
    assert!(moved.end()["t"].as_f64().unwrap() > 1.0, "it is made: {}", moved.end());
    stands("50.800");
    let log = shop.kerf("log show").out();
    let of = |mode: &str| log.lines().filter(|line| line.starts_with(mode)).count();
    assert!(of("NFP,PREVIEW") > 0 && of("NFP,CUT") > 0, "{log}");
}

#[test]
fn a_file_is_sent_to_a_port_or_an_address() {
    let shop = shop();
    for args in ["send box.sbp", "send box.sbp --server http://127.0.0.1:9"] {
        let did = shop.kerf(args);
        did.exits(2)
            .complains("box.sbp is a file: name a port or an address: kerf send box.sbp com2");
    }
}
