//! Every contradiction is refused by the names of its settings.

#![allow(clippy::unwrap_used, non_snake_case)] // rows and their variants

use crate::file;
use std::sync::Arc;

/// Abilities of SIM (readings, SIM).
const SIM: &str = "dynamics.speed_mm_s = [200, 200, 50, 50, 180, 180]\n\
    dynamics.accel_mm_s2 = [1000, 1000, 500, 500, 720, 720]\n\
    steps.per_unit = [250, 250, 250, 250, 100, 100]\n";

fn refusals(settings: &str) -> Vec<String> {
    let text = format!("{SIM}{settings}");
    let found = file::read(&Arc::from("m.toml"), &text).err().unwrap_or_default();
    found.into_iter().map(|it| format!("{}:{}", i64::from(it.place.line) - 3, it.message)).collect()
}

fn refused(settings: &str, part: &str) {
    let found = refusals(settings);
    assert!(found.iter().any(|it| it.contains(part)), "{settings}: {found:?}");
}

fn accepted(settings: &str) {
    assert_eq!(refusals(settings), Vec::<String>::new(), "{settings}");
}

#[test]
fn pro_motors_unique() {
    refused(
        "motors.x2 = \"q\"\nmotors.y2 = \"q\"",
        "2:motor Q drives two axes: motors.x2 and motors.y2",
    );
    accepted("motors.x2 = \"q\"\nmotors.y2 = \"r\"\nmotors.w = \"w\"");
    refused("motors.x2 = \"q\"\nmotors.y2 = \"r\"\nmotors.w = \"w\"\nmotors.z2 = \"q\"", "motor Q");
}

#[test]
fn pro_axes_stepdelay__longer_than_the_period() {
    accepted("motors.step_delay_ns = 18_900");
    refused("motors.step_delay_ns = 19_000", "1:a step pulse takes 20000 ns");
}

#[test]
fn pro_zpos_order() {
    refused("zpos.top_mm = -25", "1:zpos.surface_mm (-20) is above zpos.top_mm (-25)");
    refused("zpos.bottom_mm = -5", "1:zpos.bottom_mm (-5) is above zpos.surface_mm (-20)");
    accepted("zpos.top_mm = -20\nzpos.bottom_mm = -20");
}

#[test]
fn home_lies_within_the_travel() {
    let x = "axis.length = [2000, 1000, 100]\nhoming.x.fitted = true\n";
    refused(
        &format!("{x}homing.x.off = 5000"),
        "3:homing.x.off (5000) is more than the travel of X (2000)",
    );
    accepted(&format!("{x}homing.x.off = 2000"));
    accepted("axis.length = [2000, 1000, 100]\nhoming.x.off = 5000");
}

#[test]
fn pro_io_ina1() {
    refused("homing.b.fitted = true", "1:homing.b.fitted is true, but no input is");
    refused("homing.w.fitted = true\nplasma.use = true", "2:input A1 (WHOME) is the W home switch");
    refused("plasma.use = true\njob.external_start = true", "(plasma.use) and the external start");
    accepted("plasma.use = true");
}

#[test]
fn pro_plasma_tooclose_input__w_homing_refused() {
    refused("plasma.use = true\nhoming.at_job_start = [\"w\"]", "input A1 (WHOME) is homing W");
}

#[test]
fn pro_job_ext_now() {
    refused("job.external_start = true\nhoming.w.fitted = true", "input A1 (WHOME)");
    refused("job.external_start = true\nhoming.at_program_start = \"w\"", "input A1 (WHOME)");
}

#[test]
fn pro_job_ext_nojigs() {
    refused(
        "job.external_start = true\njob.two_jigs = true",
        "job.external_start and job.two_jigs",
    );
    accepted("job.external_start = true");
}

#[test]
fn pro_plasma_use__and_piercing() {
    refused("plasma.use = true\nlaser.pierce.use = true", "plasma.use and laser.pierce.use");
}

#[test]
fn pro_intensity_clip_none() {
    let laser = "laser.use = true\nlaser.type = \"pwm\"\nlaser.cut_hz = 200_000\n";
    refused(&format!("{laser}laser.min_pulse_us = 6"), "3:no valid laser pulse width");
    refused(
        &format!("{laser}laser.min_pulse_us = 3\nlaser.max_pulse_us = 2"),
        "no valid laser pulse",
    );
    accepted(&format!("{laser}laser.min_pulse_us = 1\nlaser.max_pulse_us = 5"));
}

#[test]
fn pro_misc_laser_on__needs_a_type() {
    refused("laser.use = true", "laser.use is true, but laser.type is none");
    accepted("laser.use = true\nlaser.type = \"cw\"");
}

#[test]
fn pro_homing_speeds__above_the_axis() {
    let fitted = "homing.x.fitted = true\n";
    accepted(&format!("{fitted}homing.x.fast = 200"));
    refused(
        &format!("{fitted}homing.x.fast = 201"),
        "homing.x.fast is 201 mm/s, axis X reaches 200",
    );
    refused("homing.w.fitted = true\nhoming.w.slow = 181", "homing.w.slow is 181 deg/s");
}

#[test]
fn pro_homing_offdist__not_negative() {
    accepted("homing.x.off = 0");
    refused("homing.x.off = -0.1", "homing.x.off must be 0 or greater");
}

#[test]
fn pro_speeds_cut() {
    accepted("smoothing.cut_speed_mm_s = 200");
    accepted("smoothing.cut_speed_mm_s = \"12000 mm/min\"");
    refused(
        "smoothing.cut_speed_mm_s = \"12001 mm/min\"",
        "mm/s (12001 mm/min), axis X reaches 200 (12000)",
    );
    refused("smoothing.cut_speed_mm_s = 200.017", "smoothing.cut_speed_mm_s is 200.017 mm/s");
}

#[test]
fn pro_speeds_plunge_max() {
    accepted("plunge.speed_mm_s = 50");
    refused("plunge.speed_mm_s = 50.017", "plunge.speed_mm_s is 50.017 mm/s (3001.02 mm/min)");
    accepted("plunge.speed_mm_s = \"3000 mm/min\"");
    refused("plunge.speed_mm_s = \"3001 mm/min\"", "(3001 mm/min), axis Z reaches 50 (3000)");
}

#[test]
fn pro_height_maxspeed__above_the_axis() {
    accepted("height.on = true\nheight.speed_mm_s = 50");
    for on in [true, false] {
        let file = format!("height.on = {on}\nheight.speed_mm_s = 51");
        refused(&file, "height.speed_mm_s is 51 mm/s");
    }
}

#[test]
fn pro_height_maxacc__above_the_axis() {
    accepted("height.on = true\nheight.accel_mm_s2 = 500");
    for on in [true, false] {
        let file = format!("height.on = {on}\nheight.accel_mm_s2 = 501");
        refused(&file, "height.accel_mm_s2 is 501 mm/s²");
    }
}

#[test]
fn pro_options_con_port() {
    refused("options.send_port = 1", "options.console_port and options.send_port are the same");
    refused("height.port = 2", "options.send_port and height.port are the same serial port, 2");
    refused("options.console_port = 5", "options.console_port must be 1 to 4, not 5");
}

#[test]
fn a_warm_up_has_steps_of_percent_and_minutes() {
    refused("options.warm_up = \"25\"", "'25' is no step of a warm-up");
    accepted("options.warm_up = \"30:0.5\"");
}

#[test]
fn limits_are_in_order() {
    refused("limits.low = [9e9]", "1:limits.low is above limits.high for axis X");
}

#[test]
fn the_rest_of_what_motors_are_asked() {
    refused("misc.tangential = true", "misc.tangential is true, but motors.w is none");
    refused("homing.separate_x = true", "homing.separate_x is true, but motors.x2 is none");
    refused("motors.a = \"q\"\nmotors.z2 = \"w\"", "axis A has two motors");
    refused("rotary = [\"deg\"]\nmotors.z2 = \"w\"", "the second head (motors.z2) is axis A");
}

#[test]
fn pro_options_con_speed() {
    refused("options.console_baud = 9600", "options.console_baud must be 2400 to 2400, not 9600");
    accepted("options.console_baud = 2400");
}

#[test]
fn pro_options_mouse_ports() {
    let fresh = crate::Configuration::default();
    let ports = (fresh.options.console_port, fresh.options.send_port, fresh.height.port);
    assert_eq!(ports, (1, 2, 3));
}

#[test]
fn sbp_val_vd_remote__a_key_is_nothing_else() {
    let on = "display.keypad_remote = 1\n";
    accepted(on);
    accepted(&format!("{on}pendant.z = [0, 0]\npendant.fast = 9"));
    refused(
        &format!("{on}pendant.z = [5, 10]"),
        "2:input 5 is a key of pendant.x and of pendant.z",
    );
    refused(&format!("{on}pendant.close = 4"), "2:input 4 is a key of pendant.close and stops");
    refused(&format!("{on}pendant.fast = 13"), "pendant.fast must be 0 to 12, not 13");
    accepted("pendant.z = [5, 10]");
}

#[test]
fn a_sensor_for_tools_has_a_place() {
    refused("tool_change.sensor_input = 1", "tool_change.sensor_x or tool_change.sensor_y is none");
    refused("tool_change.sensor_x = 1\ntool_change.sensor_input = 1", "names a sensor");
    let placed = "tool_change.sensor_x = 1\ntool_change.sensor_y = 2\ntool_change.sensor_input = 1";
    accepted(placed);
    refused(&format!("{placed}\ntool_change.plate_input = 2"), "names a loose plate, and");
    accepted("tool_change.plate_input = 1");
}
