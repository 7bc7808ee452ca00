//! The settings of the family (`$$`) explained: a sentence each for what it does.

/// Settings of grbl 1.1, which the others of the family have, too. That of an axis stands at the number of X.
const GRBL: &[(u16, &str)] = &[
    (0, "Length of a step pulse: motor drivers miss a shorter one than they need."),
    (1, "Time for which the motors stay powered after a move; 255 keeps them powered."),
    (2, "Reverses the level of step pulses; add 1 for X, 2 for Y, 4 for Z."),
    (3, "Reverses the direction of an axis; add 1 for X, 2 for Y, 4 for Z."),
    (4, "Reverses the level that enables the motor drivers."),
    (5, "Reverses the limit switches, for switches that open when they are hit."),
    (6, "Reverses the probe input, for a probe that opens on contact."),
    (10, "Chooses what status reports tell; Kerf sets what it needs while it drives."),
    (11, "Decides how fast corners are taken: a greater one is faster and rougher."),
    (12, "Distance by which the chords of an arc may leave its circle."),
    (13, "Reports places and feeds in inches in place of millimetres."),
    (20, "Ends a move that would leave the travel of an axis with an alarm; needs homing."),
    (21, "Stops at once with an alarm when a limit switch is hit."),
    (22, "Allows homing; the controller stays locked after power-up until it is homed."),
    (23, "Chooses the low end of an axis for its home; add 1 for X, 2 for Y, 4 for Z."),
    (24, "Feed of the slow approach, which finds the exact place of the switch."),
    (25, "Feed of the first search for the switch."),
    (26, "Time that a switch has to stop bouncing in."),
    (27, "Distance from the switch after homing; too short a one leaves the switch hit."),
    (30, "Spindle speed at full output: S words are scaled by it."),
    (31, "Spindle speed at the least output: no S word gives a lower one but 0."),
    (32, "Drives a router (0), a laser whose beam follows the speed (1), or a lathe (2)."),
    (100, "Steps that move the axis by a millimetre or a degree."),
    (110, "Highest speed of the axis, which rapid moves have."),
    (120, "Acceleration of the axis; the motor loses steps where it is too high."),
    (130, "Travel of the axis from its home; soft limits and the search for home go by it."),
];

/// The same that grblHAL alone has.
const HAL: &[(u16, &str)] = &[
    (8, "Reverses the second motor of an axis that has two, on top of $3."),
    (9, "Switches the PWM output of the spindle on, and says how S words work on it."),
    (14, "Reverses inputs for reset, hold, cycle start, door and others, a bit each."),
    (15, "Reverses the coolant outputs: 1 for flood, 2 for mist."),
    (16, "Reverses the spindle outputs: 1 for on, 2 for the direction, 4 for PWM."),
    (17, "Takes the pull-up resistors off the control inputs, a bit each."),
    (18, "Takes the pull-up resistors off the limit inputs; add 1 for X, 2 for Y, 4 for Z."),
    (19, "Takes the pull-up resistor off the probe input."),
    (28, "Way back between the pecks of G73."),
    (29, "Time between a change of direction and the step behind it."),
    (33, "Frequency of the PWM signal for the spindle."),
    (34, "PWM output while the spindle is off."),
    (35, "PWM output at the least spindle speed ($31)."),
    (36, "PWM output at the greatest spindle speed ($30)."),
    (37, "Motors that stay powered while nothing moves; add 1 for X, 2 for Y, 4 for Z."),
    (38, "Pulses of the spindle's encoder in a turn."),
    (39, "Obeys ?, ! and ~ inside comments and settings, too, as grbl does."),
    (40, "Ends jogs of homed axes at the end of their travel."),
    (41, "Parks the tool when the safety door opens; needs homing."),
    (42, "Axis that moves when the tool is parked."),
    (43, "Times that homing approaches a switch."),
    (44, "Axes that are homed first; add 1 for X, 2 for Y, 4 for Z."),
    (45, "Axes that are homed second; add 1 for X, 2 for Y, 4 for Z."),
    (46, "Axes that are homed third; add 1 for X, 2 for Y, 4 for Z."),
    (47, "Axes that are homed fourth; add 1 for X, 2 for Y, 4 for Z."),
    (48, "Axes that are homed fifth; add 1 for X, 2 for Y, 4 for Z."),
    (49, "Axes that are homed sixth; add 1 for X, 2 for Y, 4 for Z."),
    (50, "Speed of single steps that a jog keypad asks for."),
    (51, "Speed of slow jogs that a jog keypad asks for."),
    (52, "Speed of fast jogs that a jog keypad asks for."),
    (53, "Length of single steps that a jog keypad asks for."),
    (54, "Distance at which a slow jog of a jog keypad ends."),
    (55, "Distance at which a fast jog of a jog keypad ends."),
    (56, "Way out of the cut before parking, and back into it afterwards."),
    (57, "Feed of the way out of the cut before parking, and back into it."),
    (58, "Place at which the tool is parked, in the machine's own frame."),
    (59, "Speed of the way to the parking place."),
    (60, "Sets the overrides back to 100 % when a program ends."),
    (61, "Says whether an open door counts at rest, and whether coolant stays on."),
    (62, "Allows sleep ($SLP), in which the motors have no power."),
    (63, "Says what a hold does to laser and spindle, and what comes back behind it."),
    (64, "Starts locked after power-up, with an alarm."),
    (65, "Says whether the feed override counts for probing, and where probing ends."),
    (70, "Services in the network: telnet, web socket, web page, FTP and others, a bit each."),
    (73, "Joins a wireless network, opens one of its own, or both."),
    (74, "Name of the wireless network that the controller joins."),
    (75, "Password of the wireless network that the controller joins."),
    (76, "Name of the wireless network that the controller opens."),
    (77, "Password of the wireless network that the controller opens."),
    (140, "Current of the axis's motor."),
    (150, "Microsteps of the axis's motor driver; the steps of a millimetre follow them."),
    (160, "Play of the axis, which is made up for when its direction changes."),
    (170, "Offset between the two home switches of an axis that has two motors."),
    (180, "Feed of the slow approach to the home switch of this axis."),
    (190, "Feed of the first search for the home switch of this axis."),
    (300, "Name of the controller in the network."),
    (301, "Says whether the network gives the address (DHCP) or $302 does."),
    (302, "Address of the controller in the network."),
    (303, "Address of the router of the network."),
    (304, "Mask that tells which addresses are in the same network."),
    (305, "Port of telnet."),
    (306, "Port of the web page."),
    (307, "Port of the web socket."),
    (308, "Port of FTP."),
    (340, "Deviation at which the spindle still counts as up to speed; 0 does not look."),
    (341, "Says what M6 does: wait, have the tool touched off by you or by itself, or nothing."),
    (342, "Longest way of the probe when a tool is touched off."),
    (343, "Feed of the slow touch when a tool is touched off."),
    (344, "Feed of the first touch when a tool is touched off."),
    (345, "Feed of the way up between the two touches of a tool."),
    (
        346,
        "Bits of M6: 1 goes back to its place afterwards, 2 has the tool put in at G30, 4 comes off the plate quickly.",
    ),
    (347, "Share of its travel by which the two home switches of an axis may lie apart."),
    (348, "Least distance that the share of $347 may come to."),
    (349, "Greatest distance that the share of $347 may come to."),
    (370, "Reverses auxiliary inputs, a bit each."),
    (371, "Takes the pull-up resistors off auxiliary inputs, a bit each."),
    (372, "Reverses auxiliary outputs, a bit each."),
    (373, "Makes auxiliary outputs open drain, a bit each."),
    (376, "Axes that turn, whose unit is a degree: add 1 for A, 2 for B, 4 for C."),
    (384, "Forgets the shift of G92 when the power goes off."),
    (392, "Time that the spindle has to come up again when the door is closed."),
    (393, "Time that the coolant has to flow again when the door is closed."),
    (394, "Time that the spindle has to come up to speed."),
    (395, "Spindle that is there after power-up."),
    (398, "Moves that are planned ahead; counts after a restart."),
    (481, "Interval of status reports that come unasked; 0 sends none."),
    (484, "Stays locked after an emergency stop until it is unlocked."),
    (485, "Keeps the number of the tool over a restart."),
    (486, "Protects G59.1, G59.2 and G59.3 against changes, a bit each."),
    (538, "Turning axes that take the short way to G28; a bit each."),
    (539, "Time that the spindle has to come to rest."),
];

/// First setting of an axis.
const AXES: u16 = 100;

/// Settings of axes end here.
const AXES_END: u16 = 200;

/// Returns what a setting does, in a sentence; nothing where nobody knows. Some numbers are settings of grblHAL alone.
pub fn explained(number: u16, is_hal: bool) -> &'static str {
    let of_axis = (AXES..AXES_END).contains(&number) && number % 10 < 6;
    let number = if of_axis { number - number % 10 } else { number };
    let hal = HAL.iter().filter(|_| is_hal);
    GRBL.iter().chain(hal).find(|(it, _)| *it == number).map_or("", |(_, does)| does)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::settings::SETTINGS;

    #[test]
    fn each_setting_that_has_a_name_is_explained() {
        let numbers = SETTINGS.iter().map(|it| it.number);
        let unexplained: Vec<u16> = numbers.filter(|it| explained(*it, false).is_empty()).collect();
        assert!(unexplained.is_empty(), "{unexplained:?}");
    }

    #[test]
    fn numbers_of_both_tables_are_explained_once() {
        let mut numbers: Vec<u16> = GRBL.iter().chain(HAL).map(|(number, _)| *number).collect();
        let all = numbers.len();
        numbers.sort_unstable();
        numbers.dedup();
        assert_eq!(numbers.len(), all);
    }

    #[test]
    fn what_grblhal_alone_has_is_not_told_of_others() {
        assert_eq!(explained(112, false), explained(110, true));
        assert!(explained(140, false).is_empty() && explained(777, true).is_empty());
        assert!(explained(145, true).contains("Current"));
        assert!(explained(109, true).is_empty());
    }
}
