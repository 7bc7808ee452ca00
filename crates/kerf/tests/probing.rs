//! TP, the Probe, on the simulated machine: things at known places come out where they are, and without a contact
//! nothing is set.

use crate::shop::{Did, Shop};

/// A machine that stands there, mm, after it made the program of the Probe with these entries, and what lies on its
/// table.
fn shop(start: &str, entries: &str, scene: &str) -> Shop {
    let shop = Shop::new(&[
        ("scene.txt", scene),
        ("where.sbp", "PRINT %(1) * 25.4;\" \";%(2) * 25.4;\" \";%(3) * 25.4\n"),
    ]);
    shop.kerf(&format!("machine move to {start}")).exits(0);
    shop.kerf(&format!("send TP,units=mm,diameter=6,travel=30,clear=1,fast=5,slow=.5,{entries}"))
        .exits(0);
    shop
}

fn probe(shop: &Shop) -> Did {
    shop.kerf("run probe.nc --script scene.txt")
}

/// The tool reads these places, mm.
#[track_caller]
fn reads(shop: &Shop, places: [f64; 3]) {
    let did = shop.kerf("run where.sbp");
    let numbers = |line: &str| -> Option<Vec<f64>> {
        line.split(' ').map(|word| word.parse().ok()).collect()
    };
    let at = did.out().lines().find_map(numbers).unwrap();
    assert!(
        at.iter().zip(places).all(|(at, place)| (at - place).abs() < 0.01),
        "{at:?} is not {places:?}"
    );
}

/// It says so, and afterwards the tool reads these places, mm.
#[track_caller]
fn finds(shop: &Shop, told: &str, places: [f64; 3]) {
    probe(shop).exits(0).says(&format!("Probed: {told}"));
    reads(shop, places);
}

#[test]
fn a_bore_is_found_and_the_tool_stands_in_its_middle() {
    let shop = shop("101.6,76.2,0", "kind=bore", "input 1 off in cylinder 100,80 25 -50 50\n");
    finds(&shop, "X 100.0000 Y 80.0000, diameter 56.0000", [0.0, 0.0, 0.0]);
}

#[test]
fn an_outside_corner_is_found_from_above_in_all_axes() {
    let scene = "input 1 on in box 50,40,-30 200,200,-2\n";
    let shop = shop("66,56,10", "kind=outside-corner,inset=15,depth=4,plate=.5", scene);
    finds(&shop, "X 53.0000 Y 43.0000 Z -2.5000", [13.0, 13.0, 1.5]);
}

#[test]
fn the_corner_at_the_back_right_is_touched_from_the_other_sides() {
    let scene = "input 1 on in box 50,40,-30 200,200,-2\n";
    let entries = "kind=outside-corner,corner=back-right,inset=15,depth=4,axes=XY";
    let shop = shop("184,185,10", entries, scene);
    finds(&shop, "X 197.0000 Y 197.0000 Z -2.0000", [-13.0, -12.0, -1.0]);
}

#[test]
fn an_inside_corner_is_touched_from_within() {
    let scene = "input 1 off in box 50,40,-30 200,200,30\n";
    let shop = shop("60,55,-5", "kind=inside-corner", scene);
    finds(&shop, "X 47.0000 Y 37.0000", [13.0, 18.0, -5.0]);
}

#[test]
fn a_boss_is_touched_from_outside_and_the_tool_ends_over_it() {
    let scene = "input 1 on in cylinder 100,80 20 -50 -1\n";
    let shop = shop("102,79,1", "kind=boss,size=34,inset=4,depth=6", scene);
    finds(&shop, "X 100.0000 Y 80.0000, diameter 34.0000", [0.0, 0.0, 1.0]);
}

#[test]
fn an_edge_a_slot_and_a_plate_set_one_axis() {
    let edge = shop("40,40,-5", "kind=edge,direction=Y-", "input 1 on in box *,*,* *,30,*\n");
    finds(&edge, "Y 27.0000", [40.0, 4.0, -5.0]);
    let slot = shop("40,40,-5", "kind=slot,direction=X-", "input 1 off in box 30,*,* 55,*,*\n");
    finds(&slot, "X 42.5000, width 31.0000", [0.0, 40.0, -5.0]);
    let plate = shop("40,40,5", "kind=plate,plate=2", "input 1 on in box *,*,* *,*,-3\n");
    finds(&plate, "Z -5.0000", [40.0, 40.0, 3.0]);
}

/// The side begins at X 60 and lies 2 mm further after 40 mm: it leans to plus X, which turns by minus.
const LEANS: &str = "input 1 on in box 60,*,* *,60,*\ninput 1 on in box 62,60,* *,*,*\n";

#[test]
fn the_angle_of_a_side_turns_programs_of_g_code() {
    let shop = shop("40,40,0", "kind=angle,direction=X+,size=40", LEANS);
    shop.write("line.nc", b"G21 F600\nG1 X0 Y0\nG1 Y40\n");
    probe(&shop).exits(0).says("Probed: angle -2.8624 degrees");
    shop.kerf("run line.nc").exits(0);
    let turn = f64::atan2(2.0, 40.0);
    reads(&shop, [40.0 * turn.sin(), 40.0 * turn.cos(), 0.0]);
}

#[test]
fn without_a_contact_nothing_is_set() {
    let nothing = shop("10,10,0", "kind=edge,direction=X+", "input 1 on in box 60,*,* *,*,*\n");
    probe(&nothing).exits(1).complains("G018").complains("ended without the probe changing");
    reads(&nothing, [40.0, 10.0, 0.0]);
    let closed = shop("10,10,0", "kind=edge,direction=X+", "input 1 on in box *,*,* *,*,*\n");
    probe(&closed).exits(1).complains("in contact already");
}

#[test]
fn what_is_in_the_way_of_a_probe_ends_the_program() {
    let scene = "input 1 on in box 50,40,-30 200,200,-2\ninput 1 on in box *,*,-30 48,*,-4\n";
    let shop = shop("66,56,10", "kind=outside-corner,inset=15,depth=4", scene);
    let ran = probe(&shop);
    ran.exits(1).complains("G024").complains("Something is in the way of the probe");
    assert!(!ran.out().contains("Probed"));
}
