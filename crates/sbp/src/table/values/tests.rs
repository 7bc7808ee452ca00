//! V commands, by the rows of the ledger.
#![allow(clippy::unwrap_used)]

use crate::testing::{FakeHost, check_as, rows, run, run_with};
use crate::{Dialect, Options, Session};
use kerf_program::settings::{AxisUnit, Driver, LinearUnit, Settings};
use kerf_program::{Axis, Command};

rows! {
    sbp_val_range: "VS,0" => "error greater than 0", "VC,,,,,,150" => "error 0-100", "VS,5,0" => "error greater than 0; at 0,0,0";
    ranges_are_named_in_the_users_unit: "VD,,,1⏎VU,,,,,.1" => "error at least 0.127", "VU,,,,,.001" => "error at least 0.005";

    sbp_val_va_base: "MX,9⏎VA,,,.75,,,,,0" => "3=0.75; 8=0", "MX,9⏎VA,2,,,,,0" => "1=2; 6=0";
    sbp_val_va_basekeep: "M3,5,5,5⏎VA,0,0,0" => "base 5,5,5; at 0,0,0; 6=5", "M3,5,5,5⏎VA,0,0,0⏎ST" => "at 5,5,5; moves 1";
    va_sets_one_axis_at_a_time: "M3,1,2,3⏎VA,,,.5" => "at 1,2,0.5; moves 1", "VA" => "at 0,0,0; moves 0", "VA,,,0,,,,,,0,,," => "no warning";
    va_a_and_b: "VD,,5⏎VA,,,,4,90,,,,1,2" => "4=4; 5=90; 9=1; 10=2";

    sbp_val_vb_params: "" => "41=0.1; 42=4; 43=1; 44=0.5", "VB,.2,5,2,.25,0,," => "41=0.2; 42=5; 43=2; 44=0.25";
    vb_refuses_what_makes_no_tab: "VB,,0" => "error greater than 0", "VB,-1" => "error 0 or greater", "VB,,,,,1,0" => "error at least 1", "VB,,,,,2" => "error one of 0, 1";

    sbp_val_vc_params: "VC,.5,9,9,2,+,20,3,1,.05,.1,A,9" => "23=0.5; 28=2; 29=3; 141=0.05; 142=0.1; no warning",
        "VC, 6.35, , , 10, 0, 10, 0, 0, 0, 0, Z, 8" => "23=6.35; 28=10; 29=0; no warning";
    vc_overlap: "VC,,,,,,100" => "error less than 100", "VC,,,,,,-1" => "error 0-100", "VC,,,,,,0" => "no warning";
    sbp_val_vc_safez: "" => "28=1", "VC,,,,.5⏎JH" => "at 0,0,.5; last jog";
    sbp_val_vc_safea: "VD,,4⏎MA,-.2⏎JH" => "at 0,0,1,1; 29=1";
    sbp_val_vc_trigger_axis: "VC,,,,,,,,1,,,A" => "no warning", "VC,,,,,,,,1,,,z" => "no warning", "VC,,,,,,,,1,,,B" => "error axis monitored must be one of Z, A";
    sbp_val_vc_trigger_out: "VC,,,,,,,,,,,,3" => "no warning", "VC,,,,,,,,,,,,12" => "no warning", "VC,,,,,,,,,,,,1" => "error one of 3, 5",
        "VC,,,,,,,,,,,,2" => "error one of", "VC,,,,,,,,,,,,4" => "error one of", "VC,,,,,,,,,,,,13" => "error one of", "VC,,,,,,,,1,.05,.1,Z,8" => "141=0.05; 142=0.1";
    plunge_directions: "VC,,,,,x" => "error plunge direction must be one of -, +";

    sbp_val_vd_axes: "VD,,5" => "27=5", "MA,1" => "error A axis not active", "VD,,2" => "error 3-6", "VD,,7" => "error 3-6";
    sbp_val_vd_units: "MX,1⏎VD,,,1" => "1=25.4; 23=6.35; 28=25.4; 71=50.8; 41=2.54; 42=101.6; 43=25.4; 44=12.7; 12=2438.4; 25=1",
        "MX,1⏎VD,,,1⏎VD,,,0" => "1=1; 23=0.25; 28=1; 71=2; 41=0.1; 42=4; 43=1; 44=0.5; 12=96; 25=0; moves 1";
    unit_values_follow_the_unit: "VD,,,1" => "31=15.74803", "VD,,,1⏎VD,,,0" => "31=400";
    ramp_speeds_follow_the_unit: "VD,,,1" => "81=10.16; 85=0.4";
    sbp_val_vd_aunits: "VD,,4,,2⏎MA,5⏎VD,,,1" => "4=5; at 0,0,0,5", "VD,,4⏎MA,1⏎VD,,,1" => "4=25.4", "VD,,4,1,0⏎MA,1" => "4=1; 25=1", "VD,,4,,1⏎MA,25.4⏎VD,,,,0" => "4=1";
    sbp_val_vd_bunits: "VD,,5⏎MB,90⏎VD,,,1" => "5=90", "VD,,5,,,0⏎MB,1⏎VD,,,1" => "5=25.4";
    turning_an_axis_into_degrees_keeps_its_numbers: "VD,,4⏎VS,,,2⏎VU,,,,500⏎VL,,,,,,,-5,5⏎ZT⏎MA,3⏎VD,,4,,2" => "4=3; 9=0; 74=2; 34=500; 17=-5; 18=5; 29=1; 84=0.4",
        "VD,,4⏎MA,3⏎VA,,,,1⏎VD,,4,,2⏎MA,90⏎VD,,4,,0" => "4=90; 9=2";
    sbp_val_vd_console_obs: "VD,,,,,,0" => "no warning", "VD" => "no warning", "VD,  ,,,,,,,,,,, 0, -7500,  11355,  4575" => "no warning";
    sbp_val_vd_version2: "VD,,3,0,0,2,1,0,.1,0,1,1,0,0,8800,4600,0,0,1,7" => "warning order of VD is that of version 3", "VD,,3,0,0,2,1,0,.1,0,1,1,0,0,8800,4600,0,0,1" => "no warning";

    sbp_val_vh_enable: "VH,1" => "error not enabled in VN", "VN,,,1⏎VH,1" => "99=1; no warning", "VH,0,,20,80" => "no warning";
    vh_ranges: "VH,0,,101" => "error 0-100", "VH,0,,,,,11" => "error 1-10", "VH,0,,,,0" => "error greater than 0";

    vi_ranges: "VI,17" => "error 1-16", "VI,0" => "error 1-16", "VI,,,,,Q" => "error one of X, Y, Z, A, B, C", "VI,,,,,,,,,6" => "error one of 2, 3, 4, 5";

    sbp_val_vl_err: "VL,10,5" => "error low limit of X is above", "VL,100" => "error above its high limit", "VL,,,,,,,,,,5,-5" => "error limit of B";
    vl_as_real_files_write_it: "VL,,,,,&low" => "error &LOW has no value", "&low=-4⏎VL,,,,,&low" => "15=-4; 16=6", "VL,0,96,0,48,-6,6,-6,6,1,-5,5,5" => "19=-5; no warning";

    sbp_val_vn_torch: "VN,,,1" => "99=1", "VN,,,2" => "99=0", "VN,,,5" => "99=0", "VN,,,6" => "error one of";
    sbp_val_vn_inmode: "VN,,,,1" => "91=1", "VN,,,,,2" => "92=2", "VN,,,,5" => "error one of 0, 1, 2, 3, 4";

    sbp_val_vo_params: "VO,1,2,1,0⏎M2,5,0" => "at 7,1,0; moves 1", "VO,1,2,1,0⏎MX,5" => "at 7,0,0", "VO,1,2,1" => "moves 0; at 0,0,0",
        "VO,1,2,1,0⏎M2,5,0⏎VO,2⏎M2,5,0" => "at 5,0,0", "VO,1,2,1⏎MX,5⏎VO,0⏎MX,6" => "at 6,0,0", "VO,3" => "error one of 0, 1, 2";
    sbp_val_vo_display: "VO,1,2,1,0⏎M2,5,0" => "1=7; 2=1";
    sbp_val_vo_reuse: "VO,1,2,1⏎VO,2⏎VO,1⏎MX,5" => "at 7,0,0";
    vo_in_relative_mode_counts_once: "SR⏎VO,1,2⏎MX,5⏎MX,5" => "at 12,0,0", "VO,1,2⏎MX,5⏎VO,2⏎SR⏎MX,1" => "at 6,0,0";

    ramp_speeds_of_a_fresh_machine: "" => "81=0.4; 82=0.4; 83=0.4; 84=0.4; 85=0.4; 86=0.4; 90=0.4";
    sbp_val_vr_rampspeed: "VR,1" => "81=1; 82=1; 83=0.4", "VR,,.5,.6,.7,.8,.9,1,1.1" => "83=0.5; 84=0.6; 85=0.7; 86=0.8; 88=0.9; 89=1; 90=1.1";
    sbp_val_vr_warn: "VR,1.5" => "81=1.5; warning is fast", "VR,.1" => "81=0.1; warning is slow", "VR,.2,1.2" => "no warning", "VD,,,1⏎VR,10.06, 10.06, , , 10.06, 10.06, , , 5.08, 5.08, 100, 3.81, 65, , , 5.08" => "no warning; 81=10.06",
        "VD,,5⏎VR,,,,90" => "85=90; no warning", "VR,0" => "error greater than 0";

    sbp_val_vs: "VS,3,1,2,50,8,4,4,100" => "71=3; 72=3; 73=1; 74=2; 75=50; 76=8; 77=8; 78=4; 79=4; 80=100";
    vs_keeps_what_is_blank: "VS,3,1⏎VS,,.5" => "71=3; 73=0.5", "VS,\"\",\"\",5,6" => "71=2; 74=5; 75=6";
    sbp_val_vs_oldorder: "VS, 1.25, .45, , 2.75, .80" => "71=1.25; 73=0.45; 75=2.75; 76=0.8; warning older order", "VS,1.25,.45,1,2.75,.8" => "no warning", "VS,1.25,,,,.8" => "no warning";
    sbp_val_vs_minspeed: "VS,.05" => "71=0.05; no warning", "VS,.01" => "error step interval divider of VU", "VD,,,1⏎VS,1.27" => "71=1.27", "VD,,,1⏎VS,1.2" => "error at least 1.27",
        "VD,,5⏎VS,,,,.01" => "75=0.01";

    vu_values: "VU,0" => "error other than 0", "VU,157.48,157.48,-157.48" => "33=-157.48", "VU,,,,,.001" => "error at least 0.005", "VU,,,,,,,,,,0" => "error 1-10", "VU,,,,,,,,,,11" => "error 1-10";
    vu_divider: "VU,,,,,,,,,,,,,,,4" => "150=4", "VU,,,,,,,,,,,,,,,101" => "error 1-100", "VU,,,,,,,,,,,,,,,0" => "error 1-100";
    a_unit_value_is_steps_for_the_users_unit: "VU,400" => "31=400", "VD,,,1⏎VU,16" => "31=16", "VD,,,1⏎VU,16⏎VD,,,0" => "31=406.4", "VD,,5⏎VU,,,,,,,,,13.8889⏎VD,,,1" => "35=13.8889";
    sbp_val_vv: "VV,&a=5" => "&a=5", "VV &a = 5" => "&a=5", "VV,&t=Table Surface" => "&t=Table Surface", "&a=1⏎VV,&a=&a+1" => "&a=2", "VV,5" => "error an assignment is expected", "VV" => "error assignment expected";
}

fn settings(text: &str) -> Settings {
    let ran = run_with(text, FakeHost::default(), Session::default());
    assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
    ran.session.settings
}

/// What the settings are inside a file, before temporary values return.
fn within(text: &str) -> Settings {
    let ran = run(text);
    assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
    let told = ran.commands.iter().filter_map(|c| match &c.command {
        Command::Settings(s) => Some(s),
        _ => None,
    });
    // The last one told is the restoring at the end, when anything was to restore.
    let all: Vec<_> = told.collect();
    let end = all.len().saturating_sub(usize::from(ran.session.settings == **all[all.len() - 1]));
    all[..end.max(1)].last().map_or_else(Settings::default, |s| (***s).clone())
}

fn present(text: &str, letters: &str) -> String {
    crate::table::find(letters).unwrap().present(&settings(text)).unwrap()
}

#[test]
fn a_blank_keeps_what_was() {
    let before = Settings::default();
    let mut after = settings("VC,.5");
    assert_eq!(after.cutter.diameter_mm, 12.7);
    after.cutter.diameter_mm = before.cutter.diameter_mm;
    assert_eq!(after, before);
    let mut after = settings("VC,,,,1.5");
    assert_eq!(after.cutter.safe_z_mm, Some(1.5 * 25.4));
    after.cutter.safe_z_mm = before.cutter.safe_z_mm;
    assert_eq!(after, before);
}

#[test]
fn a_refused_line_changes_nothing() {
    for line in ["VS,5,.01", "VL,,,,,,,,,1,5,-5", "VC,.5,,,,,150", "VH,1,.5,10", "VR,.5,.6,0"] {
        let ran = run(line);
        assert!(ran.error.is_some(), "{line}");
        assert_eq!(ran.session.settings, Settings::default(), "{line}");
    }
}

#[test]
fn sbp_val_va_loc() {
    let strict = Options { dialect: Dialect::Strict, ..Options::default() };
    check_as(strict.clone(), "MX,2⏎VA,5.3", "1=5.3; 6=2; base 2,0,0; moves 1");
    check_as(strict.clone(), "M3,1,2,3⏎VA,,,.5", "1=1; 2=2; 3=0.5; moves 1");
    check_as(strict, "MX,2⏎VA,,,.75,,,,,0", "3=0.75; 8=0; base 2,0,0");
}

#[test]
fn vb_prepares_a_series() {
    let tabs = |text: &str| within(text).tabs;
    let on = tabs("VB,,,,,1,2,1");
    assert!(on.on && on.count == Some(2) && on.start_mm == Some(25.4));
    let again = tabs("VB,,,,,1,2,1⏎VB,,,,,1");
    assert!(again.on && again.count.is_none() && again.start_mm.is_none());
    let after = settings("VB,.2,,,,1,2,1").tabs;
    assert!(!after.on && after.count.is_none() && after.up_mm == 0.2 * 25.4, "ends with the file");
}

#[test]
fn plunge_signs_of_old_and_new_files() {
    use kerf_program::settings::PlungeSign::{Minus, Plus};
    for (text, sign) in [("-", Minus), ("+", Plus), ("0", Minus), ("-1", Minus), ("1", Plus)] {
        assert_eq!(settings(&format!("VC,,,,,{text}")).cutter.plunge, sign, "{text}");
    }
}

#[test]
fn the_triggered_output_belongs_into_files() {
    let typed = Options { typed: true, ..Options::default() };
    check_as(typed.clone(), "VC,,,,,,,,1", "error only in part files");
    check_as(typed, "VC,.5,,,,,,,0", "23=0.5");
    assert!(within("VC,,,,,,,,1⏎VS,3").cutter.trigger.active);
    assert!(!settings("VC,,,,,,,,1").cutter.trigger.active, "ends with the file");
}

#[test]
fn sbp_val_vd_params() {
    let text = "VD,,4,1,2,2,,1,2.54,0,1,1,0,0,8800,4600,0,1,0";
    let s = settings(text);
    assert_eq!((s.axis_count, s.linear_unit), (4, LinearUnit::Mm));
    assert_eq!(s.rotary_units[..2], [AxisUnit::Degrees, AxisUnit::Degrees]);
    assert!(s.display.comments && s.display.progress && !s.display.easy);
    assert!((s.display.keypad_fixed_mm - 2.54).abs() < 1e-12);
    assert_eq!(s.display.message_twips, [0.0, 0.0, 8800.0, 4600.0]);
    assert_eq!(present(text, "VD"), "VD,,4,1,2,2,1,1,2.54,0,1,1,0,0,8800,4600,0,1,0");
    assert_eq!(present("", "VD"), "VD,,3,0,0,2,1,0,0.1,0,1,1,0,0,8800,4600,0,0,1");
}

#[test]
fn sbp_val_vd_units_keypad() {
    assert_eq!(settings("").display.keypad_fixed_mm, 2.54);
    let shown = |text: &str| crate::table::find("VD").unwrap().params[7].present(&settings(text));
    assert_eq!(shown(""), Some("0.1".into()));
    assert_eq!(shown("VD,,,1"), Some("2.54".into()));
    assert_eq!(shown("VD,,,,,,,,.05"), Some("0.05".into()));
}

#[test]
fn sbp_val_vd_units_ramps() {
    let text = present("VD,,,1", "VR");
    assert_eq!(
        text,
        "VR,10.16,10.16,10.16,0.4,10.16,10.16,10.16,0.4,5.08,5.08,100,3.81,65,,,5.08,6.35"
    );
    assert_eq!(settings("VD,,,1").ramps, Settings::default().ramps, "motion stays the same");
}

#[test]
fn sbp_val_vd_units_steps() {
    for (text, shown) in [("MX,1", "400"), ("VD,,,1⏎MX,25.4", "15.74803")] {
        let ran = run(&format!("{text}⏎&steps=%(31)"));
        assert_eq!(ran.variable("steps"), shown);
        let steps = ran.session.settings.resolution.steps_per_unit[Axis::X];
        assert!((steps * ran.session.position[Axis::X] - 400.0).abs() < 1e-9, "{text}");
    }
}

#[test]
fn vd_is_told_even_when_nothing_changes() {
    let told = |text: &str| {
        run(text).commands.iter().filter(|c| matches!(c.command, Command::Settings(_))).count()
    };
    assert_eq!((told("VD,,,,,,,0"), told("VD"), told("VC,.25")), (1, 1, 0));
}

#[test]
fn sbp_val_vh_params() {
    assert_eq!(present("", "VH"), "VH,0,0.25,0,0,5.4,3,0");
    let height = settings("VN,,,2⏎VH,0,.1,20,80,10,5,200").height;
    assert_eq!((height.rate, height.low_percent, height.high_percent), (0.1, 20.0, 80.0));
    assert_eq!((height.frequency_khz, height.low_cycle, height.temperature), (10.0, 5.0, 200.0));
    let on = settings("VN,,,2⏎VH,0,,20,80⏎VH,1").height;
    assert!(on.on && on.low_percent == 20.0 && on.high_percent == 80.0);
}

#[test]
fn sbp_val_vi_params() {
    let inside = within("VI,4,,,,X,Y,Z,A,5,B,C,1⏎SV⏎VS,3").driver;
    assert_eq!(inside, Driver { port: 4, ..Settings::default().driver });
    assert_eq!(settings("VI,4").driver, Settings::default().driver, "returns at the end");
    assert_eq!(settings("VI,4⏎SV").driver.port, 4);
}

#[test]
fn channels_are_given_to_axes() {
    use Axis::{A, B, C, X, Y, Z};
    let channels = |text: &str| within(&format!("{text}⏎SV⏎VS,3")).driver.channels;
    assert_eq!(channels("VI,,,,,Y,X"), [Y, X, Z, A, B, C]);
    assert_eq!(channels("VI,,,,,,, A, Z"), [X, Y, A, Z, B, C]);
    assert_eq!(channels("VI,,,,,,,B,,,Z"), [X, Y, B, A, Z, C]);
    assert_eq!(run("VI,,,,,Y,X⏎&a=%(36)⏎&b=%(37)").variable("a"), "Y");
    assert_eq!(channels("VI,,,,,,x"), [X, X, Z, A, B, C]);
}

#[test]
fn sbp_val_vl_params() {
    let text = "VL,0,96,0,48,-6,6,-6,6,1,-360,360";
    let seen = "11=0; 12=96; 13=0; 14=48; 15=-6; 16=6; 17=-6; 18=6; 19=-360; 20=360";
    check_as(Options::default(), text, seen);
    assert!(settings(&format!("{text}⏎SV")).limits.check);
}

#[test]
fn sbp_val_vl_check() {
    let mut session = Session::default();
    session.settings.limits.check = true;
    for off in ["VL,,,,,,,,,0", "SF,0"] {
        let ran = run_with(&format!("{off}⏎SV"), FakeHost::default(), session.clone());
        assert!(!ran.session.settings.limits.check, "{off}");
        let ran = run_with(off, FakeHost::default(), session.clone());
        assert!(ran.session.settings.limits.check, "{off} returns at the end");
    }
}

#[test]
fn sbp_val_vn_params() {
    let inputs: Vec<u8> = (0..11).map(|i| i % 5).collect();
    let outputs: Vec<u8> = (0..12).map(|i| i % 6).collect();
    let modes = inputs.iter().chain(&outputs).map(u8::to_string).collect::<Vec<_>>().join(",");
    let io = settings(&format!("VN,1,1,2,{modes}")).io;
    assert_eq!(io.inputs, [0, 1, 2, 0, 3, 4, 0, 1, 2, 3, 4, 0], "input 4 has none of its own");
    assert_eq!(io.outputs[..], outputs);
    assert!(io.input4_normally_open && io.analog == 2);
}

#[test]
fn sbp_val_vn_temp() {
    assert!(!within("VN,0⏎VS,3").io.limits_active);
    assert!(settings("VN,0").io.limits_active);
    assert!(!settings("VN,0⏎SV").io.limits_active);
    assert_eq!(settings("VN,,,1").io.analog, 1, "the rest stays");
}

fn called(call: &str, part: &str) -> crate::testing::Ran {
    let mut host = FakeHost::default();
    host.files.insert("part.sbp".into(), part.into());
    run_with(call, host, Session::default())
}

#[test]
fn sbp_val_vo_adds() {
    called("FP,part.sbp,2", "VO,1,1\nMX,2").ends_at(5.0, 0.0, 0.0);
    called("MX,10⏎FP,part.sbp,2,,,,2", "VO,1,1\nMX,2").ends_at(15.0, 0.0, 0.0);
}

#[test]
fn sbp_val_vo_end() {
    let session = run("VO,1,2⏎MX,5").ends_at(7.0, 0.0, 0.0).session.clone();
    let typed = Options { typed: true, ..Options::default() };
    let next = crate::testing::run_as("MX,5", FakeHost::default(), session, typed);
    next.ends_at(5.0, 0.0, 0.0);
}

#[test]
fn what_is_typed_line_by_line_is_one_session() {
    let typed = Options { typed: true, ..Options::default() };
    let lines = |text: &str| {
        let mut session = Session::default();
        for line in text.split('⏎') {
            let ran = crate::testing::run_as(line, FakeHost::default(), session, typed.clone());
            assert!(ran.error.is_none(), "{line}: {:?}", ran.error);
            session = ran.session;
        }
        session.settings.to_user(session.frame.working(session.position)).first3()
    };
    let near = |at: [f64; 3], x: f64, y: f64| (at[0] - x).abs() < 1e-9 && (at[1] - y).abs() < 1e-9;
    assert!(near(lines("VO,1,2⏎MX,5⏎SR⏎MX,1"), 8.0, 0.0), "the offset counts once");
    assert!(near(lines("MX,5⏎MD,4,90R"), 5.0, -4.0), "turns from the last move");
    assert!(near(lines("M2,1,1⏎SP⏎MX,5⏎ZX⏎SM⏎MY,2"), 1.0, 2.0), "preview is undone later");
}

#[test]
fn sbp_val_vp_params() {
    assert_eq!(present("", "VP"), "VP,6,96,48,6,0,1,1,1");
    assert_eq!(present("VD,,,1", "VP"), "VP,152.4,2438.4,1219.2,152.4,0,1,1,1");
    assert_eq!(present("VP,12,24,18,4,1,0,0,0", "VP"), "VP,12,24,18,4,1,0,0,0");
}

#[test]
fn sbp_val_vr_params() {
    let factory = "VR,0.4,0.4,0.4,0.4,0.4,0.4,0.4,0.4,0.2,0.2,100,0.15,65,,,0.2,0.25";
    assert_eq!(present("", "VR"), factory);
    let text = "VR,0.5,0.6,0.7,0.8,0.9,1,1.1,1.2,0.3,0.35,200,0.05,90,,,0.25,0.5";
    assert_eq!(present(text, "VR"), text);
}

#[test]
fn sbp_val_vu_params() {
    check_as(
        Options::default(),
        "VU,401,402,403,404,.01,,,,20,2,3,4,5,6,7,1",
        "31=401; 32=402; 33=403; 34=404; 35=20; 151=2; 152=3; 153=4; 154=5; 155=6; 150=7",
    );
    let inside = within("VU,,,,,.01,,,,,,,,,,,1⏎SV⏎VS,3").resolution;
    assert!(inside.no_shift && (inside.circle_mm - 0.254).abs() < 1e-12);
}

/// Working heights in inches that straight moves reach, with the X they reach them at.
fn profile(text: &str) -> Vec<[f64; 2]> {
    let ran = run(text);
    assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
    ran.moves().into_iter().map(|(_, [x, _, z])| [x, z]).collect()
}

/// A tab at depth -.5 with the factory values: up, flat, down from `x` on.
fn tab(x: f64) -> Vec<[f64; 2]> {
    vec![[x, -0.5], [x + 0.5, -0.4], [x + 1.5, -0.4], [x + 2.0, -0.5]]
}

fn tabs_at(starts: &[f64]) -> Vec<[f64; 2]> {
    starts.iter().flat_map(|x| tab(*x)).collect()
}

/// The corners of tabs among the corners of a path.
fn tab_corners(text: &str) -> Vec<[f64; 2]> {
    let path = profile(text);
    let high = |p: &[f64; 2]| (p[1] + 0.4).abs() < 1e-6;
    let mut corners = Vec::new();
    for window in path.windows(2).filter(|w| high(&w[0]) != high(&w[1])) {
        corners.extend_from_slice(window);
    }
    corners
}

#[test]
fn sbp_val_vb_on_off() {
    let text = "MZ,-.5⏎VB,,,,,1⏎MX,20⏎VB,,,,,0⏎MX,40";
    assert_eq!(tab_corners(text), tabs_at(&[4.0, 10.0, 16.0]));
    assert!(!settings(text).tabs.on, "the state ends with the file");
}

#[test]
fn tabs_of_a_series_are_counted_and_started_where_told() {
    assert_eq!(tab_corners("MZ,-.5⏎VB,,,,,1,2⏎MX,40"), tabs_at(&[4.0, 10.0]));
    assert_eq!(tab_corners("MZ,-.5⏎VB,,,,,1,,1⏎MX,20"), tabs_at(&[1.0, 7.0, 13.0]));
    let again = "MZ,-.5⏎VB,,,,,1,1⏎MX,20⏎VB,,,,,1,1⏎MX,40";
    assert_eq!(tab_corners(again), tabs_at(&[4.0, 24.0]), "each series counts its own");
}

#[test]
fn sbp_val_vb_lastpass() {
    let part = "MZ,-.5\nMX,20\nJZ,1\nJX,0";
    let ran = called("FP,part.sbp,,,,3,,,1", part);
    let highs = ran.moves().iter().filter(|(_, p)| (p[2] + 0.4).abs() < 1e-6).count();
    assert_eq!(highs, 6, "three tabs, on the last of three passes: {:?}", ran.moves());
}

/// Centre and end of each arc in inches of the machine frame.
fn arcs(text: &str) -> Vec<([f64; 2], [f64; 3])> {
    let ran = run(text);
    assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
    let inches = |v: f64| (v / 25.4 * 1e6).round() / 1e6;
    let of = |c: &kerf_program::Sourced| match &c.command {
        Command::Arc(arc) => Some((arc.centre.map(inches), arc.to.first3().map(inches))),
        _ => None,
    };
    ran.commands.iter().filter_map(of).collect()
}

#[test]
fn sbp_val_vc_diam() {
    assert_eq!(arcs("VC,.5⏎CC,4,O")[0].0, [0.0, -2.25]);
    assert_eq!(arcs("CC,4,O")[0].0, [0.0, -2.125]);
    assert_eq!(run("VC,.5⏎&d=%(23)").variable("d"), "0.5");
}

#[test]
fn sbp_val_vc_overlap() {
    let step = |text: &str| {
        let arcs = arcs(text);
        let radius = |i: usize| arcs[i].1[1] - arcs[i].0[1];
        ((radius(0) - radius(1)) * 1e6).round() / 1e6
    };
    assert_eq!(step("CC,4,T,1,,,,,,,2"), 0.225);
    assert_eq!(step("VC,,,,,,50⏎CC,4,T,1,,,,,,,2"), 0.125);
    run("VC,,,,,,100").fails_with("less than 100");
}

#[test]
fn sbp_val_vc_plungedir() {
    let down = arcs("VC,,,,,+⏎CC,4,T,1,0,360,.25");
    assert_eq!(down[0].1[2], 0.25, "deeper is positive");
    let warned = |text: &str| {
        let ran = run(text);
        ran.commands.iter().any(|c| matches!(&c.command, Command::Diagnostic(_)))
    };
    assert!(warned("CC,4,T,1,0,360,.25") && !warned("VC,,,,,+⏎CC,4,T,1,0,360,.25"));
    assert!(warned("VC,,,,,+⏎CC,4,T,1,0,360,-.25") && !warned("CC,4,T,1,0,360,-.25"));
}
