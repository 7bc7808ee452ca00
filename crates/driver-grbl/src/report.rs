//! Status reports: `<Run|MPos:1.000,2.000,0.000|Bf:13,90|FS:1200,0|Pn:PX|WCO:0.000,0.000,0.000>`.

use kerf_machine::driver::{AXES, Axes, Shares};

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
    /// It stands, and its door is open.
    DoorOpen,
    /// It stands, and its door is closed again.
    DoorClosed,
    /// It goes on behind a closed door: its spindle comes up.
    Resuming,
    /// It goes home.
    Home,
    /// It is locked, by an alarm of this number where it says which.
    Alarm(Option<u16>),
    /// It waits for a tool.
    Tool,
    /// It checks lines in place of making them.
    Check,
    /// It sleeps until it is reset.
    Sleep,
}

impl Doing {
    /// Reads the state of a report. A sub-state that is not known is read as its main state.
    fn read(word: &str) -> Option<Self> {
        let (main, sub) = word.split_once(':').unwrap_or((word, ""));
        Some(match (main, sub) {
            ("Idle", _) => Self::Idle,
            ("Run" | "Jog", _) => Self::Run,
            ("Hold", "1") | ("Door", "2") => Self::Slowing,
            ("Hold", _) => Self::Held,
            ("Door", "0") => Self::DoorClosed,
            ("Door", "3" | "4") => Self::Resuming,
            ("Door", _) => Self::DoorOpen,
            ("Home", _) => Self::Home,
            ("Alarm" | "ConfigAlarm" | "Critical", sub) => Self::Alarm(sub.parse().ok()),
            ("Tool", _) => Self::Tool,
            ("Check", _) => Self::Check,
            ("Sleep", _) => Self::Sleep,
            _ => return None,
        })
    }

    /// Returns `true` if nothing moves.
    pub const fn stands(self) -> bool {
        !matches!(self, Self::Run | Self::Slowing | Self::Resuming | Self::Home)
    }

    /// Tells for what it waits at its own controls, in words.
    pub const fn waits(self) -> Option<&'static str> {
        match self {
            Self::Slowing | Self::Held => Some("it is held: its own button has it go on"),
            Self::DoorOpen => Some("its door is open"),
            Self::DoorClosed => Some("its door was open: its own button has it go on"),
            Self::Resuming => Some("its spindle comes up again"),
            Self::Tool => {
                Some("it waits for a tool: put it in, then press Continue, or its own button")
            }
            Self::Idle | Self::Run | Self::Home | Self::Alarm(_) | Self::Check | Self::Sleep => {
                None
            }
        }
    }

    /// Tells why no job can be run, and the way to mend it, in words.
    pub const fn unfit(self) -> Option<&'static str> {
        match self {
            Self::Check => Some("it checks lines in place of making them: send it $C"),
            Self::Sleep => Some("it sleeps: reset it, and home it or set its location"),
            _ => None,
        }
    }
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
    /// The number of the line that it makes.
    pub line: Option<u32>,
    /// A file that it runs from its card: how much of it was read, percent, and its name.
    pub card: Option<(f64, String)>,
    /// Shares at which it makes what it is told.
    pub shares: Option<Shares>,
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
        let mut report = Self { doing: Doing::read(fields.next()?)?, ..Self::default() };
        // FluidNC leaves the field of its card empty until it has read the first line of a file.
        for field in fields.filter(|field| !field.is_empty()) {
            let (name, value) = field.split_once(':')?;
            match name {
                "MPos" => (report.place, report.axes) = placed(Frame::Machine, value)?,
                "WPos" => (report.place, report.axes) = placed(Frame::Work, value)?,
                "WCO" => report.offset = Some(axes(value)?.0),
                "Bf" => report.free = Some(value.split(',').next()?.parse().ok()?),
                "Ov" => report.shares = Some(shares(value)?),
                "SD" => report.card = on_card(value),
                "Ln" => report.line = Some(value.parse().ok()?),
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

/// A file that runs: `12.5,box.nc`. A number alone tells whether a card is there; words alone that all of it is read.
fn on_card(value: &str) -> Option<(f64, String)> {
    let (percent, name) = value.split_once(',')?;
    Some((percent.parse().ok()?, name.to_owned()))
}

/// Shares of feeds, rapid moves and the spindle, percent: `100,50,120`.
fn shares(value: &str) -> Option<Shares> {
    let mut percents = value.split(',').map(|percent| percent.parse().ok().filter(|v| *v > 0));
    let mut next = || percents.next().flatten();
    Some(Shares { feed: next()?, rapid: next()?, spindle: next()? })
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
        assert_eq!(report.shares, Some(Shares::default()));
        let work = Report::read("<Hold:0|WPos:1,2,3,4|WCO:0.5,0,0,0>").expect("a report");
        assert_eq!((work.doing, work.axes), (Doing::Held, 4));
        assert_eq!(work.offset, Some(Axes::xyz(0.5, 0.0, 0.0)));
    }

    #[test]
    fn the_field_of_a_file_that_fluidnc_has_not_begun_to_read_or_has_read_names_none() {
        let read = |line: &str| Report::read(line).expect("a report").card;
        assert_eq!(read("<Idle|MPos:0,0,0|>"), None);
        assert_eq!(read("<Run|MPos:0,0,0|SD: /sd/box.nc: Sent>"), None);
        let runs = read("<Run|MPos:0,0,0|SD:12.50,/sd/box.nc>");
        assert_eq!(runs, Some((12.5, "/sd/box.nc".into())));
    }

    #[test]
    fn what_is_garbled_is_no_report() {
        for line in [
            "<Run|MPos:1.000,2.0x>",
            "<Rxn|MPos:1,2,3>",
            "<Idle|MPos:1,2,3",
            "<Idle|MPos>",
            "<Idle|Ov:100,1>",
            "<Idle|Ov:0,100,100>",
        ] {
            assert_eq!(Report::read(line), None, "{line}");
        }
    }

    fn check(word: &str, doing: Doing, stands: bool) {
        assert_eq!(Doing::read(word), Some(doing), "{word}");
        assert_eq!(doing.stands(), stands, "{word}");
    }

    #[test]
    fn every_state_is_read() {
        check("Idle", Doing::Idle, true);
        check("Run", Doing::Run, false);
        check("Run:1", Doing::Run, false);
        check("Run:2", Doing::Run, false);
        check("Jog", Doing::Run, false);
        check("Hold:0", Doing::Held, true);
        check("Hold:1", Doing::Slowing, false);
        check("Hold:7", Doing::Held, true);
        check("Door:0", Doing::DoorClosed, true);
        check("Door:1", Doing::DoorOpen, true);
        check("Door:2", Doing::Slowing, false);
        check("Door:3", Doing::Resuming, false);
        check("Door:4", Doing::Resuming, false);
        check("Door:9", Doing::DoorOpen, true);
        check("Home", Doing::Home, false);
        check("Alarm", Doing::Alarm(None), true);
        check("Alarm:11", Doing::Alarm(Some(11)), true);
        check("Tool", Doing::Tool, true);
        check("Check", Doing::Check, true);
        check("Sleep", Doing::Sleep, true);
    }
}
