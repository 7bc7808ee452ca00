//! What the bridge tells: facts once, the state often, both as `key=value` words.

use kerf_machine::driver::planners::{LinuxCnc, OwnPlanner, Release};
use kerf_machine::driver::{AXES, Axes, Facts, Shares, Ticket};
use std::collections::BTreeMap;

/// Version of the bridge's language.
const VERSION: &str = "2";

/// The input that is the probe.
pub const PROBE_INPUT: u8 = 1;

/// G64 P of the bridge: LinuxCNC cuts corners by so much, mm.
const BLEND_MM: f64 = 0.01;

/// G64 Q of the bridge: LinuxCNC makes straight moves that lie so near one line as that line, mm.
const SAME_LINE_MM: f64 = 0.002;

/// Greatest distance of a chord from its arc, mm.
const CHORD_MM: f64 = 0.5 * BLEND_MM;

/// What LinuxCNC does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Doing {
    /// It stands ready.
    #[default]
    Idle,
    /// It makes a piece.
    Run,
    /// It goes home.
    Homing,
    /// It is being switched on.
    Unlocking,
    /// It slows down for a hold.
    Slowing,
    /// It stands in a hold that was ordered.
    Held,
    /// It stands, or slows down, because somebody at its panel wants it so.
    Panel,
    /// It slows down for a stop.
    Stopping,
    /// It stands after a stop.
    Stopped,
    /// Its emergency stop is pressed.
    Estop,
    /// It is switched off.
    Off,
    /// It works for somebody else.
    Foreign,
    /// It has ended, and nobody knows whether its motion has.
    Gone,
}

const DOINGS: [(&str, Doing); 13] = [
    ("idle", Doing::Idle),
    ("run", Doing::Run),
    ("homing", Doing::Homing),
    ("unlocking", Doing::Unlocking),
    ("slowing", Doing::Slowing),
    ("held", Doing::Held),
    ("panel", Doing::Panel),
    ("stopping", Doing::Stopping),
    ("stopped", Doing::Stopped),
    ("estop", Doing::Estop),
    ("off", Doing::Off),
    ("foreign", Doing::Foreign),
    ("gone", Doing::Gone),
];

/// A state that the bridge told.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Status {
    /// Number of the greeting since which it tells, and that of the next line that it waits for.
    pub greeting: u32,
    pub next: u32,
    /// Number of the last piece that it was told to make.
    pub piece: u32,
    /// The last order of it that is made.
    pub done: Ticket,
    /// All of it is made.
    pub is_over: bool,
    pub doing: Doing,
    pub is_homed: bool,
    pub moves: bool,
    pub position: Axes,
    /// Outputs and inputs that are on, a bit each.
    pub outputs: u32,
    pub inputs: u32,
    pub shares: Shares,
    /// Place where the probe changed.
    pub contact: Option<Axes>,
    /// Why it makes nothing more; empty where it does.
    pub why: String,
}

/// Words of a line by their keys.
pub fn words(text: &str) -> BTreeMap<&str, &str> {
    text.split(' ').filter_map(|word| word.split_once('=')).collect()
}

pub fn number<T: std::str::FromStr>(words: &BTreeMap<&str, &str>, key: &str) -> Option<T> {
    words.get(key)?.parse().ok()
}

pub fn axes(told: &str) -> Option<Axes> {
    let mut place = Axes::default();
    for (axis, number) in told.split(',').enumerate() {
        *place.0.get_mut(axis)? = number.parse().ok().filter(|mm: &f64| mm.is_finite())?;
    }
    Some(place)
}

/// Reads numbers of axes; a question mark is one that is not known.
fn known(told: &str) -> Option<Vec<Option<f64>>> {
    told.split(',')
        .map(|word| if word == "?" { Some(None) } else { word.parse().ok().map(Some) })
        .collect()
}

/// Words in which spaces and the like stand as `%20`.
fn plain(told: &str) -> String {
    let mut parts = told.split('%');
    let mut bytes = parts.next().unwrap_or_default().as_bytes().to_vec();
    for part in parts {
        match part.split_at_checked(2).map(|(code, rest)| (u8::from_str_radix(code, 16), rest)) {
            Some((Ok(byte), rest)) => {
                bytes.push(byte);
                bytes.extend_from_slice(rest.as_bytes());
            }
            _ => bytes.extend_from_slice(part.as_bytes()),
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

impl Status {
    /// Reads a line without its check number.
    pub fn read(text: &str) -> Option<Self> {
        let words = words(text.strip_prefix("s ")?);
        let is = |key| number::<u8>(&words, key).map(|bit| bit == 1);
        let share = |key| number::<u32>(&words, key).map(|percent| percent.min(250) as u8);
        let doing = words.get("doing")?;
        Some(Self {
            greeting: number(&words, "hi")?,
            next: number(&words, "next")?,
            piece: number(&words, "piece")?,
            done: number(&words, "done")?,
            is_over: is("over")?,
            doing: DOINGS.iter().find(|(word, _)| word == doing)?.1,
            is_homed: is("homed")?,
            moves: is("moves")?,
            position: axes(words.get("at")?)?,
            outputs: number(&words, "out")?,
            inputs: number(&words, "in")?,
            shares: Shares {
                feed: share("feed")?,
                rapid: share("rapid")?,
                spindle: share("turn")?,
            },
            contact: words.get("contact").and_then(|told| axes(told)),
            why: words.get("why").map_or_else(String::new, |told| plain(told)),
        })
    }
}

/// Reads the facts of a line without its check number; the error tells why it cannot be driven.
pub fn facts(text: &str) -> Option<Result<Facts, &'static str>> {
    let words = words(text.strip_prefix("facts ")?);
    if *words.get("version")? != VERSION {
        return Some(Err(
            "its bridge is of another version of Kerf: start the one of this version",
        ));
    }
    match *words.get("unfit")? {
        "module" => {
            return Some(Err("the Python module of LinuxCNC is not there: is LinuxCNC installed?"));
        }
        "absent" => return Some(Err("LinuxCNC does not run there: start it first")),
        "axes" => return Some(Err("it has no axes X, Y and Z: Kerf drives no lathe")),
        "kinematics" => {
            return Some(Err("its joints are not its axes: Kerf drives trivial kinematics only"));
        }
        _ => {}
    }
    let count: usize = number(&words, "axes")?;
    let (speeds, ends) = (known(words.get("speed")?)?, known(words.get("travel")?)?);
    let of = |told: &[Option<f64>], n: usize| told.get(n).copied().flatten();
    Some(Ok(Facts {
        name: plain(words.get("name")?),
        axes: count.min(AXES),
        speed_mm_s: std::array::from_fn(|axis| of(&speeds, axis)),
        travel_mm: std::array::from_fn(|axis| {
            Some((of(&ends, 2 * axis)?, of(&ends, 2 * axis + 1)?))
        }),
        homes: true,
        is_fresh: true,
        arc_tolerance_mm: CHORD_MM,
        outputs: number(&words, "outputs")?,
        inputs: number(&words, "inputs")?,
        probe: Some(PROBE_INPUT),
        spindle_rpm: number(&words, "rpm")?,
        overrides: true,
        overrides_more: true,
        holds: true,
        stop_switches_off: true,
        plans_corners: true,
        takes_whole: true,
        planner: own_planner(&plain(words.get("name")?), &speeds, &known(words.get("accel")?)?),
        ..Facts::default()
    }))
}

/// Its planner, where it tells speed and acceleration of each axis.
fn own_planner(name: &str, speeds: &[Option<f64>], accels: &[Option<f64>]) -> Option<OwnPlanner> {
    let each = |told: &[Option<f64>]| {
        let mut all = Axes::splat(f64::INFINITY);
        for (axis, told) in told.iter().enumerate().take(AXES) {
            all.0[axis] = told.filter(|value| *value > 0.0)?;
        }
        Some(all)
    };
    Some(OwnPlanner::LinuxCnc(LinuxCnc {
        release: release(name),
        speed_mm_s: each(speeds)?,
        accel_mm_s2: each(accels)?,
        blend_mm: BLEND_MM,
        same_line_mm: SAME_LINE_MM,
    }))
}

/// The version in a name such as `LinuxCNC 2.9.4 (mill)`.
fn release(name: &str) -> Release {
    let version = name.split(' ').nth(1).unwrap_or_default();
    let mut numbers = version.split('.').map(|number| number.parse::<u32>().unwrap_or(0));
    let (major, minor) = (numbers.next().unwrap_or(0), numbers.next().unwrap_or(0));
    if (major, minor) < (2, 10) { Release::V2_9 } else { Release::V2_10 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_state_is_read_word_by_word() {
        let text = "s hi=1 next=4 piece=2 done=7 over=0 doing=run homed=1 moves=1 at=1.5,-2.00000,0.25 out=9 in=1 feed=120 \
                    rapid=50 turn=100 contact=1,2,-3 why=its%20stop";
        let read = Status::read(text).expect("a status");
        assert_eq!((read.piece, read.done, read.is_over, read.doing), (2, 7, false, Doing::Run));
        assert_eq!(
            (read.position, read.contact),
            (Axes::xyz(1.5, -2.0, 0.25), Some(Axes::xyz(1.0, 2.0, -3.0)))
        );
        assert_eq!(
            (read.outputs, read.inputs, read.shares.feed, &*read.why),
            (9, 1, 120, "its stop")
        );
        assert_eq!(Status::read(&text.replace("at=1.5", "at=x")), None);
        assert_eq!(Status::read(&text.replace("doing=run", "doing=ran")), None);
    }

    #[test]
    fn facts_are_read_and_what_cannot_be_driven_is_said() {
        let text = "facts version=2 name=LinuxCNC%202.9 axes=3 speed=200,?,50 accel=500,500,? travel=-1,2,?,3,-5,0 \
                    outputs=23 inputs=3 rpm=24000 unfit=no";
        let read = facts(text).expect("facts").expect("fit");
        assert_eq!((&*read.name, read.axes, read.outputs), ("LinuxCNC 2.9", 3, 23));
        assert_eq!(read.speed_mm_s[..3], [Some(200.0), None, Some(50.0)]);
        assert_eq!(read.travel_mm[..3], [Some((-1.0, 2.0)), None, Some((-5.0, 0.0))]);
        let check = |from: &str, to: &str| {
            assert!(matches!(facts(&text.replace(from, to)), Some(Err(_))), "{to}")
        };
        check("version=2", "version=1");
        check("unfit=no", "unfit=axes");
        check("unfit=no", "unfit=kinematics");
    }
}
