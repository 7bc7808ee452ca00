//! OpenSBP as one of the languages that a machine's owner can run.

use super::Interpreter;
use kerf_program::{At, Axes, FileCall, Frame, Host, Settings, Sourced, Step, Watch};
use std::sync::Arc;

impl kerf_program::Interpreter for Interpreter {
    fn step(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        Self::step(self, host, out)
    }

    fn run(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>, lines: u64) -> Step {
        Self::run(self, host, out, lines)
    }

    fn interrupt(&mut self, watch: &Watch, motion: Option<u64>, position: Axes) {
        Self::interrupt(self, watch, motion, position);
    }

    fn nudge(&mut self, by: Axes) {
        Self::nudge(self, by);
    }

    fn carried_out(&mut self, motion: u64) {
        Self::carried_out(self, motion);
    }

    fn stop(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        Self::stop(self, host, out)
    }

    fn limit(&mut self, host: &mut dyn Host, out: &mut Vec<Sourced>) -> Step {
        Self::limit(self, host, out)
    }

    fn watches(&self) -> Vec<Watch> {
        Self::watches(self).cloned().collect()
    }

    fn file_name(&self, file: u32) -> Option<Arc<str>> {
        self.program(file).map(|p| p.name.clone())
    }

    fn file_call(&self, file: u32) -> Option<FileCall> {
        Self::file_call(self, file)
    }

    fn call_stack(&self) -> Vec<At> {
        Self::call_stack(self).collect()
    }

    fn motions(&self) -> u64 {
        Self::motions(self)
    }

    fn lines(&self) -> u64 {
        Self::lines(self)
    }

    fn settings(&self) -> &Arc<Settings> {
        Self::settings(self)
    }

    fn frame(&self) -> &Frame {
        Self::frame(self)
    }

    fn position(&self) -> Axes {
        Self::position(self)
    }

    fn variables(&self) -> Vec<(String, String)> {
        let list = Self::variables(self).list();
        list.into_iter().map(|(name, value)| (name, value.display())).collect()
    }
}
