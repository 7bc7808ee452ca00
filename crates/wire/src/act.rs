//! Requests of pages: the acts they ask for.

use crate::{
    AXES, ByHand, CardAct, FileParameters, HeightMapChange, JobChoice, Op, ToolChange, ZeroChange,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// A request: one JSON text a message.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Request {
    /// Comes back in the reply. A page counts.
    pub id: u32,
    /// The act that is to be done.
    pub act: Act,
}

/// An act that is to be done. Those that move the machine carry the number of the lease.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase", rename_all_fields = "camelCase", tag = "do", deny_unknown_fields)]
pub enum Act {
    /// Ramps down, lifts the tool, asks whether to go on; a question that is open ends its job. Always
    /// allowed, to everybody.
    Stop,
    /// Ramps down and stands. Always allowed, to everybody.
    Hold,
    /// Goes on after a hold.
    Resume {
        /// Number of the lease.
        lease: u32,
    },
    /// Answers the question of this number.
    Answer {
        /// Which question.
        question: u32,
        /// The word of a button, or what was entered.
        answer: String,
    },
    /// Becomes the driver. With `force` also from somebody else who stands still.
    TakeLease {
        /// Takes it from whoever has it; not while the machine moves by a jog.
        force: bool,
    },
    /// Is the driver no longer.
    GiveLease {
        /// Number of the lease.
        lease: u32,
    },
    /// Allows motion.
    Arm {
        /// Number of the lease.
        lease: u32,
    },
    /// Forbids motion; what moves is stopped.
    Disarm,
    /// Gives up what this page has asked for and what is not done yet: tool paths, a drawing that is read.
    GiveUp,
    /// Opens a file of the part folder: reads it and makes its preview. While nothing runs, the next file is looked
    /// for beside it.
    Open {
        /// Its name below the part folder.
        name: String,
        /// Parameters with which it is run.
        #[serde(default)]
        #[ts(optional, as = "Option<FileParameters>")]
        parameters: FileParameters,
    },
    /// Runs the open file otherwise: its preview is made anew, and its hash is another.
    Parameters {
        /// Parameters with which it is run.
        parameters: FileParameters,
    },
    /// Cuts the open job otherwise: its preview is made anew, and its hash is another. Not while a job runs.
    Choose {
        /// Choices with which it is cut.
        choice: JobChoice,
    },
    /// Writes the origin that was chosen for the open job into its file. Not while a job runs.
    KeepOrigin,
    /// Writes the open job into its file: with the origin, finish and start that hold, and the shapes that were
    /// added. Not while a job runs.
    SaveJob,
    /// Takes the shape back that was added last to the open job and is not saved. Not while a job runs.
    TakeShapeBack,
    /// Makes the tool path of a drawing: its job, in a file beside it, which is opened.
    Machine {
        /// The drawing, a file of the part folder; nothing for the one that is drawn.
        drawing: Option<String>,
        /// Also where the paths of that job were changed by hand, which is lost then.
        #[serde(default)]
        anew: bool,
    },
    /// Chooses the folder of part files and which of them lists show, as FS does. The owner alone may.
    Folder {
        /// Below the part folder that the server was given, which an empty name means.
        name: String,
        /// As `*.sb?`; nothing keeps what is shown.
        mask: Option<String>,
    },
    /// Closes it.
    Close,
    /// Runs the open file, as it was previewed.
    Run {
        /// Number of the lease.
        lease: u32,
        /// Its hash: what was previewed is what runs, with the parameters of then.
        hash: String,
        /// Go through it line by line.
        #[serde(default)]
        step: bool,
    },
    /// Takes up the run that was cut short: the tool lifts, and before it goes back the operator is asked
    /// whether everything is ready.
    TakeUp {
        /// Number of the lease.
        lease: u32,
    },
    /// Carries out a line of OpenSBP.
    Command {
        /// Number of the lease.
        lease: u32,
        /// The line; several are a program.
        line: String,
    },
    /// Puts a line at the end of the recorder's list, without carrying it out.
    Record {
        /// A command of OpenSBP.
        line: String,
    },
    /// Says which variables are shown while programs run. Every page sees the same.
    Watch {
        /// Names with `&`, `$` or `#`; 50 at most.
        names: Vec<String>,
    },
    /// Moves a switch of the simulated machine. It stays there.
    Input {
        /// Number of the lease.
        lease: u32,
        /// Which input, from 1.
        number: u8,
        /// Its contact is closed.
        on: bool,
    },
    /// Changes a setting of the machine's configuration.
    Set {
        /// Number of the lease.
        lease: u32,
        /// Its key.
        key: String,
        /// Its value, as it is written in a configuration.
        value: String,
    },
    /// Begins to move for as long as it is renewed.
    JogStart {
        /// Number of the lease.
        lease: u32,
        /// Grows with every jog of a page, by a million at most; one that comes behind its own stop is dropped.
        #[ts(type = "number")]
        seq: u64,
        /// Moment when the key was held for sure: the server's clock, which answers to pings tell, as the page
        /// reckons it now, ms.
        clock_ms: f64,
        /// Direction of each axis: -1, 0, 1 or between.
        direction: [f64; AXES],
        /// Factor of the direction: motion ends there. Without it, at the table limits.
        #[ts(type = "AxisValue | null")]
        distance: Option<f64>,
        /// Share of the jog speed, 0 … 1.
        speed_share: f64,
    },
    /// Keeps a jog moving: every 50 to 100 ms. When the newest is 250 ms old by its clock, the machine ramps down,
    /// however late it arrived.
    JogRenew {
        /// Number of the lease.
        lease: u32,
        /// Of the jog.
        #[ts(type = "number")]
        seq: u64,
        /// As that of the start.
        clock_ms: f64,
    },
    /// Lifts the tool out of the cut while a program asks (PAUSE, MSGBOX, M0, a tool change): what turns stops, the
    /// tool rises to Safe-Z. When the program goes on it goes back by itself.
    Lift {
        /// Number of the lease.
        lease: u32,
        /// Number of the question.
        question: u32,
    },
    /// Ends a jog.
    JogStop {
        /// Of the jog.
        #[ts(type = "number")]
        seq: u64,
    },
    /// Presses a key of the hand console. What the key requests is granted to whoever presses it; one that moves
    /// the tool does so for as long as a jog of this number is renewed. Stop is always allowed, to everybody.
    Key {
        /// Number of the lease.
        lease: u32,
        /// As that of a jog.
        #[ts(type = "number")]
        seq: u64,
        /// As that of a jog; without it the key counts as held when it arrives.
        #[serde(default)]
        #[ts(optional)]
        clock_ms: Option<f64>,
        /// A digit, `-` the sign, carriage return for Enter, `F` File, `S` Start, `P` Stop, `U` Func.
        key: char,
    },
    /// Small shift of the workpiece (MN), mm or degrees.
    Nudge {
        /// Number of the lease.
        lease: u32,
        /// Letter of the axis.
        axis: char,
        /// Length of the shift.
        #[ts(type = "AxisValue")]
        distance: f64,
    },
    /// Moves a machine by hand that does nothing else.
    Go {
        /// Number of the lease.
        lease: u32,
        /// The kind of move and its goal.
        way: ByHand,
    },
    /// Switches an output bit of the card of a simulated machine that does nothing else.
    Bit {
        /// Number of the lease.
        lease: u32,
        /// Its name, or port and bit: tool2, B2.
        name: String,
        /// On; off otherwise.
        on: bool,
    },
    /// Steps the motor of an axis once.
    Step {
        /// Number of the lease.
        lease: u32,
        /// x, y, z, w, q or r.
        motor: String,
        /// Forward; back otherwise.
        forward: bool,
    },
    /// Changes a zero point that the controller keeps. Where it is the one that holds, or becomes it, the working zero of
    /// Kerf is the same from then on.
    Zero {
        /// Number of the lease.
        lease: u32,
        /// Its name, as G54.
        name: String,
        /// The change.
        change: ZeroChange,
    },
    /// Changes a tool that is known by its number. Not while a job runs.
    Tool {
        /// Number of the lease.
        lease: u32,
        /// Its number, from 1.
        number: u32,
        /// The change.
        change: ToolChange,
    },
    /// Has the controller touch off the tool for which it waits; Z zero follows the length. Not while a job runs.
    TouchOff {
        /// Number of the lease.
        lease: u32,
    },
    /// The tool is in for which the controller waits: it goes on.
    ToolIn {
        /// Number of the lease.
        lease: u32,
    },
    /// Forgets the factor that runs on the controller have shown.
    ForgetPace {
        /// Number of the lease.
        lease: u32,
    },
    /// Writes the steps of a millimetre of an axis into the controller, and reads them back.
    ControllerSteps {
        /// Number of the lease.
        lease: u32,
        /// Letter of the axis.
        axis: char,
        /// Steps of a millimetre.
        steps: f64,
    },
    /// Works the card of the controller. Not while a job runs, but for its end.
    ControllerCard {
        /// Number of the lease.
        lease: u32,
        /// The request.
        task: CardAct,
    },
    /// Changes the height map that programs follow. Not while a job runs.
    HeightMap {
        /// Number of the lease.
        lease: u32,
        /// The change.
        change: HeightMapChange,
    },
    /// Looks at all serial ports of this computer for boards with step queues, and at one more. Each is opened for a moment.
    /// Not while a real machine is driven.
    WireLook {
        /// Number of the lease.
        lease: u32,
        /// A further port; none where it is empty.
        port: String,
    },
    /// Begins to wire a board with step queues that hangs on a port of this computer; questions follow, and each motor
    /// turns a little. Not while a real machine is driven.
    Wire {
        /// Number of the lease.
        lease: u32,
        /// Its port, as /dev/ttyACM0.
        port: String,
        /// The name of a board that is sold: its pins are known.
        #[serde(default)]
        #[ts(optional)]
        board: Option<String>,
        /// Name of the machine's file that is written into the part folder at the end.
        into: String,
    },
    /// Answers the question of this number about the board that is being wired. `q` ends it, and nothing is written.
    WireAnswer {
        /// Number of the lease.
        lease: u32,
        /// Number of the question.
        question: u32,
        /// y, n, a pin, a number; nothing for what stands.
        answer: String,
    },
    /// Changes the operator's overrides; one that is not given stays.
    Override {
        /// Number of the lease.
        lease: u32,
        /// Of the speed asked for, 10 … 200.
        #[serde(default)]
        #[ts(optional)]
        feed_percent: Option<f64>,
        /// Of the speed of rapid moves, 10 … 100.
        #[serde(default)]
        #[ts(optional)]
        rapid_percent: Option<u8>,
        /// Of the speed of the spindle, 10 … 200.
        #[serde(default)]
        #[ts(optional)]
        spindle_percent: Option<u8>,
    },
    /// The FP sheet that a start-up line opens was filled in or put away: no page opens it any more.
    SheetDone,
    /// Empties the print window.
    ClearPrinted,
    /// Takes note of an alarm: the machine is idle and disarmed afterwards.
    Acknowledge,
    /// Makes a change of the drawing.
    Draw {
        /// The change.
        op: Op,
    },
    /// Gives the password of the settings: this page may change them for a while.
    Unlock {
        /// The password.
        password: String,
    },
    /// Protects the settings with a password, or no longer.
    Protect {
        /// The password until now, where there is one.
        #[serde(default)]
        password: Option<String>,
        /// The new one, twice; none takes the protection away.
        new: Option<[String; 2]>,
    },
    /// Answers only; tells whether the link works and how long it takes.
    Ping,
}
