//! The effect of each command as data. The interpreter carries it out; nothing here knows how.

use kerf_program::settings::Distance;
use kerf_program::{AxisSet, MoveKind};

/// The effect of a command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Act {
    /// Moves, jogs, probes and their speeds.
    Move(Move),
    /// Calls present places zero.
    Zero(Zero),
    /// Cuts a shape.
    Cut(Cut),
    /// Runs, shows or makes files.
    File(File),
    /// Modes, switches and what belongs to a session.
    Mode(Mode),
    /// Sets values of the machine.
    Value(Value),
    /// Records commands and runs them again.
    Record(Record),
    /// Shows, keeps or loads something of the installation.
    Utility(Utility),
    /// Starts the virtual tool of a letter.
    Tool(char),
    /// Shows a page of help.
    Help,
}

/// Moves and what belongs to them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Move {
    /// Moves axes to their values; parameter i belongs to axis `first + i`.
    Axes {
        /// Cut or jog.
        kind: MoveKind,
        /// Index of the axis of the first parameter.
        first: usize,
    },
    /// Lifts Z and goes to X 0, Y 0.
    Home(MoveKind),
    /// Moves by a length in a direction.
    Direction,
    /// Turns or swings an axis beside the others.
    Independent,
    /// Cuts motor power.
    MotorsOff,
    /// Sets the speeds that are given.
    Speeds,
    /// Opens a panel that is not there in a part file.
    Nudge,
    /// Moves axes from this one on until an input goes on.
    Probe {
        /// Index of the axis of the first parameter.
        first: usize,
    },
}

/// Places that are called zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Zero {
    /// The working locations of some axes.
    Working(AxisSet),
    /// All table base coordinates.
    TableBase,
    /// All of both.
    Everything,
    /// Working locations become those of the table base.
    ToTableBase,
}

/// Shapes that are cut.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Cut {
    Arch,
    Circle,
    ArcTo,
    PointCircle,
    Rectangle,
}

/// Effects on files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum File {
    /// Runs a part file.
    Run,
    /// Goes through a part file line by line.
    StepThrough,
    /// Shows a file in the editor.
    Edit,
    /// Shows an empty file in the editor.
    New,
    /// Sets the part folder.
    Folder,
    /// Makes a part file of a drawing, a picture or G-code.
    Convert,
}

/// Modes and switches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mode {
    /// Values of moves are locations or distances.
    Distance(Distance),
    /// Commands drive the tool.
    MoveCut,
    /// Commands are drawn.
    Preview,
    /// Chooses table base or working locations (FabMo).
    Coordinates,
    /// Chooses inches or mm for the rest of the run (FabMo).
    Unit,
    /// Deletes all user variables.
    ClearVariables,
    /// Keeps the values that would go back at the end of the file.
    KeepValues,
    /// Brings motion to rest.
    EndStack,
    /// Sets the duration of the warning before motion.
    Warning,
    /// Switches an output.
    Output,
    /// Sets the speed of a spindle.
    SpindleSpeed,
    /// Opens a panel that is not there in a part file.
    SendLines,
    /// Hands the tool over to hand controls.
    Keypad,
}

/// Values of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Value {
    /// Sets what is given, without further check.
    Set,
    /// Sets move and jog speeds.
    Speeds,
    /// Names the present place: working locations of so many axes, then as many of the table base.
    Locations(usize),
    /// Sets tabs and turns them on or off.
    Tabs,
    /// Sets the cutter.
    Cutter,
    /// Sets units, number of axes and what is shown.
    Display,
    /// Sets torch, laser or heater.
    Height,
    /// Sets driver channels.
    Channels,
    /// Sets table limits.
    Limits,
    /// Sets ramps.
    Ramps,
    /// Sets unit values and resolution.
    UnitValues,
    /// Refuses what is no assignment.
    Assignment,
}

/// Effects on recorded commands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Record {
    /// Starts or stops recording.
    Switch(bool),
    /// Runs all again.
    PlayAll,
    /// Runs the last ones again.
    Replay,
    /// Writes them into a file.
    Save,
    /// Forgets them.
    Clear,
}

/// Effects on what is shown and kept of the installation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Utility {
    /// Lists user variables.
    Variables,
    /// Lists the values of the V commands.
    Values,
    /// Shows what helps to find a fault.
    Diagnostics,
    /// Shows the value of an expression.
    Calculator,
    /// Saves settings into a file.
    SaveSettings,
    /// Runs a settings file.
    LoadSettings,
    /// Names the program that shows files.
    Editor,
    /// Loads the firmware of the controller.
    Firmware,
}
