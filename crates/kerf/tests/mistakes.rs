//! One mistake, one exit code: what the command line names and is not there ends with 2 in every command, and is named.

use crate::shop::Shop;
use std::collections::BTreeSet;

/// Commands that name a file, a folder or a thing that is not there, or a value that is none, with the thing.
const MISTAKES: &[(&str, &str)] = &[
    // Files.
    ("run nope.sbp", "nope.sbp"),
    ("run nope.rsm", "nope.rsm"),
    ("send nope.sbp", "nope.sbp"),
    ("send nope.sbp com2", "nope.sbp"),
    ("preview nope.sbp -o a.svg", "nope.sbp"),
    ("plot nope.sbp -o a.svg", "nope.sbp"),
    ("time nope.sbp", "nope.sbp"),
    ("timing nope.sbp -o a.svg", "nope.sbp"),
    ("heights nope.rsm --sheet=-20", "nope.rsm"),
    ("trace nope.sbp", "nope.sbp"),
    ("fmt nope.sbp", "nope.sbp"),
    ("convert nope.sbp a.nc", "nope.sbp"),
    ("convert nope.dxf b.sbp", "nope.dxf"),
    ("draw nope.rsg --list", "nope.rsg"),
    ("toolpath nope.rsg -o a.rsm", "nope.rsg"),
    ("serve nope.sbp", "nope.sbp"),
    ("sb3 nope.sbp,,4", "nope.sbp"),
    ("wavlength nope.wav", "nope.wav"),
    ("machine check nope.toml", "nope.toml"),
    ("machine import nope.cfg", "nope.cfg"),
    ("map use nope.map", "nope.map"),
    ("run a.sbp --answers nope.txt", "nope.txt"),
    ("trace a.sbp --script nope.txt", "nope.txt"),
    // Folders.
    ("check a.sbp --custom nope", "nope"),
    ("run a.sbp --custom nope", "nope"),
    ("run a.sbp --parts nope", "nope"),
    ("send MX,1 --parts nope", "nope"),
    ("serve --parts nope", "nope"),
    ("sysvars --parts nope", "nope"),
    ("trace a.sbp --allow-path nope", "nope"),
    ("parts nope", "nope"),
    ("parts --parts nope", "nope"),
    // Machines.
    ("run a.sbp --machine nope", "'nope'"),
    ("send MX,1 --machine nope", "'nope'"),
    ("check a.sbp --machine nope", "'nope'"),
    ("get delays --machine nope", "'nope'"),
    ("set uValue=1 --machine nope", "'nope'"),
    ("io list --machine nope", "'nope'"),
    ("machine show --machine nope", "'nope'"),
    ("machine use nope", "'nope'"),
    ("machine profiles nope", "nope"),
    ("machine boards nope", "nope"),
    ("receive com1 --machine nope", "'nope'"),
    ("serve --machine nope", "'nope'"),
    ("serve --also nope", "'nope'"),
    ("serve --also sim", "sim is named twice"),
    ("toolpath a.rsg -o a.rsm --machine nope", "'nope'"),
    ("settings show --machine nope", "'nope'"),
    // Names.
    ("settings load nope", "nope.sbd"),
    ("get nonsense", "nonsense"),
    ("set nonsense=1", "nonsense"),
    ("machine get nonsense", "nonsense"),
    ("machine set nonsense 1", "nonsense"),
    ("io get nonsense", "nonsense"),
    ("io set nonsense 1", "nonsense"),
    ("io map --card nonsense", "nonsense"),
    ("help nonsense", "nonsense"),
    ("machine home --machine sim q", "q"),
    ("machine warm-up 25", "25"),
    // Values.
    ("set delays.end_s=soon", "soon"),
    ("io set tool2 2", "2"),
    ("run a.sbp --ramps steep", "steep"),
    ("check a.sbp --units furlong", "furlong"),
    ("time a.sbp --accel 0,0", "0,0"),
    ("receive nonsense", "nonsense"),
    ("parts --restore x --versions a.sbp", "x"),
    ("log nonsense", "nonsense"),
    ("registry nonsense", "nonsense"),
    ("samples one two", "two"),
    ("explain S001 more", "more"),
];

#[test]
fn a_name_that_is_not_there_ends_with_the_same_code_in_every_command() {
    let shop = Shop::new(&[("a.sbp", "MX,1\n"), ("a.rsg", "")]);
    for (line, thing) in MISTAKES {
        let did = shop.kerf(line);
        let err = did.err();
        println!("{line}\n{err}");
        did.exits(2).complains(thing);
        assert!(!err.contains("os error"), "{line}: a sentence of its own: {err}");
    }
    // What is wrong with a file stands where the findings of files stand.
    shop.kerf("check nope.sbp").exits(2).says("nope.sbp");
    // An answer is no mistake: a key of programs may have no value, a code of no message is looked up.
    shop.kerf("registry get uValue").exits(1).complains("uValue has no value");
    shop.kerf("get uValue").exits(1).complains("uValue has no value");
    shop.kerf("explain NOPE").exits(1).complains("there is no code NOPE");
    assert_eq!(shop.names(), ["a.rsg", "a.sbp"], "nothing was written");
}

#[test]
fn each_command_has_a_row() {
    let help = Shop::new(&[]).kerf("--help").exits(0).out();
    let listed = help.lines().filter_map(|line| line.strip_prefix("  ")?.split(' ').next());
    let commands = listed.filter(|word| word.starts_with(|c: char| c.is_ascii_lowercase()));
    let rows: BTreeSet<&str> =
        MISTAKES.iter().filter_map(|(line, _)| line.split(' ').next()).collect();
    let without: Vec<&str> =
        commands.filter(|word| *word != "kerf" && !rows.contains(word)).collect();
    assert!(without.is_empty(), "{without:?}");
}

#[test]
fn a_file_that_is_not_there_is_told_with_its_folder_and_the_one_that_may_be_meant() {
    let shop = Shop::new(&[("plate.sbp", "MX,1\n")]);
    let did = shop.kerf("time plat.sbp");
    did.exits(2).complains("there is no such file in /").complains("did you mean plate.sbp?");
    shop.kerf("time doors/plate.sbp").exits(2).complains("there is no folder doors");
    let did = shop.kerf("check plate.sbp --machine grbl:/dev/none");
    did.exits(0).complains("grbl:/dev/none is not opened");
}
