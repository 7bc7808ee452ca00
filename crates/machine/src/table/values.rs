//! Cutter, tabs, torch, driver, preview and display: values of the V commands beside motion.

use super::Bounds::{Any, NotNegative, Positive, Range};
use super::setting::{Area, Setting, row};

/// In the order of a file.
pub(super) const AREAS: &[Area] = &[
    Area { title: "Cutter", manual: "command reference, VC", rows: CUTTER },
    Area { title: "Tabs", manual: "command reference, VB", rows: TABS },
    Area { title: "Torch, laser and heater", manual: "command reference, VH", rows: TORCH },
    Area { title: "Driver", manual: "command reference, VI", rows: DRIVER },
    Area { title: "Preview", manual: "command reference, VP", rows: VIEW },
    Area { title: "Display", manual: "command reference, VD", rows: DISPLAY },
];

const CUTTER: &[Setting] = &[
    row!(
        c,
        "cutter.diameter_mm",
        c.program.cutter.diameter_mm,
        Mm,
        Positive,
        "Diameter of the cutter."
    ),
    row!(
        c,
        "cutter.safe_z_mm",
        c.program.cutter.safe_z_mm,
        Mm,
        Any,
        "Height for MH, JH and travel; none when turned off."
    ),
    row!(
        c,
        "cutter.safe_a_mm",
        c.program.cutter.safe_a_mm,
        Mm,
        Any,
        "Height of the A axis for MH and JH."
    ),
    row!(
        c,
        "cutter.plunge",
        c.program.cutter.plunge,
        None,
        Any,
        "The sign of a plunge that goes down: minus or plus."
    ),
    row!(
        c,
        "cutter.pocket_overlap_percent",
        c.program.cutter.pocket_overlap_percent,
        Percent,
        Range(0.0, 100.0),
        "Overlap of pocket rings."
    ),
    row!(
        c,
        "cutter.trigger.on_at_mm",
        c.program.cutter.trigger.on_at_mm,
        Mm,
        Any,
        "The triggered output goes ON when this location is passed downwards."
    ),
    row!(
        c,
        "cutter.trigger.off_at_mm",
        c.program.cutter.trigger.off_at_mm,
        Mm,
        Any,
        "It goes OFF when this location is passed upwards."
    ),
    row!(
        c,
        "cutter.trigger.axis",
        c.program.cutter.trigger.axis,
        None,
        Any,
        "The axis that triggers: z or a."
    ),
    row!(
        c,
        "cutter.trigger.output",
        c.program.cutter.trigger.output,
        None,
        Range(1.0, 12.0),
        "The triggered output."
    ),
];

const TABS: &[Setting] = &[
    row!(c, "tabs.up_mm", c.program.tabs.up_mm, Mm, NotNegative, "Thickness of a tab."),
    row!(c, "tabs.next_mm", c.program.tabs.next_mm, Mm, Positive, "Path between tabs."),
    row!(c, "tabs.size_mm", c.program.tabs.size_mm, Mm, NotNegative, "Length of the flat top."),
    row!(
        c,
        "tabs.lead_mm",
        c.program.tabs.lead_mm,
        Mm,
        NotNegative,
        "Length of each incline along the path."
    ),
    row!(
        c,
        "tabs.count",
        c.program.tabs.count,
        None,
        Range(0.0, u32::MAX as f64),
        "Insert so many, then stop."
    ),
    row!(
        c,
        "tabs.start_mm",
        c.program.tabs.start_mm,
        Mm,
        NotNegative,
        "Path to the first tab; none for next_mm."
    ),
];

const TORCH: &[Setting] = &[
    row!(c, "torch.on", c.program.height.on, None, Any, "On or off."),
    row!(
        c,
        "torch.rate",
        c.program.height.rate,
        None,
        NotNegative,
        "Share of the XY speed used for Z."
    ),
    row!(
        c,
        "torch.low_percent",
        c.program.height.low_percent,
        Percent,
        Range(0.0, 100.0),
        "Pulse width at rest."
    ),
    row!(
        c,
        "torch.high_percent",
        c.program.height.high_percent,
        Percent,
        Range(0.0, 100.0),
        "Pulse width at full speed."
    ),
    row!(
        c,
        "torch.frequency_khz",
        c.program.height.frequency_khz,
        KHz,
        Positive,
        "Pulse frequency."
    ),
    row!(
        c,
        "torch.low_cycle",
        c.program.height.low_cycle,
        None,
        Range(1.0, 10.0),
        "Low cycle time."
    ),
    row!(
        c,
        "torch.temperature",
        c.program.height.temperature,
        None,
        Any,
        "Set temperature of the heater."
    ),
];

const DRIVER: &[Setting] = &[
    row!(c, "driver.port", c.program.driver.port, None, Range(1.0, 16.0), "Port slot."),
    row!(
        c,
        "driver.channels",
        c.program.driver.channels,
        None,
        Any,
        "Axis of each driver channel: x, y, z, a, b, w (axis C)."
    ),
    row!(
        c,
        "driver.speed_code",
        c.program.driver.speed_code,
        None,
        Range(2.0, 5.0),
        "2 115.2, 3 230.4, 4 460.8, 5 921.6 kbaud."
    ),
    row!(c, "driver.enabled", c.program.driver.enabled, None, Any, "Steps and outputs are given."),
    row!(
        c,
        "driver.ports",
        c.program.controller.ports,
        None,
        Any,
        "What each port of VI is: a serial device, a TCP address, or sim; blank is sim too."
    ),
    row!(
        c,
        "driver.outputs",
        c.program.controller.outputs,
        None,
        Range(1.0, 12.0),
        "Outputs that the controller has."
    ),
    row!(
        c,
        "driver.pwm",
        c.program.controller.pwm,
        None,
        Any,
        "The controller has PWM, for a laser or a heater."
    ),
    row!(
        c,
        "driver.independent",
        c.program.controller.independent,
        None,
        Any,
        "Axes can move beside the others (MI)."
    ),
];

const VIEW: &[Setting] = &[
    row!(c, "view.grid_mm", c.program.view.grid_mm, Mm, Positive, "Line spacing of the grid."),
    row!(
        c,
        "view.table_mm",
        c.program.view.table_mm,
        Mm,
        NotNegative,
        "Size of the table: X, Y, Z."
    ),
    row!(c, "view.simulate", c.program.view.simulate, None, Any, "Animate cutting."),
    row!(c, "view.draw_tool", c.program.view.draw_tool, None, Any, "Draw the cutter."),
    row!(
        c,
        "view.start_actual",
        c.program.view.start_actual,
        None,
        Any,
        "Start at the tool's location, else at 0,0."
    ),
    row!(c, "view.show_jogs", c.program.view.show_jogs, None, Any, "Draw jogs."),
];

const DISPLAY: &[Setting] = &[
    row!(c, "display.console", c.program.display.console, None, Any, "Show the control console."),
    row!(
        c,
        "display.comments",
        c.program.display.comments,
        None,
        Any,
        "Show file comments in the message screen."
    ),
    row!(
        c,
        "display.keypad_fixed_mm",
        c.program.display.keypad_fixed_mm,
        Mm,
        Positive,
        "Distance of a tap on the keypad."
    ),
    row!(
        c,
        "display.keypad_remote",
        c.program.display.keypad_remote,
        None,
        Range(0.0, 2.0),
        "What moves the tool at the keypad: 0 mouse and keys, 1 also a pendant on inputs, 2 also another program."
    ),
    row!(c, "display.part_log", c.program.display.part_log, None, Any, "Write the part file log."),
    row!(c, "display.system_log", c.program.display.system_log, None, Any, "Write the system log."),
    row!(
        c,
        "display.message_twips",
        c.program.display.message_twips,
        Twips,
        Any,
        "Message screen: X, Y, width, height."
    ),
    row!(
        c,
        "display.keypad_auto_off",
        c.program.display.keypad_auto_off,
        None,
        Any,
        "Turn outputs off when the keypad closes."
    ),
    row!(c, "display.progress", c.program.display.progress, None, Any, "Show file progress."),
    row!(c, "display.easy", c.program.display.easy, None, Any, "The EASY interface, else FULL."),
];
