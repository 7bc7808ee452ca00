//! Pins of a board with step queues.

use super::Bounds::{Any, Range};
use super::setting::{Area, Setting, row};

pub(super) const AREAS: &[Area] = &[Area {
    title: "Board with step queues",
    manual: "none: Kerf's own, docs/how-boards-with-step-queues-are-driven.md",
    rows: BOARD,
}];

const BOARD: &[Setting] = &[
    row!(
        c,
        "board.others",
        c.board.others,
        None,
        Any,
        "Boards beside the first, with their ports: \"tools /dev/ttyACM1\"; their pins are named tools:gpio4."
    ),
    row!(
        c,
        "board.x",
        c.board.motors[0],
        None,
        Any,
        "Pins of step and direction of motor X: \"gpio0 gpio1\"; ! before a pin turns its level round."
    ),
    row!(
        c,
        "board.y",
        c.board.motors[1],
        None,
        Any,
        "Pins of step and direction of motor Y: \"gpio0 gpio1\"; ! before a pin turns its level round."
    ),
    row!(
        c,
        "board.z",
        c.board.motors[2],
        None,
        Any,
        "Pins of step and direction of motor Z: \"gpio0 gpio1\"; ! before a pin turns its level round."
    ),
    row!(
        c,
        "board.w",
        c.board.motors[3],
        None,
        Any,
        "Pins of step and direction of motor W: \"gpio0 gpio1\"; ! before a pin turns its level round."
    ),
    row!(
        c,
        "board.q",
        c.board.motors[4],
        None,
        Any,
        "Pins of step and direction of motor Q: \"gpio0 gpio1\"; ! before a pin turns its level round."
    ),
    row!(
        c,
        "board.r",
        c.board.motors[5],
        None,
        Any,
        "Pins of step and direction of motor R: \"gpio0 gpio1\"; ! before a pin turns its level round."
    ),
    row!(
        c,
        "board.enable",
        c.board.enable,
        None,
        Any,
        "Pin that gives all motors their current; empty where they always have it."
    ),
    row!(
        c,
        "board.home_x",
        c.board.homes[0],
        None,
        Any,
        "Pin of the home switch of axis X; ^ before a pin pulls it up, ~ pulls it down."
    ),
    row!(
        c,
        "board.home_y",
        c.board.homes[1],
        None,
        Any,
        "Pin of the home switch of axis Y; ^ before a pin pulls it up, ~ pulls it down."
    ),
    row!(
        c,
        "board.home_z",
        c.board.homes[2],
        None,
        Any,
        "Pin of the home switch of axis Z; ^ before a pin pulls it up, ~ pulls it down."
    ),
    row!(
        c,
        "board.home_a",
        c.board.homes[3],
        None,
        Any,
        "Pin of the home switch of axis A; ^ before a pin pulls it up, ~ pulls it down."
    ),
    row!(
        c,
        "board.home_b",
        c.board.homes[4],
        None,
        Any,
        "Pin of the home switch of axis B; ^ before a pin pulls it up, ~ pulls it down."
    ),
    row!(
        c,
        "board.home_c",
        c.board.homes[5],
        None,
        Any,
        "Pin of the home switch of axis C; ^ before a pin pulls it up, ~ pulls it down."
    ),
    row!(
        c,
        "board.home_x2",
        c.board.second_homes[0],
        None,
        Any,
        "Pin of the home switch of the second motor of X; empty where both have one switch."
    ),
    row!(
        c,
        "board.home_y2",
        c.board.second_homes[1],
        None,
        Any,
        "Pin of the home switch of the second motor of Y; empty where both have one switch."
    ),
    row!(
        c,
        "board.outputs",
        c.board.outputs,
        None,
        Any,
        "Outputs of part files with their pins: \"1 gpio20, 2 !gpio21\"."
    ),
    row!(
        c,
        "board.spindle",
        c.board.spindle,
        None,
        Any,
        "Pin of the speed of the spindle, which is on for a share of time; empty for none."
    ),
    row!(
        c,
        "board.spindle_rpm",
        c.board.spindle_rpm,
        None,
        Range(1.0, 1e6),
        "Speed of the spindle at a share of all the time, revolutions a minute."
    ),
    row!(
        c,
        "board.spindle_hz",
        c.board.spindle_hz,
        Hz,
        Range(1.0, 100_000.0),
        "Cycles of the pin of the spindle."
    ),
    row!(
        c,
        "board.pwm",
        c.board.pwm,
        None,
        Any,
        "PWM channels with their pins, each on for a share of time: \"1 gpio5, 2 gpio6\"; 1 is E0 of M67 and M68."
    ),
    row!(
        c,
        "board.pwm_hz",
        c.board.pwm_hz,
        Hz,
        Range(1.0, 100_000.0),
        "Cycles of the pins of PWM channels."
    ),
    row!(
        c,
        "board.height",
        c.board.height,
        None,
        Any,
        "Pin that measures the height of the torch: the voltage of its arc, divided; empty for none."
    ),
    row!(
        c,
        "board.inputs",
        c.board.inputs,
        None,
        Any,
        "Inputs of part files with their pins, at most eight: \"3 ^gpio22\"."
    ),
    row!(
        c,
        "board.pulse_us",
        c.board.pulse_us,
        Us,
        Range(0.05, 1000.0),
        "Least width of a step pulse."
    ),
    row!(
        c,
        "board.turn_us",
        c.board.turn_us,
        Us,
        Range(0.0, 1000.0),
        "Time that the motor drivers need between direction and step."
    ),
    row!(
        c,
        "board.both_edges",
        c.board.both_edges,
        None,
        Any,
        "Each edge is a step, where the board and the motor drivers can."
    ),
    row!(
        c,
        "board.error_us",
        c.board.error_us,
        Us,
        Range(0.5, 50.0),
        "Farthest that a step is from its planned moment; where it is more, fewer bytes go over the line."
    ),
    row!(
        c,
        "board.steps_s",
        c.board.steps_s,
        Hz,
        Range(100.0, 1e6),
        "Steps a second that a motor makes at most."
    ),
    row!(
        c,
        "board.deadline_s",
        c.board.deadline_s,
        Seconds,
        Range(0.03, 5.0),
        "Time without word from its host after which the board stops all motors by itself."
    ),
    row!(
        c,
        "board.watch_s",
        c.board.watch_s,
        Seconds,
        Range(0.1, 10.0),
        "Time for which an output stays on when its host falls silent; then the board switches all off."
    ),
];
