//! `kerf machine home`, `move`, `zset` and `pos`: the machine moved by hand.

use super::which::Which;
use crate::args::PlaceArgs;
use crate::controller::{self, Beginning, First};
use crate::data_args::data_folder;
use crate::exit::{Exit, Usage};
use crate::operator::{Clock, Person, Terminal};
use crate::remote::{Ended, Remote, beside};
use crate::report::asked;
use crate::stop::Stop;
use crate::summary::told_by_server;
use crate::{out, parse, served, setup};
use anyhow::{Result, bail};
use clap::{Args, Subcommand};
use kerf_control::answers::Answers;
use kerf_control::controller::Controller;
use kerf_control::{AtRest, OperatorRequest, RunContext, Script, Session};
use kerf_journal::{RunOptions, Work};
use kerf_machine::hand::cut_move;
use kerf_machine::hand::warm_steps;
use kerf_machine::{Configuration, Errand, Held, Value, file, table};
use kerf_program::{AXES, Axis, AxisSet, MoveKind, Status, rounded};
use kerf_trace::{Event, Sink};
use kerf_wire::ByHand;
use kerf_workspace::{Workspace, unverified};
use std::io::{self, IsTerminal};
use std::path::Path;
use std::sync::Arc;

/// Moves the machine by hand.
#[derive(Args)]
pub struct MoveArgs {
    #[command(subcommand)]
    way: Way,
    /// Takes as long as the machine does
    #[arg(long, global = true)]
    real: bool,
    #[command(flatten)]
    there: ServerArgs,
}

/// Options for where a running `kerf serve` has the machine, which then moves it.
#[derive(Args, Clone, Copy)]
pub struct ServerArgs {
    /// Arms the machine first, where a running kerf serve has it
    #[arg(long, global = true)]
    pub arm: bool,
}

#[derive(Subcommand)]
enum Way {
    /// To home on some axes, Z first
    Home {
        /// Their letters, as xy; all when not given
        axes: Option<String>,
    },
    /// To the job origin in X and Y
    Origin,
    /// To the finish position of jobs in X and Y
    Finish,
    /// To a place: X and Y from the job origin, the others from home, millimetres
    To {
        /// X,Y,Z; an axis left empty stays
        #[arg(allow_hyphen_values = true)]
        place: String,
        /// From where the tool is
        #[arg(long)]
        relative: bool,
        /// X and Y first, then the others
        #[arg(long)]
        flat: bool,
    },
    /// To a place in X and Y, from the job origin
    CutTo {
        /// X,Y
        #[arg(allow_hyphen_values = true)]
        place: String,
        /// Cuts, as a job of one line
        #[arg(long)]
        cut: bool,
    },
    /// As an arrow key that is held: x+, x-, y+x- …
    Hold {
        /// Which way
        #[arg(allow_hyphen_values = true)]
        way: String,
        /// Percent of the highest speed of each axis
        #[arg(long, default_value_t = 25, value_parser = clap::value_parser!(u8).range(1..=100))]
        speed: u8,
        /// Percent of the highest acceleration of each axis
        #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u8).range(1..=100))]
        accel: u8,
        /// How long the key is held, seconds; until a bound when not given
        #[arg(long = "for", value_name = "SECONDS", value_parser = parse::not_negative)]
        seconds: Option<f64>,
    },
}

impl Way {
    /// The same for a server.
    fn by_hand(&self) -> Result<ByHand> {
        Ok(match self {
            Self::Home { axes } => ByHand::Home { axes: axes.clone() },
            Self::Origin => ByHand::Origin,
            Self::Finish => ByHand::Finish,
            Self::To { place, relative, flat } => {
                ByHand::Place { place: numbers(place)?, relative: *relative, flat: *flat }
            }
            Self::CutTo { place, cut } => ByHand::CutMove { at: pair(place)?, cut: *cut },
            Self::Hold { .. } => bail!(Usage(
                "a kerf serve has this machine: hold a key of its console, which lets go when you do".into()
            )),
        })
    }
}

/// A special height.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum SpecialHeight {
    Top,
    Surface,
    Bottom,
}

impl SpecialHeight {
    const fn key(self) -> &'static str {
        match self {
            Self::Top => "zpos.top_mm",
            Self::Surface => "zpos.surface_mm",
            Self::Bottom => "zpos.bottom_mm",
        }
    }
}

/// The machine, while somebody works on it by hand.
pub struct Shop {
    pub session: Session,
    pub workspace: Workspace,
    machine: Arc<Configuration>,
    pub controller: Option<Controller>,
    place: PlaceArgs,
    real: bool,
}

impl Shop {
    /// The machine that is named.
    pub fn open(which: &Which, real: bool) -> Result<Self> {
        Self::open_after(which, First::NONE, real)
    }

    /// The machine after steps of its controller.
    pub fn open_after(which: &Which, first: First, real: bool) -> Result<Self> {
        let place = which.place();
        let mut workspace = setup::workspace(Path::new(""), &place, false)?;
        let (mut session, _) = setup::session(&place, false, &mut workspace)?;
        let machine = match which.machine.configuration() {
            Some(_) => which.machine()?,
            None => session.configuration(),
        };
        let machine = Arc::new(machine);
        session.machine_is = machine.clone();
        let name = which.machine.controller();
        let beginning = Beginning { first, quiet: false, log: None };
        let ready = |name| controller::ready(name, beginning, &mut session, &mut workspace);
        let controller = name.map(ready).transpose()?;
        Ok(Self { session, workspace, machine, controller, place, real })
    }

    /// Fails unless the machine stands, and its place in X and Y is known.
    fn stands_for_sure(&self) -> Result<()> {
        if let Some(journal) = self.workspace.journal() {
            drop(journal.own()?);
        }
        let doubted = unverified(&self.workspace);
        if doubted.contains(Axis::X) || doubted.contains(Axis::Y) {
            bail!(
                "where the machine is is not known for sure: home it first (kerf machine home), or give \
                 the place as X,Y"
            );
        }
        Ok(())
    }

    /// Carries out a line, as if it were typed at the machine, unless its controller lacks what that needs.
    pub fn types(&mut self, line: &str) -> Result<Exit> {
        let read = || Work::from(kerf_sbp::read_typed("typed".into(), &format!("{line}\n")));
        let mut options = RunOptions::default();
        options.program.typed = true;
        if let Some(controller) = &self.controller {
            let files = setup::workspace(Path::new(""), &self.place, true)?;
            let (session, answers) = (&self.session, Answers::default());
            let work = read();
            let lacks =
                controller::look_through(controller, &work, session, &options, files, answers);
            if let Some(exit) = lacks {
                controller.detach(&mut self.workspace);
                return Ok(exit);
            }
        }
        self.does_with(read(), options, Vec::new())
    }

    /// Looks at the controller for what its inputs tell.
    pub fn look(&mut self) {
        let Some(controller) = &self.controller else { return };
        for input in controller.attend().0 {
            AtRest(&mut self.session).senses(input);
        }
    }

    /// Lifts the tool straight up to Safe-Z, where a stop has left it lower.
    pub fn lifts(&mut self) -> Result<()> {
        // The stop that ended it is over.
        Stop::listen()?.hear();
        let Some(up_mm) = self.session.lift_mm() else { return Ok(()) };
        let mut place = [None; AXES];
        place[Axis::Z.index()] = Some(up_mm);
        self.errand(Errand::To { place, relative: false, flat: false }, Vec::new())?;
        Ok(())
    }

    /// The controller was moved by what it ran by itself: the machine is believed to stand where it stands now.
    pub fn stands_where_it_stands(&mut self) -> Result<()> {
        let Some(controller) = &self.controller else { return Ok(()) };
        if let (_, Some(place)) = controller.attend() {
            self.session.memory.position = place;
        }
        self.session.keep_place(&mut self.workspace)?;
        controller.ends(true, &mut self.workspace, || false);
        Ok(())
    }

    /// The controller is left as it was found.
    pub fn leave(&mut self) {
        if let Some(controller) = &self.controller {
            controller.detach(&mut self.workspace);
        }
    }

    /// Does something and prints each step of it.
    fn does(&mut self, work: Work, requests: Vec<(f64, OperatorRequest)>) -> Result<Exit> {
        self.does_with(work, RunOptions::default(), requests)
    }

    fn does_with(
        &mut self,
        work: Work,
        options: RunOptions,
        requests: Vec<(f64, OperatorRequest)>,
    ) -> Result<Exit> {
        let clock = if self.real { Clock::Real } else { Clock::Fast };
        let mut terminal = Terminal::new(clock, Script::new(requests, Vec::new()))?;
        let mut operator = Person::new(Answers::default(), io::stdin().is_terminal(), &terminal);
        let controller = self.controller.clone();
        let machine =
            controller.as_ref().map_or_else(|| terminal.simulated(), |it| it.driven().into());
        let stop = Stop::listen()?;
        let mut steps = Steps { machine: self.machine.clone(), edge: None };
        let context = RunContext {
            sink: &mut steps,
            operator: &mut operator,
            requests: &mut terminal,
            machine,
        };
        let (settings, workspace) =
            (Some(self.session.memory.settings.clone()), &mut self.workspace);
        let name = controller.as_ref().map(|it| it.name().to_owned());
        let options = RunOptions { controller: name, ..options };
        controller.iter().for_each(|controller| controller.begins(workspace));
        let summary = self.session.run_on_record(work, options, settings, workspace, context)?;
        if let Some(controller) = &controller {
            controller.ends(summary.status == Status::Ok, workspace, || stop.is_wanted());
            controller.detach(workspace);
        }
        if let Some(error) = summary.error {
            let mend = if error.hint.is_empty() { "" } else { "; " };
            eprintln!("kerf: {}{mend}{}", error.message, error.hint);
        }
        Ok(summary.status.into())
    }

    fn errand(&mut self, errand: Errand, requests: Vec<(f64, OperatorRequest)>) -> Result<Exit> {
        self.does(Work::Hand(errand, self.machine.clone()), requests)
    }
}

/// The server that has the machine, where one runs on its data folder.
fn server(which: &Which) -> Result<Option<Remote>> {
    beside(&which.folder(), &which.machine)
}

/// Refuses to change what a running server would not know of.
pub fn not_beside_a_server(which: &Which, mend: &str) -> Result<()> {
    let folder = data_folder(&which.folder())?;
    match served::address(&folder)? {
        None => Ok(()),
        Some(address) => {
            bail!("a kerf serve has this machine: {mend} at {address}, or end it first")
        }
    }
}

/// The exit of a move that a server made.
fn went(ended: &Ended) -> Exit {
    told_by_server(ended, true)
}

/// Homes axes; all that have a switch when not told which.
pub fn home(which: &Which, letters: Option<&str>, unlock: bool, there: ServerArgs) -> Result<Exit> {
    if unlock && which.machine.controller().is_none() {
        bail!(Usage("--unlock is about a controller: name it with --machine".into()));
    }
    if let Some(server) = server(which)? {
        if unlock {
            bail!("a `kerf serve` has the machine: unlock it at its own panel");
        }
        let way = ByHand::FindHome { axes: letters.map(str::to_owned) };
        return Ok(went(&server.go(&way, there.arm)?));
    }
    if which.machine.controller().is_some() {
        return home_controller(which, unlock);
    }
    let mut shop = Shop::open(which, false)?;
    let axes = axes_with_switch(&shop.machine, letters)?;
    shop.errand(Errand::FindHome(axes), Vec::new())
}

/// Warms the spindle up.
pub fn warm_up(which: &Which, steps: &Option<String>, there: ServerArgs) -> Result<Exit> {
    let steps = steps.clone();
    if let Some(server) = server(which)? {
        return Ok(went(&server.go(&ByHand::WarmUp { steps }, there.arm)?));
    }
    let mut shop = Shop::open(which, true)?;
    let steps = steps.unwrap_or_else(|| shop.machine.options.warm_up.clone());
    let read = warm_steps(&steps).map_err(Usage);
    if read.is_err() {
        shop.leave();
    }
    shop.errand(Errand::WarmUp(read?.into()), Vec::new())
}

/// Has a controller go home with all axes that it homes, and tells where they stand.
fn home_controller(which: &Which, unlock: bool) -> Result<Exit> {
    let mut shop = Shop::open_after(which, First::going_home(unlock), false)?;
    shop.session.keep_place(&mut shop.workspace)?;
    if let Some(controller) = &shop.controller {
        controller.ends(true, &mut shop.workspace, || false);
        controller.detach(&mut shop.workspace);
    }
    tell_places(&shop);
    Ok(Exit::Good)
}

pub fn moves(which: &Which, args: &MoveArgs) -> Result<Exit> {
    if let Some(server) = server(which)? {
        return Ok(went(&server.go(&args.way.by_hand()?, args.there.arm)?));
    }
    let mut shop = Shop::open(which, args.real)?;
    let mut requests = Vec::new();
    let errand = match &args.way {
        Way::Home { axes } => {
            let all = shop.machine.motors.axes();
            Errand::Home(axes_named(&shop.machine, axes.as_deref(), all)?)
        }
        Way::Origin => Errand::Origin,
        Way::Finish => Errand::Finish,
        Way::To { place, relative, flat } => {
            Errand::To { place: numbers(place)?, relative: *relative, flat: *flat }
        }
        Way::CutTo { place, cut } => {
            let at = pair(place)?;
            if *cut {
                let job = cut_move(&shop.machine, shop.session.memory.position, at);
                let machine = shop.machine.clone();
                return shop.does(Work::Job(Arc::new(job), machine), requests);
            }
            Errand::CutMoveTo(at)
        }
        Way::Hold { way, speed, accel, seconds } => {
            requests.extend(seconds.map(|seconds| (seconds, OperatorRequest::End)));
            let [speed, accel] = [*speed, *accel].map(|percent| f64::from(percent) / 100.0);
            Errand::Held(Held { way: ways(&shop.machine, way)?, speed, accel, sets_bottom: false })
        }
    };
    shop.errand(errand, requests)
}

/// Records where Z is as one of its special heights, or puts the height by a distance.
pub fn zset(
    which: &Which,
    height: SpecialHeight,
    to: Option<f64>,
    by: Option<f64>,
) -> Result<Exit> {
    not_beside_a_server(which, "set Z top, surface or bottom on its page Job")?;
    let mut shop = Shop::open(which, false)?;
    let setting = table::setting(height.key());
    let Some(setting) = setting else { bail!("no setting {}", height.key()) };
    if by.is_none() {
        let z = to.unwrap_or(shop.session.memory.position[Axis::Z]);
        changed(&shop.machine, setting, &Value::Number(rounded(z, 6)))?;
        let exit = drive_there(&mut shop, height, to)?;
        if exit != Exit::Good {
            return Ok(exit);
        }
    }
    let before = setting.get(&shop.machine);
    let z = match (by, before) {
        (Some(by), Value::Number(before)) => before + by,
        _ => shop.session.memory.position[Axis::Z],
    };
    keep(which, &shop.machine, setting, Value::Number(rounded(z, 6)))
}

/// Changes a setting in the file of the machine, and tells it.
fn keep(
    which: &Which,
    machine: &Configuration,
    setting: &'static table::Setting,
    value: Value,
) -> Result<Exit> {
    let kept = which.to_change()?;
    let _alone = kept.alone();
    let text = kept.text()?.unwrap_or_default();
    let wanted = changed(machine, setting, &value)?;
    kept.write(&file::edit(&text, setting, &wanted))?;
    out::print(&format!("{} = {}\n", setting.key, setting.get(&wanted)));
    Ok(Exit::Good)
}

/// The machine with another value of a setting.
///
/// # Errors
/// The value is none of the setting, or contradicts another one.
fn changed(
    machine: &Configuration,
    setting: &'static table::Setting,
    value: &Value,
) -> Result<Configuration> {
    let mut wanted = machine.clone();
    setting.set(&mut wanted, value).map_err(|refused| Usage(refused.to_string()))?;
    if let Some(crossed) = kerf_machine::contradictions::contradictions(&wanted).first() {
        bail!(Usage(format!("{}; {}", crossed.message, crossed.hint)));
    }
    Ok(wanted)
}

/// Prints the job origin, or sets it: to where the tool is, or to a place from home.
pub fn origin(which: &Which, place: Option<&str>) -> Result<Exit> {
    let shop = Shop::open(which, false)?;
    let Some(setting) = table::setting("job.origin_mm") else { bail!("no setting job.origin_mm") };
    if place.is_some() {
        not_beside_a_server(which, "set the origin on its page Job")?;
    }
    let at = match place {
        None => {
            out::print(&format!("{} = {}\n", setting.key, setting.get(&shop.machine)));
            return Ok(Exit::Good);
        }
        Some("here") => {
            shop.stands_for_sure()?;
            let position = shop.session.memory.position;
            [position[Axis::X], position[Axis::Y]]
        }
        Some(place) => {
            let [Some(x), Some(y), None, None, None, None] = numbers(place)? else {
                bail!(Usage("give X,Y or here".into()))
            };
            [x, y]
        }
    };
    let value = Value::List(at.map(|v| Value::Number(rounded(v, 6))).into());
    keep(which, &shop.machine, setting, value)
}

/// Z is homed first where jobs home it; then it goes to the height that is to be recorded.
fn drive_there(shop: &mut Shop, height: SpecialHeight, to: Option<f64>) -> Result<Exit> {
    let stood = shop.session.memory.position[Axis::Z];
    let homes = shop.machine.homing.at_job_start.contains(Axis::Z);
    let mut shift = 0.0;
    if homes {
        let exit = shop.errand(Errand::FindHome(AxisSet::EMPTY.with(Axis::Z)), Vec::new())?;
        if exit != Exit::Good {
            return Ok(exit);
        }
        shift = stood;
    }
    let Some(z) = to.or(homes.then_some(shift)) else { return Ok(Exit::Good) };
    let mut free = (*shop.machine).clone();
    if height == SpecialHeight::Bottom {
        // It is being set: it does not bound the way.
        free.zpos.bottom_mm = free.zpos.bottom_mm.min(z);
    }
    let machine = std::mem::replace(&mut shop.machine, Arc::new(free));
    let mut place = [None; AXES];
    place[Axis::Z.index()] = Some(z);
    let exit = shop.errand(Errand::To { place, relative: false, flat: false }, Vec::new());
    shop.machine = machine;
    exit
}

/// Prints the places of the axes, and which are homed.
pub fn pos(which: &Which) -> Result<Exit> {
    tell_places(&Shop::open(which, false)?);
    Ok(Exit::Good)
}

/// Prints the places of the axes, and which are homed.
fn tell_places(shop: &Shop) {
    let position = shop.session.memory.position;
    for axis in Axis::ALL {
        if shop.machine.motors.of_axis(axis).is_empty() {
            continue;
        }
        let homed = if shop.session.homed.contains(axis) { "homed" } else { "not homed" };
        let name = shop.machine.motors.axis_name(axis);
        out::print(&format!("{name:<2} {:.3} {homed}\n", position[axis] + 0.0));
    }
    let [x0, y0] = shop.machine.job.origin_mm;
    if [x0, y0] != [0.0; 2] {
        let [x, y] = [position[Axis::X] - x0, position[Axis::Y] - y0].map(|v| v + 0.0);
        out::print(&format!("{x:.3},{y:.3} from the job origin\n"));
    }
}

/// Prints motions, homed axes, messages and questions.
struct Steps {
    machine: Arc<Configuration>,
    /// The switch that changed during the motion at hand.
    edge: Option<f64>,
}

impl Sink for Steps {
    fn event(&mut self, event: &Event) {
        match event {
            Event::Input { t, .. } => self.edge = Some(*t),
            Event::Move(made) => {
                let ways = Axis::ALL.map(|axis| made.to.of(axis) - made.from.of(axis));
                let length = ways[..3].iter().map(|way| way * way).sum::<f64>().sqrt();
                for axis in Axis::ALL {
                    let (from, to) = (made.from.of(axis), made.to.of(axis));
                    if (from - to).abs() > 1e-9 {
                        let name = self.machine.motors.axis_name(axis);
                        let kind = if made.kind == MoveKind::Cut { ", cut" } else { "" };
                        let (t0, t1) = (made.t0, made.t1);
                        let span = format!("{t0:8.3} to {t1:8.3} s");
                        let way = format!("{name:<2} {from:9.3} to {to:9.3}");
                        // The speed is that along the path; an axis has its part of it.
                        let part = if length > 0.0 { (to - from).abs() / length } else { 1.0 };
                        let speed = made.speed * part;
                        out::print(&format!("{span}  {way}, up to {speed:.3}/s{kind}\n"));
                    }
                }
                if let Some(t) = self.edge.take() {
                    out::print(&format!("{t:8.3} s  a switch changed\n"));
                }
            }
            Event::Homed { axis, steps, .. } => out::print(&format!("{axis} {steps} steps\n")),
            Event::Message { text, .. } => out::print(&format!("{text}\n")),
            Event::Ask(ask) => out::print(&format!("{}\n", asked(ask))),
            _ => {}
        }
    }
}

/// Axes that can be homed: those that are named, else all that have a switch.
fn axes_with_switch(c: &Configuration, letters: Option<&str>) -> Result<AxisSet> {
    let fitted = |axis: &Axis| c.homing.of(*axis).fitted;
    let all = Axis::ALL.into_iter().filter(fitted).fold(AxisSet::EMPTY, AxisSet::with);
    let axes = axes_named(c, letters, all)?;
    if axes.is_empty() {
        bail!("no axis of this machine has a home switch: nothing was homed (homing.x.fitted)");
    }
    match axes.iter().find(|axis| !all.contains(*axis)) {
        None => Ok(axes),
        Some(axis) => bail!(
            "axis {0} has no home switch: nothing was homed (homing.{0}.fitted)",
            c.motors.axis_name(axis)
        ),
    }
}

/// Axes by their letters.
pub fn axes_named(c: &Configuration, letters: Option<&str>, all: AxisSet) -> Result<AxisSet> {
    let Some(letters) = letters else { return Ok(all) };
    if letters.is_empty() {
        bail!(Usage("name axes by their letters, as xy".into()));
    }
    letters.chars().try_fold(AxisSet::EMPTY, |set, letter| Ok(set.with(named(c, letter)?)))
}

fn named(c: &Configuration, letter: char) -> Result<Axis> {
    let axis = c.motors.axis_called(letter);
    axis.ok_or_else(|| Usage(format!("there is no axis {letter}")).into())
}

/// `10,20,-5`; empty places stay.
pub fn numbers(text: &str) -> Result<[Option<f64>; AXES]> {
    let mut all = [None; AXES];
    for (i, word) in text.split(',').enumerate() {
        let Some(place) = all.get_mut(i) else { bail!(Usage("six axes at the most".into())) };
        if !word.trim().is_empty() {
            let number = word.trim().parse().ok().filter(|n: &f64| n.is_finite());
            *place = Some(number.ok_or_else(|| Usage(format!("'{word}' is no number")))?);
        }
    }
    Ok(all)
}

/// `10,20`: X and Y.
fn pair(text: &str) -> Result<[f64; 2]> {
    match numbers(text)? {
        [Some(x), Some(y), None, None, None, None] => Ok([x, y]),
        _ => bail!(Usage("give X,Y".into())),
    }
}

/// `x+`, `x+y-`: which way each axis goes.
fn ways(c: &Configuration, text: &str) -> Result<[i8; AXES]> {
    let mut all = [0; AXES];
    let letters: Vec<char> = text.chars().filter(|c| *c != ',').collect();
    let wrong = || Usage("an axis and + or -, as x+".into());
    for pair in letters.chunks(2) {
        let &[letter, sign] = pair else { bail!(wrong()) };
        let way = &mut all[named(c, letter)?.index()];
        if *way != 0 {
            bail!(Usage(format!("{letter} is named twice: an axis goes one way")));
        }
        *way = match sign {
            '+' => 1,
            '-' => -1,
            _ => bail!(wrong()),
        };
    }
    if letters.is_empty() { Err(wrong().into()) } else { Ok(all) }
}
