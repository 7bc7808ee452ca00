//! G-code: whole files, and lines of it among those of OpenSBP.

use kerf_ledger::{gcode, run, sbp};

const PROGRAM: &str = "G20 ⏎ G90 ⏎ G0 X1 Y1 ⏎ G1 Z-.1 F60";

#[test]
fn sbp_gcode_fp() {
    for name in ["prog.nc", "prog.TAP", "prog.ngc", "prog.gcode"] {
        let run = sbp(&format!("FP,{name} ⏎ PRINT %(1)")).file(name, PROGRAM).run();
        run.ends_at([1.0, 1.0, -0.1]).prints(&["1"]).is_silent();
    }
    gcode(PROGRAM).run().ends_at([1.0, 1.0, -0.1]).is_silent();
    sbp("FP,prog.nc ⏎ MX,9").file("prog.nc", "G20 ⏎ G1 X1 F60 ⏎ G777").run().errs(3, "G002");
}

#[test]
fn sbp_gcode_fp__what_it_calls_and_asks() {
    let run = sbp("FP,prog.nc")
        .file("prog.nc", "G20 F60 ⏎ O<part> call [2] ⏎ M0 ⏎ (MSG, done) ⏎ M30 ⏎ G1 X9")
        .file("part.ngc", "G1 X[#1 * 2]")
        .run();
    run.ends_at([4.0]).asks(&["program stop (M0)"]).shows(&["done"]);
}

#[test]
fn sbp_gcode_mix() {
    let lines = "G1 X1 F60 ⏎ MY,2 ⏎ PRINT %(1)";
    sbp(lines).run().ends_at([1.0, 2.0]).prints(&["1"]).is_silent();
    gcode(lines).run().ends_at([1.0, 2.0]).prints(&["1"]);
    let each = "(begin) ⏎ ;and ⏎ N10 X1 F60 ⏎ M5 ⏎ T1 ⏎ S100 ⏎ Y2 ⏎ MX,3 ⏎ F30 ⏎ G1 Z-1";
    sbp("G1 F60 ⏎ N10 X1 ⏎ Y2 ⏎ MX,3 ⏎ F30 ⏎ Z-1").run().ends_at([3.0, 2.0, -1.0]);
    gcode(&format!("% ⏎ G1 F60 ⏎ {each} ⏎ %")).run().ends_at([3.0, 2.0, -1.0]);
    // Flow of OpenSBP chooses lines of G-code.
    sbp("&i=0 ⏎ G91 ⏎ AGAIN: ⏎ G1 X1 F60 ⏎ &i=&i+1 ⏎ IF &i<3 THEN GOTO AGAIN ⏎ IF &i=3 THEN G1 Y1")
        .run()
        .ends_at([3.0, 1.0]);
}

#[test]
fn sbp_gcode_ambig() {
    run("M2, 3, 4").ends_at([3.0, 4.0]);
    gcode("G1 X1 F60 ⏎ M2, 3, 4").run().ends_at([3.0, 4.0]);
    gcode("G1 X1 F60 ⏎ MY,1 ⏎ M2 ⏎ MX,9").run().ends_at([1.0, 1.0]);
    run("MX,1 ⏎ M2 ⏎ MX,9").ends_at([9.0]).warns(2, "W015");
    let off = run("SO,3,1 ⏎ M0 ⏎ MX,1");
    assert_eq!(off.events("motors").next().expect("motors")["on"], false, "{off}");
    let stop = gcode("G1 X1 F60 ⏎ M0").run();
    assert_eq!(stop.events("motors").count(), 0, "{stop}");
    stop.asks(&["program stop (M0)"]);
    let spindle = gcode("G20 G1 X1 F60 ⏎ M3 S9000;on ⏎ M5; off ⏎ G1 X2").run();
    assert_eq!(spindle.events("turn").count(), 2, "a comment of a G-code file: {spindle}");
    spindle.ends_at([2.0]);
}

#[test]
fn sbp_gcode_offsets() {
    sbp("FP,prog.nc,2,2,1,,2")
        .at([10.0, 4.0])
        .file("prog.nc", "G20 G1 X1 Y1 F60")
        .run()
        .ends_at([12.0, 6.0]);
    sbp("FP,prog.nc,,,,2,1,-.1").at([5.0, 5.0]).file("prog.nc", "G20 G1 X1 F60 ⏎ X0").run().visits(
        &[
            [5.0, 5.0, -0.1],
            [6.0, 5.0, -0.1],
            [5.0, 5.0, -0.1],
            [5.0, 5.0, -0.2],
            [6.0, 5.0, -0.2],
            [5.0, 5.0, -0.2],
            [5.0, 5.0, 0.0],
        ],
    );
}

#[test]
fn sbp_gcode_spindle() {
    for case in [gcode("M3 S12000 ⏎ G4 P1 ⏎ M5"), sbp("M3 S12000 ⏎ G4 P1 ⏎ M5")] {
        let run = case.run();
        run.asks(&["The spindle is about to start."]);
        run.switches(1, &[(true, "program"), (false, "program")]);
        let speed = run.events("spindle").next().expect("a speed");
        assert_eq!(speed["rpm"], 12000, "{run}");
    }
    let no = gcode("M3 S12000 ⏎ G1 X1 F60").answers(&["Cancel"]).run();
    no.status("stopped").stands_at([0.0]);
    assert_eq!(no.events("output").count(), 0, "{no}");
    sbp("SetSpindleStatus 1 ⏎ M3 S9000")
        .run()
        .asks(&[])
        .switches(1, &[(true, "program"), (false, "end")]);
}

#[test]
fn sbp_file_fp_savedformats__g_code() {
    for text in
        ["G20\nG1 X1 F60\n", "G20\r\nG1 X1 F60\r\n\u{1a}", "G20\rG1 X1 F60", "\u{feff}G20\nG1X1F60"]
    {
        sbp("FP,part.nc").file("part.nc", text).run().ends_at([1.0]).is_silent();
    }
}

#[test]
fn files_under_the_ending_of_the_other_language() {
    sbp("G20 G90 ⏎ O1 sub ⏎ G1 X1 F60 ⏎ O1 endsub ⏎ O1 call ⏎ M2")
        .run()
        .ends_at([1.0])
        .warns(1, "G001");
    gcode("'a box ⏎ MX,1 ⏎ PRINT %(1)").run().ends_at([1.0]).prints(&["1"]).warns(1, "G001");
}

#[test]
fn an_input_interrupts_g_code_and_the_file_goes_on() {
    let program = "ON INPUT(2,1) GOSUB LIFT ⏎ FP,prog.nc ⏎ END ⏎ LIFT: ⏎ MZ,1 ⏎ RETURN";
    let run = sbp(program).file("prog.nc", "G20 ⏎ G1 X10 F60 ⏎ Y5 ⏎ X0").input(2, 3.0, true).run();
    run.ends_at([0.0, 5.0, 1.0]);
    let stopped = run.events("move").next().expect("a move")["to"]["x"].as_f64().expect("a number");
    assert!((2.0..4.0).contains(&stopped), "{stopped}");
}

#[test]
fn a_probe_move_ends_where_its_input_changes() {
    let run = gcode("G20 ⏎ G38.2 Z-2 F60 ⏎ G10 L20 P1 Z0 ⏎ G0 Z1").input(1, 1.0, true).run();
    let z = run.events("move").next().expect("a move")["to"]["z"].as_f64().expect("a number");
    assert!((-1.1..-0.8).contains(&z), "{z}");
    run.stands_at([0.0, 0.0, 1.0]);
    gcode("G20 ⏎ G38.2 Z-2 F60").run().fails(2, "G018");
}

#[test]
fn a_block_that_asks_twice_comes_to_its_end() {
    let run = gcode("G20 ⏎ M66 P1 L3 M0 ⏎ G0 X1").answers(&["OK", "OK"]).run();
    run.ends_at([1.0]);
    assert_eq!(run.events("ask").count(), 2, "{run}");
}
