//! System variables, by the rows of the ledger.
#![allow(clippy::unwrap_used)]

use super::{LAST, VERSION, system_variables};
use crate::testing::{FakeHost, check_as, rows, run, run_with};
use crate::{Dialect, Options, Session};

rows! {
    sbp_sys_001_005: "VD,,5⏎M5,1,2,3,4,5" => "1=1; 2=2; 3=3; 4=4; 5=5";
    sbp_sys_006_010: "ZT⏎MX,2⏎ZX" => "1=0; 6=2", "VD,,5⏎ZT⏎M5,1,2,3,4,5⏎Z5" => "6=1; 7=2; 8=3; 9=4; 10=5";
    sbp_sys_011_020: "VL,0,96,0,48,-6,6,-5,5,0,-360,360" => "11=0; 12=96; 13=0; 14=48; 15=-6; 16=6; 17=-5; 18=5; 19=-360; 20=360";
    sbp_sys_021: "SR" => "21=1", "SR⏎SA" => "21=0";
    sbp_sys_022: "SP" => "22=1", "SP⏎SM" => "22=0", "" => "22=0";
    sbp_sys_023: "VC,.375" => "23=0.375; 20=360";
    sbp_sys_025: "" => "25=0", "VD,,,1" => "25=1", "VD,,,1⏎IF %(25)=1 THEN GOTO UNIT_ERROR⏎MX,1⏎END⏎UNIT_ERROR:⏎&seen=guard" => "&seen=guard; 25=1; moves 0";
    sbp_sys_027: "VD,,4" => "27=4", "" => "27=3";
    sbp_sys_028: "VC,,,,1.5" => "28=1.5", "VC,,,,OFF" => "28=";
    sbp_sys_029: "" => "29=1", "VC,,,,,,,2" => "29=2";
    sbp_sys_030: "VD,,5" => "30=5", "" => "30=3";
    sbp_sys_031_035: "VU,400,400,800,500,,,,,13.8889" => "31=400; 32=400; 33=800; 34=500; 35=13.8889";
    sbp_sys_036_040: "" => "36=X; 37=Y; 38=Z; 39=A; 40=B", "VI,,,,,Z,Y,X,B,,A" => "36=Z; 37=Y; 38=X; 39=B; 40=A";
    sbp_sys_041_044: "" => "41=0.1; 42=4; 43=1; 44=0.5", "VB,.2,6,1.5,.75" => "41=0.2; 42=6; 43=1.5; 44=0.75";
    sbp_sys_046: "" => "46=0", "VN,,,,,,1" => "46=1", "VN,,,,,,2" => "46=1", "VN,,,,,,3" => "46=0";
    sbp_sys_047: "" => "47=0", "VN,,1" => "47=1";
    the_file_at_the_top_has_a_name: "" => "60=test.sbp";
    without_a_file_offset: "M3,10,4,.5" => "61=0; 62=0; 63=0";
    without_proportions: "" => "66=1; 67=1; 68=1";
    sbp_sys_071_075: "VS,3,1,2,50" => "71=3; 72=3; 73=1; 74=2; 75=50";
    sbp_sys_076_080: "VS,,,,,8,4,5,90" => "76=8; 77=8; 78=4; 79=5; 80=90";
    sbp_sys_081_085: "" => "81=0.4; 82=0.4; 83=0.4; 84=0.4; 85=0.4";
    sbp_sys_086_090: "" => "86=0.4; 87=0.4; 88=0.4; 89=0.4; 90=0.4", "VR,,,,,.5,.6,.7,.8" => "83=0.4; 86=0.5; 87=0.5; 88=0.6; 89=0.7; 90=0.8";
    sbp_sys_091_098: "VN,,,,2" => "91=2; 92=0; 98=0", "VN,,,,,,,,,,4" => "98=4; 97=0";
    input_4_is_always_a_stop: "" => "94=4", "VN,,1" => "94=3";
    sbp_sys_099: "" => "99=0", "VN,,,1" => "99=1", "VN,,,2" => "99=0";
    sbp_sys_100: "SO,4,-4⏎SO,1,1⏎SO,4,1" => "100=9", "SO,12,1" => "100=0";
    sbp_sys_101_108: "SO,3,1" => "103=1; 101=0; 108=0", "SO,8,1" => "108=1";
    sbp_sys_109: "" => "109=-1", "SO,4,-4" => "109=-4";
    sbp_sys_111_122: "VN,,,,,,,,,,,,,,,,,3" => "113=3; 111=0; 122=0", "VN,,,,,,,,,,,,,,,,,,,,,,,,,,5" => "122=5";
    sbp_sys_123: "VD,,5" => "123=0", "VD,,5⏎MI,B,1,30" => "123=1", "VD,,5⏎MI,B,1,30⏎MI,B,1,0" => "123=0";
    sbp_sys_131_134: "VN,,,,,,,,,,,,,,4" => "134=4; 131=0", "VN,,,,,,,,,,,1" => "131=1";
    sbp_sys_135: "SO,9,1⏎SO,12,1" => "135=9", "SO,8,1" => "135=0";
    sbp_sys_136_139: "SO,11,1" => "138=1; 136=0; 139=0";
    sbp_sys_141_142: "VC,,,,,,,,1,.05,.1,Z,8" => "141=0.05; 142=0.1";
    sbp_sys_144_145: "VD,,6⏎MC,30" => "144=30; 145=0", "VD,,6⏎ZT⏎MC,30⏎ZC" => "144=0; 145=30";
    sbp_sys_150: "" => "150=1", "VU,,,,,,,,,,,,,,,4" => "150=4";
    sbp_sys_151_156: "" => "151=1; 152=1; 153=1; 154=1; 155=1; 156=1", "VU,,,,,,,,,,5" => "151=5; 152=1";
    sbp_lang_sysvar_units: "MX,1" => "1=1", "MX,1⏎VD,,,1" => "1=25.4";
    sbp_lang_sysvar_unknown: "&a=%(500)" => "error no system variable 500", "&a=%(0)" => "error no system variable 0", "&a=%(162)" => "error no system variable 162",
        "&a=%(1.5)" => "error no system variable 1.5", "&a=%(-1)" => "error no system variable";
    sbp_lang_sysvar_computed: "&p=1⏎MX,3⏎&a=%(&p)⏎&b=%(70+&p)" => "&a=3; &b=2";
}

#[test]
fn sbp_sys_unassigned() {
    let ranges = [146..=149, 157..=161];
    let single = [24, 26, 45, 59, 64, 65, 69, 70, 110, 124, 125, 130, 140, 143];
    let numbers: Vec<u8> = single.into_iter().chain(ranges.into_iter().flatten()).collect();
    for number in &numbers {
        let warning = format!("{number}=; warning system variable {number} is not assigned");
        check_as(Options::default(), "", &warning);
    }
    let assigned = system_variables().map(|v| v.number);
    let all: std::collections::BTreeSet<u8> = assigned.chain(numbers).collect();
    assert!(all.into_iter().eq(1..=LAST), "every number is one or the other");
}

#[test]
fn numbers_stand_once_and_in_order() {
    let numbers: Vec<u8> = system_variables().map(|v| v.number).collect();
    assert!(numbers.is_sorted_by(|a, b| a < b), "{numbers:?}");
    assert!(system_variables().all(|v| !v.name.is_empty() && !v.unit.is_empty()));
}

#[test]
fn the_version_names_the_program() {
    assert!(VERSION.starts_with("kerf ") && VERSION.contains('.'));
    assert_eq!(run("&v=%(48)").variable("v"), VERSION);
    assert_eq!(run("&v=%(49)").variable("v"), "0");
}

/// The variable with inputs 1 … 12 on as listed.
fn with_inputs(on: &[usize], number: u8) -> String {
    let mut host = FakeHost::default();
    on.iter().for_each(|n| host.inputs[*n] = true);
    run_with(&format!("&v=%({number})"), host, Session::default()).variable("v")
}

#[test]
fn sbp_sys_050() {
    assert_eq!(with_inputs(&[1, 3], 50), "5");
    assert_eq!(with_inputs(&[8, 9], 50), "128");
}

#[test]
fn sbp_sys_051_058() {
    for number in 51..=58 {
        let on = if number == 53 { "1" } else { "0" };
        assert_eq!(with_inputs(&[3], number), on, "{number}");
    }
    assert_eq!(with_inputs(&[8], 58), "1");
}

#[test]
fn sbp_sys_126_129() {
    for number in 126..=129 {
        let on = if number == 127 { "1" } else { "0" };
        assert_eq!(with_inputs(&[10], number), on, "{number}");
    }
}

#[test]
fn inputs_are_read_when_motion_has_come_to_rest() {
    let host = FakeHost { busy: 4, ..FakeHost::default() };
    let ran = run_with("MX,1⏎&v=%(24)⏎&w=%(51)", host, Session::default());
    assert_eq!((ran.variable("w"), ran.host.busy), ("0".into(), 0));
}

#[test]
fn z_is_where_torch_height_has_it_and_the_others_are_where_they_were_sent() {
    let places = |on: u8| {
        let strays = Some([254.0, 0.0, 50.8, 0.0, 0.0, 0.0]);
        let host = FakeHost { strays_to: strays, ..FakeHost::default() };
        let text = format!("VN,,,1⏎VH,{on}⏎MX,1⏎&x=%(1)⏎&z=%(3)");
        let ran = run_with(&text, host, Session::default());
        (ran.variable("x"), ran.variable("z"))
    };
    assert_eq!(places(1), ("1".into(), "2".into()));
    assert_eq!(places(0), ("1".into(), "0".into()));
}

fn nested(call: &str, part: &str) -> crate::testing::Ran {
    let mut host = FakeHost::default();
    host.files.insert("part.sbp".into(), part.into());
    run_with(call, host, Session::default())
}

#[test]
fn sbp_sys_060() {
    let ran = nested("&a=%(60)⏎FP,part.sbp⏎&c=%(60)", "&b=%(60)");
    let names = ["A", "B", "C"].map(|v| ran.variable(v));
    assert_eq!(names, ["test.sbp", "part.sbp", "test.sbp"]);
}

#[test]
fn sbp_sys_061_063() {
    let part = "&x=%(61)\n&y=%(62)\n&z=%(63)";
    let ran = nested("M3,10,4,.5⏎FP,part.sbp,,,,,1⏎&after=%(61)", part);
    assert_eq!(["X", "Y", "Z", "AFTER"].map(|v| ran.variable(v)), ["10", "4", "0.5", "0"]);
}

#[test]
fn sbp_sys_066_068() {
    let part = "&x=%(66)\n&y=%(67)\n&z=%(68)";
    let ran = nested("FP,part.sbp,2,3,.5⏎&after=%(66)", part);
    assert_eq!(["X", "Y", "Z", "AFTER"].map(|v| ran.variable(v)), ["2", "3", "0.5", "1"]);
}

#[test]
fn base_coordinates_are_base_minus_working_unless_told_otherwise() {
    let program = "MX,7⏎VA,2";
    check_as(Options::default(), program, "1=2; 6=5; base 7");
    let strict = Options { dialect: Dialect::Strict, ..Options::default() };
    check_as(strict, program, "1=2; 6=7; base 7");
    let asked_for = Options { base_locations: true, ..Options::default() };
    check_as(asked_for, program, "1=2; 6=7; base 7");
}

#[test]
fn shipped_tool_changers_reach_places_in_base_coordinates() {
    // From a tool's own zero to a place in base coordinates, and back to the base frame.
    run("ZT⏎MX,7⏎VA,2⏎JX,30-%(6)").ends_at(25.0, 0.0, 0.0);
    let ran = run("ZT⏎MZ,7⏎VA,,,2⏎JZ,30-%(8)⏎VA,,,%(3)+%(8),,,,,0⏎&left=%(8)");
    ran.ends_at(0.0, 0.0, 30.0);
    assert_eq!(ran.variable("left"), "0");
}

#[test]
fn the_console_can_read_them_at_any_time() {
    let program = crate::read("a.sbp".into(), b"MX,2");
    let mut run = crate::Interpreter::new(program, Session::default(), Options::default());
    let mut host = FakeHost::default();
    assert_eq!(run.system_variable(&mut host, 25), Some(crate::Value::Number(0.0)));
    assert_eq!(run.system_variable(&mut host, 24), Some(crate::Value::Empty));
    assert_eq!(run.system_variable(&mut host, 200), None);
    host.busy = 1;
    let mut out = Vec::new();
    while run.position() == Default::default() {
        run.step(&mut host, &mut out);
    }
    assert_eq!(run.system_variable(&mut host, 51), None, "still moving");
    assert_eq!(run.system_variable(&mut host, 51), Some(crate::Value::Number(0.0)));
}
