//! The maps, row by row of the manual.

#![allow(clippy::unwrap_used, non_snake_case)] // rows and their variants

use super::*;

/// Signal and address of each pin of a card.
fn check(card: &str, group: &str, expected: &str) {
    for row in expected.split(';') {
        let words: Vec<&str> = row.split_whitespace().collect();
        let [pin, signal, rest @ ..] = words.as_slice() else { panic!("{row}") };
        let terminals = wiring(card).unwrap().terminals;
        let found = terminals.iter().find(|it| it.group == group && it.pin == *pin);
        let found = found.unwrap_or_else(|| panic!("{card} has no {group} {pin}"));
        assert_eq!(found.signal.replace(' ', "_"), *signal, "{card} {pin}");
        if let [address, rest @ ..] = rest {
            assert_eq!(found.bit().map(Bit::address).as_deref(), Some(*address), "{card} {pin}");
            for word in rest {
                assert!(found.note.contains(word), "{card} {pin}: {}", found.note);
            }
        }
    }
}

fn notes(card: &str, words: &[&str]) {
    let all = wiring(card).unwrap().notes.join(" ");
    words.iter().for_each(|word| assert!(all.contains(word), "{card}: {word}"));
}

#[test]
fn every_bit_has_its_place_and_a_name_of_its_own() {
    for (bits, ports) in [(OUTPUT_BITS, 3), (INPUT_BITS, 2)] {
        assert_eq!(bits.len(), ports * 8);
        for (i, bit) in bits.iter().enumerate() {
            assert_eq!(usize::from(bit.place), i % 8);
            assert_eq!(bits.iter().filter(|it| it.is_called(bit.name)).count(), 1, "{}", bit.name);
        }
    }
}

#[test]
fn pro_motors_six() {
    let motors = ["x", "y", "z", "w", "q", "r"];
    let bits: Vec<&str> = OUTPUT_BITS.iter().map(|bit| bit.name).collect();
    for motor in motors {
        assert!(
            bits.contains(&&*format!("{motor}step")) && bits.contains(&&*format!("{motor}dir"))
        );
    }
}

fn output(name: &str, address: &str, byte: u8) {
    let (is_output, found) = bit(name).unwrap();
    assert!(is_output);
    assert_eq!((found.address().as_str(), found.mask()), (address, byte), "{name}");
}

#[test]
fn pro_io_outa__order() {
    for (i, name) in
        ["xdir", "xstep", "ydir", "ystep", "zdir", "zstep", "wdir", "wstep"].iter().enumerate()
    {
        output(name, &format!("A{i}"), 1 << i);
    }
}

#[test]
fn pro_io_outc45__aliases() {
    output("R0", "C4", 0x10);
    output("R1", "C5", 0x20);
}

#[test]
fn pro_io_outc67__aliases() {
    output("Q0", "C6", 0x40);
    output("Q1", "C7", 0x80);
}

#[test]
fn pro_io_pci_o_dirs() {
    check("pci", "output", "5 xdir A0;6 ydir A2;7 zdir A4;8 wdir A6");
}

#[test]
fn pro_io_pci_o_steps() {
    check("pci", "output", "23 xstep A1;24 ystep A3;25 zstep A5;26 wstep A7");
}

#[test]
fn pro_io_pci_o_cuts() {
    check("pci", "output", "9 cut1 B1 cutter on/off;10 cut2 B3 cutter;11 cut3 B5 cutter");
}

#[test]
fn pro_io_pci_o_run__map() {
    check("pci", "output", "12 job_running B7");
}

#[test]
fn pro_io_pci_o_tools__map() {
    check("pci", "output", "27 tool1 B0;28 tool2 B2;29 tool3 B4");
}

#[test]
fn pro_io_pci_o_router__map() {
    check("pci", "output", "30 router B6");
}

#[test]
fn pro_io_pci_o_power() {
    check(
        "pci",
        "output",
        "1 +12V;2 +12V;3 +12V;4 +5V;20 +12V;21 +12V;22 +12V;17 Gnd;19 Gnd;35 Gnd;37 Gnd",
    );
    check("pci", "output", "13 not_used;16 not_used;31 not_used;34 not_used");
    let all = wiring("pci").unwrap().terminals;
    assert_eq!(all.iter().filter(|it| it.group == "output").count(), 37);
}

#[test]
fn pro_io_pci_o_elec() {
    notes("pci", &["open collector through 1 kOhm", "200 mA", "37-pin female D"]);
}

#[test]
fn pro_io_pci_i_homes() {
    check("pci", "input", "5 whome A1;6 yhome A3;23 zhome A0;24 xhome A2");
}

#[test]
fn pro_io_pci_i_bdel() {
    check("pci", "input", "7 end_bottom_delay A5");
    for alias in ["bdel", "arc"] {
        assert_eq!(bit(alias).unwrap().1.name, "end_bottom_delay");
    }
}

#[test]
fn pro_io_pci_i_hc() {
    check("pci", "input", "8 zlow A7;25 zhigh A4");
}

#[test]
fn pro_io_pci_i_stop__map() {
    check("pci", "input", "26 estop A6");
    assert_eq!(bit("stop").unwrap().1.name, "estop");
}

#[test]
fn pro_io_pci_i_power() {
    check(
        "pci",
        "input",
        "1 +12V;4 +5V;17 Gnd;37 Gnd;20 input_power_A;21 input_power_B;22 input_power_C",
    );
    check("pci", "input", "9 not_used;16 not_used;27 not_used;34 not_used");
    let all = wiring("pci").unwrap().terminals;
    assert_eq!(all.iter().filter(|it| it.group == "input").count(), 37);
    notes("pci", &["20 (A) for 5-8 and 23-26", "(C) for 13-16 and 31-34"]);
}

#[test]
fn pro_io_io_x() {
    check("io", "output", "X-STEP xstep A1 pci 23;X-DIR xdir A0 pci 5;X-POS +12V");
}

#[test]
fn pro_io_io_y() {
    check("io", "output", "Y-STEP ystep A3 pci 24;Y-DIR ydir A2 pci 6;Y-POS +12V");
}

#[test]
fn pro_io_io_z() {
    check("io", "output", "Z-STEP zstep A5 pci 25;Z-DIR zdir A4 pci 7;Z-POS +12V");
}

#[test]
fn pro_io_io_w() {
    check("io", "output", "W-STEP wstep A7 pci 26;W-DIR wdir A6 pci 8;W-POS +12V");
}

#[test]
fn pro_io_io_tools() {
    check(
        "io",
        "output",
        "T1A/T1B tool1 B0 27 N/O;T2A/T2B tool2 B2 28 N/O;T3A/T3B tool3 B4 29 N/O",
    );
}

#[test]
fn pro_io_io_cuts() {
    check("io", "output", "C1A/C1B cut1 B1 9 N/O;C2A/C2B cut2 B3 10 N/O;C3A/C3B cut3 B5 11 N/O");
}

#[test]
fn pro_io_io_router__map() {
    check("io", "output", "ROUTER router B6 RTR/RTR RUN old boards");
}

#[test]
fn pro_io_io_run__map() {
    check("io", "output", "RUN job_running B7 EX");
}

#[test]
fn pro_io_io_power() {
    check("io", "output", "+12 +12V");
    for pin in ["R-STE", "R-DIR", "R-POS", "Q-STE", "Q-DIR", "Q-POS"] {
        check("io", "output", &format!("{pin} not_used"));
    }
}

#[test]
fn pro_io_io_apply() {
    notes("io", &["spindle on Router/Shutter, coolant on Tool 1", "laser on/off on Cut 1"]);
    let about = |name: &str| crate::profile::profile(name).unwrap().about();
    assert!(about("router-96x48").contains("spindle on Router/Shutter, coolant on Tool 1"));
    assert!(about("laser-pwm").contains("shutter is on Router/Shutter, the beam on Cut 1"));
}

#[test]
fn pro_io_inb2__unassigned() {
    let about = |place: u8| {
        let mut bits = INPUT_BITS.iter().filter(|bit| bit.port == Port::B && bit.place == place);
        bits.next().unwrap().about
    };
    assert_eq!(about(2), "unassigned");
}

#[test]
fn pro_io_inb37__unused() {
    let unused = INPUT_BITS.iter().filter(|bit| bit.port == Port::B && bit.about == "unused");
    assert_eq!(unused.map(|bit| bit.place).collect::<Vec<_>>(), [3, 4, 5, 6, 7]);
}

#[test]
fn pro_io_io_in_homes() {
    check("io", "input", "X-Home xhome A2;Y-Home yhome A3;Z-Home zhome A0;W-Home whome A1");
}

#[test]
fn pro_io_io_in_bdel__map() {
    check("io", "input", "BDEL end_bottom_delay A5 pulse");
}

#[test]
fn pro_io_io_in_stop__map() {
    check("io", "input", "STOP estop A6");
}

#[test]
fn pro_io_io_in_hct__map() {
    check("io", "input", "HC-T zhigh A4 down");
}

#[test]
fn pro_io_io_in_hcb__map() {
    check("io", "input", "HC-B zlow A7 up");
}

#[test]
fn pro_io_box_motors() {
    for group in ["X MOTOR", "Y MOTOR", "Z MOTOR", "W MOTOR"] {
        check("box", group, "1,2,9 phase_A;3,4,11 phase_A_bar;5,6,13 phase_B;7,8,15 phase_B_bar");
    }
    notes("box", &["15-pin female D"]);
}

#[test]
fn pro_io_box_homes() {
    for (group, row) in [
        ("X-HOME", "xhome A2"),
        ("Y-HOME", "yhome A3"),
        ("Z-HOME", "zhome A0"),
        ("W-HOME", "whome A1"),
    ] {
        check("box", group, &format!("1 +15V;2 {row};5 Gnd"));
    }
}

#[test]
fn pro_io_box_stop() {
    check("box", "STOP", "1 +15V;2 estop A6;5 Gnd");
}

#[test]
fn pro_io_box_bdelhc() {
    check("box", "BDEL-HC", "1 +15V;2 zhigh A4;3 zlow A7;4 end_bottom_delay A5;5 Gnd");
}

#[test]
fn pro_io_box_pci() {
    let all = wiring("box").unwrap().terminals;
    assert!(all.iter().any(|it| it.group == "PCI OUTPUT" && it.note == "37 rows"));
    assert!(all.iter().any(|it| it.group == "PCI INPUT" && it.note == "37 rows"));
}
