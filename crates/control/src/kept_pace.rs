//! The planner of a controller as it told it last, kept by its port: whoever only looks at a file does not open the controller.

use crate::learned::Learned;
use crate::own_pace::OwnPace;
use kerf_journal::facts::Fact;
use kerf_machine::driver::planners::{Grbl, Link, LinuxCnc, OwnPlanner, Release};
use kerf_program::{AXES, Axes};
use kerf_workspace::stored::Stored;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The value that keeps them, of each port.
const PLANNERS: &str = Fact::ControllerPlanners.key();

/// Ports of which a planner is kept at most.
const PORTS: usize = 64;

/// A way of making moves, as it is kept.
#[derive(Debug, Serialize, Deserialize)]
struct Kept {
    planner: KeptPlanner,
    tolerance_mm: f64,
}

/// Limits of axes; nothing where an axis has none.
type Limits = [Option<f64>; AXES];

/// A planner, as it is kept.
#[derive(Debug, Serialize, Deserialize)]
enum KeptPlanner {
    Grbl {
        speed_mm_s: Limits,
        accel_mm_s2: Limits,
        junction_deviation_mm: f64,
        arc_tolerance_mm: f64,
        blocks: usize,
        /// Rate and buffer of its line; no rate where that takes no time.
        link: Option<(Option<f64>, usize)>,
    },
    LinuxCnc {
        is_2_10: bool,
        speed_mm_s: Limits,
        accel_mm_s2: Limits,
        blend_mm: f64,
        same_line_mm: f64,
    },
}

fn limits(of: &Axes) -> Limits {
    of.0.map(|value| Some(value).filter(|value| value.is_finite()))
}

fn axes(of: Limits) -> Axes {
    Axes(of.map(|value| value.unwrap_or(f64::INFINITY)))
}

impl From<&OwnPlanner> for KeptPlanner {
    fn from(planner: &OwnPlanner) -> Self {
        match planner {
            OwnPlanner::Grbl(grbl) => Self::Grbl {
                speed_mm_s: limits(&grbl.speed_mm_s),
                accel_mm_s2: limits(&grbl.accel_mm_s2),
                junction_deviation_mm: grbl.junction_deviation_mm,
                arc_tolerance_mm: grbl.arc_tolerance_mm,
                blocks: grbl.blocks,
                link: grbl.link.map(|Link { baud, buffer }| {
                    (Some(baud).filter(|baud| baud.is_finite()), buffer)
                }),
            },
            OwnPlanner::LinuxCnc(linuxcnc) => Self::LinuxCnc {
                is_2_10: linuxcnc.release == Release::V2_10,
                speed_mm_s: limits(&linuxcnc.speed_mm_s),
                accel_mm_s2: limits(&linuxcnc.accel_mm_s2),
                blend_mm: linuxcnc.blend_mm,
                same_line_mm: linuxcnc.same_line_mm,
            },
        }
    }
}

impl From<KeptPlanner> for OwnPlanner {
    fn from(kept: KeptPlanner) -> Self {
        match kept {
            KeptPlanner::Grbl {
                speed_mm_s,
                accel_mm_s2,
                junction_deviation_mm,
                arc_tolerance_mm,
                blocks,
                link,
            } => Self::Grbl(Grbl {
                speed_mm_s: axes(speed_mm_s),
                accel_mm_s2: axes(accel_mm_s2),
                junction_deviation_mm,
                arc_tolerance_mm,
                blocks,
                link: link.map(|(baud, buffer)| {
                    let baud = baud.unwrap_or(f64::INFINITY);
                    Link { baud, buffer }
                }),
            }),
            KeptPlanner::LinuxCnc { is_2_10, speed_mm_s, accel_mm_s2, blend_mm, same_line_mm } => {
                Self::LinuxCnc(LinuxCnc {
                    release: if is_2_10 { Release::V2_10 } else { Release::V2_9 },
                    speed_mm_s: axes(speed_mm_s),
                    accel_mm_s2: axes(accel_mm_s2),
                    blend_mm,
                    same_line_mm,
                })
            }
        }
    }
}

fn all(stored: &Stored) -> BTreeMap<String, Kept> {
    stored.get(PLANNERS).and_then(|text| serde_json::from_str(text).ok()).unwrap_or_default()
}

/// Returns the way in which the controller at a port made moves when it was driven last, with what runs there have shown.
pub fn kept_pace(port: &str, stored: &Stored) -> Option<OwnPace> {
    let Kept { planner, tolerance_mm } = all(stored).remove(port)?;
    Some(OwnPace::new(planner.into(), tolerance_mm).learned(Learned::of(port, stored)))
}

/// Keeps the way in which the controller at a port makes moves.
pub(crate) fn keep_pace(pace: &OwnPace, port: &str, stored: &mut Stored) {
    let (planner, tolerance_mm) = pace.by_planner();
    let mut kept = all(stored);
    if kept.len() >= PORTS && !kept.contains_key(port) {
        kept.pop_first();
    }
    kept.insert(port.to_owned(), Kept { planner: planner.into(), tolerance_mm });
    let text = serde_json::to_string(&kept).ok();
    if stored.get(PLANNERS) != text.as_deref() {
        stored.set(PLANNERS, text.as_deref());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_planner_is_read_as_it_was_kept() {
        let limits = Axes([100.0, 90.0, 50.0, f64::INFINITY, f64::INFINITY, f64::INFINITY]);
        let grbl = Grbl { blocks: 101, junction_deviation_mm: 0.02, ..Grbl::new(limits, limits) };
        let endless = Link { baud: f64::INFINITY, buffer: 1024 };
        let linuxcnc = LinuxCnc {
            release: Release::V2_10,
            speed_mm_s: limits,
            accel_mm_s2: limits,
            blend_mm: 0.05,
            same_line_mm: 0.01,
        };
        let mut stored = Stored::default();
        for planner in [
            OwnPlanner::Grbl(grbl.clone()),
            OwnPlanner::Grbl(Grbl { link: Some(endless), ..grbl }),
            OwnPlanner::LinuxCnc(linuxcnc),
        ] {
            let pace = OwnPace::new(planner, 0.002);
            keep_pace(&pace, "/dev/ttyUSB0", &mut stored);
            assert_eq!(kept_pace("/dev/ttyUSB0", &stored), Some(pace));
        }
        assert_eq!(kept_pace("/dev/ttyUSB1", &stored), None);
    }
}
