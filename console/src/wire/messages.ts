// Made from crates/wire by `cargo xtask wire`; changes are lost.

/** What is to be done. Those that move the machine carry the number of the lease. */
export type Act = { "do": "stop" } | { "do": "hold" } | { "do": "resume",
/** Number of the lease. */
lease: number, } | { "do": "answer",
/** Which question. */
question: number,
/** The word of a button, or what was entered. */
answer: string, } | { "do": "takeLease",
/** Takes it from whoever has it; not while the machine moves by a jog. */
force: boolean, } | { "do": "giveLease",
/** Number of the lease. */
lease: number, } | { "do": "arm",
/** Number of the lease. */
lease: number, } | { "do": "disarm" } | { "do": "giveUp" } | { "do": "open",
/** Its name below the part folder. */
name: string,
/** How it is run. */
parameters?: FileParameters, } | { "do": "parameters",
/** How it is run. */
parameters: FileParameters, } | { "do": "choose",
/** How it is cut. */
choice: JobChoice, } | { "do": "keepOrigin" } | { "do": "saveJob" } | { "do": "takeShapeBack" } | { "do": "machine",
/** The drawing, a file of the part folder; nothing for the one that is drawn. */
drawing: string | null,
/** Also where the paths of that job were changed by hand, which is lost then. */
anew: boolean, } | { "do": "folder",
/** Below the part folder that the server was given, which an empty name means. */
name: string,
/** As `*.sb?`; nothing keeps what is shown. */
mask: string | null, } | { "do": "close" } | { "do": "run",
/** Number of the lease. */
lease: number,
/** Its hash: what was previewed is what runs, with the parameters of then. */
hash: string,
/** Go through it line by line. */
step: boolean, } | { "do": "takeUp",
/** Number of the lease. */
lease: number, } | { "do": "command",
/** Number of the lease. */
lease: number,
/** The line; several are a program. */
line: string, } | { "do": "record",
/** A command of OpenSBP. */
line: string, } | { "do": "watch",
/** Names with `&`, `$` or `#`; 50 at most. */
names: Array<string>, } | { "do": "input",
/** Number of the lease. */
lease: number,
/** Which input, from 1. */
number: number,
/** Whether its contact is closed. */
on: boolean, } | { "do": "set",
/** Number of the lease. */
lease: number,
/** Its key. */
key: string,
/** Its value, as it is written in a configuration. */
value: string, } | { "do": "jogStart",
/** Number of the lease. */
lease: number,
/** Grows with every jog of a page, by a million at most; one that comes behind its own stop is dropped. */
seq: number,
/** When the key was held for sure: the server's clock, which answers to pings tell, as the page reckons it now, ms. */
clockMs: number,
/** Direction of each axis: -1, 0, 1 or between. */
direction: [number, number, number, number, number, number],
/** Mm or degrees; motion ends there. Without it, at the table limits. */
distance: number | null,
/** Share of the jog speed, 0 … 1. */
speedShare: number, } | { "do": "jogRenew",
/** Number of the lease. */
lease: number,
/** Of the jog. */
seq: number,
/** As that of the start. */
clockMs: number, } | { "do": "lift",
/** Number of the lease. */
lease: number,
/** Number of the question. */
question: number, } | { "do": "jogStop",
/** Of the jog. */
seq: number, } | { "do": "key",
/** Number of the lease. */
lease: number,
/** As that of a jog. */
seq: number,
/** As that of a jog; without it the key counts as held when it arrives. */
clockMs?: number,
/** A digit, `-` the sign, carriage return for Enter, `F` File, `S` Start, `P` Stop, `U` Func. */
key: string, } | { "do": "nudge",
/** Number of the lease. */
lease: number,
/** Letter of the axis. */
axis: string,
/** How far. */
distance: number, } | { "do": "go",
/** Number of the lease. */
lease: number,
/** The kind of move and its goal. */
way: ByHand, } | { "do": "bit",
/** Number of the lease. */
lease: number,
/** Its name, or port and bit: tool2, B2. */
name: string,
/** On; off otherwise. */
on: boolean, } | { "do": "step",
/** Number of the lease. */
lease: number,
/** x, y, z, w, q or r. */
motor: string,
/** Forward; back otherwise. */
forward: boolean, } | { "do": "override",
/** Number of the lease. */
lease: number,
/** Of the speed asked for, 10 … 200. */
feedPercent: number, } | { "do": "sheetDone" } | { "do": "clearPrinted" } | { "do": "acknowledge" } | { "do": "draw",
/** What. */
op: Op, } | { "do": "unlock",
/** The password. */
password: string, } | { "do": "protect",
/** The password until now, where there is one. */
password: string | null,
/** The new one, twice; none takes the protection away. */
new: [string, string] | null, } | { "do": "ping" };

/** A level of arrays. Mm. */
export type ArrayState = {
/** `block` or `job`. */
level: string,
/** Rows, counted upwards, and columns, to the right. */
grid: [number, number],
/** Gaps between neighbouring columns and rows. */
gap: [number, number],
/** Distances from one to the next, in X and Y. */
pitch: [number, number],
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
/** What stands in the entry field. */
prefill: string,
/** Whether it has an entry field. */
entry: boolean,
/** 0 none, 16 critical, 32 question, 48 warning, 64 information. */
icon: number,
/** The file that is to be shown in the editor (FE): its name below the part folder, empty for a new one. Nothing for other questions. */
edits: string | null,
/** The file that asks. */
file: string,
/** Its line. */
line: number,
/** What the machine was doing. */
was: State, };

/** What a person reads an axis in. */
export type AxisUnits = {
/** Its letter. */
letter: string,
/** `in`, `mm` or `deg`. */
unit: string,
/** Internal units (mm or degrees) in one of them. */
scale: number,
/** Whether the machine has it. */
used: boolean, };

/** The smallest box round the shapes of a drawing, arcs counted exactly. */
export type Block = {
/** Least X and Y. */
min: [number, number],
/** Greatest X and Y. */
max: [number, number],
/** Least and greatest height of its 3D shapes; nothing without any. Flat shapes have no height. */
z: [number, number] | null, };

/** A move by hand of a machine that does nothing else. Mm, degrees. */
export type ByHand = { "to": "findHome",
/** Their letters, as `xy`; all that have a switch for nothing. */
axes: string | null, } | { "to": "home",
/** Their letters, as `xy`; all for nothing. */
axes: string | null, } | { "to": "origin" } | { "to": "finish" } | { "to": "place",
/** X and Y from the job origin, the others from home; or all from where the tool is. Axes without a value stay. */
place: [number | null, number | null, number | null, number | null, number | null, number | null],
/** From where the tool is. */
relative: boolean,
/** X and Y first, then the others; else all together. */
flat: boolean, } | { "to": "cutMove",
/** That place. */
at: [number, number],
/** Cuts on the way, as a job of one line. */
cut: boolean, };

/** A file that a run is in. */
export type Call = {
/** The file. */
file: string,
/** The line that is read next. */
line: number, };

/** One change of what a page shows: a section of the [`Snapshot`] as it is now, or what is added to one. */
export type Change = { "change": "machine", machine: Machine, } | { "change": "motion", motion: Motion, } | { "change": "units", units: Units, } | { "change": "setup", setup: Setup, } | { "change": "speeds", speeds: Speeds, } | { "change": "io", io: Io, } | { "change": "opened", opened: Opened | null, } | { "change": "job", job: Job | null, } | { "change": "typed", typed: TypedPath, } | { "change": "interrupted", interrupted: Interrupted | null, } | { "change": "asked", asked: Asked | null, } | { "change": "pause", pause: Pause | null, } | { "change": "sound", sound: Sound | null, } | { "change": "overrides", overrides: Overrides, } | { "change": "printed", lines: Array<string>, } | { "change": "clearPrinted" } | { "change": "messages", messages: Array<Message>, } | { "change": "start", start: StartUp | null, } | { "change": "lease", lease: Lease | null, } | { "change": "clients", clients: Array<Client>, } | { "change": "drawing", drawing: DrawingState | null, } | { "change": "files", files: number, } | { "change": "folder", folder: Folder, } | { "change": "recorder", recorder: Recorder, } | { "change": "watched", watched: Array<NamedValue>, } | { "change": "settings", settings: number, } | { "change": "handConsole", handConsole: HandConsole, } | { "change": "digitized", digitized: Digitized | null, } | { "change": "looked", looked: Looked | null, };

/** What a text that is being edited is like. */
export type Checked = {
/** What is wrong with it. */
findings: Array<Finding>, };

/** A page that is connected. */
export type Client = {
/** Its number. */
client: number,
/** What it may do. */
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
/** What it does. */
doc: string,
/** Whether it moves the machine. */
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
/** What it does. */
doc: string, };

/** Depth of a cut: `thru`, `3d`, or mm above the surface. */
export type CutHeight = string | number;

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
/** Whether its end is its start. */
closed: boolean,
/** Three numbers a vertex: X, Y and the bulge of the segment behind it, the tangent of a quarter of the angle of an arc, positive counter-clockwise; 0 is a line. */
points: Array<number>,
/** Height of each vertex, for a 3D shape. */
z: Array<number> | null,
/** Whether the machine halts before it. */
pause: boolean, };

/** The path at a level of detail. */
export type Detail = {
/** How far it is from the true path at most, mm. */
tolerance: number,
/** Segments. */
segments: number,
/** Pieces they come in. */
pieces: number, };

/** Points that are being digitized, and the segments through them. */
export type Digitized = {
/** The job origin, from which they count: X and Y from home, mm. */
origin: [number, number],
/** The points in order. */
points: Array<DigitizedPoint>,
/** The bulge of the segment behind each point but the last, from it to the next one. */
bulges: Array<number>,
/** Number of the current point, from 1; 0 without points. */
current: number,
/** Whether heights count. */
threeD: boolean,
/** Whether the next point is an arc point. */
nextArc: boolean,
/** There are points that no shape was saved of as they are. */
unsaved: boolean, };

/** A digitized point. */
export type DigitizedPoint = {
/** X and Y from the job origin, Z from home, mm. */
at: [number, number, number],
/** The arc from the point before to the point behind goes through it; else it ends a line. */
arc: boolean, };

/** What a page shows of the drawing. Its shapes come over HTTP: `/api/drawing/shapes`. */
export type DrawingState = {
/** The file it came from or was saved in last. */
name: string | null,
/** Grows with every change of the shapes. */
revision: number,
/** Its revision when it was opened or begun. */
begun: number,
/** How many shapes. */
shapes: number,
/** The shapes that operations act on: numbers from 1. */
selection: Array<number>,
/** The shapes that were picked to be sequenced, in that order: numbers from 1. */
picked: Array<number>,
/** Whether there is something to take back. */
canUndo: boolean,
/** Whether there is something to make again. */
canRedo: boolean,
/** Whether it differs from its file. */
changed: boolean,
/** How many shapes are on the clipboard. */
clipboard: number,
/** The eight groups and how their shapes are cut. */
groups: Array<GroupState>,
/** The basic block of data: bounds of the drawing before it is arrayed. Nothing without shapes. */
block: Block | null,
/** Where the head goes when its job is done, from the origin. */
finish: [number, number],
/** How near ends are joined when nothing else is said: as near as the last time. */
join: number,
/** The comments that are kept with it. */
comments: Array<string>,
/** Its two levels of repetition: blocks in a job, then jobs on the table. */
arrays: Array<ArrayState>,
/** What the last operation, or reading the file, had to tell. */
notes: Array<string>, };

/** What an input is assigned to (VN). */
export type Duty = "standard" | "limit" | "stop";

/** What a file is that would be replaced. */
export type FileAbout = {
/** Its name below the part folder. */
name: string,
/** What it is: `a part program of 412 lines`. */
what: string,
/** Bytes. */
bytes: number,
/** When it was changed: seconds since 1970. */
changed: number,
/** SHA-256 of its content, in hexadecimal digits: who saw it names it as what may be replaced. */
hash: string, };

/** A file of the part folder. */
export type FileInfo = {
/** Its name below the part folder, `/` between folders. */
name: string,
/** Whether it is a folder. */
folder: boolean,
/** Bytes. */
bytes: number,
/** When it was changed: seconds since 1970. */
changed: number,
/** What its head tells about the job. */
header: string | null,
/** Whether it is a part file: one that the mask of the part folder lets through, or G-code. */
part: boolean, };

/** What sort of file is open. */
export type FileKind = "program" | "job" | "drawing";

/** How a part file is run: the parameters of FP. */
export type FileParameters = {
/** Scales X, Y and Z. */
proportion: [number, number, number],
/** How often the file runs, at least once. */
repetitions: number,
/** 0: places as written. 1: the present place is X 0, Y 0, Z 0 of the file. 2: X 0, Y 0. */
offset: number,
/** How far Z moves before each repetition, mm. */
plunge: number,
/** Leave tabs on the last repetition. */
tabs: boolean,
/** Z moves to 0 before the first plunge. */
plungeFromZero: boolean, };

/** An earlier content of a file that Kerf wrote over. */
export type FileVersion = {
/** Grows with each save of the file, from 1. */
number: number,
/** The file had this content since then: seconds since 1970. */
changed: number,
/** Bytes. */
bytes: number, };

/** Something a person should know about a file. */
export type Finding = {
/** How bad. */
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
/** What is wrong. */
message: string,
/** How to mend it. */
hint: string, };

/** The folder that part files are chosen from. */
export type Folder = {
/** Its name below the folder that the server was given; empty for that itself. */
name: string,
/** Which files lists show: `*` any characters, `?` one. */
mask: string, };

/** How the shapes of a group are cut: what the operation `set` changes. Lengths in mm, angles in degrees. */
export type GroupState = {
/** Its colour. */
name: string,
/** Whether its shapes are cut. */
on: boolean,
/** Whether the head only follows them, to get round obstacles. */
traversal: boolean,
/** Cut on both sides of the shape. */
double: boolean,
/** The tool output, 1 … 3. */
tool: number,
/** The cut output, 1 … 3. */
cut: number,
/** Highest cutting speed; nothing is the machine's. */
speedMmMin: number | null,
/** Depth of the cut. */
height: CutHeight,
/** Depth of one pass. */
pass: number | null,
/** Z of each pass from the machine's home. None when each point of a shape has its own height, which counts from the surface. */
levels: Array<number>,
/** Distance of the path, right of travel. */
offset: number,
/** What the rough pass leaves. */
rough: number,
/** What is left out at the beginning. */
tag: number,
/** Radius and angle of the arc onto the path. */
leadIn: [number, number],
/** Radius and angle of the arc off the path. */
leadOut: [number, number], };

/** The screen of the hand console. */
export type HandConsole = {
/** Its lines, of 20 characters at most. */
lines: [string, string],
/** How often it has beeped. */
beeps: number,
/** Its serial link, in a sentence: the port it is at, or why it is not. Empty where there is none. */
link: string, };

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
/** What is told of it. */
doc: string, };

/** What is known of the word at a place. */
export type Hover = {
/** The text. */
text: string,
/** First column of the word, from 1. */
from: number,
/** The column behind it. */
to: number, };

/** What holds for the rest of a job. */
export type InForce = {
/** Highest cutting speed. */
cutMmS: number,
/** Plunging speed. */
plungeMmS: number,
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

/** What runs. */
export type Job = {
/** Number of the run since the server began. */
run: number,
/** The part file; empty for a command that somebody typed. */
file: string,
/** Its hash, when it is a file. */
hash: string | null,
/** The command line, when somebody typed it. */
command: string | null,
/** Planned time, seconds; 0 when it is not known. */
seconds: number,
/** VD without comments was carried out and nothing was printed since: the message screen is closed. */
silent: boolean,
/** The open files, outermost first, with the line that is read. */
calls: Array<Call>,
/** The file whose line the tool makes ([`Motion::line`](crate::Motion)): one of those, or one that is read to its end; empty before the first move. */
toolFile: string,
/** Where the tool travels, the surface of the material, the lowest the tool goes: Z from home, mm, as they are in force in a job. Pauses and height control change them. */
heights: [number, number, number] | null,
/** What a pause has changed for the rest of a job; nothing while it is as it was set. */
inForce: InForce | null,
/** How it ended: `ok`, `ended`, `failed`, `stopped`, `limit`; nothing while it runs. */
ended: string | null,
/** What ended it, when it was an error. */
error: Finding | null, };

/** What the person who starts a job decides about it. Its file stays as it is. */
export type JobChoice = {
/** The path with which it begins, counted from 1 in cutting order; that of the file for nothing. */
start: number | null,
/** How far beside itself every path is cut, mm, to the right of travel. */
offset: number,
/** Where its origin lies on the table, X and Y from home, mm; that of the file for nothing. */
origin: [number, number] | null,
/** Where the head goes at the end, X and Y from the origin, mm; that of the file for nothing. */
finish: [number, number] | null,
/** How much higher the paths with heights of their own lie than in the file, mm. */
lift: number, };

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
/** Whether its end is its start. */
closed: boolean,
/** Three numbers a vertex: X, Y and the bulge of the segment behind it, the tangent of a quarter of the angle of an arc, positive counter-clockwise; 0 is a line. */
points: Array<number>,
/** Height of each vertex, for a 3D shape. */
z: Array<number> | null,
/** Whether the machine halts before it. */
pause: boolean, };

/** A job, to be looked at and started. */
export type JobView = {
/** The hash by which it is run. */
hash: string,
/** Its paths in cutting order, arrays laid out, mm from the origin. */
paths: Array<JobPath>,
/** Where the origin lies on the table, X and Y from home, mm. */
origin: [number, number],
/** Where the head goes at the end, X and Y from the origin, mm. */
finish: [number, number],
/** The path with which it begins, from 1. */
start: number,
/** How often it is cut. */
repeats: number,
/** Cutting speed. */
cutMmS: number,
/** Plunging speed. */
plungeMmS: number,
/** Where the tool travels, the surface of the material, the lowest the tool goes: Z from home, mm. */
heights: [number, number, number],
/** Whether the tool rises when the job is paused. */
raise: boolean,
/** Reaches of X and Y, from home, mm. */
table: [[number, number], [number, number]],
/** The origin becomes the present position at each start. */
originAtStart: boolean, };

/** An input or output. */
export type Lamp = {
/** Its number, from 1. */
number: number,
/** Whether it is on. */
on: boolean,
/** What it is for, when something is known. */
label: string,
/** What it is assigned to, when it is an input. */
duty: Duty, };

/** The last run of a file, when it is over. */
export type LastRun = {
/** How it ended, as [`Job`] has it. */
ended: string,
/** When: seconds since 1970. */
at: number,
/** The line of the last move; the path of a job. */
line: number, };

/** Who drives: one at a time. Every command that moves the machine carries the number. */
export type Lease = {
/** Grows with every lease; a command with an old number is refused. */
number: number,
/** Who has it. */
client: number,
/** Name of the device. */
device: string, };

/** How bad a finding is. */
export type Level = "error" | "warning" | "note";

/** What pages are to have in sight. */
export type Look = "digitized" | "data" | "machine" | "out";

/** What pages were last told to have in sight. */
export type Looked = {
/** Grows with each time. */
number: number,
/** What. */
at: Look, };

/** The state of the machine. */
export type Machine = {
/** What it is doing. */
state: State,
/** What running a file means. */
mode: Mode,
/** Whether it may be moved: not after a start, a lost link, an alarm, until somebody arms it. */
armed: boolean,
/** Why it is disarmed, held or in alarm, for a person. */
why: string | null,
/** Its name. */
name: string, };

/** A line of the message area. */
export type Message = {
/** How it is meant. */
tone: Tone,
/** The text. */
text: string,
/** The run it belongs to; 0 when to none. */
run: number, };

/** What running a file means. */
export type Mode = "preview" | "simulated" | "cut";

/** Where the machine is. Sent about 25 times a second while it moves. */
export type Motion = {
/** Where the axes are. */
at: Positions,
/** Speed along the path. */
speedMmS: number,
/** Machine time since the run began, seconds. */
t: number,
/** Whether it is a cut; a jog otherwise. */
cutting: boolean,
/** Line of the part file that makes the move; 0 when none does. */
line: number,
/** Moves of the job made so far: segments of the preview before this are done. */
made: number,
/** How far the job is, 0 … 1 of its planned time. */
progress: number,
/** Planned time that is left at the present override, seconds of whoever waits: a simulated machine may be faster. */
remaining: number, };

/** A variable. */
export type NamedValue = {
/** Its name with `&` or `$`. */
name: string,
/** What it holds. */
value: string, };

/** A change of the drawing. */
export type Op = { "op": "new" } | { "op": "open",
/** Its name below the part folder. */
name: string, } | { "op": "save",
/** Its name below the part folder: `.rsg`, `.dxf` or `.svg`; `.rsm` for tool paths that were opened. */
name: string,
/** The hash of the file that may be replaced; `*` for any. The file that was opened or saved last needs none while it is as it was. */
replaces: string | null, } | { "op": "do",
/** The clauses. */
clauses: string, } | { "op": "undo" } | { "op": "redo" } | { "op": "finish",
/** Mm from the origin. */
at: [number, number], } | { "op": "program",
/** Name of the program below the part folder: `.sbp` or `.nc`. */
name: string,
/** The hash of the file that may be replaced; `*` for any. */
replaces: string | null, };

/** The file that is open, to be looked at and run. */
export type Opened = {
/** Its name below the part folder. */
name: string,
/** What it is run by, in hexadecimal digits: SHA-256 of its bytes; of more, where its parameters are others than the usual, or when the preview is ready and knows the program files that it calls. */
hash: string,
/** SHA-256 of its bytes alone. */
content: string,
/** What sort of file it is. */
kind: FileKind,
/** How it is run, when it is a part program. */
parameters: FileParameters,
/** How it is run, when it is a job. */
choice: JobChoice,
/** The origin of a job on the table, X and Y from home, mm; nothing of other files. */
origin: [number, number] | null,
/** Shapes that were added to a job since it was saved. */
added: number,
/** Lines; paths of a job. */
lines: number,
/** The words of its head about the job; the comments of a drawing that became one. */
header: string | null,
/** The preview, which is made when it is opened. */
preview: PreviewState,
/** Planned time, seconds; 0 until the preview is there. */
seconds: number,
/** What is wrong with it or worth knowing. */
findings: Array<Finding>,
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
/** What it does. */
doc: string,
/** The ways to say it. */
variants: Array<OperationVariant>, };

/** A part of what is said. */
export type OperationPart = {
/** What stands before the value: `about `, `tool=`; alone it is a word that is always said. */
lead: string,
/** What is entered; nothing for a word alone. */
value: OperationValue | null,
/** It may be left out. */
optional: boolean,
/** It may be said several times. */
repeats: boolean, };

/** What is entered for a part. */
export type OperationValue = { "is": "pair" } | { "is": "vertex" } | { "is": "triple" } | { "is": "length",
/** Its name in the table: `RADIUS`, `D`. */
name: string, } | { "is": "number",
/** Its name in the table: `ANGLE`, `FACTOR`. */
name: string, } | { "is": "arc" } | { "is": "grid" } | { "is": "shape" } | { "is": "shapes" } | { "is": "group" } | { "is": "groups" } | { "is": "words",
/** The words. */
words: Array<string>, } | { "is": "wordsOr",
/** The words. */
words: Array<string>,
/** Whether the number is a length. */
length: boolean, } | { "is": "file" } | { "is": "text" };

/** One way to say an operation: its parts in order, after the name. */
export type OperationVariant = {
/** As it is written. */
form: string,
/** What is said, in order. */
parts: Array<OperationPart>, };

/** The operator's overrides. */
export type Overrides = {
/** Cuts run at so much of the speed asked for, 10 … 200. */
feedPercent: number, };

/** A parameter. */
export type Parameter = {
/** Its name. */
name: string,
/** What may be written. */
kind: ParameterKind,
/** `in`, `mm`, `in/s`, `deg` … or nothing. */
unit: string,
/** Whether it has to be given. */
required: boolean,
/** What it means when left blank, as it would be written; nothing when the present value stays. */
default: string | null,
/** The present value, for one that shows a setting. */
present: string | null,
/** The values it accepts, in words; empty for any. */
bound: string,
/** Least value, included. */
least: number | null,
/** Greatest value, included. */
most: number | null,
/** What it is for. */
doc: string, };

/** What may be written for a parameter. */
export type ParameterKind = { "is": "number" } | { "is": "whole" } | { "is": "choice",
/** As they are written. */
words: Array<string>, } | { "is": "numberOrOff" } | { "is": "text" } | { "is": "file" } | { "is": "axis" } | { "is": "obsolete" };

/** A pause of so many seconds, while it lasts. */
export type Pause = {
/** The comment of the program right above it; empty where there is none. */
text: string,
/** Machine time since the run began at which it is over, seconds. */
until: number, };

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
/** What it is for. */
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
working: [number, number, number, number, number, number],
/** Table base coordinates. */
base: [number, number, number, number, number, number],
/** The machine's own frame, in which previews are drawn. */
machine: [number, number, number, number, number, number], };

/** What a page knows before it asks for pieces. */
export type PreviewInfo = {
/** What vertices are relative to: mm, machine frame. */
origin: [number, number, number],
/** Where the working zero was: mm, machine frame. */
zero: [number, number, number],
/** Corner of the table with the least X and Y: mm, machine frame. */
table: [number, number],
/** Size of the table, mm. */
tableSize: [number, number],
/** Distance of the lines of the grid, mm. */
grid: number,
/** Bounds of the cuts: least and greatest corner, mm, machine frame. */
bounds: [[number, number, number], [number, number, number]] | null,
/** Diameter of the cutter, mm. */
cutter: number,
/** Planned time, seconds. */
seconds: number,
/** Length of the cuts, mm. */
cut: number,
/** Length of the jogs, mm. */
jog: number,
/** Moves. */
moves: number,
/** An axis turns the work about X: the key with `~rotary` behind it gives the path where it lies on the work. */
rotary: boolean,
/** From all of it to the coarsest. */
details: Array<Detail>,
/** The tool paths that the program names. */
toolpaths: Array<ToolPathInfo>, };

/** Whether a preview is there. */
export type PreviewState = { "state": "working" } | { "state": "ready",
/** Changes whenever the preview does. */
key: string, } | { "state": "failed",
/** Why. */
why: string, };

/** Why something was not done. */
export type Problem = {
/** The sort of reason, for programs. */
why: Why,
/** The reason and what helps, for people. */
text: string, };

/** Commands that were typed, and can be run again. */
export type Recorder = {
/** Whether what is typed is recorded (RA, RI). */
on: boolean,
/** The lines, oldest first. */
lines: Array<string>, };

/** The answer to a request. */
export type Reply = {
/** Of the request. */
id: number,
/** Why nothing was done; nothing when it was. */
problem: Problem | null,
/** What was noticed although it was done: warnings of a drawing operation. */
notes: Array<string>,
/** The server's clock when it answered a ping, ms since it began. */
clockMs?: number, };

/** A request: one JSON text a message. */
export type Request = {
/** Comes back in the reply. A page counts. */
id: number,
/** What is to be done. */
act: Act, };

/** What a device may do. Each may do what those before it may. */
export type Role = "observer" | "operator" | "setter" | "owner";

/** Settings that belong together. */
export type SettingArea = {
/** Its name, as people say it. */
title: string,
/** Manual and section that tell of it. */
manual: string,
/** Its settings. */
settings: Array<SettingEntry>, };

/** A setting of the machine. */
export type SettingEntry = {
/** Its name, dotted: `homing.x.fast_mm_s`. */
key: string,
/** What may be written. */
kind: SettingKind,
/** `mm`, `s`, `%` … or nothing. */
unit: string,
/** What it accepts beside its kind, in words; empty for anything of that kind. */
bound: string,
/** Least value, included. */
least: number | null,
/** Greatest value, included. */
most: number | null,
/** What it is in a new configuration, as it is written. */
default: string,
/** What it is now, as it is written. */
value: string,
/** What it is for. */
doc: string, };

/** What may be written for a setting. */
export type SettingKind = { "is": "flag" } | { "is": "number",
/** The setting may be absent. */
none: boolean, } | { "is": "choice",
/** As they are written. */
words: Array<string>, } | { "is": "text" } | { "is": "list",
/** How many. */
length: number,
/** The setting may be absent. */
none: boolean, };

/** Settings of the machine's configuration that pages show or follow, and which axes were homed. Mm. */
export type Setup = {
/** The special positions of Z, from its home. */
heights: ZHeights,
/** How far X and Y reach from their home; 0 is without bounds. */
reach: [number, number],
/** Whether changing settings asks for a password. */
protected: boolean,
/** Whether outputs stay on when a machine that stands is stopped, disarmed or left. */
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
/** Whether its end is its start. */
closed: boolean,
/** Three numbers a vertex: X, Y and the bulge of the segment behind it, the tangent of a quarter of the angle of an arc, positive counter-clockwise; 0 is a line. */
points: Array<number>,
/** Height of each vertex, for a 3D shape. */
z: Array<number> | null,
/** Whether the machine halts before it. */
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
/** Whether only drawings are worked on here. */
drawingOnly: boolean,
/** The machine. */
machine: Machine,
/** Where it is. */
motion: Motion,
/** What a person reads lengths in. */
units: Units,
/** What the machine is set to, as far as drawings are worked on with it. */
setup: Setup,
/** Speeds in force. */
speeds: Speeds,
/** Inputs and outputs. */
io: Io,
/** The file that is open. */
opened: Opened | null,
/** What runs, or ran last. */
job: Job | null,
/** The path of what was typed. */
typed: TypedPath,
/** A run that can be taken up where it was cut short. */
interrupted: Interrupted | null,
/** How Kerf was started, where a start-up line says what pages show. */
start: StartUp | null,
/** The question that is open. */
asked: Asked | null,
/** The pause of so many seconds that is under way. */
pause: Pause | null,
/** The sound that was started last. */
sound: Sound | null,
/** The operator's overrides. */
overrides: Overrides,
/** The print window, oldest line first. */
printed: Array<string>,
/** Messages, oldest first. */
messages: Array<Message>,
/** Who drives. */
lease: Lease | null,
/** Who is connected. */
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
/** What pages were told to have in sight. */
looked: Looked | null, };

/** A sound that a program started (PLAY). */
export type Sound = {
/** Sounds are counted: each is heard once. */
number: number,
/** What it is fetched as, below `/api/media/`. */
name: string, };

/** Speeds; of axes that turn, degrees a second. */
export type Speeds = {
/** Cutting: X and Y together, then Z, A, B, C. */
cutMmS: [number, number, number, number, number],
/** Jogging. */
jogMmS: [number, number, number, number, number],
/** Spindle, revolutions a minute. */
rpm: number, };

/** What a start-up line says of pages (programming handbook, Command Line Options). */
export type StartUp = {
/** The part file, as the FP sheet names it. */
file: string,
/** The FP sheet opens on it, and nothing moves before OK. */
sheet: boolean,
/** 0 as last used, 1 with menus and the command line, 2 without, 9 files only: no commands, no keypad. */
display: number, };

/** What the machine is doing. */
export type State = "idle" | "running" | "jogging" | "held" | "asking" | "stopped" | "alarm";

/** What a system variable reads. */
export type SystemValue = {
/** The number in its brackets. */
number: number,
/** What it tells. */
name: string,
/** Its unit; empty for none. */
unit: string,
/** What it reads. */
value: string, };

/** Text of the editor that is not saved. */
export type TextDraft = {
/** The file below the part folder that it is of; empty for a new one. */
name: string,
/** The text; its lines end with a line feed. */
text: string,
/** What the lines of the file end with. */
ends: string,
/** SHA-256 of the file as it was read; empty for a new one. */
base: string,
/** Whether the file is another by now. */
changedOnDisk: boolean,
/** The page that typed it, by a name that it gives itself. */
page: string,
/** Which text it is; of one that is to be kept, the draft from which the page went on. Empty for none. */
revision: string, };

/** Inputs and outputs of a run on the simulated machine, beside its motion. */
export type Timing = {
/** Where it ends, seconds of machine time. */
seconds: number,
/** Whether it holds all of a run that came to its end. */
whole: boolean,
/** Whether it ends before the run because that has more edges than a chart holds. */
full: boolean,
/** How the run ended: `ok`, `ended`, `failed`, `stopped`, `limit`. */
status: string,
/** Why it ended before its end. */
finding: Finding | null,
/** Its lines, from above. */
lines: Array<TimingLine>, };

/** What a line of a timing chart shows. */
export type TimingKind = "axis" | "value" | "output" | "input";

/** A line of a timing chart. */
export type TimingLine = {
/** What it shows. */
kind: TimingKind,
/** Its name. */
name: string,
/** Where this is not 0 the line has more points than a chart holds: of each grain of so many seconds, counted from 0, only the first, the least, the greatest and the last are here. */
grain: number,
/** Moments, seconds, and the value there. An axis goes evenly between them; a value or a bit is 0 before the first and keeps what it is to the next. */
points: Array<[number, number]>, };

/** What comes over the socket to the page: one JSON text a message. */
export type ToPage = { "tell": "snapshot",
/** Who the page is. */
who: Who,
/** Everything. */
snapshot: Snapshot, } | { "tell": "changes",
/** At least one. */
changes: Array<Change>, } | { "tell": "reply" } & Reply;

/** How a message is meant. */
export type Tone = "note" | "program" | "warning" | "error";

/** A tool path that the program names. */
export type ToolPathInfo = {
/** Its name. */
name: string,
/** The tool. */
tool: string,
/** Planned time, seconds. */
seconds: number,
/** Its first move. */
firstMove: number, };

/** What a drawing becomes when it is machined. */
export type ToolPaths = {
/** The revision of the drawing. */
revision: number,
/** The paths, in the order in which they are cut, arrays laid out. */
paths: Array<CutShape>,
/** Shapes whose short lines become curves, as those are machined. */
smoothed: Array<ShapePath>,
/** Vertices that are left out because they lie too near to the one before: X and Y by turns. */
filtered: Array<number>,
/** What was noticed while they were made, or why there are none. */
notes: Array<string>, };

/** The path of what was typed, so far. */
export type TypedPath = {
/** Changes when it begins anew. */
key: number,
/** How many segments it has: they can be asked for as `/api/typed/KEY/FROM`. */
segments: number, };

/** What a person reads lengths in. */
export type Units = {
/** `in` or `mm`. */
linear: string,
/** Millimetres in one of them. */
mm: number,
/** Each axis. */
axes: Array<AxisUnits>,
/** Whether the numbers of moves are places (SA) or distances (SR). */
absolute: boolean, };

/** What the machine remembers, to be looked at. */
export type Values = {
/** System variables, by number. */
system: Array<SystemValue>,
/** User variables, by name. */
variables: Array<NamedValue>,
/** The lines of OpenSBP that set what is set now. */
settings: Array<string>,
/** What helps to find a fault (UD): versions, places, switches, the last error. */
diagnostics: Array<NamedValue>,
/** The folder of part files and which of them lists show (FS). */
folder: Folder,
/** The part file that ran last: its name below the part folder; empty before the first. */
partFile: string,
/** The folder of part files from the root on. */
parts: string,
/** The folder of settings and logs. */
data: string, };

/** Who a page is. */
export type Who = {
/** Its number, as long as it is connected. */
client: number,
/** What it may do. */
role: Role,
/** Name of the device; empty for a page on the machine itself. */
device: string, };

/** The sort of reason. */
export type Why = "malformed" | "role" | "password" | "lease" | "disarmed" | "state" | "file" | "changed" | "replaces" | "mistake" | "late" | "server" | "full";

/** Heights at which a job is cut. */
export type ZHeights = {
/** Where the tool travels. */
top: number,
/** The surface of the material. */
surface: number,
/** The lowest the tool may go; where THRU cuts. */
bottom: number, };
