//! Tests that a V command reads back what it was given, in both units and after any number of changes.
#![allow(clippy::unwrap_used)]

use crate::table::{Bound, CommandSpec, Kind, ParamSpec, find};
use crate::testing::{FakeHost, run_as};
use crate::{Options, Session, format_number};
use kerf_program::settings::LinearUnit;
use proptest::prelude::*;

/// Commands that keep their values after a typed line. VB's series and VD's units have tests of their own.
const COMMANDS: [&str; 9] = ["VC", "VH", "VI", "VL", "VN", "VO", "VP", "VR", "VU"];

fn typed(text: &str, session: Session) -> Session {
    let options = Options { typed: true, ..Options::default() };
    let ran = run_as(text, FakeHost::default(), session, options);
    assert!(ran.error.is_none(), "{text}: {:?}", ran.error);
    ran.session
}

fn machine() -> Session {
    typed("VD,,6⏎VN,,,1", Session::default())
}

/// A value in the bounds of a parameter, or a blank; `share` picks it. Bounds are in inches, so the
/// values stay legal when they are given in mm.
fn legal(param: &ParamSpec, share: u16) -> String {
    let pick = |list: &[String]| list[usize::from(share) % list.len()].clone();
    let part = f64::from(share) / f64::from(u16::MAX);
    let value = match param.kind {
        Kind::Obsolete => return "x".into(),
        Kind::OneOf(list) => return pick(&list.iter().map(i32::to_string).collect::<Vec<_>>()),
        Kind::Word(list) => return pick(&list.iter().map(ToString::to_string).collect::<Vec<_>>()),
        Kind::AxisLetter => return pick(&"XYZABC".chars().map(String::from).collect::<Vec<_>>()),
        Kind::Whole => match param.bound {
            Bound::Range(low, high) => return format!("{}", (low + part * (high - low)).round()),
            _ => return format!("{}", share.max(1)),
        },
        _ => match param.bound {
            Bound::Range(low, high) => low + part * (high - low),
            Bound::Below(low, high) => low + part * (high - low) * 0.999,
            _ => 2.0 + part * 100.0,
        },
    };
    format_number(value)
}

fn line(spec: &CommandSpec, shares: &[Option<u16>]) -> String {
    let values = spec.params.iter().zip(shares).enumerate();
    values.fold(spec.letters.to_string(), |line, (index, (param, share))| {
        // The trigger belongs into files; VL wants its pairs in order, VI a channel for each axis.
        let blank = param.kind == Kind::AxisLetter
            || spec.letters == "VC" && index == 7
            || spec.letters == "VL" && index % 2 == 1;
        let value = share.filter(|_| !blank).map(|s| legal(param, s)).unwrap_or_default();
        let value = if spec.letters == "VL" && index != 8 && !value.is_empty() {
            format!("-{value}")
        } else {
            value
        };
        line + "," + &value
    })
}

/// Returns `true` if the setting of a parameter shows now what was written for it.
fn shows(param: &ParamSpec, written: &str, present: Option<&str>) -> bool {
    let Some(present) = present else { return param.setting.is_none() };
    match (written.parse::<f64>(), present.parse::<f64>()) {
        (Ok(a), Ok(b)) => a == b || param.name == "Offset" && a == 0.0 && b == 2.0,
        _ => {
            let plunge = |word: &str| matches!(word, "+" | "1");
            written.eq_ignore_ascii_case(present)
                || param.name == "Plunge direction" && plunge(written) == plunge(present)
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn what_is_given_reads_back(
        which in 0..COMMANDS.len(),
        mm in any::<bool>(),
        shares in proptest::collection::vec(proptest::option::of(any::<u16>()), 26),
    ) {
        let spec = find(COMMANDS[which]).unwrap();
        let unit = if mm { LinearUnit::Mm } else { LinearUnit::Inch };
        let before = typed(&format!("VD,,,{}", u8::from(mm)), machine());
        prop_assert_eq!(before.settings.linear_unit, unit);
        let line = line(spec, &shares);
        let after = typed(&line, before.clone()).settings;
        let written: Vec<&str> = line.split(',').skip(1).collect();
        for (param, written) in spec.params.iter().zip(written) {
            let present = param.present(&after);
            if written.is_empty() {
                prop_assert_eq!(&present, &param.present(&before.settings), "{}: {}", line, param.name);
            } else {
                let same = shows(param, written, present.as_deref());
                prop_assert!(same, "{line}: {} shows {present:?}", param.name);
            }
        }
    }

    #[test]
    fn a_hundred_changes_of_units_change_nothing(
        xyz in proptest::array::uniform3(-100.0..100.0f64),
        speeds in proptest::array::uniform8(0.05..20.0f64),
        mm in any::<bool>(),
    ) {
        let [x, y, z] = xyz.map(|v| (v * 1e4).round() / 1e4);
        let speeds = speeds.map(|v| format_number((v * 1e3).round() / 1e3).parse::<f64>().unwrap());
        let speeds = speeds.map(|v| if mm { v + 1.27 } else { v });
        let list = speeds.map(format_number).join(",");
        let start = format!("VD,,5,{}⏎M3,{x},{y},{z}⏎VA,,,1⏎VS,{list}", u8::from(mm));
        let first = typed(&start, Session::default());
        let switches = "⏎VD,,,1⏎VD,,,0".repeat(50);
        let home = format!("⏎VD,,,{}", u8::from(mm));
        let last = typed(&(switches + &home), first.clone());
        prop_assert_eq!(&last.settings, &first.settings);
        prop_assert_eq!(last.position, first.position);
        prop_assert_eq!(last.frame, first.frame);
        let vs = find("VS").unwrap().present(&last.settings).unwrap();
        prop_assert_eq!(vs, format!("VS,{list}"));
    }
}

#[test]
fn settings_written_as_lines_bring_themselves_back() {
    let changed = "VD,,5,1,0,2,,1,2.5,1⏎VB,3,50⏎VC,6,,,OFF,+,20,30⏎VL,1,2000⏎VN,0,1,2,1,2\
                   ⏎VH,0,.3,10,90⏎VR,5,6⏎VS,40,20,10,5⏎VU,200,,,,.5⏎SR⏎SW,2⏎SO,4,-3";
    let session = typed(changed, Session::default());
    for session in [session, Session::default()] {
        let text = crate::table::settings_lines(&session.settings).join("⏎");
        let back = typed(&text, Session::default());
        assert_eq!(crate::table::settings_lines(&back.settings).join("⏎"), text);
        // In mm a value that was set in inches may differ in the last bit, which no one sees.
        if session.settings.linear_unit == LinearUnit::Inch {
            assert_eq!(back.settings, session.settings, "{text}");
        }
    }
}
