//! Small files that stand for more than a memory holds: each is looked at in a gibibyte, and told what was left.

#![cfg(unix)]

use crate::shop::Shop;
use crate::shop::bounded::{Ended, bounded};

/// Memory a command may address, KiB.
const MOST_KIB: u64 = 1 << 20;

/// Runs `kerf` on a file, with these arguments.
fn look(name: &str, text: &str, args: &str) -> Ended {
    let shop = Shop::new(&[(name, text)]);
    let did = bounded(&shop, MOST_KIB, args);
    assert_eq!(did.signal, None, "{args}: {}", did.err);
    did
}

/// Blocks within each other, each 100 times the one before, 10^16 in all.
fn blocks() -> String {
    let pairs = |text: &str| -> String {
        text.split('/').map(|pair| pair.replacen(' ', "\n", 1) + "\n").collect()
    };
    let block = |n: u32| {
        let insert = |n: u32| format!("0 INSERT/2 b{n}/10 0/20 0/70 10/71 10/44 1/45 1");
        let body = n.checked_sub(1).map_or("0 LINE/10 0/20 0/11 1/21 0".into(), insert);
        format!("0 BLOCK/2 b{n}/10 0/20 0/{body}/0 ENDBLK/")
    };
    let blocks: String = (0..9).map(block).collect();
    pairs(&format!(
        "0 SECTION/2 BLOCKS/{blocks}0 ENDSEC/0 SECTION/2 ENTITIES/0 INSERT/2 b8/10 0/20 0/0 ENDSEC/0 EOF"
    ))
}

#[test]
fn blocks_in_blocks_end_with_the_block_and_its_line() {
    let did = look("plan.dxf", &blocks(), "toolpath plan.dxf -o plan.sbp");
    assert_eq!(did.code, Some(1), "{}", did.err);
    let told =
        "INSERT of block `b8` comes to more than 200,000 shapes beyond those that the file writes";
    assert!(did.err.contains("plan.dxf:") && did.err.contains(told), "{}", did.err);
    assert!(did.err.contains("fewer rows and columns"), "{}", did.err);
}

/// It took 5 GB.
#[test]
fn a_main_program_that_starts_again_is_not_drawn_for_ever() {
    let text = "G20 G90 G1 X1 F60\nX0\nM99\n";
    let did = look("part.nc", text, "preview part.nc -o part.svg --max-lines 30000");
    assert_eq!(did.code, Some(3), "{}", did.err);
    assert!(did.err.contains("stopped after 30"), "{}", did.err);
}

/// It took 4 GB: every round found the same mistakes again.
#[test]
fn a_loop_that_finds_the_same_each_time_is_told_once() {
    let text = "G20 G90 F60\no1 while [1]\nG1 X1,5\no1 endwhile\n";
    let did = look("part.nc", text, "check part.nc --max-lines 30000");
    assert_eq!(did.code, Some(1), "{}", did.out);
    assert!(did.out.matches("error[").count() < 50, "{}", did.out);
}

#[test]
fn a_loop_that_goes_farther_each_time_is_told_twenty_times_and_counted() {
    let text = "VL,0,10\nSF,1\n&a=11\nA:\n&a=&a+1\nMX,&a\nGOTO A\n";
    let did = look("part.sbp", text, "check part.sbp --max-lines 30000");
    assert_eq!(did.code, Some(1), "{}", did.out);
    assert!(did.out.contains("this line did the same 9,"), "{}", did.out);
    assert_eq!(did.out.matches("error[M001]").count(), 20, "{}", did.out);
}

#[test]
fn an_endless_loop_of_moves_is_looked_at_up_to_a_bound() {
    for args in ["check part.sbp", "time part.sbp", "trace part.sbp"] {
        let did =
            look("part.sbp", "A:\nMX,1\nMX,0\nGOTO A\n", &format!("{args} --max-lines 20000"));
        let code = if args.starts_with("check") { 1 } else { 3 };
        assert_eq!(did.code, Some(code), "{args}: {}", did.err);
    }
}

#[test]
fn what_comes_after_the_bound_of_commands_is_told_as_not_looked_at() {
    // A line of it is many moves.
    let text = "A:\nCP,10,1,1,O,1,0,360,-.1,100\nGOTO A\n";
    let did = look("part.sbp", text, "check part.sbp --max-lines 5000");
    assert_eq!(did.code, Some(1), "{}", did.out);
    let told = "stopped after 5,000 commands: what comes after them was not looked at";
    assert!(did.out.contains(told), "{}", did.out);
    assert!(did.out.contains("--max-lines looks further"), "{}", did.out);
}

#[test]
fn arrays_of_arrays_are_refused_before_they_are_made() {
    let copies = "rect 0,0 1,1; select all; array rect 400x400; select all; array rect 400x400";
    let did = look("no.sbp", "", &format!("draw --do '{copies}' -o plate.dxf"));
    assert_eq!(did.code, Some(1), "{}", did.err);
    assert!(did.err.contains("the number of shapes"), "{}", did.err);
}
