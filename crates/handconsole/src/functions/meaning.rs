//! What each function is for, as the book tells it.

/// What the function of a number does.
pub fn meaning(number: &str) -> Option<&'static str> {
    MEANINGS.iter().find(|(of, _)| *of == number).map(|(_, meaning)| *meaning)
}

const MEANINGS: &[(&str, &str)] = &[
    (
        "0",
        "Highest cutting speed of the machine; at most that of the X axis. `smoothing.cut_speed_mm_s`",
    ),
    ("1", "Speed from ZTop down to the cut; at most that of the Z axis. `plunge.speed_mm_s`"),
    (
        "2",
        "The tool goes to ZTop, ZSurface and ZBottom in turn; digits move it, Enter records where it stands. Z is homed \
         first where jobs home it. Nothing is set before the third. `zpos.*`",
    ),
    ("3", "ZBottom by a distance, negative down. `zpos.bottom_mm`"),
    ("4", "To the job origin in X and Y, Z at least at ZTop"),
    ("5", "To the finish position of the job, in the same way"),
    ("6", "By distances. Z first where it rises, last where it sinks"),
    (
        "7",
        "The origin of the open job is where the tool is; also that of the machine, for jobs that have none. \
         `job.origin_mm`",
    ),
    ("8", "The finish position in the same way, counted from the origin. `job.finish_mm`"),
    (
        "10",
        "The open job is written into its file, with the origin, the finish position and the start shape that hold. Its \
         paths stay as they were made: neither 60 nor 300 goes into the file. Shapes that were digitized are among them",
    ),
    ("11", "The settings of the machine are kept as they are now"),
    (
        "17",
        "Millimetres of one unit of the height sensor; a K that suits is told, K itself stays. `height.scale_mm`",
    ),
    (
        "18",
        "Both set points of proportional height control, 0 to 255. `height.x_set_point`, `height.y_set_point`",
    ),
    ("18.1", "That of X"),
    ("18.2", "That of Y"),
    ("19", "Both set points by a distance; held between 0 and 255, which is told"),
    ("19.1", "That of X"),
    ("19.2", "That of Y"),
    ("20", "Z to home, then all other axes"),
    (
        "21",
        "To a place: X and Y from the job origin, Z from home. Z first where it rises, last where it sinks",
    ),
    ("23", "By how much the second head goes further when it is homed. `homing.z2_adjustment_mm`"),
    ("30", "The wait at the bottom before the cut. `delays.bottom_s`"),
    ("31", "Whether an input ends that wait. `delays.bottom_type`"),
    ("32", "Whether the tool rises in a pause. `pause.raise`"),
    (
        "34",
        "Whether each Start takes the present position as job origin. `job.change_origin_at_start`",
    ),
    (
        "38",
        "Speed of the digits that move the tool, of the highest of each axis. `arrows.speed_percent`",
    ),
    ("39", "Their acceleration. `arrows.accel_percent`"),
    ("40", "Acceleration in curves, of the lesser of X's and Y's. `smoothing.centripetal_percent`"),
    (
        "50",
        "The home switch of Z is sought; then that of w, where it keeps the tool along the path",
    ),
    ("51", "Those of X and Y; Z rises to ZTop first where it is lower"),
    ("52", "Which shape of the job is nearest to the tool: its number, to be typed behind Start"),
    (
        "60",
        "Every path of the open job is cut so far to the right of travel, always from how it was made: 0 restores it",
    ),
    ("61", "How often a Start cuts the job. `job.repeats`"),
    ("70", "Shapes are taken from a pattern: digitizing, a mode of its own"),
    (
        "100.2",
        "The highest cutting speed along Y is so many times that along X. `smoothing.y_factor`",
    ),
    ("300", "As 3; then the 3D paths of the open job lie with their lowest place at ZBottom"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::functions::FUNCTIONS;

    #[test]
    fn every_function_is_told_of_once_and_in_order() {
        let told: Vec<_> = MEANINGS.iter().map(|(number, _)| *number).collect();
        let there: Vec<_> = FUNCTIONS.iter().map(|function| function.number).collect();
        assert_eq!(told, there);
    }
}
