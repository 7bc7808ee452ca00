//! Status reports: `<Run|MPos:1.000,2.000,0.000|Bf:13,90|FS:1200,0|Pn:PX|WCO:0.000,0.000,0.000>`.

use kerf_machine::driver::{AXES, Axes};

/// Activity of the controller.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Doing {
    /// Nothing.
    #[default]
    Idle,
    /// It moves.
    Run,
    /// It slows down for a hold or an open door.
    Slowing,
    /// It stands in a hold.
    Held,
    /// It goes home.
    Home,
    /// It is locked.
    Alarm,
    /// Anything else that moves nothing: sleep, check mode, tool change.
    Other,
}

/// A status report.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Report {
    /// Activity.
    pub doing: Doing,
    /// Place in its machine frame, or in that of the workpiece.
    pub place: Option<(Frame, Axes)>,
    /// Number of axes it told.
    pub axes: usize,
    /// Zero of the workpiece, machine frame.
    pub offset: Option<Axes>,
    /// Moves that the planner has room for.
    pub free: Option<usize>,
    /// The letters of the pins that are active.
    pub pins: String,
}

/// The frame of a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Frame {
    /// That of the machine: `MPos`.
    Machine,
    /// That of the workpiece: `WPos`.
    Work,
}

impl Report {
    /// Reads a line between `<` and `>`; nothing when it is none.
    pub fn read(line: &str) -> Option<Self> {
        let inner = line.strip_prefix('<')?.strip_suffix('>')?;
        let mut fields = inner.split('|');
        let mut report = Self { doing: doing(fields.next()?)?, ..Self::default() };
        for field in fields {
            let (name, value) = field.split_once(':')?;
            match name {
                "MPos" => (report.place, report.axes) = placed(Frame::Machine, value)?,
                "WPos" => (report.place, report.axes) = placed(Frame::Work, value)?,
                "WCO" => report.offset = Some(axes(value)?.0),
                "Bf" => report.free = Some(value.split(',').next()?.parse().ok()?),
                "Pn" => value.clone_into(&mut report.pins),
                _ => {}
            }
        }
        Some(report)
    }
}

fn placed(frame: Frame, value: &str) -> Option<(Option<(Frame, Axes)>, usize)> {
    let (place, count) = axes(value)?;
    Some((Some((frame, place)), count))
}

fn doing(word: &str) -> Option<Doing> {
    Some(match word {
        "Idle" => Doing::Idle,
        "Run" | "Jog" => Doing::Run,
        "Hold:0" | "Door:0" | "Door:1" => Doing::Held,
        "Hold:1" | "Door:2" | "Door:3" => Doing::Slowing,
        "Home" => Doing::Home,
        _ if word == "Alarm" || word.starts_with("Alarm:") => Doing::Alarm,
        "Check" | "Sleep" | "Tool" => Doing::Other,
        _ => return None,
    })
}

/// Numbers with commas between them, one for each axis; with how many there are.
pub fn axes(value: &str) -> Option<(Axes, usize)> {
    let mut place = Axes::default();
    let mut count = 0;
    for number in value.split(',') {
        let number: f64 = number.parse().ok()?;
        if count == AXES || !number.is_finite() {
            return None;
        }
        place.0[count] = number;
        count += 1;
    }
    Some((place, count))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reports_are_read() {
        let line = "<Run|MPos:1.000,-2.500,0.125|Bf:13,90|FS:1200,8000|Ov:100,100,100|A:S|Pn:PX>";
        let report = Report::read(line).expect("a report");
        assert_eq!(report.doing, Doing::Run);
        assert_eq!(report.place, Some((Frame::Machine, Axes::xyz(1.0, -2.5, 0.125))));
        assert_eq!((report.free, report.axes, &*report.pins), (Some(13), 3, "PX"));
        let work = Report::read("<Hold:0|WPos:1,2,3,4|WCO:0.5,0,0,0>").expect("a report");
        assert_eq!((work.doing, work.axes), (Doing::Held, 4));
        assert_eq!(work.offset, Some(Axes::xyz(0.5, 0.0, 0.0)));
    }

    #[test]
    fn what_is_garbled_is_no_report() {
        for line in ["<Run|MPos:1.000,2.0x>", "<Rxn|MPos:1,2,3>", "<Idle|MPos:1,2,3", "<Idle|MPos>"]
        {
            assert_eq!(Report::read(line), None, "{line}");
        }
    }
}
