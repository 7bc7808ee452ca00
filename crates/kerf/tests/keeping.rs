//! G-code that became OpenSBP with its variables cuts the same path: with other values, under the
//! proportions and offsets of FP, in a mirror.

use crate::shop::Shop;
use serde_json::Value;

/// Calls of a file, each after a move to X10 Y20 Z3. The last stretches circles, which each language then cuts as
/// chords of its own.
const CALLS: [&str; 6] = [
    "FP,FILE",
    "FP,FILE,,,,,1",
    "FP,FILE,2,2,.5,,2",
    "FP,FILE,-1,1,1",
    "FP,FILE,3,3,3,2,1",
    "FP,FILE,1,-2,2",
];

/// Converts G-code as Kerf does with `--keep-variables`.
fn kept(shop: &Shop, text: &str) -> String {
    shop.write("a.nc", text.as_bytes());
    let did = shop.kerf("convert a.nc a.sbp --keep-variables --units mm --force");
    did.exits(0);
    assert!(!did.err().contains("not kept"), "{}", did.err());
    shop.read("a.sbp")
}

/// Ramps at corners know an axis' own speed from one along the path.
const RAMPS_S: f64 = 0.02;

/// A cut: its end where the machine is, how long it takes, which way it turns, how far.
type Cut = ([f64; 3], f64, Option<String>, f64);

/// The cuts of a file that another one calls.
fn cuts(shop: &Shop, file: &str, call: &str) -> Vec<Cut> {
    let part = format!("M3,10,20,3\n{}\n", call.replace("FILE", file));
    shop.write("call.sbp", part.as_bytes());
    let trace = shop.kerf("trace call.sbp --units mm");
    trace.exits(0);
    let (mut zero, mut here, mut cuts) = ([0.0; 3], [0.0; 3], Vec::new());
    for event in trace.events() {
        let kind = event["e"].as_str().unwrap();
        if kind == "location" {
            for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
                if let Some(set) = event["set"][letter].as_f64() {
                    zero[axis] += here[axis] - set;
                    here[axis] = set;
                }
            }
        }
        if kind != "move" && kind != "arc" {
            continue;
        }
        here = ["x", "y", "z"].map(|letter| event["to"][letter].as_f64().unwrap());
        if event["kind"] == "cut" {
            let to = [0, 1, 2].map(|axis| here[axis] + zero[axis]);
            let number = |name: &str| event[name].as_f64().unwrap();
            let time = number("t1") - number("t0");
            let turn = event.get("dir").and_then(Value::as_str).map(str::to_owned);
            cuts.push((to, time, turn, event["sweep"].as_f64().unwrap_or_default()));
        }
    }
    cuts
}

fn same(a: &Cut, b: &Cut) -> bool {
    let place = a.0.iter().zip(b.0).all(|(a, b)| (a - b).abs() < 1e-3);
    place && (a.1 - b.1).abs() < 0.02 * a.1 + RAMPS_S && a.2 == b.2 && (a.3 - b.3).abs() < 0.05
}

/// Both files cut the same, however they are called, and with the value of `#1` changed in both.
fn check(text: &str) {
    check_called(text, CALLS.len());
}

/// The same with the first ways to call a file.
fn check_called(text: &str, calls: usize) {
    let shop = Shop::new(&[]);
    let sbp = kept(&shop, text);
    for value in ["4", "7.5"] {
        shop.write("a.nc", text.replace("#1 = 4", &format!("#1 = {value}")).as_bytes());
        shop.write("a.sbp", sbp.replace("&p1 = 4", &format!("&p1 = {value}")).as_bytes());
        for call in &CALLS[..calls] {
            let (nc, sbp_cuts) = (cuts(&shop, "a.nc", call), cuts(&shop, "a.sbp", call));
            let first = nc.iter().zip(&sbp_cuts).find(|(a, b)| !same(a, b));
            assert_eq!(first, None, "#1 = {value}, {call}\n{sbp}");
            assert_eq!(nc.len(), sbp_cuts.len(), "#1 = {value}, {call}");
            assert!(nc.len() > 2, "{call}");
        }
    }
}

/// Checks the reason that variables are not kept.
fn check_refused(text: &str, line: u32, why: &str) {
    let shop = Shop::new(&[("a.nc", text)]);
    let did = shop.kerf("convert a.nc a.sbp --keep-variables --units mm");
    did.exits(0).complains("note[C004]").complains(why).complains(&format!("a.nc:{line}:1"));
}

#[test]
fn where_the_tool_is_counts_as_the_file_counts() {
    check(
        "G21 G90 G17 F600\n#1 = 4\nG0 X0 Y0 Z5\nG1 Z0\nG0 Z#5422\n\
         G1 X[#5420 + #1] Y0 Z#5422\nY[#5421 + 2]\nZ[#5422 - #1]\nM2\n",
    );
}

#[test]
fn a_block_is_calculated_before_it_is_done() {
    check(
        "G21 G90 F600\n#1 = 4\n#2 = -2\n#1=#2 #2=#1\nG0 X#1 Y#2 Z5\n\
         G1 X1 #3=#5420 #4=[#5420 + #1]\nX#3 Y#4\n#3=7 G1 X#3\nX#3\nM2\n",
    );
}

#[test]
fn slopes_keep_their_feed() {
    check(
        "G21 G90 F900\n#1 = 4\nG0 X0 Y0 Z20\nG1 X20 Y3 Z[20 - #1 * 2]\nX21 Z#1\nX60 Z0\nY2\nZ-20\n\
         X61 Y3 Z[0 - #1] F300\nM2\n",
    );
}

#[test]
fn helices_keep_their_feed() {
    check_called(
        "G21 G90 G17 F900\n#1 = 4\nG0 X0 Y0 Z5\nG1 Z0\nG2 X#1 Y#1 I#1 Z[0 - #1]\nG3 X0 Y0 I0 J[0 - #1] Z-20\n\
         G3 X0 Y0 I4 J0 Z-30\nG3 I[0 - #1] Z-90\nG2 X8 Y0 I4 J0 Z#5422\nM2\n",
        CALLS.len() - 1,
    );
}

#[test]
fn a_new_zero_counts_in_the_scale_of_the_file() {
    check("G21 G90 F600\n#1 = 4\nG0 X1 Y2 Z5\nG92 X[#1] Z0\nG1 X20 Y2 Z-1\nG1 X#5420 Y9\nX0\nM2\n");
}

#[test]
fn behind_a_change_of_tools_the_height_is_what_it_was() {
    check(
        "G21 G90 F600\n#1 = 4\nG0 X1 Y2 Z5\nG1 Z-1\nX#1\nT2 M6\nX9\nT3 M6\nG1 Z-2\nX[#1 + 2]\n\
         T4 M6\n#2 = #5422\nT5 M6\nX2\nZ[#2 - 1]\nM2\n",
    );
    // No height is said at all: what the tool has is what it keeps.
    check("G21 G90 F600\n#1 = 4\nG0 X1 Y2\nT2 M6\nG1 X#1\nX3\nY7\nM2\n");
}

#[test]
fn parameters_that_nothing_was_put_into_are_zero() {
    check(
        "G21 G90 F600\nO<bow> sub\nG1 X#1 Y#2\nO<bow> endsub\n#1 = 4\nG0 Z[#40 + 5]\n\
         O<bow> call [#1] [2]\nO<bow> call [#1 + 3]\nO1 if [#9 EQ 1]\n#8 = 5\nO1 endif\nG1 X#8\nM2\n",
    );
}

#[test]
fn numbers_below_zero_are_calculated_alike() {
    check(
        "G21 G90 F600\n#1 = 4\n#2 = [-3 ** 2]\n#3 = [-7 MOD 3]\n#4 = [7 MOD -3]\n\
         G0 X#2 Y#3 Z#4\nG1 X[0 - #1 - -2]\nY[-#1 ** 2]\nX[FUP[-2.5]] Y[FIX[-2.5]]\nM2\n",
    );
}

#[test]
fn a_loop_is_counted_as_the_nearest_whole_number() {
    check(
        "G21 G90 F600\n#1 = 4\nG0 X0\nO1 repeat [#1]\nG1 X[#5420 + 1]\nO1 endrepeat\n\
         O2 repeat [#1 - 1.6]\nG1 Y[#5421 + 1]\nO2 endrepeat\n\
         O3 repeat [[#1 + 1] / 2]\nG1 X[#5420 - 2]\nO3 endrepeat\nO4 repeat [3]\nG1 Z[#5422 - 1]\nO4 endrepeat\nM2\n",
    );
}

#[test]
fn a_mode_that_hangs_on_the_way_taken_is_not_kept() {
    let branch = |last: &str| {
        format!(
            "G21 G90 F600\n#1 = 4\nG0 X0\nO1 if [#1 EQ 4]\nG0 X5\nO1 else\nG1 X6\nO1 endif\n{last}\nM2\n"
        )
    };
    check_refused(&branch("Y9"), 9, "a motion (G0 to G3) that depends on the way taken");
    check(&branch("G1 Y9\nX3\nY2\nX1"));
    let around = "G21 G90 F600\n#1 = 0\nG0 X0\nO1 while [#1 LT 1]\nX5\nG1 Y1\n#1 = [#1 + 1]\nO1 endwhile\nM2\n";
    check_refused(around, 5, "depends on the way taken");
    let sub = "G21 G90 F600\nO1 sub\nG0 Z5\nO1 endsub\nG1 X1\nO1 call\nX5\nM2\n";
    check_refused(sub, 7, "depends on the way taken");
    let tool = "G21 G90 F600\nT1\nO1 if [#1 EQ 4]\nT2\nO1 endif\nM6\nG1 X1\nM2\n";
    check_refused(tool, 6, "M6 whose tool (T) depends on the way taken");
}

#[test]
fn what_labels_cannot_say_is_not_kept() {
    let twice = "G21 G90 F600\nO1 if [1]\nG1 X1\nO1 endif\nO1 if [1]\nG1 X2\nO1 endif\nM2\n";
    check_refused(twice, 5, "an O-word whose number or name stands twice");
    let circle = "G21 G90 F600\nO1 sub\nO3 if [#1 GT 0]\nO2 call [#1 - 1]\nO3 endif\nG1 X#1\nO1 endsub\n\
                  O2 sub\nO1 call [#1]\nO2 endsub\nO1 call [2]\nM2\n";
    check_refused(circle, 2, "a subroutine that calls itself");
    check_refused("G21 G90\nG1 X1 F600\nG2 X3 I1 P2\nM2\n", 3, "an arc of several turns");
    check_refused("G21 G90\nG0 X1 Z1\nM6\nG1 X2 F60\nM2\n", 3, "M6 without a tool (T)");
}
