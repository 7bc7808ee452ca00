//! kerf-cut
use kerf_program::MoveKind;
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    Line { kind: MoveKind, to: [f64; 3] },
    Arc { centre: [f64; 2], sweep_rad: f64, to: [f64; 3], chords: u32, small: bool },
}
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Tabber<T> {
    x: Option<T>,
}
impl<T: Copy> Tabber<T> {
    pub fn new(_: &kerf_program::settings::Tabs, _: Option<f64>) -> Self {
        Self { x: None }
    }
    pub fn push(&mut self, _from: [f64; 3], step: Step, tag: T, out: &mut Vec<(T, Step)>) {
        out.push((tag, step));
    }
    pub fn flush(&mut self, _: &mut Vec<(T, Step)>) {}
    pub fn path_end(&mut self, _: &mut Vec<(T, Step)>) {}
    pub fn drop_buffered(&mut self) {}
}
