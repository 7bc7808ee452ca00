//! Boards: found at ports and in the network, their settings, and whether they hold what Kerf expects of a controller.

use crate::controller::socket;
use crate::exit::{Exit, Usage};
use crate::given;
use crate::machine_name::{DriverName, MachineName};
use crate::out;
use anyhow::{Context, Result, anyhow, bail};
use clap::Subcommand;
use kerf_control::controller::queued::{Introduced, at_ports};
use kerf_control::controller::{Connection, Place};
use kerf_driver_grbl::Grbl;
use kerf_driver_grbl::settings::setting;
use kerf_machine::Machine;
use kerf_machine::driver::{ToldSetting, Wired};
use kerf_transport::{Address, Line, ListedPort, ports};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, channel};
use std::thread::{JoinHandle, spawn};
use std::time::{Duration, Instant};

/// Whoever has not told who it is after this is no controller.
const FOUND: Duration = Duration::from_millis(2900);

/// A board with step queues, for which a serial port is opened once more, has told it after so much more.
const STEP_BOARD: Duration = Duration::from_millis(4500);

/// One look at a line.
const NAP: Duration = Duration::from_millis(5);

/// A board answers what it is told within this.
const ANSWERED: Duration = Duration::from_secs(3);

/// Names under which boards are in a network.
const IN_NETWORKS: [&str; 4] =
    ["tcp:fluidnc.local", "tcp:fluidnc", "tcp:grblhal.local", "tcp:grblhal"];

/// LinuxCNC on this computer.
const LINUXCNC_HERE: &str = "linuxcnc:local";

/// Settings by their numbers, as the board writes them.
pub type Settings = BTreeMap<u16, String>;

#[derive(Clone, Debug, Subcommand)]
pub enum SettingsAction {
    /// Changes one
    Set {
        /// Its number, as 110
        number: u16,
        /// The value
        #[arg(allow_hyphen_values = true)]
        value: String,
    },
    /// Writes all of them into a file
    Backup {
        /// The file
        file: PathBuf,
    },
    /// Changes those that differ from the ones in a file
    Restore {
        /// The file, as a backup wrote it
        file: PathBuf,
    },
    /// Lists those that differ from the ones in a file, or on another board
    Compare {
        /// A file, or a machine as --machine names it
        with: String,
    },
}

/// A board on its line, spoken to directly.
pub struct Board {
    grbl: Grbl,
    line: Box<dyn Line>,
    since: Instant,
}

impl Board {
    /// Opens the line and waits until the board has told who it is.
    pub fn open(address: &Address, within: Duration) -> Result<Self> {
        let line = address.open()?;
        let mut board = Self { grbl: Grbl::new(), line, since: Instant::now() };
        while board.grbl.facts().is_none() {
            if let Some(trouble) = board.grbl.trouble() {
                bail!("{address}: {trouble}");
            }
            if board.since.elapsed() > within {
                bail!("{address} does not answer: is it a controller, and is this its rate?");
            }
            board.carry()?;
        }
        Ok(board)
    }

    fn now_s(&self) -> f64 {
        self.since.elapsed().as_secs_f64()
    }

    /// Moves bytes both ways.
    fn carry(&mut self) -> Result<()> {
        let bytes = self.grbl.speak(self.now_s());
        if !bytes.is_empty() {
            self.line.write(&bytes)?;
        }
        let mut came = [0; 1024];
        let count = self.line.read(&mut came, NAP)?;
        let now_s = self.now_s();
        self.grbl.hear(&came[..count], now_s);
        Ok(())
    }

    /// Puts back what was changed to speak to it.
    pub fn leave(mut self) -> Result<()> {
        let until = Instant::now() + ANSWERED;
        while let Some(changed) = self.grbl.changed()
            && !self.grbl.puts_back(changed)
            && Instant::now() < until
        {
            self.carry()?;
        }
        Ok(())
    }

    fn name(&self) -> String {
        self.grbl.facts().map(|facts| facts.name.clone()).unwrap_or_default()
    }

    /// Returns its settings; what was changed to speak to it is as it was.
    pub fn settings(&self) -> Settings {
        self.grbl.told_settings().into_iter().map(|told| (told.number, told.value)).collect()
    }

    /// Asks for its settings in its own words, where it has them, and for what each does where that is told.
    fn describes(&mut self, explains: bool) -> Result<()> {
        let mut asks = self.grbl.asks_settings();
        while asks {
            if !self.has_answered()? {
                bail!("{} does not answer $ES or $SED", self.name());
            }
            asks = explains && self.grbl.asks_settings();
        }
        Ok(())
    }

    /// Waits for its answers; tells whether they came.
    fn has_answered(&mut self) -> Result<bool> {
        let until = Instant::now() + ANSWERED;
        while !self.grbl.has_said_all() {
            if Instant::now() > until {
                return Ok(false);
            }
            self.carry()?;
        }
        Ok(true)
    }

    /// Changes a setting.
    pub fn set(&mut self, number: u16, value: &str) -> Result<()> {
        self.grbl.writes(number, value);
        if !self.has_answered()? {
            bail!("${number}={value} is not answered");
        }
        match (self.grbl.takes_refusal(), self.grbl.trouble()) {
            (Some(refused), _) => Err(anyhow!(refused)),
            (None, Some(trouble)) => Err(anyhow!("${number}={value}: {trouble}")),
            (None, None) => Ok(()),
        }
    }
}

/// A line with the name of a machine and what it is, where one of that name answers.
type Found = (String, String);

/// Looks for boards at all serial ports and under the names that they have in networks, side by side; prints each with its
/// firmware.
pub fn connect(more: &[String]) -> Result<Exit> {
    let (mut addresses, mut bridges) = (Vec::new(), vec![LINUXCNC_HERE]);
    for words in more {
        if words.starts_with("linuxcnc:") {
            bridges.push(words);
            continue;
        }
        addresses.push(Address::read(words).map_err(|why| Usage(format!("{words}: {why}")))?);
    }
    let serial = ports().into_iter().map(|path| Address::Serial { path, baud: Address::BAUD });
    let named = IN_NETWORKS.iter().filter_map(|words| Address::read(words).ok());
    addresses.extend(serial.chain(named));
    let bridges = beside(bridges);
    let mut found = found(addresses);
    found.extend(bridges.join().unwrap_or_default());
    if found.is_empty() {
        eprintln!(
            "kerf: no controller was found; name where one is: kerf machine connect tcp:192.168.1.20"
        );
        return Ok(Exit::Failed);
    }
    let lines: String = found.iter().map(|(at, name)| format!("{at:<35} {name}\n")).collect();
    out::print(&lines);
    Ok(Exit::Good)
}

/// Returns who answers in time, with the names of their firmware, in the order of the addresses.
fn found(addresses: Vec<Address>) -> Vec<Found> {
    let (tells, told) = channel();
    for (place, address) in addresses.into_iter().enumerate() {
        let tells = tells.clone();
        spawn(move || {
            let Ok(board) = Board::open(&address, FOUND) else {
                if let Some((at, name)) = step_board(&address) {
                    drop(tells.send((place, at, name)));
                }
                return;
            };
            let axes: String =
                "XYZABC".chars().take(board.grbl.facts().map_or(0, |it| it.axes)).collect();
            // Nobody listens any more where the time is over.
            let at = format!("grbl:{}", address.key());
            drop(tells.send((place, at, format!("{}, axes {axes}", board.name()))));
            drop(board.leave());
        });
    }
    drop(tells);
    gathered(&told)
}

/// Looks for a board with step queues at a serial port: its name, and its chip and firmware.
fn step_board(address: &Address) -> Option<Found> {
    let Address::Serial { path, .. } = address else { return None };
    let port = ListedPort { path: path.clone(), device: None };
    let (port, told) = at_ports(vec![port]).pop()?;
    let Introduced { dictionary, .. } = told.ok()?;
    let chip = dictionary.text("MCU").unwrap_or("unknown");
    let name = format!("{}, a board with step queues, {chip}", dictionary.version());
    Some((format!("klipper:{}", port.path), name))
}

/// Looks for LinuxCNC under these names, on a thread of its own.
fn beside(names: Vec<&str>) -> JoinHandle<Vec<Found>> {
    let names: Vec<String> = names.into_iter().map(str::to_owned).collect();
    spawn(move || names.iter().filter_map(|words| linuxcnc(words)).collect())
}

/// Returns what LinuxCNC is under a name, where it runs.
fn linuxcnc(words: &str) -> Option<Found> {
    let Ok(MachineName::Controller(name)) = MachineName::read(words) else { return None };
    let Place::Followed(socket) = socket(&name) else { return None };
    let (driver, line) = (socket.opens)().ok()?;
    let connection = Connection::open(words, driver, line).ok()?;
    let axes: String = "XYZABC".chars().take(connection.facts().axes).collect();
    Some((words.to_owned(), format!("{}, axes {axes}", connection.facts().name)))
}

fn gathered(told: &Receiver<(usize, String, String)>) -> Vec<Found> {
    let until = Instant::now() + FOUND + STEP_BOARD;
    let mut found = BTreeMap::new();
    while let Ok((place, at, name)) =
        told.recv_timeout(until.saturating_duration_since(Instant::now()))
    {
        found.insert(place, (at, name));
    }
    found.into_values().collect()
}

/// Prints the settings of a board, or does something with them.
pub fn settings(
    name: &DriverName,
    action: Option<&SettingsAction>,
    explains: bool,
) -> Result<Exit> {
    if name.is_linuxcnc() {
        bail!("LinuxCNC has its settings in its INI file: they are seen and changed there");
    }
    if let Some(SettingsAction::Restore { file }) = action {
        return restore(name, file);
    }
    let mut board = Board::open(&name.address, Duration::from_secs(8))?;
    let done = does(&mut board, action, explains);
    let left = board.leave();
    let exit = done?;
    left?;
    Ok(exit)
}

fn does(board: &mut Board, action: Option<&SettingsAction>, explains: bool) -> Result<Exit> {
    match action {
        None => {
            board.describes(explains)?;
            out::print(&listed(board, explains));
        }
        Some(SettingsAction::Set { number, value }) => {
            if let Some(why) = setting(*number).and_then(|it| it.refuses(value)) {
                bail!(Usage(why));
            }
            board.set(*number, value)?;
        }
        Some(SettingsAction::Backup { file }) => {
            std::fs::write(file, backup(&board.name(), &board.settings()))
                .with_context(|| format!("cannot write {}", file.display()))?;
        }
        // Done by `restore`, which opens the board twice.
        Some(SettingsAction::Restore { .. }) => {}
        Some(SettingsAction::Compare { with }) => {
            let others = match MachineName::read(with) {
                Ok(MachineName::Controller(name)) => {
                    let other = Board::open(&name.address, Duration::from_secs(8))?;
                    let settings = other.settings();
                    other.leave()?;
                    settings
                }
                _ => read(Path::new(with))?,
            };
            let differing = compared(&board.settings(), &others);
            out::print(&differing);
            return Ok(if differing.is_empty() { Exit::Good } else { Exit::Failed });
        }
    }
    Ok(Exit::Good)
}

/// A line a setting, with its name, unit and bounds: as the board tells them, else as they are known. Below it stands what it
/// does where that is wanted.
fn listed(board: &Board, explains: bool) -> String {
    let line = |told: ToldSetting| {
        let below = if explains { explanation(&told) } else { String::new() };
        let ToldSetting { number, value, name, unit, bounds, .. } = told;
        if name.is_empty() {
            return format!("${number}={value}\n{below}");
        }
        let bounds = match bounds {
            (None, None) => String::new(),
            (Some(least), None) => format!(" [{least} or more]"),
            (None, Some(most)) => format!(" [{most} or less]"),
            (Some(least), Some(most)) => format!(" [{least} to {most}]"),
        };
        let value = format!("${number}={value} {unit}");
        format!("{:<24} {name}{bounds}\n{below}", value.trim_end())
    };
    board.grbl.told_settings().into_iter().map(line).collect()
}

/// Explains a setting, and adds the board's own words below.
fn explanation(told: &ToldSetting) -> String {
    let own = told.own.lines().enumerate().map(|(n, line)| match n {
        0 => format!("    board: {line}\n"),
        _ => format!("           {line}\n"),
    });
    let does = Some(told.does).filter(|does| !does.is_empty());
    does.map(|does| format!("    {does}\n")).into_iter().chain(own).collect()
}

fn backup(board: &str, settings: &Settings) -> String {
    let lines: String =
        settings.iter().map(|(number, value)| format!("${number}={value}\n")).collect();
    format!("; {board}\n{lines}")
}

/// Reads a backup: a setting a line, what begins with a semicolon is none.
fn read(file: &Path) -> Result<Settings> {
    let text = given::text(file)?;
    let mut settings = Settings::new();
    for (n, line) in text.lines().map(str::trim).enumerate() {
        if line.is_empty() || line.starts_with(';') {
            continue;
        }
        let pair = line.strip_prefix('$').and_then(|rest| rest.split_once('='));
        let read = pair.and_then(|(number, value)| Some((number.parse().ok()?, value.to_owned())));
        let (number, value) = read.ok_or_else(|| {
            anyhow!("{}:{}: '{line}' is no setting as $110=5000", file.display(), n + 1)
        })?;
        settings.insert(number, value);
    }
    Ok(settings)
}

/// Makes a board's settings those of a file, and reads back what it wrote.
///
/// # Errors
/// A value is out of its bounds: nothing is written then. The board refuses one, or does not answer.
fn restore(name: &DriverName, file: &Path) -> Result<Exit> {
    let wanted = read(file)?;
    for (number, value) in &wanted {
        if let Some(why) = setting(*number).and_then(|it| it.refuses(value)) {
            bail!(Usage(format!("{}: {why}; nothing was changed", file.display())));
        }
    }
    let mut board = Board::open(&name.address, Duration::from_secs(8))?;
    let done = write_differing(&mut board, &wanted);
    let left = board.leave();
    let written = done?;
    left?;
    if written.is_empty() {
        return Ok(Exit::Good);
    }
    let board = Board::open(&name.address, Duration::from_secs(8))?;
    let has = board.settings();
    board.leave()?;
    let mut exit = Exit::Good;
    for number in written {
        let (value, is) = (&wanted[&number], has.get(&number).map_or("nothing", String::as_str));
        if !same(value, is) {
            eprintln!("kerf: the board was told ${number}={value} and has {is}");
            exit = Exit::Failed;
        }
    }
    Ok(exit)
}

/// Changes what differs and tells each; returns the numbers that it changed.
fn write_differing(board: &mut Board, wanted: &Settings) -> Result<Vec<u16>> {
    let (has, mut written) = (board.settings(), Vec::new());
    for (number, value) in wanted {
        match has.get(number) {
            Some(is) if same(is, value) => {}
            None => eprintln!("kerf: the board has no ${number}: left out"),
            Some(is) => {
                board.set(*number, value)?;
                out::print(&format!("${number}={value}, was {is}\n"));
                written.push(*number);
            }
        }
    }
    Ok(written)
}

/// Boards tell a thousandth at most.
const TOLD: f64 = 0.000_6;

fn same(a: &str, b: &str) -> bool {
    a == b || matches!((a.parse::<f64>(), b.parse::<f64>()), (Ok(a), Ok(b)) if (a - b).abs() < TOLD)
}

/// A line a setting that is another.
fn compared(here: &Settings, there: &Settings) -> String {
    let mut numbers: Vec<&u16> = here.keys().chain(there.keys()).collect();
    numbers.sort_unstable();
    numbers.dedup();
    let line = |number: &&u16| {
        let (a, b) = (here.get(number), there.get(number));
        if matches!((a, b), (Some(a), Some(b)) if same(a, b)) {
            return None;
        }
        let shown = |value: Option<&String>| value.map_or("-", |value| value.as_str()).to_owned();
        let name = setting(**number).map_or("", |it| it.name);
        Some(format!("${number:<5} {:<14} {:<14} {name}\n", shown(a), shown(b)))
    };
    numbers.iter().filter_map(line).collect()
}
