//! `kerf get` and `kerf set`: everything that has a value.

use crate::shop::Shop;
use crate::shop::console::Console;

#[test]
fn every_kind_of_value_is_got_and_set_by_its_name() {
    let shop = Shop::new(&[("looks.sbp", "PRINT \"input 3 is \";%(53)\n")]);
    let check = |name: &str, before: &str, after: &str| {
        assert_eq!(shop.kerf(&format!("get {name}")).exits(0).out(), format!("{before}\n"));
        shop.kerf(&format!("set {name}={after}")).exits(0);
        assert_eq!(shop.kerf(&format!("get {name}")).exits(0).out(), format!("{after}\n"));
    };
    check("delays.end_s", "0", "0.5");
    check("homing.x.end", "\"low\"", "\"high\"");
    check("tool2", "0", "1");
    check("in.jig1", "0", "1");
    check("in.3", "0", "1");
    shop.kerf("run looks.sbp --start kept").exits(0).says("input 3 is 1");
    shop.kerf("set uValue=a=b").exits(0);
    assert_eq!(shop.kerf("get ShopBot/UserData/uValue").exits(0).out(), "a=b\n");
    shop.kerf("set uValue=").exits(0);
    shop.kerf("get uValue").exits(1).complains("uValue has no value");
    shop.kerf("send MX,2 VC,.375 --quiet").exits(0);
    assert_eq!(shop.kerf("get %(1)").exits(0).out(), "2\n");
    shop.kerf("get VC").exits(0).says("0.375,");
    shop.kerf("get delays.end_s tool2").exits(0).says("delays.end_s = 0.5\ntool2 = 1\n");
    // The older names know the same values.
    assert_eq!(shop.kerf("machine get delays.end_s").exits(0).out(), "0.5\n");
    assert_eq!(shop.kerf("io get tool2").exits(0).out(), "1\n");
}

#[test]
fn a_part_of_a_name_lists_all_that_have_it() {
    let shop = Shop::new(&[]);
    shop.kerf("set $homing=3").exits(0);
    let did = shop.kerf("get homing");
    did.exits(0).says("homing.x.fast = 50  [mm/s").says("$homing = 3");
    shop.kerf("get jig").says("in.jig1 = 0").says("out.jig1 = 0");
    let all = shop.kerf("get").exits(0).out();
    for name in ["delays.end_s = ", "out.tool2 = ", "location X\n", "$homing = 3\n"] {
        assert!(all.contains(name), "{name}");
    }
}

#[test]
fn a_name_that_is_none_is_told_with_the_nearest() {
    let shop = Shop::new(&[]);
    let check = |args: &str, code: i32, why: &str| {
        shop.kerf(args).exits(code).complains(why);
    };
    check("get delays.ends", 2, "did you mean delays.end_s?");
    check("set delays.ends=1", 2, "did you mean delays.end_s?");
    check("set tool2=on", 2, "tool2 is 0 or 1, not 'on'");
    check("set delays.end_s=-1", 2, "delays.end_s");
    check("set VC=.3", 2, "kerf send 'VC,.3'");
    check("set %(1)=3", 2, "%(1) is a system variable");
    check("set Status=1", 2, "the machine tells Status");
    check("set tool2", 2, "give NAME=VALUE");
    check("get out.2 --machine grbl:/dev/none", 1, "there is no serial port");
    assert_eq!(shop.kerf("get delays.end_s").out(), "0\n");
}

#[test]
fn values_of_a_server_are_got_and_set_there() {
    let shop = Shop::new(&[]);
    let console = Console::begin(&shop, &[]);
    let on = |what: &str| shop.kerf(&format!("{what} --server {}", console.url));
    on("set uValue=7").exits(0);
    assert_eq!(on("get uValue").exits(0).out(), "7\n");
    shop.kerf("get uValue --data elsewhere").exits(1);
}

#[test]
fn a_run_that_was_cut_short_is_taken_up_in_the_folder_that_is_named() {
    let shop = Shop::new(&[]);
    let did = shop.kerf("run --resume --data other");
    did.exits(1).complains("other");
    assert!(!did.err().contains("not heeded"), "{}", did.err());
}
