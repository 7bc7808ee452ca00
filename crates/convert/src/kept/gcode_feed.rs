//! The feed of a part file that keeps its variables.
//!
//! F counts along the path; VS gives XY and Z a speed each. On a slope the speeds depend on where the
//! tool comes from, so the part file works them out each time, in subroutines of its own:
//!
//! ```text
//!  &to_x … &to_z ──► SLOPE ──► &flat ──► SPEEDS ──► VS      &flat: the way in XY
//!                    HELIX ──► &flat ────┘
//! ```

use super::Unkept;
use super::gcode_expressions::location;

/// The speeds of a straight slope, and of anything whose way in XY is known.
const SLOPE: &str = "\
'A feed counts along the path: this sets the XY and the Z speed that make it.
SLOPE:
&flat = SQR((&to_x * %(66) + %(61) - %(1)) ^ 2 + (&to_y * %(67) + %(62) - %(2)) ^ 2)
SPEEDS:
&rise = ABS(&to_z * %(68) + %(63) - %(3))
&way = SQR(&flat ^ 2 + &rise ^ 2)
IF &way = 0 THEN GOTO SPEEDS_DONE
IF &flat < &rise THEN GOTO STEEP
VS,&feed * &flat / &way,&feed
RETURN
STEEP:
VS,&feed,&feed * &rise / &way
SPEEDS_DONE:
RETURN
";

/// The way in XY of an arc: its angle times its radius.
const HELIX: &str = "\
HELIX:
&end_x = &to_x - (%(1) - %(61)) / %(66) - &to_i
&end_y = &to_y - (%(2) - %(62)) / %(67) - &to_j
&cross = (&to_i * &end_y - &to_j * &end_x) * &turn
&dot = 0 - &to_i * &end_x - &to_j * &end_y
&angle = 1.570796
IF &cross < 0 THEN &angle = 4.712389
IF &dot > 0 THEN &angle = ATN(&cross / &dot)
IF &dot < 0 THEN &angle = ATN(&cross / &dot) + 3.141593
IF &angle < 0.0001 THEN &angle = &angle + 6.283185
&flat = &angle * SQR((&to_i * %(66)) ^ 2 + (&to_j * %(67)) ^ 2)
GOTO SPEEDS
";

/// The values of a block that makes a motion.
#[derive(Default)]
pub(super) struct Places {
    pub(super) axes: [Option<String>; 3],
    pub(super) centre: [Option<String>; 2],
}

/// The feed while a part file is written.
pub(super) struct Feed {
    /// Some cut moves Z beside X or Y.
    slopes: bool,
    /// An F was written.
    said: bool,
    /// Speeds of slopes, and those of helices, are worked out somewhere.
    sloped: bool,
    helices: bool,
}

impl Feed {
    /// Of a program in which nothing was written yet.
    pub(super) const fn new(slopes: bool) -> Self {
        Self { slopes, said: false, sloped: false, helices: false }
    }

    /// The lines of an F.
    pub(super) fn set(&mut self, value: &str) -> Vec<String> {
        let speed = match value.parse::<f64>() {
            Ok(feed) => kerf_program::decimal(feed / 60.0, 6),
            Err(_) => format!("{value} / 60"),
        };
        self.said = true;
        if self.slopes {
            vec![format!("&feed = {speed}"), "VS,&feed,&feed".to_owned()]
        } else {
            vec![format!("VS,{speed},{speed}")]
        }
    }

    /// The lines of a cut on which Z moves beside X or Y, with speeds of its own.
    pub(super) fn on_a_slope(
        &mut self,
        line: u32,
        places: &Places,
        turn: Option<&str>,
        cut: &str,
    ) -> Result<Vec<String>, Unkept> {
        if !self.said {
            return Err(Unkept::new(line, "a slope before any F"));
        }
        let mut lines = Vec::new();
        for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
            let to = places.axes[axis].clone().unwrap_or_else(|| location(axis));
            lines.push(format!("&to_{name} = {to}"));
        }
        if let Some(turn) = turn {
            for (axis, name) in ["i", "j"].into_iter().enumerate() {
                lines.push(format!(
                    "&to_{name} = {}",
                    places.centre[axis].as_deref().unwrap_or("0")
                ));
            }
            lines.push(format!("&turn = {turn}"));
            self.helices = true;
        }
        self.sloped = true;
        let works_out = if turn.is_some() { "GOSUB HELIX" } else { "GOSUB SLOPE" };
        lines.extend([works_out, cut, "VS,&feed,&feed"].map(str::to_owned));
        Ok(lines)
    }

    /// The subroutines that the written lines call.
    pub(super) const fn subroutines(&self) -> [&'static str; 2] {
        [if self.helices { HELIX } else { "" }, if self.sloped { SLOPE } else { "" }]
    }
}
