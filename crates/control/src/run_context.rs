//! The participants that a run is lent, beside its program and its workspace.

use crate::Requests;
use crate::answers::Operator;
use kerf_sim::Opened;
use kerf_trace::Sink;

/// Participants of a run beside program and machine.
pub struct RunContext<'a> {
    /// Takes the events.
    pub sink: &'a mut dyn Sink,
    /// Answers questions.
    pub operator: &'a mut dyn Operator,
    /// Requests of the operator.
    pub requests: &'a mut dyn Requests,
    /// The machine that makes what is planned.
    pub machine: Opened,
}

impl RunContext<'_> {
    /// The same context for something that comes first.
    pub fn again(&mut self) -> RunContext<'_> {
        let Self { sink, operator, requests, machine } = self;
        RunContext {
            sink: &mut **sink,
            operator: &mut **operator,
            requests: &mut **requests,
            machine: machine.clone(),
        }
    }
}
