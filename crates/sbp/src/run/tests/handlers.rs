//! ON INPUT with a machine that moves later than the program is read.

use super::rig::{Rig, place, rig, watch};
use crate::{Interpreter, Options, Session, Status, Step, Value, read};
use kerf_program::Axes;

#[test]
fn sbp_flow_oninput_on() {
    let mut rig = rig("ON INPUT(3,1) GOTO Hit ⏎ MX,10 ⏎ END ⏎ Hit: ⏎ PRINT %(1)");
    rig.read_ahead();
    assert_eq!((rig.motion_count(), rig.done), (1, None), "handlers live until the motion is made");
    rig.fires(3, 1, 1, [4.0, 0.0, 0.0]).finish().at(4.0, 0.0, 0.0);
    assert_eq!((rig.printed().as_str(), rig.done), ("4", Some(Status::Ok)));
}

#[test]
fn sbp_flow_oninput_off() {
    let mut rig = rig("ON INPUT(3,0) &hit=1 ⏎ MX,10");
    rig.read_ahead().fires(3, 0, 1, [4.0, 0.0, 0.0]).finish();
    rig.at(4.0, 0.0, 0.0).variable("hit", "1");
}

#[test]
fn the_four_conditions_are_two_directions_and_two_stops() {
    let rig = &mut rig(
        "ON INPUT(3,0) &a=1 ⏎ ON INPUT(3,1) &a=1 ⏎ ON INPUT(3,2) &a=1 ⏎ ON INPUT(3,3) &a=1 ⏎ PAUSE 1",
    );
    for _ in 0..5 {
        rig.step();
    }
    let expected = [(false, false), (true, false), (false, true), (true, true)];
    let armed: Vec<_> = rig.interpreter.watches().map(|w| (w.on, w.ramped)).collect();
    assert_eq!(armed, expected);
    for line in ["ON INPUT(3,4) &a=1", "ON INPUT(3,-1) &a=1", "ON INPUT(3,.5) &a=1"] {
        crate::testing::run(line).fails_with("condition must be 0, 1, 2 or 3");
    }
}

#[test]
fn ending_a_watch_with_a_variable_that_was_never_set_ends_none() {
    rig("ON INPUT(3,1) &a=1 ⏎ ON INPUT(&none,1) ⏎ MX,1").finish().at(1.0, 0.0, 0.0);
    crate::testing::run("ON INPUT(&none,1) &a=1").fails_with("variable &NONE has no value");
}

#[test]
fn variables_are_told_in_order_of_their_names() {
    let mut rig = rig("&b=2 ⏎ &a=\"one\"");
    rig.finish();
    let told = kerf_program::Interpreter::variables(&rig.interpreter);
    let words = told.iter().map(|(name, value)| format!("{name} {value}"));
    assert_eq!(words.collect::<Vec<_>>(), ["A one", "B 2"]);
}

#[test]
fn sbp_flow_oninput_resume() {
    let mut rig = rig("ON INPUT(3,1) &hit=1 ⏎ MX,10 ⏎ MY,2");
    rig.read_ahead();
    assert_eq!(rig.motion_count(), 2);
    rig.fires(3, 1, 1, [4.0, 0.0, 0.0]).finish().at(4.0, 2.0, 0.0).variable("hit", "1");
    assert_eq!(rig.motion_count(), 2);
}

#[test]
fn nothing_behind_the_interrupted_move_has_happened() {
    let text = "&n=1 ⏎ ON INPUT(3,1) &hit=&n ⏎ MX,10 ⏎ &n=2 ⏎ GOSUB Sub ⏎ MX,20 ⏎ END ⏎ \
                Sub: ⏎ &r=RND(1) ⏎ MY,&n ⏎ &n=3 ⏎ RETURN";
    let mut undisturbed = rig(text);
    undisturbed.finish();
    let r = undisturbed.interpreter.variables().get("r").unwrap().display();
    let mut rig = rig(text);
    rig.read_ahead();
    assert_eq!(rig.interpreter.variables().get("n"), Some(&Value::Number(3.0)), "was read");
    rig.fires(3, 1, 1, [4.0, 0.0, 0.0]).step();
    rig.variable("hit", "1").variable("n", "1").variable("r", "(none)");
    rig.finish().at(20.0, 2.0, 0.0).variable("n", "3").variable("r", &r);
}

#[test]
fn sbp_flow_oninput_action() {
    let mut location = rig("ON INPUT(2,1) VA, 0.0 ⏎ MX,10 ⏎ PRINT %(1)");
    location.read_ahead().fires(2, 1, 1, [4.2, 0.0, 0.0]).finish();
    assert_eq!(location.printed(), "0");
    let base = location.interpreter.frame().base(location.interpreter.position());
    assert_eq!(base, place([4.2, 0.0, 0.0]), "the table base stays");
    let mut sub = rig("ON INPUT(2,1) GOSUB S ⏎ MX,10 ⏎ MY,1 ⏎ END ⏎ S: ⏎ MZ,1 ⏎ RETURN");
    sub.read_ahead().fires(2, 1, 1, [4.0, 0.0, 0.0]).finish().at(4.0, 1.0, 1.0);
    let mut command = rig("ON INPUT(2,1) MZ,1 ⏎ MX,10 ⏎ MY,1");
    command.read_ahead().fires(2, 1, 1, [4.0, 0.0, 0.0]).finish().at(4.0, 1.0, 1.0);
    let mut end = rig("ON INPUT(2,1) END ⏎ MX,10 ⏎ MY,1");
    end.read_ahead().fires(2, 1, 1, [4.0, 0.0, 0.0]).finish().at(4.0, 0.0, 0.0);
    let mut all = rig("ON INPUT(2,1) ENDALL ⏎ MX,10 ⏎ MY,1");
    all.read_ahead().fires(2, 1, 1, [4.0, 0.0, 0.0]).finish().at(4.0, 0.0, 0.0);
    assert_eq!(all.done, Some(Status::Ended));
}

#[test]
fn a_subroutine_of_a_handler_returns_into_the_subroutine_that_was_interrupted() {
    let mut rig =
        rig("ON INPUT(2,1) GOSUB S ⏎ GOSUB Cut ⏎ MX,9 ⏎ END ⏎ Cut: ⏎ MX,5 ⏎ MY,5 ⏎ RETURN ⏎ \
         S: ⏎ &s=&s & x ⏎ RETURN");
    rig.read_ahead().fires(2, 1, 1, [4.0, 0.0, 0.0]).finish().at(9.0, 5.0, 0.0);
    assert_eq!(rig.done, Some(Status::Ok));
}

#[test]
fn sbp_flow_oninput_autoclear() {
    let mut rig = rig("ON INPUT(3,1) &n=&n+1 ⏎ MX,10 ⏎ MX,20");
    rig.interpreter = {
        let mut session = Session::default();
        session.variables.set("n", Value::Number(0.0));
        let program =
            read("t".into(), b"Top:\nON INPUT(3,1) &n=&n+1\nMX,10\nMX,20\nIF &n<2 THEN GOTO Top");
        Interpreter::new(program, session, Options::default())
    };
    rig.read_ahead().fires(3, 1, 1, [4.0, 0.0, 0.0]).step();
    assert_eq!(rig.interpreter.watches().count(), 0, "cleared after firing");
    // The line is executed again and arms it again.
    rig.read_ahead().come_to_rest().read_ahead();
    assert_eq!(rig.interpreter.watches().count(), 1);
    let motion = rig.interpreter.motions() - 1;
    rig.fires(3, 1, motion, [15.0, 0.0, 0.0]).finish().at(20.0, 0.0, 0.0).variable("n", "2");
}

#[test]
fn sbp_flow_oninput_clear() {
    let mut rig = rig("ON INPUT(3,1) GOTO Hit ⏎ ON INPUT(3,1) ⏎ MX,10 ⏎ Hit:");
    rig.read_ahead();
    assert_eq!(rig.interpreter.watches().count(), 0);
    // The other condition of the same switch stays.
    let mut other = self::rig("ON INPUT(3,1) &a=1 ⏎ ON INPUT(3,0) ⏎ MX,10");
    other.read_ahead();
    assert_eq!(other.interpreter.watches().count(), 1);
}

#[test]
fn sbp_flow_oninput_many() {
    let text =
        "ON INPUT(2,1) &a=1 ⏎ ON INPUT(2,0) &b=1 ⏎ ON INPUT(3,1) &c=1 ⏎ MX,1 ⏎ MX,2 ⏎ MX,3 ⏎ MX,4";
    let mut rig = rig(text);
    rig.read_ahead().fires(2, 0, 1, [0.5, 0.0, 0.0]);
    rig.read_ahead().fires(3, 1, 2, [1.5, 0.0, 0.0]);
    rig.read_ahead().fires(2, 1, 3, [2.5, 0.0, 0.0]);
    rig.finish().at(4.0, 0.0, 0.0).variable("a", "1").variable("b", "1").variable("c", "1");
    crate::testing::run("ON INPUT(12,1) &a=1").ended(Status::Ok);
    crate::testing::run("ON INPUT(13,1) &a=1").fails_with("1 to 12");
    crate::testing::run("ON INPUT(0,1) &a=1").fails_with("1 to 12");
}

#[test]
fn a_handler_armed_twice_holds_its_last_action() {
    let mut rig = rig("ON INPUT(2,1) &a=1 ⏎ ON INPUT(2,1) &a=2 ⏎ MX,10");
    rig.read_ahead().fires(2, 1, 1, [4.0, 0.0, 0.0]).finish().variable("a", "2");
}

#[test]
fn sbp_flow_oninput_abbrev() {
    let mut rig = rig("&t=3 ⏎ &on=1 ⏎ ON INP(&t,&on) GOTO Hit ⏎ MX,10 ⏎ END ⏎ Hit: ⏎ MY,1");
    rig.read_ahead().fires(3, 1, 1, [4.0, 0.0, 0.0]).finish().at(4.0, 1.0, 0.0);
}

#[test]
fn sbp_flow_oninput_scope() {
    // A nested file inherits its caller's handlers.
    let files = [("b.sbp", "MX,10 ⏎ MY,1")];
    let mut inherited = Rig::new("ON INPUT(3,1) &hit=1 ⏎ FP,b.sbp ⏎ MZ,1", &files);
    inherited.read_ahead().fires(3, 1, 1, [4.0, 0.0, 0.0]).finish();
    inherited.at(4.0, 1.0, 1.0).variable("hit", "1");
    // They end with the run.
    let mut over = rig("ON INPUT(3,1) &hit=1 ⏎ MX,1");
    over.finish();
    assert_eq!(over.interpreter.watches().count(), 0);
    over.variable("hit", "(none)");
}

const CALLED: [(&str, &str); 1] = [("b.sbp", "MX,10 ⏎ MY,1 ⏎ &b=1")];

#[test]
fn a_jump_of_a_handler_leaves_the_files_that_its_own_called() {
    let text = "ON INPUT(3,1) GOTO Hit ⏎ FP,b.sbp,2 ⏎ MZ,9 ⏎ END ⏎ Hit: ⏎ MZ,1 ⏎ MX,5";
    let mut rig = Rig::new(text, &CALLED);
    rig.read_ahead().fires(3, 1, 1, [4.0, 0.0, 0.0]).finish();
    // MX,5 is not scaled: the proportion of b.sbp is gone with it.
    rig.at(5.0, 0.0, 1.0).variable("b", "(none)");
    assert_eq!(rig.done, Some(Status::Ok));
}

#[test]
fn a_subroutine_of_a_handler_returns_into_the_file_that_was_interrupted() {
    let text = "ON INPUT(3,1) GOSUB Hit ⏎ FP,b.sbp,2 ⏎ MZ,9 ⏎ END ⏎ Hit: ⏎ MZ,1 ⏎ MX,5 ⏎ RETURN";
    let mut rig = Rig::new(text, &CALLED);
    rig.read_ahead().fires(3, 1, 1, [4.0, 0.0, 0.0]).finish();
    rig.at(5.0, 1.0, 9.0).variable("b", "1");
    assert_eq!(rig.done, Some(Status::Ok));
}

#[test]
fn a_subroutine_of_a_handler_that_never_returns_ends_with_its_own_file() {
    let text = "ON INPUT(3,1) GOSUB Hit ⏎ FP,b.sbp ⏎ MZ,9 ⏎ END ⏎ Hit: ⏎ MZ,1";
    for ending in ["", " ⏎ END ⏎ MZ,8"] {
        let mut rig = Rig::new(&format!("{text}{ending}"), &CALLED);
        rig.read_ahead().fires(3, 1, 1, [4.0, 0.0, 0.0]).finish();
        rig.at(4.0, 0.0, 1.0).variable("b", "(none)");
        assert_eq!(rig.done, Some(Status::Ok));
    }
}

#[test]
fn a_label_of_a_file_that_is_over_cannot_be_reached() {
    let files = [("arm.sbp", "ON INPUT(3,1) GOTO Hit ⏎ END ⏎ Hit: ⏎ MZ,9")];
    let mut rig = Rig::new("FP,arm.sbp ⏎ MX,10 ⏎ MY,1", &files);
    rig.read_ahead().fires(3, 1, 1, [4.0, 0.0, 0.0]).finish().at(4.0, 0.0, 0.0);
    assert_eq!(rig.done, Some(Status::Failed));
    assert!(rig.error.contains("file of this ON INPUT is over"), "{}", rig.error);
    // An action without a label works from anywhere.
    let files = [("arm.sbp", "ON INPUT(3,1) &hit=1")];
    let mut rig = Rig::new("FP,arm.sbp ⏎ MX,10 ⏎ MY,1", &files);
    rig.read_ahead()
        .fires(3, 1, 1, [4.0, 0.0, 0.0])
        .finish()
        .at(4.0, 1.0, 0.0)
        .variable("hit", "1");
}

#[test]
fn nothing_is_read_behind_a_pause_while_handlers_are_armed() {
    let text = "ON INPUT(3,1) &hit=&n ⏎ &n=1 ⏎ PAUSE 5 ⏎ &n=2 ⏎ MX,1";
    let mut rig = rig(text);
    rig.step();
    rig.step();
    rig.step();
    rig.step();
    rig.host.moving = true;
    assert_eq!(rig.step(), Step::Waiting, "the pause lasts");
    rig.host.moving = false;
    rig.interpreter.interrupt(&watch(3, 1), None, Axes::default());
    rig.finish().at(1.0, 0.0, 0.0).variable("hit", "1").variable("n", "2");
    // Without handlers the program is read on.
    let mut free = self::rig("PAUSE 5 ⏎ MX,1");
    free.step();
    free.step();
    free.host.moving = true;
    assert_eq!(free.step(), Step::Ran);
}

#[test]
fn a_handler_that_fires_during_a_question_runs_before_the_answer() {
    let mut rig = rig("ON INPUT(3,1) GOTO Hit ⏎ MX,1 ⏎ PAUSE ⏎ MX,9 ⏎ Hit: ⏎ MY,1");
    rig.read_ahead();
    assert!(rig.host.asked.is_empty());
    rig.come_to_rest();
    rig.interpreter.interrupt(&watch(3, 1), None, place([1.0, 0.0, 0.0]));
    rig.finish().at(1.0, 1.0, 0.0);
}

#[test]
fn states_of_motion_that_was_made_are_forgotten() {
    let mut rig = rig("ON INPUT(3,1) &hit=&n ⏎ &n=1 ⏎ MX,1 ⏎ &n=2 ⏎ MX,2 ⏎ &n=3 ⏎ MX,3");
    rig.read_ahead();
    assert_eq!(rig.interpreter.past.len(), 3);
    rig.interpreter.carried_out(1);
    assert_eq!(rig.interpreter.past.len(), 2);
    rig.fires(3, 1, 2, [1.5, 0.0, 0.0]).finish().at(3.0, 0.0, 0.0).variable("hit", "2");
}

#[test]
fn what_ends_the_stack_of_moves_and_what_does_not() {
    let files = [("d", "1"), ("b.sbp", "&b=1"), ("custom6.sbc", "&b=1")];
    let open = "OPEN \"o\" FOR OUTPUT AS #1 ⏎ OPEN \"d\" FOR INPUT AS #2";
    for (line, ends) in [
        ("VS,3", false),
        ("L:", false),
        ("'comment", false),
        ("&a=%(1)+2", false),
        ("IF &n=1 THEN &a=2", false),
        ("IF %(51)=1 THEN &a=2", true),
        ("GOTO L ⏎ L:", false),
        ("PRINT &n", true),
        ("WRITE #1, 2", true),
        ("PRINT #1, 2", true),
        ("INPUT #2, &a", true),
        ("OPEN \"e\" FOR OUTPUT AS #3", true),
        ("CLOSE", true),
        ("CLOSE #1", true),
        ("INPUT &a", true),
        ("MSGBOX(a,0,b)", true),
        ("PAUSE", true),
        ("PAUSE 1", true),
        ("PAUSE UNTIL 5,0", true),
        ("WARNING OFF", true),
        ("PLAY a.wav", true),
        ("SHELL, \"x\"", true),
        ("SetUsrVal, 1", true),
        ("GetUsrVal, &a", true),
        ("$a=1", true),
        ("FP,b.sbp", true),
        ("C6", true),
        ("FE,x", true),
        ("FS,x", true),
        ("SO,2,1", false),
        ("SO,2,0", true),
        ("ON INPUT(3,1) &a=1", true),
        ("ENDALL", true),
    ] {
        let mut rig = Rig::new(&format!("&n=1 ⏎ {open} ⏎ MX,1 ⏎ {line} ⏎ MX,2"), &files);
        rig.read_ahead();
        assert_eq!(rig.motion_count(), if ends { 1 } else { 2 }, "{line}");
        assert_eq!(rig.done, None, "{line}");
        assert!(rig.host.asked.is_empty() && rig.host.shells.is_empty(), "{line}");
        rig.finish();
        assert_ne!(rig.done, Some(Status::Failed), "{line}: {}", rig.error);
    }
}

/// Tabs as VB sets them: on, in every file.
const TABS_ON: &str = "VB,.1,4,1,.5,1";

#[test]
fn moves_that_wait_for_tabs_lie_behind_the_interrupted_one() {
    let text = format!(
        "&n=0 ⏎ {TABS_ON} ⏎ MZ,-.5 ⏎ ON INPUT(3,1) &hit=&n ⏎ MX,5 ⏎ &n=1 ⏎ MY,5 ⏎ &n=2 ⏎ MX,0 ⏎ \
         &n=3 ⏎ MY,0 ⏎ &n=4"
    );
    let mut undisturbed = rig(&text);
    undisturbed.read_ahead().come_to_rest().read_ahead();
    assert!(undisturbed.motion_count() > 12, "tabs make many moves of four");
    let line_of = |motion: u64| {
        let mut motions = undisturbed.out.iter().filter(|c| c.command.is_motion());
        motions.nth(motion as usize - 1).map_or(0, |c| c.at.line)
    };
    for motion in 2..=undisturbed.interpreter.motions() {
        let mut rig = rig(&text);
        rig.read_ahead().come_to_rest().read_ahead();
        rig.fires(3, 1, motion, [2.0, 2.0, -0.5]).step();
        // Lines 5, 7, 9 and 11 move; &n counts those before.
        let before = (line_of(motion) - 5) / 2;
        rig.variable("hit", &before.to_string()).variable("n", &before.to_string());
        let lines: Vec<_> = rig.finish().out.iter().filter(|c| c.command.is_motion()).collect();
        let next = lines.get(motion as usize).map(|c| c.at.line);
        let expected = (line_of(motion) < 11).then_some(line_of(motion) + 2);
        assert_eq!(next, expected, "interrupted in line {}", line_of(motion));
    }
}
