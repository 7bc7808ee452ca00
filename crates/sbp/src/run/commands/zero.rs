//! Zeros: where the display reads 0.

use crate::run::locate;
use crate::run::{Context, Stop};
use crate::syntax::table::act::Zero;
use kerf_program::AxisSet;

/// Carries a zero command out.
pub(super) fn run(c: &mut Context<'_>, act: Zero) -> Result<(), Stop> {
    match act {
        Zero::Working(axes) => return zero_working(c, axes),
        Zero::TableBase => {
            c.core.place.frame.base_zero = c.core.place.position;
            locate::location_set(c, AxisSet::EMPTY, AxisSet::first(6));
        }
        Zero::Everything => {
            c.core.place.frame.working_zero = c.core.place.position;
            c.core.place.working_aside =
                c.core.place.working_aside.and(Some(c.core.place.position));
            c.core.place.frame.base_zero = c.core.place.position;
            locate::location_set(c, AxisSet::first(6), AxisSet::first(6));
        }
        Zero::ToTableBase => {
            c.core.place.frame.working_zero = c.core.place.frame.base_zero;
            c.core.place.working_aside =
                c.core.place.working_aside.and(Some(c.core.place.frame.base_zero));
            locate::location_set(c, AxisSet::first(6), AxisSet::EMPTY);
        }
    }
    Ok(())
}

fn zero_working(c: &mut Context<'_>, axes: AxisSet) -> Result<(), Stop> {
    for axis in axes.iter() {
        locate::set_working(c, axis, 0.0);
    }
    // Whoever zeroes an axis has looked where it is.
    locate::is_certain_of(c, axes);
    locate::location_set(c, axes, AxisSet::EMPTY);
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::testing::{FakeHost, rows, run_with};
    use crate::{Options, Session, testing::check_as};

    rows! {
        sbp_cmd_zx: "VD,,5⏎ZT⏎M5,1,2,3,4,5⏎ZX" => "at 0,2,3,4,5; base 1,2,3,4,5; moves 1; no warning", "ZX,1" => "error takes no values";
        sbp_cmd_zy: "VD,,5⏎ZT⏎M5,1,2,3,4,5⏎ZY" => "at 1,0,3,4,5; base 1,2,3,4,5; moves 1; no warning", "ZY,1" => "error takes no values";
        sbp_cmd_zz: "VD,,5⏎ZT⏎M5,1,2,3,4,5⏎ZZ" => "at 1,2,0,4,5; base 1,2,3,4,5; moves 1; no warning", "ZZ,1" => "error takes no values";
        sbp_cmd_za: "VD,,5⏎ZT⏎M5,1,2,3,4,5⏎ZA" => "at 1,2,3,0,5; base 1,2,3,4,5; moves 1; no warning", "ZA,1" => "error takes no values";
        sbp_cmd_zb: "VD,,5⏎ZT⏎M5,1,2,3,4,5⏎ZB" => "at 1,2,3,4,0; base 1,2,3,4,5; moves 1; no warning", "ZB,1" => "error takes no values";
        sbp_cmd_z2: "VD,,5⏎ZT⏎M5,1,2,3,4,5⏎Z2" => "at 0,0,3,4,5; base 1,2,3,4,5; moves 1; no warning", "Z2,1" => "error takes no values";
        sbp_cmd_z3: "VD,,5⏎ZT⏎M5,1,2,3,4,5⏎Z3" => "at 0,0,0,4,5; base 1,2,3,4,5; moves 1; no warning", "Z3,1" => "error takes no values";
        sbp_cmd_z4: "VD,,5⏎ZT⏎M5,1,2,3,4,5⏎Z4" => "at 0,0,0,0,5; base 1,2,3,4,5; moves 1; no warning", "Z4,1" => "error takes no values";
        sbp_cmd_z5: "VD,,5⏎ZT⏎M5,1,2,3,4,5⏎Z5" => "at 0,0,0,0,0; base 1,2,3,4,5; moves 1; no warning", "Z5,1" => "error takes no values";
        zc_and_z6: "VD,,6⏎M6,1,2,3,4,5,6⏎ZC" => "at 1,2,3,4,5,0", "VD,,6⏎M6,1,2,3,4,5,6⏎Z6" => "at 0,0,0,0,0,0";
        sbp_cmd_zt: "M3,9,9,9⏎VA,1,2,3⏎ZT" => "at 1,2,3; base 0,0,0,0,0", "M3,9,9,9⏎VA,1,2,3⏎ZT⏎ST" => "at 0,0,0; base 0,0,0",
            "ZT⏎MX,5⏎ZX" => "base 5,0,0; at 0,0,0; 6=5";
        sbp_cmd_uz: "M3,4,5,6⏎VA,1,2,3⏎UZ" => "at 0,0,0,0,0,0; base 0,0,0,0,0,0; 6=0; 8=0";
    }

    #[test]
    fn in_the_dialect_strict_base_is_a_location() {
        let strict = Options { dialect: crate::Dialect::Strict, ..Options::default() };
        check_as(strict, "M3,9,9,9⏎VA,1,2,3⏎ZT", "at 1,2,3; 6=0; 7=0; 8=0; 9=0; 10=0");
    }

    #[test]
    fn sbp_cmd_z_infile() {
        let mut host = FakeHost::default();
        host.files.insert("part.sbp".into(), "MX,1\n&base=%(6)\nZX\n&x=%(1)\nMX,1".into());
        let ran = run_with("ZT⏎M2,10,4⏎FP,part.sbp,,,,,2", host, Session::default());
        assert_eq!((ran.variable("base"), ran.variable("x")), ("0".into(), "0".into()));
        ran.ends_at(1.0, 4.0, 0.0);
        let s = &ran.session;
        let base = s.settings.to_user(s.frame.base(s.position));
        assert_eq!(base.0[0], 12.0);
        let told = format!("{:?}", ran.commands);
        assert!(told.contains("the offset of the file for X ends here"), "{told}");
    }

    #[test]
    fn whoever_zeroes_an_axis_says_where_it_is() {
        let lost = |program: &str| {
            let mut host = FakeHost::default();
            host.stored.insert("PositionLost".into(), "XYZ".into());
            let ran = run_with(program, host, Session::default());
            ran.host.stored.get("PositionLost").cloned()
        };
        assert_eq!(lost("ZX"), Some("YZ".into()));
        assert_eq!(lost("Z2"), Some("Z".into()));
        assert_eq!((lost("ZX⏎ZY⏎ZZ"), lost("ZT")), (None, None));
        // The base coordinates are what may be wrong: going by them makes nothing certain.
        assert_eq!(lost("ST"), Some("XYZ".into()));
    }
}
