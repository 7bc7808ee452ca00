//! The whole state of a running program: values with a state of their own, and what follows from several of them.

mod files;
mod flow;
mod given;
mod handlers;
mod idling;
mod path;
mod place;
mod user_files;
mod values;
mod variables;

pub(crate) use files::Files;
pub(crate) use flow::{Flow, Level, Purpose};
pub(crate) use given::Given;
pub(crate) use handlers::{Handler, Handlers};
pub(crate) use idling::Idling;
pub(crate) use path::{Cutting, Origin};
pub(crate) use place::RunPosition;
pub(crate) use user_files::{UserFile, UserFiles};
pub(crate) use values::Values;
pub(crate) use variables::Memory;
pub use variables::Variables;

use super::session::{Options, Session};
use crate::syntax::Program;
use kerf_program::{Answers, Axes, Axis};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// The state: what is saved, cloned and restored.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) struct Core {
    pub(crate) options: Options,
    /// Programs read so far. Saved once for all states, see `saving`.
    #[serde(skip)]
    pub(crate) files: Files,
    pub(crate) flow: Flow,
    pub(crate) values: Values,
    pub(crate) place: RunPosition,
    pub(crate) cutting: Cutting,
    pub(crate) handlers: Handlers,
    pub(crate) answers: Answers,
    pub(crate) given: Given,
    pub(crate) idling: Idling,
    pub(crate) user_files: UserFiles,
    pub(crate) memory: Memory,
}

impl Core {
    pub(crate) fn new(program: Arc<Program>, session: Session, options: Options) -> Self {
        let mut core = Self {
            files: Files::default(),
            flow: Flow::default(),
            values: Values::new(session.settings),
            cutting: Cutting::new(session.heading.filter(|_| options.typed)),
            place: RunPosition {
                frame: session.frame,
                position: session.position,
                offset_applied: session.offset_applied,
                independent: session.independent,
                before_preview: session.before_preview,
                ..RunPosition::default()
            },
            handlers: Handlers::default(),
            answers: Answers::default(),
            given: Given::default(),
            idling: Idling::default(),
            user_files: UserFiles::default(),
            memory: Memory::new(session.variables, options.seed),
            options,
        };
        core.load(program);
        core
    }

    /// Adds a program, or finds the same one read before.
    pub(crate) fn load(&mut self, program: Arc<Program>) -> u32 {
        self.files.load(program, &mut self.memory.variables)
    }

    /// Internal units of one unit in the file, after settings or the level changed.
    pub(crate) fn refresh_scale(&mut self) {
        let (settings, flow) = (&self.values.settings, &self.flow);
        let scale = |axis: Axis| settings.axis_scale(axis) * flow.proportion(axis);
        self.place.scale = Axis::ALL.map(scale);
    }

    /// The workpiece lies elsewhere by so much: what the program knows in the machine frame follows.
    pub(crate) fn nudge(&mut self, by: Axes) {
        self.place.nudge(by);
        for level in &mut self.flow.levels {
            level.start_z = level.start_z.map(|z| z + by[Axis::Z]);
        }
    }

    /// Returns `true` if an axis may be elsewhere than the program sent it: MI or torch height moves it.
    pub(crate) fn wanders(&self, axis: Axis) -> bool {
        self.place.independent.contains(axis) || axis == Axis::Z && self.values.settings.torch_on()
    }

    pub(crate) fn into_session(self) -> Session {
        Session {
            settings: Arc::unwrap_or_clone(self.values.settings),
            frame: self.place.frame,
            position: self.place.position,
            variables: self.memory.variables,
            independent: self.place.independent,
            offset_applied: self.place.offset_applied,
            heading: self.cutting.heading,
            before_preview: self.place.before_preview,
        }
    }
}
