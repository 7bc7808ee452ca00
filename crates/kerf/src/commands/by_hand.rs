//! `kerf machine home`, `warm-up`, `move` and `pos`: the machine moved by hand.

use super::axis_words::{axes_named, axes_with_switch, numbers, pair, ways};
use super::shop::Shop;
use super::which::Which;
use crate::controller::First;
use crate::exit::{Exit, Usage};
use crate::remote::{Ended, Remote, beside};
use crate::summary::told_by_server;
use crate::{out, parse};
use anyhow::{Result, bail};
use clap::{Args, Subcommand};
use kerf_control::OperatorRequest;
use kerf_journal::Work;
use kerf_machine::hand::{cut_move, warm_steps};
use kerf_machine::{Errand, Held};
use kerf_program::Axis;
use kerf_wire::ByHand;
use std::sync::Arc;

/// Moves the machine by hand.
#[derive(Args)]
pub struct MoveArgs {
    #[command(subcommand)]
    way: MoveAction,
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
enum MoveAction {
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

impl MoveAction {
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

/// The server that has the machine, where one runs on its data folder.
fn server(which: &Which) -> Result<Option<Remote>> {
    beside(&which.folder(), &which.machine)
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
        MoveAction::Home { axes } => {
            let all = shop.machine.motors.axes();
            Errand::Home(axes_named(&shop.machine, axes.as_deref(), all)?)
        }
        MoveAction::Origin => Errand::Origin,
        MoveAction::Finish => Errand::Finish,
        MoveAction::To { place, relative, flat } => {
            Errand::To { place: numbers(place)?, relative: *relative, flat: *flat }
        }
        MoveAction::CutTo { place, cut } => {
            let at = pair(place)?;
            if *cut {
                let job = cut_move(&shop.machine, shop.session.memory.position, at);
                let machine = shop.machine.clone();
                return shop.does(Work::Job(Arc::new(job), machine), requests);
            }
            Errand::CutMoveTo(at)
        }
        MoveAction::Hold { way, speed, accel, seconds } => {
            requests.extend(seconds.map(|seconds| (seconds, OperatorRequest::End)));
            let [speed, accel] = [*speed, *accel].map(|percent| f64::from(percent) / 100.0);
            Errand::Held(Held { way: ways(&shop.machine, way)?, speed, accel, sets_bottom: false })
        }
    };
    shop.errand(errand, requests)
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
