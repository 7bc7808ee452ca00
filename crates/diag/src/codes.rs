//! The one table of diagnostic codes.
//!
//! A code never changes its meaning and is never reused. Letters tell the room: `S` reading
//! OpenSBP, `G` G-code, `R` running, `C` converting, `W` what `check` warns of, `F` files, `K` the configuration,
//! `M` the machine, `J` the journal.

use crate::Severity;
use serde::{Deserialize, Serialize};

/// Explanation of a code that `kerf explain` prints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Explanation {
    /// The code itself.
    pub code: Code,
    /// One line that names the mistake.
    pub title: &'static str,
    /// Its meaning, an example, a way to mend it.
    pub text: &'static str,
}

macro_rules! codes {
    ($($name:ident $text:literal $severity:ident $title:literal $explanation:literal;)*) => {
        /// A stable diagnostic code.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
        pub enum Code { $(#[doc = $title] #[serde(rename = $text)] $name,)* }

        /// Every code, in the order of the table.
        pub const ALL: &[Explanation] =
            &[$(Explanation { code: Code::$name, title: $title, text: $explanation },)*];

        impl Code {
            /// The code as it is printed.
            pub const fn as_str(self) -> &'static str {
                match self { $(Code::$name => $text,)* }
            }
            /// The severity it has unless the place says otherwise.
            pub const fn severity(self) -> Severity {
                match self { $(Code::$name => Severity::$severity,)* }
            }
        }
    };
}

codes! {
    NotText "S001" Error "not a text file"
        "A part file is plain text. This file holds NUL bytes, as programs, pictures and archives do. Open it in the program that wrote it and save it as text.";
    UnknownCommand "S002" Error "unknown command"
        "The line begins with two letters that are no OpenSBP command, or a command and its first value are written together. `M23, 4` is read as the unknown command M23: write `M2, 3, 4` or `M2 3, 4`.";
    UnknownStatement "S003" Error "unknown statement"
        "The line is neither a command, an assignment, a label nor a statement of the language. There is no ELSE, END IF, WHILE or FOR in OpenSBP: use IF ... THEN GOTO.";
    Syntax "S004" Error "the line cannot be read"
        "Part of the line does not fit what the command or statement expects at this place.";
    UnclosedQuote "S005" Error "a quote is not closed"
        "Text that begins with a double quote ends with one on the same line.";
    UnclosedParenthesis "S006" Error "a parenthesis is not closed"
        "Each ( needs its ) on the same line.";
    BadExpression "S007" Error "the expression cannot be read"
        "An operator or a value is missing, or a character does not belong into an expression.";
    UnknownFunction "S008" Error "unknown function"
        "Known functions: SQR ABS INT FIX SGN EXP LOG SIN COS TAN ATN RND, and as extensions ASIN ACOS ATAN SQRT ROUND FLOOR CEIL PI. Angles are radians.";
    TooManyParameters "S009" Error "too many parameters"
        "The command takes fewer values than the line gives. Trailing empty fields are allowed, values are not.";
    MissingParameter "S010" Error "a required value is missing"
        "This value has no default; the command cannot run without it.";
    BadVariableName "S011" Error "character not allowed in a variable name"
        "A variable is & followed by letters, digits and underscores.";
    ThenExpected "S012" Error "THEN expected"
        "IF needs its THEN on the same line: IF &a > 1 THEN GOTO Done.";
    OneCommandPerLine "S013" Error "one command a line"
        "Each line holds one command or statement.";
    ReadOnlyVariable "S014" Error "system variables are read-only"
        "System variables show the state of the machine. V commands change it: VA for locations, VS for speeds.";
    LineTooLong "S015" Error "the line is too long"
        "Lines over a million characters are refused.";

    RepeatedLabel "W001" Warning "a label is repeated"
        "Jumps go to the first place where a label stands; the later ones can only be reached by running into them.";
    UnknownLabel "W002" Warning "a jump to a label that does not exist"
        "The jump becomes an error when it is taken.";
    DoubtfulSpelling "W003" Warning "accepted, but spelled doubtfully"
        "Old programs accepted this spelling, so Kerf does. The hint shows the usual one.";
    UnassignedSystemVariable "W004" Warning "system variable without a meaning"
        "This number is inside the table but means nothing; it reads as empty.";
    MissingUnitGuard "W005" Warning "no unit guard"
        "The file does not test %(25), so it cuts at the wrong size on a machine set to the other unit.";
    JogBelowSurface "W006" Warning "a jog below the surface"
        "A jog moves at rapid speed. Below Z 0 it may run through material.";
    SpindleOff "W007" Warning "cutting with the spindle off"
        "The file cuts but never turns the spindle on (C6, SO,1,1).";
    UnitsMismatch "W008" Warning "units do not match"
        "The file says it is written in the other unit than the one set.";
    FloatCounter "W009" Warning "a fractional counter tested for equality"
        "Adding a fraction again and again rarely hits a value exactly. Test with < or >.";
    EndlessLoop "W010" Warning "a loop that never moves"
        "The program jumps back without moving, waiting or asking.";
    OldOrder "W011" Warning "parameters in the order of an older version"
        "Files for older versions listed these values in another order.";
    Lifts "W012" Warning "a plunge that lifts"
        "The plunge value moves the tool up. Plunges are negative unless VC says that Z counts downwards.";
    TextAfterEnd "W013" Warning "text that is ignored"
        "The rest of the line is not read.";
    Unusual "W014" Warning "unusual value"
        "The value is allowed but of little use or risky.";
    NoMotion "W015" Warning "a move that goes nowhere"
        "The command gives no location at all.";
    DialectDiffers "W016" Warning "means something else in another dialect"
        "Other programs read this line differently.";
    IgnoredInFile "W017" Warning "a command that does nothing in a part file"
        "Help and other pages open for the operator at the keyboard. A part file that names them runs on.";
    Unreachable "W018" Note "a line that is never reached"
        "The line before it ends the program or jumps away, and no label stands between. Code that was set aside on purpose may stay; code that was forgotten wants a label.";
    NeverAssigned "W019" Warning "a variable that the file gives no value"
        "The file calculates with a variable that no line of it assigns. It works only when another file has set it before.";
    NoSound "W020" Warning "a sound that is not there"
        "PLAY names a file that is neither in the part folder nor, by the last part of its name, in the folder `media` of the data folder. The part file goes on without it.";
    KeptProtected "W021" Warning "values that do not stay"
        "The machine's settings are protected by a password (`kerf machine password`). A part file runs with the values that it sets; when it ends they are what they were, also after SV, unless the password was given with the run.";
    EmptyFile "W022" Warning "the file is empty"
        "Nothing stands in the file, so nothing is done. A disk that was full, or a program that was ended while it saved, leaves files without a byte: save it again where it was made.";
    SampleAnswer "W023" Note "0 stands for an answer"
        "The program asks for a value, and whatever only looks at it (check, preview, time, the picture in the console) has nobody to ask: 0 is taken. Sample answers for a file stand beside it: `box.sbp.answers` for `box.sbp`, written as for --answers, which comes before it. A run asks the operator all the same.";

    UndefinedVariable "R001" Error "variable has no value"
        "A variable must be assigned before it is used as a number. As text it reads as empty.";
    NotANumber "R002" Error "a number was expected"
        "The value is text that is no number.";
    DivisionByZero "R003" Error "division by zero"
        "The divisor is zero. Test the divisor with IF before dividing, or set it where the program starts.";
    BadArithmetic "R004" Error "the calculation has no result"
        "The result is no finite number, as the root of a negative number.";
    LabelNotFound "R005" Error "label not found"
        "GOTO and GOSUB jump to labels of the same file. A label is a name alone on a line, ending in a colon.";
    ReturnWithoutGosub "R006" Error "RETURN without GOSUB"
        "RETURN goes back to the line after the last GOSUB of this file. Put END before the first subroutine.";
    NestedTooDeep "R007" Error "nested too deep"
        "At most eight files may be open within each other, and GOSUB has a bound as well.";
    NoSystemVariable "R008" Error "no such system variable"
        "System variables are numbered 1 to 161.";
    OutOfRange "R009" Error "value out of range"
        "The value is outside what the command accepts.";
    ParameterKind "R010" Error "wrong kind of value"
        "The command expects another kind of value here.";
    AxisNotActive "R011" Error "axis not active"
        "VD sets how many axes the machine has.";
    OnlyInFiles "R012" Error "only in part files"
        "This statement has no meaning outside a part file.";
    Geometry "R013" Error "the shape cannot be cut"
        "The values give no shape: a cutter larger than the hole, an end that is not on the circle.";
    LineLimit "R014" Error "too many lines executed, or too many moves for a look"
        "The bound of --max-lines was reached, or a check, a preview or an estimate came to its bound of moves and \
         other commands. Is there a loop that never ends? A machine runs such a program until it is stopped.";
    Terminated "R015" Error "terminated by the user"
        "A question was answered with Cancel, or a value was missing.";
    NotEnabled "R016" Error "not enabled"
        "The function is switched off in the settings.";
    NotSupported "R017" Error "not supported here"
        "The machine or the program at this end cannot do this.";
    BadArc "R018" Error "the end is not on the circle"
        "The end point and the centre give two different radii.";
    StackDropped "R019" Note "motion that was read but not made"
        "An error found while a stack of moves is read means that none of the stack moves.";
    ProgramFailed "R020" Error "the program gave up"
        "A FAIL of FabMo's dialect ended the run; the text is the program's own.";
    NothingRecorded "R021" Error "nothing is recorded"
        "RP, RR and RS need commands that were typed while recording was on. RZ forgets them, RI turns recording off and RA on.";
    Protected "R022" Error "the settings are protected"
        "The machine's settings are protected by a password (`kerf machine password`), and this line changes them. Give the password: --password or KERF_PASSWORD with `kerf send`, the page of the settings in the console. A part file may set what it likes: it ends with the file.";

    FileNotFound "F001" Error "file not found"
        "The name is looked for in the current part folder, ignoring case.";
    FileNotAllowed "F002" Error "file outside the allowed folders"
        "Files are read and written only in the part folder, the custom folder and the scratch folder, unless an option allows more.";
    FileNotOpen "F003" Error "file number is not open"
        "OPEN gives a number to a file; CLOSE takes it back.";
    EndOfFile "F004" Error "end of file"
        "INPUT # read past the last value.";
    FileError "F005" Error "the file cannot be used"
        "The system refused the file.";
    ShellDisabled "F006" Error "external programs are disabled"
        "SHELL runs nothing unless --allow-shell is given.";
    FileNumber "F007" Error "bad file number"
        "File numbers are 1 to 9 and each is used by one file at a time.";

    NotGcode "G001" Error "written in another language"
        "The lines are no G-code. Part files of OpenSBP end in .sbp, drawings in .dxf, plots in .plt; each is run or converted under its own ending.";
    UnknownGWord "G002" Error "unknown G code"
        "No such G code is defined in the language as routers, lasers and LinuxCNC use it.";
    UnknownMWord "G003" Error "unknown M code"
        "No such M code is defined in the language as routers, lasers and LinuxCNC use it.";
    BadBlock "G004" Error "the block cannot be read"
        "A block is made of words: a letter and a number, as in G1 X10.5. Comments stand in parentheses or behind a semicolon.";
    NoNumber "G005" Error "a letter without a number"
        "Each letter is followed by a number, a parameter (#5, #<name>) or an expression in brackets.";
    WordTwice "G006" Error "a word stands twice in a block"
        "Each letter except G and M stands at most once in a block. Write two lines.";
    ModalConflict "G007" Error "two codes of the same group"
        "Codes of one group exclude each other, as G0 and G1 or G20 and G21. Write two lines.";
    MissingWord "G008" Error "a word is missing"
        "The code needs a value that the block does not give, as G4 its P or an arc its centre.";
    UnusedWord "G009" Error "a word that nothing uses"
        "No code of this block and no motion in force takes this word.";
    UnclosedComment "G010" Error "a comment is not closed"
        "A comment that begins with ( ends with ) on the same line.";
    BadFormula "G011" Error "the expression cannot be read"
        "Expressions stand in brackets, as in X[#1 + 2 * SIN[30]]. Angles are degrees.";
    BadParameter "G012" Error "no such parameter"
        "Parameters are numbered from 1 to 5602; those from 5400 on tell the state and cannot be set.";
    NoValue "G013" Error "the parameter has no value"
        "A named parameter must be set before it is used. EXISTS[#<name>] tells whether it was.";
    BadFlow "G014" Error "O-words that do not match"
        "Each sub, if, while, do and repeat needs its end with the same O number on a later line.";
    NoSubroutine "G015" Error "no such subroutine"
        "The subroutine is neither in this file nor a file of its own in the part folder.";
    FeedMissing "G016" Error "no feed"
        "A cutting move needs a feed: F with a value above zero, per minute; with G93 in every block.";
    Compensation "G017" Error "cutter compensation cannot do this"
        "The tool does not fit where the path asks it to go, or the code may not be used while compensation is on.";
    Probing "G018" Error "the probe move failed"
        "The probe made no contact before the end of the move, or was in contact at its start.";
    NotInDialect "G019" Error "not in this dialect"
        "The controller that the dialect stands for does not know this. --dialect or another machine may.";
    ConsoleLine "G020" Warning "a line for the controller's console"
        "Lines that begin with $ set or ask the controller when typed; in a file they are not run.";
    UnitsNeverSaid "G021" Warning "the file does not say its units"
        "Without G20 or G21 the file is read in the unit of the machine, which may not be the one it was written in.";
    BlankInNumber "G022" Warning "blanks within a number"
        "The language ignores blanks, so `X1 0` is X10. Is a letter missing?";
    ArcPlane "G023" Error "the arc does not fit the plane"
        "Arcs lie in the plane of G17 (I and J), G18 (I and K) or G19 (J and K).";
    Aborted "G024" Error "the program ended itself"
        "A comment of the program, (ABORT,REASON), ends it at a place that it should not come to, and says why.";

    OutsideLimits "M001" Error "outside the table limits"
        "The move leaves the limits of VL while limit checking is on.";
    InputStop "M002" Error "stopped by an input"
        "A limit or stop input became active while the machine moved.";
    NoHome "M003" Error "a home switch did not come"
        "While an axis was homed its switch did not change within the length of the axis and a tenth more. The axis is not homed, nor are those that would have followed. Look at the switch, its wire, `axis.length` and the end at which `homing` says it sits.";
    NotHomed "M004" Error "the machine was not homed"
        "The machine is set to run only after its axes were homed (`homing.before_runs`). Home them with `kerf machine home`, or at the question.";
    NotConnected "M005" Error "the machine is not connected"
        "The controller does not answer. What moved has slowed down, outputs went off, the run is over. The last location is kept, but nobody knows whether it is still true: before the next file is cut Kerf asks whether to home, or whether the location is right. Look at the cable; meanwhile SP shows files in preview.";
    SpeedLimited "M006" Warning "a group is cut slower than it asks for"
        "The cutting speed of a group is higher than the machine's cutting speed (`smoothing.cut_speed_mm_s`, `cut` in a pause), which holds then. Lower the group's speed, or raise the machine's.";
    OtherEntry "M007" Warning "the tool goes down otherwise than asked"
        "A group asks for a ramp or a helix, and the tool goes down in another way. Straight down where height control follows the sheet, a laser pierces or a plasma torch starts: these begin above the place. Steeper where the way down would go round a thousand times and more. Along the path instead of round a helix where a whole job is offset, as the room beside the paths is not known then. Nothing is cut that the path does not cut.";
    Controller "M008" Error "the controller does not do this"
        "The controller has stopped by itself, has refused an order, or lacks what the program asks for: an axis, an output, a place within its travel. What it lacks is found before the first move, as far as the program can be looked through; nothing has moved then. After an alarm its place may be lost: home it, or set the location, before the next file. The chapter on controllers says what each kind can do.";
    NoSheet "M009" Warning "height control has no sheet"
        "Height control is on (`height.on`), a shape is cut THRU, and no sheet lies on the table of the simulated machine. A run pauses where the sensor is first needed, with the tool up: nothing is cut in the air. Lay a sheet with `--sheet`, move the switches `zhigh` and `zlow`, or set `height.on = false`. A plan, a picture and a time take the sheet to lie flat, the tool cutting at ZSurface.";
    OutsideMap "M010" Error "a cut leaves the height map"
        "While a height map is in force every cut follows the surface that was probed. Beyond its grid nobody knows the surface: a cut that goes more than 5 mm past it ends the program before it moves there. Probe a larger grid, or take the map off with `kerf map off`.";
    Mapped "M011" Note "Z follows a height map"
        "A height map is in force: Z of every move is the program's plus the height of the surface there, as it was probed. Cuts are cut into pieces of 1 mm for that; jogs go straight to the height of their end. `kerf map off` takes it off.";
    MapNotFollowed "M012" Error "the height map cannot be followed"
        "A height map is in force, and its file in the data folder, height.map, is damaged; or a job is to run whose height control (height.on) finds the surface itself. Nothing moves with heights that nobody knows, or that are counted twice. `kerf map off` takes the map off, `kerf map use FILE` takes another.";
    NotConverted "C001" Warning "not in the other language"
        "The language that is written, or the controller it is written for, has no words for this. A comment in the converted file says what is missing. Where motion would be missing nothing is written: choose another controller with --to, or change the program.";
    StartTaken "C002" Note "the program goes on from where the tool stands"
        "The program moves by distances, or begins to cut, before it has said where the tool is. Places in the converted file are counted as if the tool had stood at zero. Put it there before the converted file runs, or begin the program with a jog to a place.";
    ConversionDiffers "C003" Error "the converted file would move otherwise"
        "Every converted file is read back and followed, and its moves are compared with those of the source. They differed, so nothing was written. This is a fault of Kerf: please report it with the file.";
    Journal "J001" Warning "the run is not on record"
        "The journal in the data folder cannot be written, because the disk is full or the folder may not be changed. The run goes on: stopping in the middle of a cut would spoil the work. Should the power fail now, it could be taken up only from where the journal ended. Make room; as soon as the journal can be written again, it is.";
    AnotherMachine "J002" Warning "machine.toml is not as Kerf left it"
        "The file in the data folder describes another machine than the one that Kerf left in it: somebody edited it, an older file came back, or it lost its bytes. It holds as it is now. Lengths, units and motors may be others, so locations are confirmed once before the next cut. The machine as Kerf left it is kept beside the file.";
    NotKept "C004" Note "a construct that cannot be kept"
        "With --keep-variables the converted file keeps variables, conditions and subroutines where both languages can say them. This line has something that the other language cannot say, so the whole program was written as the moves it makes.";

    NoConfiguration "K001" Error "not a configuration"
        "The configuration of a machine is TOML: lines such as `axes = 4`, sections such as `[delays]`. `kerf machine show` prints a complete one.";
    UnknownSetting "K002" Error "no such setting"
        "A machine's configuration has no setting of this name. Names that are misspelt would have no effect, so they are refused. `kerf get` lists every setting with its unit, bounds and default.";
    BadSetting "K003" Error "a setting does not accept this value"
        "The value is of another type than the setting, or out of its bounds. `kerf get` lists what each setting accepts.";
    Contradiction "K004" Error "settings contradict each other"
        "Each value alone would do, but together they describe no machine: two axes on one motor, Z bottom above Z top, a laser pulse longer than its period. Nothing moves until one of them is changed.";
}

/// The explanation of a code, looked up without regard to case.
pub fn explain(code: &str) -> Option<&'static Explanation> {
    ALL.iter().find(|e| e.code.as_str().eq_ignore_ascii_case(code.trim()))
}

impl std::fmt::Display for Code {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.as_str())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_is_unique_and_explained() {
        let mut seen = std::collections::BTreeSet::new();
        for e in ALL {
            assert!(seen.insert(e.code.as_str()), "{} twice", e.code);
            assert!(e.text.len() > 20 && !e.title.is_empty(), "{}", e.code);
        }
        assert_eq!(explain("s002").map(|e| e.code), Some(Code::UnknownCommand));
        assert!(explain("S999").is_none());
    }
}
