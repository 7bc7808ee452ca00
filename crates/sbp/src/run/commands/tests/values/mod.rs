//! V commands, by the rows of the ledger.
#![allow(clippy::unwrap_used)]

mod cuts;
mod rows;

use crate::testing::{FakeHost, check_as, run, run_with};
use crate::{Dialect, Options, Session};
use kerf_program::settings::{AxisUnit, Driver, LinearUnit, Settings};
use kerf_program::{Axis, Command};

fn settings(text: &str) -> Settings {
    let ran = run_with(text, FakeHost::default(), Session::default());
    assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
    ran.session.settings
}

/// Returns the settings inside a file, before temporary values return.
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
    assert_eq!(channels("VI,,,,,,x,y,z"), [X, X, Y, Z, B, C]);
}

#[test]
#[allow(non_snake_case)]
fn sbp_val_vd_bunits__mm_stays() {
    use kerf_program::settings::{AxisUnit, LinearUnit};
    let unit = |text: &str| settings(text).axis_unit(Axis::B);
    let (inch, mm) = (AxisUnit::Linear(LinearUnit::Inch), AxisUnit::Linear(LinearUnit::Mm));
    // B in mm on a machine in inches: VD without its field leaves it so, as the settings files of UR are.
    for line in ["VD,,5,0", "VD,,,0", "VD,,5", "VD,,,0,,,,1"] {
        assert_eq!(unit(&format!("VD,,5,0,2,1⏎{line}")), mm, "{line}");
    }
    assert_eq!(unit("VD,,5,0,2,1⏎VD,,,1"), mm);
    // An axis that was in the unit of the machine follows it.
    assert_eq!((unit("VD,,5,0,2,0⏎VD,,,1"), unit("VD,,5,1,2,1⏎VD,,,0")), (mm, inch));
    assert_eq!(unit("VD,,5,0,2,2⏎VD,,,1"), AxisUnit::Degrees);
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
    let first = crate::table::find("VR").and_then(|spec| spec.params[0].factory());
    assert_eq!(first.as_deref(), Some("0.4"));
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

#[test]
fn sbp_val_vu_circres() {
    let chords = |text: &str| {
        let ran = crate::testing::run(text);
        let arc = ran.commands.iter().find_map(|c| match &c.command {
            kerf_program::Command::Arc(arc) => Some(arc.chords),
            _ => None,
        });
        (arc, ran.error.is_some())
    };
    assert_eq!(chords("CC,4"), (Some(252), false));
    assert_eq!(chords("VU,,,,,.005⏎CC,4"), (Some(2514), false));
    assert_eq!(chords("VU,,,,,.001⏎CC,4"), (None, true));
}

/// Returns the value that a fill-in sheet shows of VR, by position from 1.
fn vr_shows(text: &str, position: usize) -> String {
    let settings = settings(text);
    let lines = crate::table::settings_lines(&settings);
    let vr = lines.iter().find(|line| line.starts_with("VR")).unwrap();
    vr.split(',').nth(position).unwrap().trim().to_owned()
}

#[test]
fn sbp_val_vr_3d() {
    assert_eq!(vr_shows("VR,1", 11), "100");
    assert_eq!(vr_shows("VR,,,,,,,,,,,200", 11), "200");
}

#[test]
fn sbp_val_vr_mindist() {
    assert_eq!(
        (vr_shows("VR,1", 12), vr_shows("VR,,,,,,,,,,,,.05", 12)),
        ("0.15".into(), "0.05".into())
    );
}

#[test]
fn sbp_val_vr_corner() {
    assert_eq!(
        (vr_shows("VR,1", 13), vr_shows("VR,,,,,,,,,,,,,90", 13)),
        ("65".into(), "90".into())
    );
}

#[test]
fn sbp_val_vr_keypad() {
    // From .4 to 2.4 in/s in .2 in: the acceleration that the rate stands for.
    let acceleration = |text: &str| {
        let rate_mm = settings(text).ramps.keypad_rate_mm;
        let mm_s2 = kerf_program::settings::Ramps::acceleration_mm_s2(0.4 * 25.4, rate_mm);
        (mm_s2 / 25.4 * 1e6).round() / 1e6
    };
    assert_eq!(acceleration("VR,1"), 14.0);
    assert_eq!(acceleration(&format!("VR{}.4", ",".repeat(16))), 7.0);
    assert_eq!(vr_shows("VR,1", 16), "0.2");
}
