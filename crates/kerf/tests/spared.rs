//! Refusals before harm is done: files written over, moves beyond all reason, values nobody can read.

use crate::shop::{Did, Shop};

#[test]
fn a_run_does_not_write_over_what_it_reads() {
    let files = [("ow.sbp", "MX,1\n"), ("yes.txt", "OK\n"), ("inputs.txt", "input 3 on at 2\n")];
    let shop = Shop::new(&files);
    std::fs::create_dir(shop.file("sub")).unwrap();
    for (options, option) in [
        ("--trace ow.sbp", "--trace"),
        ("--vcd sub/../ow.sbp", "--vcd"),
        ("--readings ./ow.sbp", "--readings"),
        ("--answers yes.txt --trace yes.txt", "--trace"),
        ("--script inputs.txt --vcd inputs.txt", "--vcd"),
    ] {
        let did = shop.kerf(&format!("run ow.sbp {options}"));
        did.exits(2).complains(&format!("{option} would write over"));
    }
    for (name, text) in files {
        assert_eq!(shop.read(name), text);
    }
    shop.kerf("run ow.sbp --trace ow.jsonl --vcd ow.vcd").exits(0);
    shop.kerf("run ow.sbp --trace ow.jsonl --vcd ow.vcd").exits(0);
}

#[test]
fn a_move_beyond_all_reason_is_an_error_of_its_line() {
    let shop = Shop::new(&[("far.sbp", "MX,1\nMX,1e11\nPRINT %(1)\n")]);
    for command in ["run", "check", "time"] {
        let did = shop.kerf(&format!("{command} far.sbp"));
        did.exits(1);
        let told = did.out() + &did.err();
        assert!(told.contains("far.sbp:2") && told.contains("X would go to 1e11"), "{told}");
        assert!(!told.contains("100000000000"), "{told}");
    }
    shop.kerf("machine set cutter.safe_z_mm 1e12").exits(0);
    shop.write("home.sbp", b"MH\n");
    shop.kerf("run home.sbp").exits(1).complains("home.sbp:1").complains("Z would go to");
}

#[test]
fn values_of_the_registry_are_lines() {
    let shop = Shop::new(&[]);
    let set = |key: &str, value: &str| {
        Did::of(shop.command().args(["registry", "set", key, value]).output().unwrap())
    };
    for (key, value) in
        [("", "x"), (" ", "x"), ("a\nb", "x"), ("a=b", "x"), ("a", "x\ny=2"), ("a/", "x")]
    {
        set(key, value).exits(2);
    }
    set("UserData/a", "x = y").exits(0);
    assert_eq!(shop.kerf("registry get").exits(0).out(), "a=x = y\n");
}
