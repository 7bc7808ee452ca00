//! Changes of tools on a controller: lifted, asked for, measured at a sensor; Z zero goes with the length of the tool.

use crate::bench::Bench;
use crate::close;
use crate::shop::{Did, Shop};
use kerf_driver_grbl::fake::Fake;

/// A sensor 50.8 mm right of home and 25.4 mm behind it.
const MACHINE: &str = "&my_sensor_x := 2\n&my_sensor_y := 1\n&my_sensor_reach := 4\n\
    &my_sensor_same := .001\n&my_probe_speed := .5\n&my_tool_change_time := 0\nEND\n";

/// Has been told to look for its probe so often.
fn probes(fake: &Fake) -> usize {
    fake.lines.iter().filter(|line| line.starts_with("G91G38.3")).count()
}

/// Runs a file that changes to tool 3, whose tip is 3 mm lower than that of the tool before, and goes to Z zero.
#[track_caller]
fn changes(file: &str, program: &str) -> (Shop, Bench) {
    let files =
        [(file, program), ("my_variables.sbc", MACHINE), ("set_up.sbp", "$tool_sensor = 1\n")];
    let (shop, bench) = (Shop::new(&files), Bench::new(&[]));
    shop.kerf("run set_up.sbp").exits(0);
    shop.kerf("machine set m6_runs_c9 true").exits(0);
    bench.look(|fake| fake.plate_mm = Some(-10.0));
    let child = bench.start(&shop, &format!("run {file} --custom ."));
    bench.until(|fake| probes(fake) == 1 && fake.position().0[2] > 10.0 && fake.lowest_mm < -9.9);
    let [x, y, ..] = bench.look(|fake| fake.position()).0;
    assert!(close(x, 50.8) && close(y, 25.4), "the old tool is measured at the sensor: {x} {y}");
    bench.look(|fake| fake.plate_mm = Some(-7.0));
    bench.until(|fake| probes(fake) == 2);
    assert_eq!(bench.look(|fake| fake.spindle()), None);
    // The sensor is no plate under the work.
    bench.until(|fake| fake.position().0[2] < -6.9);
    bench.until(|fake| fake.position().0[2] > 10.0);
    bench.look(|fake| fake.plate_mm = None);
    Did::of(child.wait_with_output().unwrap()).exits(0).says("ran to its end");
    let z = bench.look(|fake| fake.position()).0[2];
    assert!(close(z, 3.0), "Z zero is 3 mm higher for a tool that is 3 mm longer: {z}");
    (shop, bench)
}

#[test]
fn a_tool_change_of_a_part_file_measures_both_tools() {
    changes("part.sbp", "SO,1,1\nMS,2,1\nMX,1\n&Tool = 3\nC9\nMZ,0\nSO,1,0\n");
}

#[test]
fn m6_on_a_controller_is_the_tool_change_of_the_machine() {
    let (shop, bench) = changes("part.nc", "G20 F60\nG54\nM3 S12000\nG1 X1\nT3 M6\nG1 Z0\nM2\n");
    // The tool that is in is known, and so is its length: the next change measures the new one alone.
    shop.write("again.nc", b"G20 F60\nG54\nG0 Z1\nT4 M6\nG1 Z0\nM2\n");
    bench.look(|fake| fake.plate_mm = Some(-9.0));
    let child = bench.start(&shop, "run again.nc --custom .");
    bench.until(|fake| probes(fake) == 3);
    bench.until(|fake| fake.position().0[2] < -8.9);
    bench.until(|fake| fake.position().0[2] > 10.0);
    bench.look(|fake| fake.plate_mm = None);
    Did::of(child.wait_with_output().unwrap()).exits(0);
    let (z, count) = bench.look(|fake| (fake.position().0[2], probes(fake)));
    assert!(close(z, 1.0) && count == 3, "{z} {count}");
}
