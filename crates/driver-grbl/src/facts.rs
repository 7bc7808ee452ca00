//! The facts that a controller tells of itself: its version line (`$I`) and its settings (`$$`).

use crate::error_texts;
use crate::own_words::OwnWords;
use kerf_machine::driver::planners::{Grbl, Link, OwnPlanner};
use kerf_machine::driver::{AXES, Axes, Changed, Facts};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Bytes that the receive buffer of grbl holds, where it does not say.
const RX: usize = 128;

/// Moves that the planner of grbl holds, where it does not say.
const PLANNER: usize = 15;

/// The bit of `$10` that has the place told in the machine frame, and the one that has the buffers told.
const TELLS: u32 = 3;

/// The input that is the probe.
pub const PROBE_INPUT: u8 = 1;

/// The letter of the probe in a report.
pub const PROBE: char = 'P';

/// The pins whose state is told, as inputs: the probe and the limits. A door is no input: the controller holds by
/// itself while it is open.
pub const INPUTS: [(char, u8); 5] = [(PROBE, PROBE_INPUT), ('X', 5), ('Y', 6), ('Z', 7), ('A', 8)];

/// Line of the first auxiliary output (`M64P0`), and the last one that can be one: numbers behind it are named lines, such as the
/// router of a job, which is the spindle.
const FIRST_AUX: u32 = 4;
const LAST_AUX: u32 = 12;

/// Firmware of the family.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Firmware {
    #[default]
    Grbl,
    Hal,
    Fluid,
}

/// The words by which a firmware works its card.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Words {
    /// grblHAL; and whether it takes files on its line.
    Hal { takes: bool },
    /// `FluidNC`.
    Fluid,
}

/// Facts that are known so far.
#[derive(Clone, Debug)]
pub struct KnownFacts {
    version: String,
    firmware: Firmware,
    /// Letters of its options; nothing where it tells none.
    options: Option<String>,
    /// Letters of its axes, where it tells them.
    letters: Option<String>,
    /// Auxiliary outputs (`M64`).
    aux: u32,
    /// It says that it has a card, and that it takes files on its line.
    card: bool,
    takes_files: bool,
    /// It says that it has no probe.
    lacks_probe: bool,
    /// Its settings, alarms and errors in its own words.
    pub own: OwnWords,
    /// Modal words that hold in it.
    modes: Vec<String>,
    settings: BTreeMap<u16, f64>,
    /// One of them is another than before, and nobody has heeded it.
    is_new: bool,
    /// The same as it writes them, with those that are no numbers.
    texts: BTreeMap<u16, String>,
    /// Bytes that its receive buffer holds.
    pub rx: usize,
    /// Moves that its planner holds.
    pub planner: usize,
    /// It has told how many that are.
    is_sized: bool,
    /// Room in it as the last report told it.
    room: usize,
}

impl Default for KnownFacts {
    fn default() -> Self {
        Self {
            version: String::new(),
            firmware: Firmware::Grbl,
            options: None,
            letters: None,
            aux: 0,
            card: false,
            takes_files: false,
            lacks_probe: false,
            own: OwnWords::default(),
            modes: Vec::new(),
            settings: BTreeMap::new(),
            is_new: false,
            texts: BTreeMap::new(),
            rx: RX,
            planner: PLANNER,
            is_sized: false,
            room: 0,
        }
    }
}

impl KnownFacts {
    /// Returns the moves that its planner has left, by the room in it. More room than the planner is known to have is
    /// believed when two reports in a row tell it: one that was garbled would have it hold moves for ever.
    pub fn left(&mut self, room: usize) -> usize {
        if std::mem::replace(&mut self.room, room) == room {
            self.planner = self.planner.max(room);
        }
        self.planner.saturating_sub(room)
    }

    /// Learns from a report of a machine that does nothing; tells whether it is known how many moves the planner holds. One
    /// that does not tell is believed when two reports agree.
    pub fn learns_planner(&mut self, room: usize) -> bool {
        let agrees = self.room == room;
        self.left(room);
        self.is_sized || agrees
    }

    /// Learns from a line in brackets.
    pub fn bracket(&mut self, line: &str) {
        let Some((name, value)) = line.trim_matches(['[', ']']).split_once(':') else { return };
        match name {
            "VER" => self.is_version(value.trim_end_matches([':', ' '])),
            "FIRMWARE" if value == "grblHAL" => self.firmware = Firmware::Hal,
            "OPT" => self.has_options(value),
            "AXS" => self.letters = value.split(':').nth(1).map(String::from),
            "AUX IO" => {
                self.aux = value.split(',').nth(1).and_then(|n| n.parse().ok()).unwrap_or(0);
            }
            "NEWOPT" => {
                let has = |option| value.split(',').any(|word| word == option);
                (self.lacks_probe, self.own.has) = (has("NOPROBE"), has("ENUMS"));
                self.own.describes = has("SED");
                (self.card, self.takes_files) = (has("SD"), has("YM"));
            }
            "GC" => self.modes = value.split_whitespace().map(String::from).collect(),
            _ => self.own.bracket(name, value),
        }
    }

    fn is_version(&mut self, version: &str) {
        let fluid = version.contains("FluidNC");
        self.firmware = if fluid { Firmware::Fluid } else { self.firmware };
        version.trim_end_matches(|c| " :".contains(c)).clone_into(&mut self.version);
    }

    fn has_options(&mut self, value: &str) {
        let mut parts = value.split(',');
        self.options = parts.next().map(String::from);
        let mut sizes = parts.map(str::parse);
        if let Some(Ok(planner)) = sizes.next() {
            (self.planner, self.is_sized) = (planner, true);
        }
        if let Some(Ok(rx)) = sizes.next() {
            self.rx = rx;
        }
    }

    /// Learns from a line `$110=500.000`; tells whether it is one.
    pub fn setting(&mut self, line: &str) -> bool {
        let read = || {
            let (number, value) = line.strip_prefix('$')?.split_once('=')?;
            let value = value.split_whitespace().next()?;
            Some((number.parse().ok()?, value.parse().ok()?))
        };
        let read: Option<(u16, f64)> = read();
        if let Some((number, value)) = read {
            self.is_new |= self.settings.insert(number, value) != Some(value);
        }
        let text = line.strip_prefix('$').and_then(|rest| rest.split_once('='));
        let text = text.and_then(|(number, value)| Some((number.parse().ok()?, value.to_owned())));
        self.texts.extend(text);
        read.is_some()
    }

    /// Returns `true` if a setting is another than when this was asked last.
    pub const fn takes_news(&mut self) -> bool {
        std::mem::replace(&mut self.is_new, false)
    }

    /// Returns `true` if it is to be asked for its errors and alarms in words, once.
    pub const fn asks_words(&mut self) -> bool {
        self.own.has && !std::mem::replace(&mut self.own.asked, true)
    }

    /// Returns an error in words: its own where it has told them.
    pub fn error(&self, number: u16) -> Cow<'static, str> {
        let own = self.own.errors.get(&number).cloned();
        own.map_or(Cow::Borrowed(error_texts::error(number)), Cow::Owned)
    }

    /// Returns an alarm in words: its own where it has told them.
    pub fn alarm(&self, number: u16) -> Cow<'static, str> {
        let own = self.own.alarms.get(&number).cloned();
        own.map_or(Cow::Borrowed(error_texts::alarm(number)), Cow::Owned)
    }

    /// Returns `true` if its reports name the line that it makes.
    pub fn tells_lines(&self) -> bool {
        let by_option = self.options.as_ref().is_some_and(|letters| letters.contains('N'));
        by_option && (!self.is_hal() || self.bit(10, 2))
    }

    /// The words by which it works its card.
    ///
    /// # Errors
    /// It has none, for a reason.
    pub fn card(&self) -> Result<Words, &'static str> {
        let says = || self.options.as_ref().is_some_and(|letters| letters.contains('S'));
        match self.firmware {
            Firmware::Hal if self.card => Ok(Words::Hal { takes: self.takes_files }),
            Firmware::Hal => Err("its firmware has no card ($I tells no SD): build it with one"),
            Firmware::Fluid if says() => Ok(Words::Fluid),
            Firmware::Fluid => Err("its firmware has no card ($I tells no S)"),
            Firmware::Grbl => Err("grbl 1.1 has no card: grblHAL and FluidNC have one"),
        }
    }

    /// Its modes are asked for anew.
    pub fn forgets_modes(&mut self) {
        self.modes.clear();
    }

    /// Returns `true` if it has told its modes.
    pub const fn has_modes(&self) -> bool {
        !self.modes.is_empty()
    }

    /// Returns `true` if no feed holds: nothing has moved since it was reset.
    pub fn has_no_feed(&self) -> bool {
        let feed = self.modes.iter().find_map(|mode| mode.strip_prefix('F')?.parse::<f64>().ok());
        feed == Some(0.0)
    }

    /// Returns `true` if it has told its settings.
    pub fn is_known(&self) -> bool {
        !self.settings.is_empty()
    }

    /// Returns all settings as it writes them.
    pub const fn texts(&self) -> &BTreeMap<u16, String> {
        &self.texts
    }

    /// Returns `true` if it is grblHAL.
    pub fn is_hal(&self) -> bool {
        self.firmware == Firmware::Hal
    }

    /// Returns a setting.
    pub fn of(&self, number: u16) -> Option<f64> {
        self.settings.get(&number).copied()
    }

    fn bit(&self, number: u16, bit: u32) -> bool {
        self.of(number).is_some_and(|value| value as u32 >> bit & 1 == 1)
    }

    /// Places are told in inches.
    pub fn in_inches(&self) -> bool {
        self.bit(13, 0)
    }

    /// The setting that makes it tell its machine place and its buffers, where it does not.
    pub fn mend(&self) -> Option<Changed> {
        let mask = self.of(10)? as u32;
        (mask & TELLS != TELLS).then_some(Changed { number: 10, was: mask, is: mask | TELLS })
    }

    /// Tells why it cannot be driven as it is set, with the way to mend it.
    pub fn unfit(&self, axes: usize) -> Option<&'static str> {
        let letters = self.letters.as_deref().unwrap_or("XYZABC");
        if !"XYZABC".starts_with(letters) && !letters.starts_with("XYZABC") {
            Some("its axes are not X Y Z A B C in this order: build its firmware so")
        } else if self.settings.is_empty() {
            Some("it does not tell its settings ($$)")
        } else if (0..axes).any(|axis| self.steps(axis) <= 0.0) {
            Some("it does not tell the steps of its axes: look at $100, $101, $102")
        } else if self.in_inches() && axes > 3 {
            Some("it tells places in inches, which turning axes do not have: set $13=0")
        } else if self.of(32) == Some(2.0) {
            Some("it is set to be a lathe, where X is a diameter: set $32=0")
        } else if self.modes.iter().any(|mode| mode == "G51") {
            Some("it scales what it is told: send it G50")
        } else {
            None
        }
    }

    /// Steps of an axis, a millimetre or degree.
    pub fn steps(&self, axis: usize) -> f64 {
        self.of(100 + axis as u16).unwrap_or(0.0)
    }

    /// Its spindle turns when it is switched on. A beam would burn along every way, as all of them are `G1`.
    fn has_spindle(&self) -> bool {
        !self.bit(32, 0) && self.of(30).is_none_or(|most_rpm| most_rpm > 0.0)
    }

    /// The outputs there are.
    fn outputs(&self) -> u32 {
        let spindle = u32::from(self.has_spindle());
        let has_mist = self.options.as_ref().is_none_or(|letters| letters.contains('M'));
        let aux = (1_u32 << self.aux.min(LAST_AUX + 1 - FIRST_AUX)) - 1;
        spindle | 0b10 | u32::from(has_mist) << 2 | aux << (FIRST_AUX - 1)
    }

    /// Tells in words why it has no output for a spindle.
    fn no_spindle(&self) -> &'static str {
        if self.bit(32, 0) {
            "its laser mode is on, and a beam would burn along every jog: set $32=0"
        } else if self.has_spindle() {
            ""
        } else {
            "its spindle has no speed: look at $30"
        }
    }

    /// Range of an axis, mm: its home is at the upper end, unless it is set to be zero at the lower one.
    fn travel_mm(&self, axis: usize) -> Option<(f64, f64)> {
        // FluidNC puts home anywhere, and tells it in no setting.
        if !self.bit(20, 0) || self.firmware == Firmware::Fluid {
            return None;
        }
        let travel = self.of(130 + axis as u16)?;
        let low_home = self.bit(23, axis as u32);
        if self.forces_zero() && low_home { Some((0.0, travel)) } else { Some((-travel, 0.0)) }
    }

    fn forces_zero(&self) -> bool {
        let by_option = self.options.as_ref().is_some_and(|letters| letters.contains('Z'));
        if self.is_hal() { self.bit(22, 3) } else { by_option }
    }

    /// The inputs of which its reports tell: the probe, and the limits of its axes.
    fn inputs(&self, axes: usize) -> u32 {
        let limits = INPUTS[1..].iter().take(axes).map(|(_, line)| *line);
        let probe = (!self.lacks_probe).then_some(PROBE_INPUT);
        limits.chain(probe).fold(0, |bits, line| bits | 1 << (line - 1))
    }

    /// All of it, for whoever plans.
    pub fn facts(&self, axes: usize) -> Facts {
        let each = |of: &dyn Fn(usize) -> Option<f64>| {
            std::array::from_fn::<_, AXES, _>(|axis| of(axis).filter(|_| axis < axes))
        };
        let speed_mm_s = each(&|axis| Some(self.of(110 + axis as u16)? / 60.0));
        let name = match self.firmware {
            Firmware::Grbl => "grbl ",
            Firmware::Hal => "grblHAL ",
            Firmware::Fluid => "",
        };
        Facts {
            name: format!("{name}{}", self.version).trim_end().to_owned(),
            axes,
            speed_mm_s,
            travel_mm: std::array::from_fn(
                |axis| {
                    if axis < axes { self.travel_mm(axis) } else { None }
                },
            ),
            homes: self.bit(22, 0),
            arc_tolerance_mm: self.of(12).unwrap_or(0.002),
            arcs: true,
            outputs: self.outputs(),
            no_spindle: self.no_spindle(),
            inputs: self.inputs(axes),
            probe: (!self.lacks_probe).then_some(PROBE_INPUT),
            spindle_rpm: self.of(30).unwrap_or(1000.0),
            overrides: true,
            overrides_more: true,
            holds: true,
            stop_switches_off: true,
            plans_corners: true,
            planner: self.own_planner(axes),
            ..Facts::default()
        }
    }

    /// Its planner as it is set, fed without delay; nothing where it does not tell speeds and accelerations.
    fn own_planner(&self, axes: usize) -> Option<OwnPlanner> {
        let each = |first: u16, per_second: f64| {
            let mut all = Axes::splat(f64::INFINITY);
            for axis in 0..axes {
                all.0[axis] =
                    self.of(first + axis as u16).filter(|value| *value > 0.0)? / per_second;
            }
            Some(all)
        };
        let usual = Grbl::new(each(110, 60.0)?, each(120, 1.0)?);
        Some(OwnPlanner::Grbl(Grbl {
            junction_deviation_mm: self.of(11).unwrap_or(usual.junction_deviation_mm),
            arc_tolerance_mm: self.of(12).unwrap_or(usual.arc_tolerance_mm),
            // One block of the ring stays free.
            blocks: self.planner + 1,
            link: Some(Link { baud: f64::INFINITY, buffer: self.rx }),
            ..usual
        }))
    }
}

/// Tells how a locked controller takes orders again, in words.
pub const fn locked(homes: bool) -> &'static str {
    if homes {
        "home it first (--home)"
    } else {
        "look why, set its location, and unlock it (--unlock)"
    }
}
