//! The machine stands and nothing is typed: the digits move the tool.

use crate::next::{Next, To};
use crate::{COLUMNS, ConsoleRequest, Key, Screen, View};
use kerf_machine::Held;
use kerf_program::{AXES, rounded};

/// Job and its size.
pub(crate) fn screen(view: &View) -> Screen {
    let Some(job) = &view.job else { return Screen::new("JOB: Untitled", "0x0mm #0") };
    let line = |size_mm: [f64; 2], decimals: i32| {
        let [width, height] = size_mm.map(|mm| rounded(mm, decimals));
        format!("{width}x{height}mm #{}", job.shapes)
    };
    let size = match job.size_mm.map(|size| [line(size, 1), line(size, 0)]) {
        None => "part file".into(),
        Some([fine, whole]) => {
            if fine.len() > COLUMNS {
                whole
            } else {
                fine
            }
        }
    };
    Screen::new(format!("JOB: {}", job.name), size)
}

pub(crate) fn press<M>(key: Key, view: &View) -> Next<M> {
    match key {
        Key::Digit(digit) => Next::request(jog(digit, view).map(ConsoleRequest::Jog)),
        Key::File => Next::to(To::File),
        Key::Start => Next::request([ConsoleRequest::Start]),
        Key::Func => Next::to(To::Selecting),
        Key::PlusMinus | Key::Enter | Key::Stop => Next::default(),
    }
}

/// The move of a digit that is held: the digits lie as the arrows of a keypad, 5 lifts Z and 0 lowers it.
pub(crate) fn jog(digit: u8, view: &View) -> Option<Held> {
    let [x, y, z] = match digit {
        1 => [-1, -1, 0],
        2 => [0, -1, 0],
        3 => [1, -1, 0],
        4 => [-1, 0, 0],
        6 => [1, 0, 0],
        7 => [-1, 1, 0],
        8 => [0, 1, 0],
        9 => [1, 1, 0],
        5 => [0, 0, 1],
        0 => [0, 0, -1],
        _ => return None,
    };
    let mut way = [0; AXES];
    way[..3].copy_from_slice(&[x, y, z]);
    let speeds = &view.machine.speeds;
    let [speed, accel] =
        [speeds.arrow_speed_percent, speeds.arrow_accel_percent].map(|percent| percent / 100.0);
    Some(Held { way, speed, accel, sets_bottom: false })
}
