//! Commands to moves to planned motion.
//!
//! Two steps. A [`Mover`] keeps the position and the settings in force and turns the motion
//! commands of `kerf-program` into [`Move`]s: where from, where to, along what, and how fast at
//! most. A model of motion ([`ShopBot`], the ramps of the OpenSBP command reference; [`Profiler`],
//! smoothed sections and stops; [`Optimal`], all that the axes can do) makes a [`Plan`] of a stack of moves, which answers where every axis is
//! at time t, how fast, and in which move. Time estimate, picture, simulation and real run all ask
//! the same plan.
//!
//! ```text
//!  Line, Arc ── Mover ──► Move … Move ── Planner ──► Plan, Plan … ── at(t), span_s(i), stop(t), …
//! ```
//!
//! A stack is planned while it is read: a [`Planner`] takes moves and gives finished pieces of plan,
//! and keeps only what a later move can still change. [`Model::plan`] plans a whole stack at once,
//! with the same outcome.
//!
//! Beside this, [`Stepper`] finds when each motor steps, and [`controllers`] tells how long other
//! controllers would take for the same moves.
//!
//! Everything is in the machine frame, in millimetres, seconds and degrees; every number that is
//! not says so in its name (`_rad`, `_percent`). A speed of a move is a speed along its *reference
//! length* (see [`Move::length_mm`]), which is the XY path for a cut of OpenSBP: the manual's speeds
//! are XY vector speeds, and Z, A and B only follow.
//!
//! ```
//! use kerf_motion::{Mover, plan_stack};
//! use kerf_program::{At, Axes, Feed, Line, MoveKind, Settings};
//!
//! let settings = Settings::default();
//! let mut mover = Mover::new(Axes::default(), &settings);
//! let to = Axes::xyz(101.6, 0.0, 0.0);
//! let line = Line { kind: MoveKind::Cut, to, feed: Feed::Axis };
//! let moves = mover.line(At::default(), &line).into_iter().collect();
//! let plan = plan_stack(moves, &settings.ramps);
//! assert!((plan.duration_s() - 2.0914).abs() < 1e-4);
//! assert_eq!(plan.at(plan.duration_s()).position, to);
//! ```

mod ahead;
mod caps;
mod chain;
mod clock;
pub mod controllers;
mod corner;
mod course;
mod ease;
mod fit;
mod in_force;
mod leg;
mod mover;
mod moves;
mod optimal;
mod pass;
mod plan;
mod planner;
mod profile;
mod profiler;
mod quartic;
mod queue;
mod ramped;
mod rejoin;
mod retimed;
mod shopbot;
mod sketch;
mod slowing;
mod splice;
mod state;
mod steps;
mod stop;
mod surge;
mod turns;
mod window;

pub use in_force::planner;
pub use leg::{Leg, Rest};
pub use mover::Mover;
pub use moves::{Move, Path};
pub use optimal::{Optimal, OptimalPlanner};
pub use pass::Pass;
pub use plan::{Plan, Span};
pub use planner::{Model, Planner, Replanner};
pub use profiler::{Profiler, ProfilerPlanner};
pub use queue::Queue;
pub use retimed::Retimed;
pub use shopbot::{ShopBot, plan_stack};
pub use sketch::Mark;
pub use state::State;
pub use steps::{Step, Stepper};
pub use stop::Stop;
pub use window::ShopBotPlanner;
