// Made from crates/wire by `cargo xtask wire`; changes are lost.

import type {
  AxisGoal, AxisPlace, AxisSpeeds, AxisValue, Degrees, Mm, MmPerMin, MmPerS, Seconds, UnitSize, UnixSeconds,
} from "../units/quantity";

export type ActStop = { "do": "stop" };

export type ActHold = { "do": "hold" };

export type ActResume = { "do": "resume",
/** Number of the lease. */
lease: number, };

export type ActAnswer = { "do": "answer",
/** Which question. */
question: number,
/** The word of a button, or what was entered. */
answer: string, };

export type ActTakeLease = { "do": "takeLease",
/** Takes it from whoever has it; not while the machine moves by a jog. */
force: boolean, };

export type ActGiveLease = { "do": "giveLease",
/** Number of the lease. */
lease: number, };

export type ActArm = { "do": "arm",
/** Number of the lease. */
lease: number, };

export type ActDisarm = { "do": "disarm" };

export type ActGiveUp = { "do": "giveUp" };

export type ActOpen = { "do": "open",
/** Its name below the part folder. */
name: string,
/** Parameters with which it is run. */
parameters?: FileParameters, };

export type ActParameters = { "do": "parameters",
/** Parameters with which it is run. */
parameters: FileParameters, };

export type ActChoose = { "do": "choose",
/** Choices with which it is cut. */
choice: JobChoice, };

export type ActKeepOrigin = { "do": "keepOrigin" };

export type ActSaveJob = { "do": "saveJob" };

export type ActTakeShapeBack = { "do": "takeShapeBack" };

export type ActMachine = { "do": "machine",
/** The drawing, a file of the part folder; nothing for the one that is drawn. */
drawing: string | null,
/** Also where the paths of that job were changed by hand, which is lost then. */
anew: boolean, };

export type ActFolder = { "do": "folder",
/** Below the part folder that the server was given, which an empty name means. */
name: string,
/** As `*.sb?`; nothing keeps what is shown. */
mask: string | null, };

export type ActClose = { "do": "close" };

export type ActRun = { "do": "run",
/** Number of the lease. */
lease: number,
/** Its hash: what was previewed is what runs, with the parameters of then. */
hash: string,
/** Go through it line by line. */
step: boolean, };

export type ActTakeUp = { "do": "takeUp",
/** Number of the lease. */
lease: number, };

export type ActCommand = { "do": "command",
/** Number of the lease. */
lease: number,
/** The line; several are a program. */
line: string, };

export type ActRecord = { "do": "record",
/** A command of OpenSBP. */
line: string, };

export type ActWatch = { "do": "watch",
/** Names with `&`, `$` or `#`; 50 at most. */
names: Array<string>, };

export type ActInput = { "do": "input",
/** Number of the lease. */
lease: number,
/** Which input, from 1. */
number: number,
/** Its contact is closed. */
on: boolean, };

export type ActSet = { "do": "set",
/** Number of the lease. */
lease: number,
/** Its key. */
key: string,
/** Its value, as it is written in a configuration. */
value: string, };

export type ActJogStart = { "do": "jogStart",
/** Number of the lease. */
lease: number,
/** Grows with every jog of a page, by a million at most; one that comes behind its own stop is dropped. */
seq: number,
/** Moment when the key was held for sure: the server's clock, which answers to pings tell, as the page reckons it now, ms. */
clockMs: number,
/** Direction of each axis: -1, 0, 1 or between. */
direction: [number, number, number, number, number, number],
/** Factor of the direction: motion ends there. Without it, at the table limits. */
distance: AxisValue | null,
/** Share of the jog speed, 0 … 1. */
speedShare: number, };

export type ActJogRenew = { "do": "jogRenew",
/** Number of the lease. */
lease: number,
/** Of the jog. */
seq: number,
/** As that of the start. */
clockMs: number, };

export type ActLift = { "do": "lift",
/** Number of the lease. */
lease: number,
/** Number of the question. */
question: number, };

export type ActJogStop = { "do": "jogStop",
/** Of the jog. */
seq: number, };

export type ActKey = { "do": "key",
/** Number of the lease. */
lease: number,
/** As that of a jog. */
seq: number,
/** As that of a jog; without it the key counts as held when it arrives. */
clockMs?: number,
/** A digit, `-` the sign, carriage return for Enter, `F` File, `S` Start, `P` Stop, `U` Func. */
key: string, };

export type ActNudge = { "do": "nudge",
/** Number of the lease. */
lease: number,
/** Letter of the axis. */
axis: string,
/** Length of the shift. */
distance: AxisValue, };

export type ActGo = { "do": "go",
/** Number of the lease. */
lease: number,
/** The kind of move and its goal. */
way: ByHand, };

export type ActBit = { "do": "bit",
/** Number of the lease. */
lease: number,
/** Its name, or port and bit: tool2, B2. */
name: string,
/** On; off otherwise. */
on: boolean, };

export type ActStep = { "do": "step",
/** Number of the lease. */
lease: number,
/** x, y, z, w, q or r. */
motor: string,
/** Forward; back otherwise. */
forward: boolean, };

export type ActZero = { "do": "zero",
/** Number of the lease. */
lease: number,
/** Its name, as G54. */
name: string,
/** The change. */
change: ZeroChange, };

export type ActTool = { "do": "tool",
/** Number of the lease. */
lease: number,
/** Its number, from 1. */
number: number,
/** The change. */
change: ToolChange, };

export type ActTouchOff = { "do": "touchOff",
/** Number of the lease. */
lease: number, };

export type ActToolIn = { "do": "toolIn",
/** Number of the lease. */
lease: number, };

export type ActForgetPace = { "do": "forgetPace",
/** Number of the lease. */
lease: number, };

export type ActControllerSteps = { "do": "controllerSteps",
/** Number of the lease. */
lease: number,
/** Letter of the axis. */
axis: string,
/** Steps of a millimetre. */
steps: number, };

export type ActControllerCard = { "do": "controllerCard",
/** Number of the lease. */
lease: number,
/** The request. */
task: CardAct, };

export type ActHeightMap = { "do": "heightMap",
/** Number of the lease. */
lease: number,
/** The change. */
change: HeightMapChange, };

export type ActWireLook = { "do": "wireLook",
/** Number of the lease. */
lease: number,
/** A further port; none where it is empty. */
port: string, };

export type ActWire = { "do": "wire",
/** Number of the lease. */
lease: number,
/** Its port, as /dev/ttyACM0. */
port: string,
/** The name of a board that is sold: its pins are known. */
board?: string,
/** Name of the machine's file that is written into the part folder at the end. */
into: string, };

export type ActWireAnswer = { "do": "wireAnswer",
/** Number of the lease. */
lease: number,
/** Number of the question. */
question: number,
/** y, n, a pin, a number; nothing for what stands. */
answer: string, };

export type ActOverride = { "do": "override",
/** Number of the lease. */
lease: number,
/** Of the speed asked for, 10 … 200. */
feedPercent?: number,
/** Of the speed of rapid moves, 10 … 100. */
rapidPercent?: number,
/** Of the speed of the spindle, 10 … 200. */
spindlePercent?: number, };

export type ActSheetDone = { "do": "sheetDone" };

export type ActClearPrinted = { "do": "clearPrinted" };

export type ActAcknowledge = { "do": "acknowledge" };

export type ActDraw = { "do": "draw",
/** The change. */
op: Op, };

export type ActUnlock = { "do": "unlock",
/** The password. */
password: string, };

export type ActProtect = { "do": "protect",
/** The password until now, where there is one. */
password: string | null,
/** The new one, twice; none takes the protection away. */
new: [string, string] | null, };

export type ActPing = { "do": "ping" };

/** An act that is to be done. Those that move the machine carry the number of the lease. */
export type Act =
  | ActStop
  | ActHold
  | ActResume
  | ActAnswer
  | ActTakeLease
  | ActGiveLease
  | ActArm
  | ActDisarm
  | ActGiveUp
  | ActOpen
  | ActParameters
  | ActChoose
  | ActKeepOrigin
  | ActSaveJob
  | ActTakeShapeBack
  | ActMachine
  | ActFolder
  | ActClose
  | ActRun
  | ActTakeUp
  | ActCommand
  | ActRecord
  | ActWatch
  | ActInput
  | ActSet
  | ActJogStart
  | ActJogRenew
  | ActLift
  | ActJogStop
  | ActKey
  | ActNudge
  | ActGo
  | ActBit
  | ActStep
  | ActZero
  | ActTool
  | ActTouchOff
  | ActToolIn
  | ActForgetPace
  | ActControllerSteps
  | ActControllerCard
  | ActHeightMap
  | ActWireLook
  | ActWire
  | ActWireAnswer
  | ActOverride
  | ActSheetDone
  | ActClearPrinted
  | ActAcknowledge
  | ActDraw
  | ActUnlock
  | ActProtect
  | ActPing;

/** A level of arrays. Mm. */
export type ArrayState = {
/** `block` or `job`. */
level: string,
/** Rows, counted upwards, and columns, to the right. */
grid: [number, number],
/** Gaps between neighbouring columns and rows. */
gap: [Mm, Mm],
/** Distances from one to the next, in X and Y. */
pitch: [Mm, Mm],
/** The corner at which it begins: bl, br, tr, tl. */
start: string,
/** The order of the places: row, column, row-snake, column-snake. */
order: string, };

/** A question that a job waits for. It belongs to the job: any page may answer. */
export type Asked = {
/** Its number; an answer names it, so that none goes to another question. */
number: number,
/** `input`, `msgbox`, `pause`, `spindle`, `limit`, `keypad`, `editor`, `speed`, `hold`, `step`, `paused`. */
kind: string,
/** The text. */
text: string,
/** The title. */
title: string,
/** The words on its buttons. */
buttons: Array<string>,
/** The button that ENTER presses: its place in the list. */
default: number,
/** Text that stands in the entry field. */
prefill: string,
/** It has an entry field. */
entry: boolean,
/** 0 none, 16 critical, 32 question, 48 warning, 64 information. */
icon: number,
/** The file that is to be shown in the editor (FE): its name below the part folder, empty for a new one. Nothing for other questions. */
edits: string | null,
/** The file that asks. */
file: string,
/** Its line. */
line: number,
/** State that the machine was in. */
was: State, };

/** Unit in which a person reads an axis. */
export type AxisUnits = {
/** Its letter. */
letter: string,
/** `in`, `mm` or `deg`. */
unit: string,
/** Internal units (mm or degrees) in one of them. */
scale: UnitSize,
/** The machine has it. */
used: boolean, };

/** The smallest box round the shapes of a drawing, arcs counted exactly. */
export type Block = {
/** Least X and Y. */
min: [Mm, Mm],
/** Greatest X and Y. */
max: [Mm, Mm],
/** Least and greatest height of its 3D shapes; nothing without any. Flat shapes have no height. */
z: [Mm, Mm] | null, };

export type ByHandFindHome = { "to": "findHome",
/** Their letters, as `xy`; all that have a switch for nothing. */
axes: string | null, };

export type ByHandHome = { "to": "home",
/** Their letters, as `xy`; all for nothing. */
axes: string | null, };

export type ByHandOrigin = { "to": "origin" };

export type ByHandFinish = { "to": "finish" };

export type ByHandPlace = { "to": "place",
/** X and Y from the job origin, the others from home; or all from where the tool is. Axes without a value stay. */
place: AxisGoal,
/** From where the tool is. */
relative: boolean,
/** X and Y first, then the others; else all together. */
flat: boolean, };

export type ByHandWarmUp = { "to": "warmUp",
/** Percent of its greatest speed and minutes, as `25:2, 50:2`; those of the settings for nothing. */
steps: string | null, };

export type ByHandCutMove = { "to": "cutMove",
/** That place. */
at: [Mm, Mm],
/** Cuts on the way, as a job of one line. */
cut: boolean, };

/** A move by hand of a machine that does nothing else. Mm, degrees. */
export type ByHand =
  | ByHandFindHome
  | ByHandHome
  | ByHandOrigin
  | ByHandFinish
  | ByHandPlace
  | ByHandWarmUp
  | ByHandCutMove;

/** A file that a run is in. */
export type Call = {
/** The file. */
file: string,
/** The line that is read next. */
line: number, };

export type CardActList = { "to": "list" };

export type CardActLook = { "to": "look",
/** Its name. */
name: string, };

export type CardActUpload = { "to": "upload",
/** The file. */
file: string,
/** A file of that name is written over. */
replaces: boolean, };

export type CardActRun = { "to": "run",
/** Its name. */
name: string,
/** Also where its text could not be read back. */
unseen: boolean, };

export type CardActDelete = { "to": "delete",
/** Its name. */
name: string, };

export type CardActKeep = { "to": "keep",
/** Its name. */
name: string,
/** A file of that name is written over. */
replaces: boolean, };

export type CardActCancel = { "to": "cancel" };

/** A request about the card. */
export type CardAct =
  | CardActList
  | CardActLook
  | CardActUpload
  | CardActRun
  | CardActDelete
  | CardActKeep
  | CardActCancel;

/** A file on the card. */
export type CardFile = {
/** Its name, with the folders before it. */
name: string,
/** Its size, bytes. */
bytes: number,
/** Outcome of the look through it; nothing where its text is not known. */
looked: CardLook | null, };

/** Outcome of a look through a file of the card: it is within the limits of the controller. */
export type CardLook = {
/** Time that the controller is estimated to take, seconds. */
seconds: Seconds,
/** Warnings: what it does otherwise than the file says. */
warnings: Array<string>, };

/** A task on the card. */
export type CardTask = {
/** Its kind. */
kind: CardTaskKind,
/** The file that it is about; empty where it is none. */
name: string,
/** Bytes that are there. */
done: number,
/** Bytes in all; 0 where that is not known. */
all: number, };

/** Kind of a task on the card. */
export type CardTaskKind = "list" | "look" | "upload" | "run" | "delete" | "keep";

export type ChangeMachine = { "change": "machine", machine: Machine, };

export type ChangeMotion = { "change": "motion", motion: Motion, };

export type ChangeUnits = { "change": "units", units: Units, };

export type ChangeSetup = { "change": "setup", setup: Setup, };

export type ChangeSpeeds = { "change": "speeds", speeds: Speeds, };

export type ChangeIo = { "change": "io", io: Io, };

export type ChangeOpened = { "change": "opened", opened: Opened | null, };

export type ChangeJob = { "change": "job", job: CurrentRun | null, };

export type ChangeTyped = { "change": "typed", typed: TypedPath, };

export type ChangeInterrupted = { "change": "interrupted", interrupted: Interrupted | null, };

export type ChangeAsked = { "change": "asked", asked: Asked | null, };

export type ChangePause = { "change": "pause", pause: Pause | null, };

export type ChangeSound = { "change": "sound", sound: Sound | null, };

export type ChangeOverrides = { "change": "overrides", overrides: Overrides, };

export type ChangeZeros = { "change": "zeros", zeros: Array<Zero>, };

export type ChangeControllerSteps = { "change": "controllerSteps", controllerSteps: Array<number>, };

export type ChangeControllerSettings = { "change": "controllerSettings", controllerSettings: Array<ControllerSetting>, };

export type ChangeControllerCard = { "change": "controllerCard", controllerCard: ControllerCard, };

export type ChangeTools = { "change": "tools", tools: ToolTable, };

export type ChangeTogether = { "change": "together", together: Array<ServedMachine>, };

export type ChangeHeightMap = { "change": "heightMap", heightMap: HeightMap | null, };

export type ChangeWiring = { "change": "wiring", wiring: Wiring | null, };

export type ChangePrinted = { "change": "printed", lines: Array<string>, };

export type ChangeClearPrinted = { "change": "clearPrinted" };

export type ChangeMessages = { "change": "messages", messages: Array<Message>, };

export type ChangeStart = { "change": "start", start: StartUp | null, };

export type ChangeLease = { "change": "lease", lease: Lease | null, };

export type ChangeClients = { "change": "clients", clients: Array<Client>, };

export type ChangeDrawing = { "change": "drawing", drawing: DrawingState | null, };

export type ChangeFiles = { "change": "files", files: number, };

export type ChangeFolder = { "change": "folder", folder: Folder, };

export type ChangeRecorder = { "change": "recorder", recorder: Recorder, };

export type ChangeWatched = { "change": "watched", watched: Array<NamedValue>, };

export type ChangeSettings = { "change": "settings", settings: number, };

export type ChangeHandConsole = { "change": "handConsole", handConsole: HandConsole, };

export type ChangeDigitized = { "change": "digitized", digitized: Digitized | null, };

export type ChangeLooked = { "change": "looked", looked: Looked | null, };

/** One change of what a page shows: a section of the [`Snapshot`] as it is now, or what is added to one. */
export type Change =
  | ChangeMachine
  | ChangeMotion
  | ChangeUnits
  | ChangeSetup
  | ChangeSpeeds
  | ChangeIo
  | ChangeOpened
  | ChangeJob
  | ChangeTyped
  | ChangeInterrupted
  | ChangeAsked
  | ChangePause
  | ChangeSound
  | ChangeOverrides
  | ChangeZeros
  | ChangeControllerSteps
  | ChangeControllerSettings
  | ChangeControllerCard
  | ChangeTools
  | ChangeTogether
  | ChangeHeightMap
  | ChangeWiring
  | ChangePrinted
  | ChangeClearPrinted
  | ChangeMessages
  | ChangeStart
  | ChangeLease
  | ChangeClients
  | ChangeDrawing
  | ChangeFiles
  | ChangeFolder
  | ChangeRecorder
  | ChangeWatched
  | ChangeSettings
  | ChangeHandConsole
  | ChangeDigitized
  | ChangeLooked;

/** Findings about a text that is being edited. */
export type Checked = {
/** The findings. */
findings: Array<Finding>, };

/** A page that is connected. */
export type Client = {
/** Its number. */
client: number,
/** Its role. */
role: Role,
/** Name of the device. */
device: string, };

/** A command of OpenSBP: what its fill-in sheet is made of. */
export type CommandEntry = {
/** Its two letters. */
letters: string,
/** Its name, as a menu shows it. */
name: string,
/** The menu it belongs to: `move`, `jog`, `cut`, `file`, `settings`, `values`, `zero`, `record`, `tools`, `utilities`, `help`. */
group: string,
/** Description of its effect. */
doc: string,
/** It moves the machine. */
moves: boolean,
/** Its parameters, in order. */
parameters: Array<Parameter>, };

/** A word that could stand here. */
export type Completion = {
/** The word. */
label: string,
/** `command`, `statement`, `function`, `variable`, `label`, `value`, `code`. */
kind: string,
/** A few words beside it. */
detail: string,
/** Description of its effect. */
doc: string, };

/** The card of the controller, as far as it is known. */
export type ControllerCard = {
/** There is one. */
has: boolean,
/** Reason why there is none; empty of a machine without a controller. */
why: string,
/** Its files as they were listed last; nothing before that. */
files: Array<CardFile> | null,
/** The task under way. */
task: CardTask | null,
/** Reasons why the last task was not done, each with its place and how it is mended. */
refused: Array<string>,
/** Name of the file that the last task would have written over. */
replaces: string | null,
/** Name of the file whose text the last task could not read back: it may be run unseen. */
unread: string | null,
/** Name of the file of the part folder into which the last task has copied one. */
kept: string | null,
/** Notes of the last task: what a conversion left out or made otherwise. */
notes: Array<string>, };

/** A line that was sent or came. */
export type ControllerLine = {
/** Its number; they count up. */
number: number,
/** Its time, seconds since 1970 with their thousandths. */
at: UnixSeconds,
/** It was sent; else it came. */
sent: boolean,
/** Its kind. */
kind: LineKind,
/** The line itself; of a byte that is obeyed at once its code. */
text: string,
/** Words beside it, as those of an error's number; mostly none. */
words: string, };

/** A portion of what passed. */
export type ControllerLines = {
/** The lines, the oldest first. */
lines: Array<ControllerLine>,
/** The number from which to ask on. */
next: number,
/** There are more behind them already. */
more: boolean,
/** Lines that are not kept any more, of all that there were. */
gone: number, };

/** A setting that the controller of the machine keeps by number, as it told it last. */
export type ControllerSetting = {
/** Its number. */
number: number,
/** Its value, as the controller writes it. */
value: string,
/** Its name; empty where nobody knows it. */
name: string,
/** The unit of its value; empty where it has none. */
unit: string,
/** Least value, where there is one. */
least: number | null,
/** Greatest value, where there is one. */
most: number | null,
/** A sentence that explains it; empty where nobody knows. */
does: string,
/** The same as the controller itself tells it; empty where it does not. */
own: string, };

/** The run that is under way, or the last one. */
export type CurrentRun = {
/** Number of the run since the server began. */
run: number,
/** The part file; empty for a command that somebody typed. */
file: string,
/** Its hash, when it is a file. */
hash: string | null,
/** The command line, when somebody typed it. */
command: string | null,
/** The controller runs the file from a card of its own. */
fromCard: boolean,
/** Planned time, seconds; 0 when it is not known. */
seconds: Seconds,
/** It began in preview on a machine that nobody armed: it is only drawn to its end. */
drawsOnly: boolean,
/** VD without comments was carried out and nothing was printed since: the message screen is closed. */
silent: boolean,
/** The open files, outermost first, with the line that is read. */
calls: Array<Call>,
/** The file whose line the tool makes ([`Motion::line`](crate::Motion)): one of those, or one that is read to its end; empty before the first move. */
toolFile: string,
/** Z of travel, of the surface of the material and of the lowest place of the tool: from home, mm, as they are in force in a job. Pauses and height control change them. */
heights: [Mm, Mm, Mm] | null,
/** Settings as a pause has changed them for the rest of a job; nothing while they are as they were set. */
inForce: InForce | null,
/** Word for its end: `ok`, `ended`, `failed`, `stopped`, `limit`; nothing while it runs. */
ended: string | null,
/** The error that ended it, when one did. */
error: Finding | null, };

/** Depth of a cut: `thru`, `3d`, or mm above the surface. */
export type CutHeight = string | Mm;

/** Which cut of a shape a path is. */
export type CutPass = "rough" | "final" | "traversal";

/** One path of the tool. */
export type CutShape = {
/** Which cut of that shape it is. */
pass: CutPass,
/** Number of the shape, from 1. */
number: number,
/** Its group: black, blue, green, cyan, red, magenta, brown, white. */
group: string,
/** Its end is its start. */
closed: boolean,
/** Three numbers a vertex: X, Y and the bulge of the segment behind it, the tangent of a quarter of the angle of an arc, positive counter-clockwise; 0 is a line. */
points: Array<number>,
/** Height of each vertex, for a 3D shape. */
z: Array<number> | null,
/** The machine halts before it. */
pause: boolean, };

/** The path at a level of detail. */
export type Detail = {
/** Greatest distance from the true path, mm. */
tolerance: Mm,
/** Segments. */
segments: number,
/** Pieces they come in. */
pieces: number, };

/** Points that are being digitized, and the segments through them. */
export type Digitized = {
/** The job origin, from which they count: X and Y from home, mm. */
origin: [Mm, Mm],
/** The points in order. */
points: Array<DigitizedPoint>,
/** The bulge of the segment behind each point but the last, from it to the next one. */
bulges: Array<number>,
/** Number of the current point, from 1; 0 without points. */
current: number,
/** Heights count. */
threeD: boolean,
/** The next point is an arc point. */
nextArc: boolean,
/** There are points that no shape was saved of as they are. */
unsaved: boolean, };

/** A digitized point. */
export type DigitizedPoint = {
/** X and Y from the job origin, Z from home, mm. */
at: [Mm, Mm, Mm],
/** The arc from the point before to the point behind goes through it; else it ends a line. */
arc: boolean, };

/** The drawing as a page shows it. Its shapes come over HTTP: `/api/drawing/shapes`. */
export type DrawingState = {
/** The file it came from or was saved in last. */
name: string | null,
/** Grows with every change of the shapes. */
revision: number,
/** Its revision when it was opened or begun. */
begun: number,
/** Number of shapes. */
shapes: number,
/** The shapes that operations act on: numbers from 1. */
selection: Array<number>,
/** The shapes that were picked to be sequenced, in that order: numbers from 1. */
picked: Array<number>,
/** There is something to take back. */
canUndo: boolean,
/** There is something to make again. */
canRedo: boolean,
/** It differs from its file. */
changed: boolean,
/** Number of shapes on the clipboard. */
clipboard: number,
/** The eight groups and how their shapes are cut. */
groups: Array<GroupState>,
/** The basic block of data: bounds of the drawing before it is arrayed. Nothing without shapes. */
block: Block | null,
/** Place to which the head goes when its job is done, from the origin. */
finish: [Mm, Mm],
/** Distance at which ends are joined when nothing else is said: that of the last time. */
join: Mm,
/** The comments that are kept with it. */
comments: Array<string>,
/** Its two levels of repetition: blocks in a job, then jobs on the table. */
arrays: Array<ArrayState>,
/** Notes of the last operation, or of reading the file. */
notes: Array<string>, };

/** Duty that is assigned to an input (VN). */
export type Duty = "standard" | "limit" | "stop";

/** A file that would be replaced. */
export type FileAbout = {
/** Its name below the part folder. */
name: string,
/** Description: `a part program of 412 lines`. */
what: string,
/** Bytes. */
bytes: number,
/** Time of its last change: seconds since 1970. */
changed: UnixSeconds,
/** SHA-256 of its content, in hexadecimal digits: who saw it names it as what may be replaced. */
hash: string, };

/** A file of the part folder. */
export type FileInfo = {
/** Its name below the part folder, `/` between folders. */
name: string,
/** It is a folder. */
folder: boolean,
/** Bytes. */
bytes: number,
/** Time of its last change: seconds since 1970. */
changed: UnixSeconds,
/** Text of its head about the job. */
header: string | null,
/** It is a part file: one that the mask of the part folder lets through, or G-code. */
part: boolean,
/** The sort of file as which it is opened; nothing for a folder, a log, and whatever else is none. */
opens: FileKind | null, };

/** Sort of the open file. */
export type FileKind = "program" | "job" | "drawing";

/** Parameters with which a part file is run: those of FP. */
export type FileParameters = {
/** Scales X, Y and Z. */
proportion: [number, number, number],
/** Number of runs of the file, at least one. */
repetitions: number,
/** 0: places as written. 1: the present place is X 0, Y 0, Z 0 of the file. 2: X 0, Y 0. */
offset: number,
/** Distance that Z moves before each repetition, mm. */
plunge: Mm,
/** Leave tabs on the last repetition. */
tabs: boolean,
/** Z moves to 0 before the first plunge. */
plungeFromZero: boolean, };

/** An earlier content of a file that Kerf wrote over. */
export type FileVersion = {
/** Grows with each save of the file, from 1. */
number: number,
/** The file had this content since then: seconds since 1970. */
changed: UnixSeconds,
/** Bytes. */
bytes: number, };

/** Something a person should know about a file. */
export type Finding = {
/** Severity. */
level: Level,
/** Its code. */
code: string,
/** The file. */
file: string,
/** Line, from 1; 0 for the whole file. */
line: number,
/** Column in characters, from 1. */
column: number,
/** Characters. */
length: number,
/** Description of what is wrong. */
message: string,
/** Advice how to mend it. */
hint: string, };

/** The folder that part files are chosen from. */
export type Folder = {
/** Its name below the folder that the server was given; empty for that itself. */
name: string,
/** Which files lists show: `*` any characters, `?` one. */
mask: string, };

/** A board with step queues that answers at a port. */
export type FoundBoard = {
/** Its chip, as rp2040. */
chip: string,
/** Version of its firmware. */
firmware: string,
/** It was configured since it was powered: it has to be reset before it is wired otherwise. */
isConfigured: boolean,
/** It is shut down. */
isShutDown: boolean,
/** Boards that are sold with this chip. */
mayBe: Array<SoldBoard>, };

/** A serial port, and who is at it. */
export type FoundPort = {
/** Its path. */
port: string,
/** Maker and product of the device, as it tells them. */
device: string | null,
/** The board that answers. */
board: FoundBoard | null,
/** The reason for which none does, in a sentence. */
trouble: string | null, };

/** Cut of the shapes of a group, as the operation `set` changes it. Lengths in mm, angles in degrees. */
export type GroupState = {
/** Its colour. */
name: string,
/** Its shapes are cut. */
on: boolean,
/** The head only follows them, to get round obstacles. */
traversal: boolean,
/** Cut on both sides of the shape. */
double: boolean,
/** The tool output, 1 … 3. */
tool: number,
/** The cut output, 1 … 3. */
cut: number,
/** Highest cutting speed; nothing is the machine's. */
speedMmMin: MmPerMin | null,
/** Depth of the cut. */
height: CutHeight,
/** Depth of one pass. */
pass: Mm | null,
/** Z of each pass from the machine's home. None when each point of a shape has its own height, which counts from the surface. */
levels: Array<Mm>,
/** Distance of the path, right of travel. */
offset: Mm,
/** Material that the rough pass leaves. */
rough: Mm,
/** Length that is left out at the beginning. */
tag: Mm,
/** Radius and angle of the arc onto the path. */
leadIn: [Mm, Degrees],
/** Radius and angle of the arc off the path. */
leadOut: [Mm, Degrees], };

/** The screen of the hand console. */
export type HandConsole = {
/** Its lines, of 20 characters at most. */
lines: [string, string],
/** Number of beeps so far. */
beeps: number,
/** Its serial link, in a sentence: the port it is at, or why it is not. Empty where there is none. */
link: string, };

/** The height map in force: heights of a surface at the places of a grid, counted from working zero. */
export type HeightMap = {
/** Places along X. */
columns: number,
/** Places along Y. */
rows: number,
/** Corner with the least X and Y. */
low: [Mm, Mm],
/** Corner with the greatest X and Y. */
high: [Mm, Mm],
/** Lowest height. */
lowest: Mm,
/** Highest height. */
highest: Mm,
/** X of each column; none of a map with more than 2500 places, as the next two. */
xs: Mm[],
/** Y of each row. */
ys: Mm[],
/** The heights row by row, along X. */
zs: Mm[], };

export type HeightMapChangeFile = { "to": "file",
/** Its name below the part folder. */
name: string, };

export type HeightMapChangeOff = { "to": "off" };

/** A change of the height map in force. */
export type HeightMapChange =
  | HeightMapChangeFile
  | HeightMapChangeOff;

/** Which parameter of a command is being written. */
export type Hint = {
/** The command's letters. */
letters: string,
/** Its name. */
name: string,
/** Names of its parameters. */
parameters: Array<string>,
/** The place of the one that is being written. */
at: number,
/** Explanation. */
doc: string, };

/** Explanation of the word at a place. */
export type Hover = {
/** The text. */
text: string,
/** First column of the word, from 1. */
from: number,
/** The column behind it. */
to: number, };

/** Settings that hold for the rest of a job. */
export type InForce = {
/** Highest cutting speed. */
cutMmS: MmPerS,
/** Plunging speed. */
plungeMmS: MmPerS,
/** The tool rises in pauses. */
raise: boolean, };

/** A run that was cut short or given up, and can be taken up where it was. */
export type Interrupted = {
/** The part file. */
file: string,
/** The text of a part file: SHA-256, in hexadecimal digits. Nothing of a job. */
hash: string | null,
/** The line of the last move that was made, or the path of a job; 0 before the first. */
line: number,
/** Which run it was and where it ended, in a sentence. */
text: string,
/** The operator stopped it; else Kerf was killed or the power failed. */
stopped: boolean,
/** The machine moved when Kerf ended: it is not sure to be where it is believed to be. */
moved: boolean, };

/** All inputs and outputs. */
export type Io = {
/** Inputs 1 … 12. */
inputs: Array<Lamp>,
/** Outputs 1 … 12. */
outputs: Array<Lamp>,
/** The ports of the card. */
ports: Ports,
/** The mend that is needed before anything moves, while a pressed stop forbids motion. */
forbidden: string | null, };

/** Choices of the person who starts a job. Its file stays as it is. */
export type JobChoice = {
/** The path with which it begins, counted from 1 in cutting order; that of the file for nothing. */
start: number | null,
/** Distance beside itself at which every path is cut, mm, to the right of travel. */
offset: Mm,
/** Place of its origin on the table, X and Y from home, mm; that of the file for nothing. */
origin: [Mm, Mm] | null,
/** Place to which the head goes at the end, X and Y from the origin, mm; that of the file for nothing. */
finish: [Mm, Mm] | null,
/** Height that the paths with heights of their own are raised above those of the file, mm. */
lift: Mm, };

/** One path of a job. */
export type JobPath = {
/** It is followed and not cut. */
traversal: boolean,
/** The tool that cuts it. */
tool: number,
/** Number of the shape, from 1. */
number: number,
/** Its group: black, blue, green, cyan, red, magenta, brown, white. */
group: string,
/** Its end is its start. */
closed: boolean,
/** Three numbers a vertex: X, Y and the bulge of the segment behind it, the tangent of a quarter of the angle of an arc, positive counter-clockwise; 0 is a line. */
points: Array<number>,
/** Height of each vertex, for a 3D shape. */
z: Array<number> | null,
/** The machine halts before it. */
pause: boolean, };

/** A job, to be looked at and started. */
export type JobView = {
/** The hash by which it is run. */
hash: string,
/** Its paths in cutting order, arrays laid out, mm from the origin. */
paths: Array<JobPath>,
/** Place of the origin on the table, X and Y from home, mm. */
origin: [Mm, Mm],
/** Place to which the head goes at the end, X and Y from the origin, mm. */
finish: [Mm, Mm],
/** The path with which it begins, from 1. */
start: number,
/** Number of times that it is cut. */
repeats: number,
/** Cutting speed. */
cutMmS: MmPerS,
/** Plunging speed. */
plungeMmS: MmPerS,
/** Z of travel, of the surface of the material and of the lowest place of the tool: from home, mm. */
heights: [Mm, Mm, Mm],
/** The tool rises when the job is paused. */
raise: boolean,
/** Reaches of X and Y, from home, mm. */
table: [[Mm, Mm], [Mm, Mm]],
/** The origin becomes the present position at each start. */
originAtStart: boolean, };

/** An input or output. */
export type Lamp = {
/** Its number, from 1. */
number: number,
/** It is on. */
on: boolean,
/** Its purpose, when something is known. */
label: string,
/** Duty that is assigned to it, when it is an input. */
duty: Duty, };

/** The last run of a file, when it is over. */
export type LastRun = {
/** Word for its end, as [`CurrentRun`] has it. */
ended: string,
/** Time of its end: seconds since 1970. */
at: UnixSeconds,
/** The line of the last move; the path of a job. */
line: number,
/** Time that it took, seconds of whoever waited; 0 where it is not known. */
seconds: Seconds, };

/** The turn at driving, one at a time. Every command that moves the machine carries the number. */
export type Lease = {
/** Grows with every lease; a command with an old number is refused. */
number: number,
/** Number of the page or script that has it. */
client: number,
/** Name of the device. */
device: string, };

/** Severity of a finding. */
export type Level = "error" | "warning" | "note";

/** Kind of a line between Kerf and a controller. */
export type LineKind = "line" | "atOnce" | "ask" | "report" | "ok" | "error" | "alarm" | "message" | "welcome" | "link";

/** Part of the picture that pages are to have in sight. */
export type Look = "digitized" | "data" | "machine" | "out";

/** Part of the picture that pages were last told to have in sight. */
export type Looked = {
/** Grows with each time. */
number: number,
/** That part. */
at: Look, };

/** The state of the machine. */
export type Machine = {
/** Its activity. */
state: State,
/** Effect of running a file. */
mode: Mode,
/** It may be moved: not after a start, a lost link, an alarm, until somebody arms it. */
armed: boolean,
/** Reason why it is disarmed, held or in alarm, for a person. */
why: string | null,
/** Its controller has begun a change of tools and waits for the tool. */
wantsTool: boolean,
/** It touches that tool off by itself when it is asked to. */
touchesOff: boolean,
/** Its name. */
name: string,
/** Acts that a page may do to it beside moving it. */
offers: Offers,
/** The factor that runs on it have shown, by which the time of files is told; nothing before the first. */
pace: Pace | null, };

/** A line of the message area. */
export type Message = {
/** Its sort. */
tone: Tone,
/** Code of a finding, by which a page tells it in another language; empty where it is none. */
code: string,
/** The text, which does not repeat the place. */
text: string,
/** A way to mend it; empty where none is told. */
hint: string,
/** The run it belongs to; 0 when to none. */
run: number,
/** The place in a file that it is about, with the line that stands there; nothing where it is about none. */
place: Call | null, };

/** Effect of running a file. */
export type Mode = "preview" | "simulated" | "cut";

/** Position and motion of the machine. Sent about 30 times a second while it moves. */
export type Motion = {
/** Positions of the axes. */
at: Positions,
/** Speed along the path. */
speedMmS: MmPerS,
/** Machine time since the run began, seconds. */
t: Seconds,
/** It is a cut; a jog otherwise. */
cutting: boolean,
/** Line of the part file that makes the move; 0 when none does. */
line: number,
/** Moves of the job made so far: segments of the preview before this are done. */
made: number,
/** Progress of the job, 0 … 1 of its planned time. */
progress: number,
/** Planned time that is left at the present override, seconds of whoever waits: a simulated machine may be faster. */
remaining: Seconds,
/** Time of the run so far, seconds of whoever waits: with the planned time of what was made before it was taken up. */
elapsed: Seconds, };

/** A variable. */
export type NamedValue = {
/** Its name with `&` or `$`. */
name: string,
/** Its value. */
value: string, };

/** A tool that is known by its number. */
export type NumberedTool = {
/** Its number, from 1. */
number: number,
/** Its name; empty where it has none. */
name: string,
/** Diameter of its cutter; 0 where it is not known. */
diameter: Mm,
/** Its length: of one that was measured, the height of the table base at which it touched the sensor. */
length: Mm,
/** Its length was measured at the sensor of the machine: Z zero goes with it. */
measured: boolean, };

/** Acts that a page may do to a machine beside moving it, as the machine itself tells. */
export type Offers = {
/** Its switches are moved on a page. */
inputs: boolean,
/** The bits of its card are switched one at a time, and its motors stepped once. */
card: boolean,
/** Start arms it: nobody is hurt by what it does. */
startArms: boolean, };

export type OpNew = { "op": "new" };

export type OpOpen = { "op": "open",
/** Its name below the part folder. */
name: string, };

export type OpSave = { "op": "save",
/** Its name below the part folder: `.rsg`, `.dxf` or `.svg`; `.rsm` for tool paths that were opened. */
name: string,
/** The hash of the file that may be replaced; `*` for any. The file that was opened or saved last needs none while it is as it was. */
replaces: string | null, };

export type OpDo = { "op": "do",
/** The clauses. */
clauses: string, };

export type OpUndo = { "op": "undo" };

export type OpRedo = { "op": "redo" };

export type OpFinish = { "op": "finish",
/** Mm from the origin. */
at: [Mm, Mm], };

export type OpProgram = { "op": "program",
/** Name of the program below the part folder: `.sbp` or `.nc`. */
name: string,
/** The hash of the file that may be replaced; `*` for any. */
replaces: string | null, };

/** A change of the drawing. */
export type Op =
  | OpNew
  | OpOpen
  | OpSave
  | OpDo
  | OpUndo
  | OpRedo
  | OpFinish
  | OpProgram;

/** The file that is open, to be looked at and run. */
export type Opened = {
/** Its name below the part folder. */
name: string,
/** Hash by which it is run, in hexadecimal digits: SHA-256 of its bytes; of more, where its parameters are others than the usual, or when the preview is ready and knows the program files that it calls. */
hash: string,
/** SHA-256 of its bytes alone. */
content: string,
/** Sort of file. */
kind: FileKind,
/** Parameters with which it is run, when it is a part program. */
parameters: FileParameters,
/** Choices with which it is cut, when it is a job. */
choice: JobChoice,
/** The origin of a job on the table, X and Y from home, mm; nothing of other files. */
origin: [Mm, Mm] | null,
/** Shapes that were added to a job since it was saved. */
added: number,
/** Lines; paths of a job. */
lines: number,
/** The words of its head about the job; the comments of a drawing that became one. */
header: string | null,
/** The preview, which is made when it is opened. */
preview: PreviewState,
/** Planned time, seconds; 0 until the preview is there. */
seconds: Seconds,
/** Mistakes in it, and whatever else is worth knowing. */
findings: Array<Finding>,
/** The questions that it asked while it was previewed, with the sample answers that it got. */
samples: Array<SampleAnswer>,
/** It has mistakes that keep it from running: the first errors of the findings. */
broken: boolean,
/** Its last run since Kerf began, as the file is now; nothing where it has not run. */
ran: LastRun | null,
/** The picture was cleared (SP given in preview): it is empty until the file is drawn again. */
cleared: boolean, };

/** An operation. */
export type OperationEntry = {
/** Its first word. */
name: string,
/** Description of its effect. */
doc: string,
/** The ways to say it. */
variants: Array<OperationVariant>, };

/** A part of what is said. */
export type OperationPart = {
/** Text before the value: `about `, `tool=`; alone it is a word that is always said. */
lead: string,
/** Value that is entered; nothing for a word alone. */
value: OperationValue | null,
/** It may be left out. */
optional: boolean,
/** It may be said several times. */
repeats: boolean, };

export type OperationValuePair = { "is": "pair" };

export type OperationValueVertex = { "is": "vertex" };

export type OperationValueTriple = { "is": "triple" };

export type OperationValueLength = { "is": "length",
/** Its name in the table: `RADIUS`, `D`. */
name: string, };

export type OperationValueNumber = { "is": "number",
/** Its name in the table: `ANGLE`, `FACTOR`. */
name: string, };

export type OperationValueArc = { "is": "arc" };

export type OperationValueGrid = { "is": "grid" };

export type OperationValueShape = { "is": "shape" };

export type OperationValueShapes = { "is": "shapes" };

export type OperationValueGroup = { "is": "group" };

export type OperationValueGroups = { "is": "groups" };

export type OperationValueWords = { "is": "words",
/** The words. */
words: Array<string>, };

export type OperationValueWordsOr = { "is": "wordsOr",
/** The words. */
words: Array<string>,
/** The number is a length. */
length: boolean, };

export type OperationValueFile = { "is": "file" };

export type OperationValueText = { "is": "text" };

/** Kind of value that is entered for a part. */
export type OperationValue =
  | OperationValuePair
  | OperationValueVertex
  | OperationValueTriple
  | OperationValueLength
  | OperationValueNumber
  | OperationValueArc
  | OperationValueGrid
  | OperationValueShape
  | OperationValueShapes
  | OperationValueGroup
  | OperationValueGroups
  | OperationValueWords
  | OperationValueWordsOr
  | OperationValueFile
  | OperationValueText;

/** One way to say an operation: its parts in order, after the name. */
export type OperationVariant = {
/** As it is written. */
form: string,
/** Its parts, in order. */
parts: Array<OperationPart>, };

/** The operator's overrides. */
export type Overrides = {
/** Cuts run at so much of the speed asked for, 10 … 200. */
feedPercent: number,
/** Rapid moves run at so much of their speed, up to 100; nothing where the machine does not override them by itself. */
rapidPercent: number | null,
/** The spindle turns at so much of the speed asked for, 10 … 200; nothing where the machine does not override it. */
spindlePercent: number | null, };

/** A factor by which the motion of runs takes longer than the planner of the controller says. */
export type Pace = {
/** The factor. */
factor: number,
/** Runs that it was learned from. */
runs: number, };

/** A parameter. */
export type Parameter = {
/** Its name. */
name: string,
/** Kind of value that may be written. */
kind: ParameterKind,
/** `in`, `mm`, `in/s`, `deg` … or nothing. */
unit: string,
/** It has to be given. */
required: boolean,
/** Value that counts when it is left blank, as it would be written; nothing when the present value stays. */
default: string | null,
/** The present value, for one that shows a setting. */
present: string | null,
/** The values it accepts, in words; empty for any. */
bound: string,
/** Least value, included. */
least: number | null,
/** Greatest value, included. */
most: number | null,
/** Its purpose. */
doc: string, };

export type ParameterKindNumber = { "is": "number" };

export type ParameterKindWhole = { "is": "whole" };

export type ParameterKindChoice = { "is": "choice",
/** As they are written. */
words: Array<string>, };

export type ParameterKindNumberOrOff = { "is": "numberOrOff" };

export type ParameterKindText = { "is": "text" };

export type ParameterKindFile = { "is": "file" };

export type ParameterKindAxis = { "is": "axis" };

export type ParameterKindObsolete = { "is": "obsolete" };

/** Kind of value that may be written for a parameter. */
export type ParameterKind =
  | ParameterKindNumber
  | ParameterKindWhole
  | ParameterKindChoice
  | ParameterKindNumberOrOff
  | ParameterKindText
  | ParameterKindFile
  | ParameterKindAxis
  | ParameterKindObsolete;

/** A pause of so many seconds, while it lasts. */
export type Pause = {
/** The comment of the program right above it; empty where there is none. */
text: string,
/** Machine time since the run began at which it is over, seconds. */
until: Seconds, };

/** One bit of a port. */
export type PortBit = {
/** An output; an input otherwise. */
output: boolean,
/** The letter of its port. */
port: string,
/** Its place, 0 … 7. */
place: number,
/** Its name on this machine. */
name: string,
/** Its purpose. */
about: string, };

/** The ports of the card, a byte each. */
export type Ports = {
/** Input ports A and B. */
inputs: [number, number],
/** Output ports A, B and C. The step bit of a motor is on while it steps. */
outputs: [number, number, number], };

/** A place in every frame: mm or degrees, X Y Z A B C. */
export type Positions = {
/** Working location: what the location display shows. */
working: AxisPlace,
/** Table base coordinates. */
base: AxisPlace,
/** The machine's own frame, in which previews are drawn. */
machine: AxisPlace, };

/** Facts that a page knows before it asks for pieces. */
export type PreviewInfo = {
/** Origin of the vertices: mm, machine frame. */
origin: [Mm, Mm, Mm],
/** Place that the working zero had: mm, machine frame. */
zero: [Mm, Mm, Mm],
/** Corner of the table with the least X and Y: mm, machine frame. */
table: [Mm, Mm],
/** Size of the table, mm. */
tableSize: [Mm, Mm],
/** Distance of the lines of the grid, mm. */
grid: Mm,
/** Bounds of the cuts: least and greatest corner, mm, machine frame. */
bounds: [[Mm, Mm, Mm], [Mm, Mm, Mm]] | null,
/** Diameter of the cutter, mm. */
cutter: Mm,
/** Planned time, seconds. */
seconds: Seconds,
/** Length of the cuts, mm. */
cut: Mm,
/** Length of the jogs, mm. */
jog: Mm,
/** Moves. */
moves: number,
/** An axis turns the work about X: the key with `~rotary` behind it gives the path where it lies on the work. */
rotary: boolean,
/** From all of it to the coarsest. */
details: Array<Detail>,
/** The tool paths that the program names. */
toolpaths: Array<ToolPathInfo>, };

export type PreviewStateWorking = { "state": "working" };

export type PreviewStateReady = { "state": "ready",
/** Changes whenever the preview does. */
key: string, };

export type PreviewStateFailed = { "state": "failed",
/** Reason of the failure. */
why: string, };

/** State of a preview. */
export type PreviewState =
  | PreviewStateWorking
  | PreviewStateReady
  | PreviewStateFailed;

/** Reason why something was not done. */
export type Problem = {
/** The sort of reason, for programs. */
why: Why,
/** The reason and what helps, for people. */
text: string, };

/** Commands that were typed, and can be run again. */
export type Recorder = {
/** Typed commands are recorded (RA, RI). */
on: boolean,
/** The lines, oldest first. */
lines: Array<string>, };

/** The answer to a request. */
export type Reply = {
/** Of the request. */
id: number,
/** Reason why nothing was done; nothing when it was. */
problem: Problem | null,
/** Notes on an act that was done all the same: warnings of a drawing operation. */
notes: Array<string>,
/** The server's clock when it answered a ping, ms since it began. */
clockMs?: number, };

/** A request: one JSON text a message. */
export type Request = {
/** Comes back in the reply. A page counts. */
id: number,
/** The act that is to be done. */
act: Act, };

/** Rights of a device. Each role may do what those before it may. */
export type Role = "observer" | "operator" | "setter" | "owner";

/** A run of a file. */
export type RunRecord = {
/** Its name below the part folder. */
file: string,
/** Time of its beginning: seconds since 1970. */
begun: UnixSeconds,
/** Time that it took, seconds of whoever waited; 0 while it runs, or where it was cut short. */
seconds: Seconds,
/** Word for its end, as that of a job, or `cut short` where Kerf ended first; nothing while it runs. */
ended: string | null,
/** The line of the last move; the path of a job. */
line: number,
/** Name of the device of whoever drove; empty for a page on the machine itself. */
by: string, };

/** A question that a program asked while it was previewed, with its sample answer. */
export type SampleAnswer = {
/** The line that asks. */
line: number,
/** The text of the question. */
text: string,
/** The words on its buttons; none where a value is entered. */
buttons: Array<string>,
/** The answer that it got: empty where a value counts as 0. */
answer: string,
/** The file of answers beside the program says so. */
given: boolean, };

/** A machine with an owner, a journal and a page of its own, beside others of the same server. */
export type ServedMachine = {
/** Its name, as the command line has it. */
name: string,
/** The port of its page, at the same host. */
port: number,
/** It is the machine that tells this. */
here: boolean, };

/** Settings that belong together. */
export type SettingArea = {
/** Its name, as people say it. */
title: string,
/** Manual and section that tell of it. */
manual: string,
/** Its settings. */
settings: Array<SettingEntry>, };

/** A change of a setting that holds. */
export type SettingChange = {
/** Seconds since 1970, UTC. */
at: UnixSeconds,
/** The setting: `homing.x.fast_mm_s`. */
key: string,
/** Its value before, as it is written. */
from: string,
/** Its value since, as it is written. */
to: string,
/** Name of the device of whoever changed it; empty for a page on the machine itself. */
by: string,
/** The typed line, or the part file, that changed it; empty where a form did. */
through: string, };

/** A setting of the machine. */
export type SettingEntry = {
/** Its name, dotted: `homing.x.fast_mm_s`. */
key: string,
/** Kind of value that may be written. */
kind: SettingKind,
/** `mm`, `s`, `%` … or nothing. */
unit: string,
/** Bounds of its values beside their kind, in words; empty for anything of that kind. */
bound: string,
/** Least value, included. */
least: number | null,
/** Greatest value, included. */
most: number | null,
/** Its value in a new configuration, as it is written. */
default: string,
/** Its present value, as it is written. */
value: string,
/** Its purpose. */
doc: string, };

export type SettingKindFlag = { "is": "flag" };

export type SettingKindNumber = { "is": "number",
/** The setting may be absent. */
none: boolean, };

export type SettingKindChoice = { "is": "choice",
/** As they are written. */
words: Array<string>, };

export type SettingKindText = { "is": "text" };

export type SettingKindList = { "is": "list",
/** Number of values. */
length: number,
/** The setting may be absent. */
none: boolean, };

/** Kind of value that may be written for a setting. */
export type SettingKind =
  | SettingKindFlag
  | SettingKindNumber
  | SettingKindChoice
  | SettingKindText
  | SettingKindList;

/** Settings of the machine's configuration that pages show or follow, and which axes were homed. Mm. */
export type Setup = {
/** The special positions of Z, from its home. */
heights: ZHeights,
/** Reaches of X and Y from their home; 0 is without bounds. */
reach: [Mm, Mm],
/** Changing settings asks for a password. */
protected: boolean,
/** Outputs stay on when a machine that stands is stopped, disarmed or left. */
outputsStayOn: boolean,
/** A click selects what lies so near, pixels. */
pickRadius: number,
/** So much larger than what is drawn is the window that shows all of it, percent. */
windowExpansion: number,
/** Letters of the axes that were homed. */
homed: string,
/** Letters of the axes that have a home switch and were not homed: places on them are counted from where the machine was switched on. */
notHomed: string, };

/** The shapes of a drawing. */
export type ShapeList = {
/** The revision of the drawing. */
revision: number,
/** In the order in which they are cut. */
shapes: Array<ShapePath>, };

/** A path of lines and arcs, mm. */
export type ShapePath = {
/** Number of the shape, from 1. */
number: number,
/** Its group: black, blue, green, cyan, red, magenta, brown, white. */
group: string,
/** Its end is its start. */
closed: boolean,
/** Three numbers a vertex: X, Y and the bulge of the segment behind it, the tangent of a quarter of the angle of an arc, positive counter-clockwise; 0 is a line. */
points: Array<number>,
/** Height of each vertex, for a 3D shape. */
z: Array<number> | null,
/** The machine halts before it. */
pause: boolean, };

/** Everything a page shows, at one moment. */
export type Snapshot = {
/** Version of the messages. */
version: number,
/** Version of Kerf. */
kerf: string,
/** Grows with every change: whoever follows sees whether he has heard them all. */
revision: number,
/** The port of STOP's own way, beside that of the console; 0 where there is none. */
stopPort: number,
/** Only drawings are worked on here. */
drawingOnly: boolean,
/** The machine. */
machine: Machine,
/** Its position and motion. */
motion: Motion,
/** Units in which a person reads lengths. */
units: Units,
/** Settings of the machine, as far as drawings are worked on with it. */
setup: Setup,
/** Speeds in force. */
speeds: Speeds,
/** Inputs and outputs. */
io: Io,
/** The file that is open. */
opened: Opened | null,
/** The run that is under way, or the last one. */
job: CurrentRun | null,
/** The path of what was typed. */
typed: TypedPath,
/** The machines that are served together, this one among them; none where it is alone. */
together: Array<ServedMachine>,
/** A run that can be taken up where it was cut short. */
interrupted: Interrupted | null,
/** Settings with which Kerf was started, where a start-up line says what pages show. */
start: StartUp | null,
/** The question that is open. */
asked: Asked | null,
/** The pause of so many seconds that is under way. */
pause: Pause | null,
/** The sound that was started last. */
sound: Sound | null,
/** The operator's overrides. */
overrides: Overrides,
/** Zero points that the controller keeps; none of a machine without one. */
zeros: Array<Zero>,
/** Steps of a millimetre that the controller keeps, of each axis; none of a machine whose settings have them. */
controllerSteps: Array<number>,
/** Settings that the controller keeps by number, in their order; none of a machine without such. */
controllerSettings: Array<ControllerSetting>,
/** The card of the controller, whose files it runs by itself. */
controllerCard: ControllerCard,
/** The tools by their numbers. */
tools: ToolTable,
/** The height map that programs follow; nothing where surfaces are flat. */
heightMap: HeightMap | null,
/** A board that is being wired, or was wired last. */
wiring: Wiring | null,
/** The print window, oldest line first. */
printed: Array<string>,
/** Messages, oldest first. */
messages: Array<Message>,
/** The turn at driving that goes on. */
lease: Lease | null,
/** Connected pages. */
clients: Array<Client>,
/** The drawing that is open. */
drawing: DrawingState | null,
/** Grows when files of the part folder change. */
files: number,
/** The folder that part files are chosen from. */
folder: Folder,
/** Commands that were typed. */
recorder: Recorder,
/** Variables that are shown while programs run, as far as they have values. */
watched: Array<NamedValue>,
/** Grows when the machine's configuration changes. */
settings: number,
/** The screen of the hand console. */
handConsole: HandConsole,
/** The points that are being digitized; nothing while none are. */
digitized: Digitized | null,
/** Part of the picture that pages were last told to have in sight. */
looked: Looked | null, };

/** A board that is sold, whose pins are known. */
export type SoldBoard = {
/** Its name in Kerf, as skr-pico. */
name: string,
/** Its maker's name for it. */
title: string, };

/** A sound that a program started (PLAY). */
export type Sound = {
/** Sounds are counted: each is heard once. */
number: number,
/** Name by which it is fetched, below `/api/media/`. */
name: string, };

/** Speeds; of axes that turn, degrees a second. */
export type Speeds = {
/** Cutting: X and Y together, then Z, A, B, C. */
cutMmS: AxisSpeeds,
/** Jogging. */
jogMmS: AxisSpeeds,
/** Spindle, revolutions a minute. */
rpm: number, };

/** Settings of a start-up line for pages (programming handbook, Command Line Options). */
export type StartUp = {
/** The part file, as the FP sheet names it. */
file: string,
/** The FP sheet opens on it, and nothing moves before OK. */
sheet: boolean,
/** 0 as last used, 1 with menus and the command line, 2 without, 9 files only: no commands, no keypad. */
display: number, };

/** Activity of the machine. */
export type State = "idle" | "running" | "jogging" | "held" | "asking" | "stopped" | "alarm";

/** A system variable and its value. */
export type SystemValue = {
/** The number in its brackets. */
number: number,
/** Meaning of its value. */
name: string,
/** Its unit; empty for none. */
unit: string,
/** Its value. */
value: string, };

/** Text of the editor that is not saved. */
export type TextDraft = {
/** The file below the part folder that it is of; empty for a new one. */
name: string,
/** The text; its lines end with a line feed. Empty where its edits tell it. */
text: string,
/** The changes to the file as it was read, in order of lines; nothing where the text is told as a whole. */
edits: Array<TextEdit> | null,
/** Line ending of the file. */
ends: string,
/** SHA-256 of the file as it was read; empty for a new one. */
base: string,
/** The file is another by now. */
changedOnDisk: boolean,
/** The page that typed it, by a name that it gives itself. */
page: string,
/** Which text it is; of one that is to be kept, the draft from which the page went on. Empty for none. */
revision: string, };

/** Lines of a text, and those that stand in their place. */
export type TextEdit = {
/** The first line that is another, from 1. */
line: number,
/** Lines that are others. */
count: number,
/** The lines that stand there now. */
lines: Array<string>, };

/** Inputs and outputs of a run on the simulated machine, beside its motion. */
export type Timing = {
/** Its end, seconds of machine time. */
seconds: Seconds,
/** It holds all of a run that came to its end. */
whole: boolean,
/** It ends before the run because that has more edges than a chart holds. */
full: boolean,
/** Word for the end of the run: `ok`, `ended`, `failed`, `stopped`, `limit`. */
status: string,
/** Reason why the run ended before its end. */
finding: Finding | null,
/** Its lines, from above. */
lines: Array<TimingLine>, };

/** Kind of a line of a timing chart. */
export type TimingKind = "axis" | "value" | "output" | "input";

/** A line of a timing chart. */
export type TimingLine = {
/** Kind of line. */
kind: TimingKind,
/** Its name. */
name: string,
/** Length of a grain, seconds. If it is not 0 the line has more points than a chart holds: of each grain, counted from 0, only the first, the least, the greatest and the last are here. */
grain: number,
/** Moments, seconds, and the value there. An axis goes evenly between them; a value or a bit is 0 before the first and keeps what it is to the next. */
points: Array<[number, number]>, };

/** A file that is to be run so many times. */
export type ToDo = {
/** Its name below the part folder. */
file: string,
/** Parts that are wanted, at least one. */
wanted: number,
/** Runs of it that came to their end since it stands here. */
made: number, };

export type ToPageSnapshot = { "tell": "snapshot",
/** The page: its number, role and device. */
who: Who,
/** Everything. */
snapshot: Snapshot, };

export type ToPageChanges = { "tell": "changes",
/** At least one. */
changes: Array<Change>, };

export type ToPageReply = { "tell": "reply" } & Reply;

/** A message over the socket to the page: one JSON text each. */
export type ToPage =
  | ToPageSnapshot
  | ToPageChanges
  | ToPageReply;

/** Sort of message. */
export type Tone = "note" | "program" | "warning" | "error";

export type ToolChangeIs = { "to": "is",
/** Its name; empty for none. */
name: string,
/** Diameter of its cutter; 0 where it is not known. */
diameter: Mm,
/** Its length. */
length: Mm, };

export type ToolChangeGone = { "to": "gone" };

export type ToolChangeIn = { "to": "in" };

/** A change of a tool. */
export type ToolChange =
  | ToolChangeIs
  | ToolChangeGone
  | ToolChangeIn;

/** A tool path that the program names. */
export type ToolPathInfo = {
/** Its name. */
name: string,
/** The tool. */
tool: string,
/** Planned time, seconds. */
seconds: Seconds,
/** Its first move. */
firstMove: number, };

/** Tool paths that a drawing becomes when it is machined. */
export type ToolPaths = {
/** The revision of the drawing. */
revision: number,
/** The paths, in the order in which they are cut, arrays laid out. */
paths: Array<CutShape>,
/** Shapes whose short lines become curves, as those are machined. */
smoothed: Array<ShapePath>,
/** Vertices that are left out because they lie too near to the one before: X and Y by turns. */
filtered: Array<number>,
/** Notes from their making, or the reason why there are none. */
notes: Array<string>, };

/** All tools that are known. */
export type ToolTable = {
/** The tools, in order of their numbers. */
tools: Array<NumberedTool>,
/** Number of the one in the spindle; 0 for none that is known. */
inSpindle: number,
/** The machine has a sensor that measures tools. */
hasSensor: boolean,
/** The machine finds home: a length that was measured holds for good. */
findsHome: boolean, };

/** The path of what was typed, so far. */
export type TypedPath = {
/** Changes when it begins anew. */
key: number,
/** Number of its segments, which can be asked for as `/api/typed/KEY/FROM`. */
segments: number, };

/** Units in which a person reads lengths. */
export type Units = {
/** `in` or `mm`. */
linear: string,
/** Millimetres in one of them. */
mm: UnitSize,
/** Each axis. */
axes: Array<AxisUnits>,
/** The numbers of moves are places (SA); distances otherwise (SR). */
absolute: boolean, };

/** Values that the machine remembers, to be looked at. */
export type Values = {
/** System variables, by number. */
system: Array<SystemValue>,
/** User variables, by name. */
variables: Array<NamedValue>,
/** The lines of OpenSBP that set what is set now. */
settings: Array<string>,
/** Facts that help to find a fault (UD): versions, places, switches, the last error. */
diagnostics: Array<NamedValue>,
/** The folder of part files and which of them lists show (FS). */
folder: Folder,
/** The part file that ran last: its name below the part folder; empty before the first. */
partFile: string,
/** The folder of part files from the root on. */
parts: string,
/** The folder of settings and logs. */
data: string, };

/** Identity of a page. */
export type Who = {
/** Its number, as long as it is connected. */
client: number,
/** Its role. */
role: Role,
/** Name of the device; empty for a page on the machine itself. */
device: string, };

/** The sort of reason. */
export type Why = "malformed" | "role" | "password" | "lease" | "disarmed" | "state" | "file" | "changed" | "replaces" | "mistake" | "late" | "server" | "full";

/** A switch of a board that is being wired, as it is now. */
export type WiredSwitch = {
/** The letter of the axis whose home switch it is (X2 that of its second motor), or the number of an input. */
about: string,
/** Its pin with its signs, as the machine's file has it. */
pin: string,
/** It is pressed. */
on: boolean, };

/** The question of the wizard that is open, or its end. */
export type Wiring = {
/** A board is being wired. */
isOpen: boolean,
/** Ports are being looked at for boards. */
isLooking: boolean,
/** Ports that were looked at, while none is being wired. */
found: Array<FoundPort>,
/** Switches of the board as they are now, once it is configured and while a question is open. */
switches: Array<WiredSwitch>,
/** Number of the question: an answer to an older one is refused. */
question: number,
/** The step whose words a page has: `motor`, `went` and so on. Nothing while the machine is at work, and at the end. */
step: string | null,
/** Subject: the letter of an axis or a motor, the number of an output. */
about: string,
/** The value that holds, or that was tried. */
value: string,
/** Sentences that were told since the question before. */
told: Array<string>,
/** It is over: a sentence about what came of it. */
ended: string | null, };

/** Heights at which a job is cut. */
export type ZHeights = {
/** Height at which the tool travels. */
top: Mm,
/** The surface of the material. */
surface: Mm,
/** The lowest the tool may go; where THRU cuts. */
bottom: Mm, };

/** A zero point that the controller of the machine keeps. */
export type Zero = {
/** Its name, as G54; G92 is a shift of all others, TLO the length of the tool, which shifts them too. */
name: string,
/** Its place, the machine's own frame; of a shift, its way. */
at: AxisPlace,
/** It is the one that holds; a shift always does. */
holds: boolean, };

export type ZeroChangeReads = { "to": "reads",
/** The numbers. */
values: AxisGoal, };

export type ZeroChangeLies = { "to": "lies",
/** The place, the machine's own frame. */
at: AxisGoal, };

export type ZeroChangeHolds = { "to": "holds" };

export type ZeroChangeGone = { "to": "gone" };

/** A change of a zero point that the controller keeps. Axes without a number stay. */
export type ZeroChange =
  | ZeroChangeReads
  | ZeroChangeLies
  | ZeroChangeHolds
  | ZeroChangeGone;
