//! Everything a page shows, at one moment.

use crate::preview::TypedPath;
use crate::{
    Asked, Change, Client, ControllerCard, ControllerSetting, CurrentRun, Digitized, DrawingState,
    Folder, HandConsole, HeightMap, Interrupted, Io, Lease, Looked, Machine, Message, Motion,
    NamedValue, Opened, Overrides, Pause, Recorder, ServedMachine, Setup, Sound, Speeds, ToolTable,
    Units, VERSION, Wiring, Zero,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// Lines of the print window that are kept.
const PRINTED: usize = 1000;
/// Messages that are kept.
const MESSAGES: usize = 200;

/// Settings of a start-up line for pages (programming handbook, Command Line Options).
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct StartUp {
    /// The part file, as the FP sheet names it.
    pub file: String,
    /// The FP sheet opens on it, and nothing moves before OK.
    pub sheet: bool,
    /// 0 as last used, 1 with menus and the command line, 2 without, 9 files only: no commands, no
    /// keypad.
    pub display: u8,
}

/// Everything a page shows, at one moment.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, TS, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub struct Snapshot {
    /// Version of the messages.
    pub version: u32,
    /// Version of Kerf.
    pub kerf: String,
    /// Grows with every change: whoever follows sees whether he has heard them all.
    pub revision: u32,
    /// The port of STOP's own way, beside that of the console; 0 where there is none.
    pub stop_port: u16,
    /// Only drawings are worked on here.
    pub drawing_only: bool,
    /// The machine.
    pub machine: Machine,
    /// Its position and motion.
    pub motion: Motion,
    /// Units in which a person reads lengths.
    pub units: Units,
    /// Settings of the machine, as far as drawings are worked on with it.
    pub setup: Setup,
    /// Speeds in force.
    pub speeds: Speeds,
    /// Inputs and outputs.
    pub io: Io,
    /// The file that is open.
    pub opened: Option<Opened>,
    /// The run that is under way, or the last one.
    pub job: Option<CurrentRun>,
    /// The path of what was typed.
    pub typed: TypedPath,
    /// The machines that are served together, this one among them; none where it is alone.
    pub together: Vec<ServedMachine>,
    /// A run that can be taken up where it was cut short.
    pub interrupted: Option<Interrupted>,
    /// Settings with which Kerf was started, where a start-up line says what pages show.
    pub start: Option<StartUp>,
    /// The question that is open.
    pub asked: Option<Asked>,
    /// The pause of so many seconds that is under way.
    pub pause: Option<Pause>,
    /// The sound that was started last.
    pub sound: Option<Sound>,
    /// The operator's overrides.
    pub overrides: Overrides,
    /// Zero points that the controller keeps; none of a machine without one.
    pub zeros: Vec<Zero>,
    /// Steps of a millimetre that the controller keeps, of each axis; none of a machine whose settings have them.
    pub controller_steps: Vec<f64>,
    /// Settings that the controller keeps by number, in their order; none of a machine without such.
    pub controller_settings: Vec<ControllerSetting>,
    /// The card of the controller, whose files it runs by itself.
    pub controller_card: ControllerCard,
    /// The tools by their numbers.
    pub tools: ToolTable,
    /// The height map that programs follow; nothing where surfaces are flat.
    pub height_map: Option<HeightMap>,
    /// A board that is being wired, or was wired last.
    pub wiring: Option<Wiring>,
    /// The print window, oldest line first.
    pub printed: Vec<String>,
    /// Messages, oldest first.
    pub messages: Vec<Message>,
    /// The turn at driving that goes on.
    pub lease: Option<Lease>,
    /// Connected pages.
    pub clients: Vec<Client>,
    /// The drawing that is open.
    pub drawing: Option<DrawingState>,
    /// Grows when files of the part folder change.
    pub files: u32,
    /// The folder that part files are chosen from.
    pub folder: Folder,
    /// Commands that were typed.
    pub recorder: Recorder,
    /// Variables that are shown while programs run, as far as they have values.
    pub watched: Vec<NamedValue>,
    /// Grows when the machine's configuration changes.
    pub settings: u32,
    /// The screen of the hand console.
    pub hand_console: HandConsole,
    /// The points that are being digitized; nothing while none are.
    pub digitized: Option<Digitized>,
    /// Part of the picture that pages were last told to have in sight.
    pub looked: Option<Looked>,
}

impl Default for Snapshot {
    fn default() -> Self {
        Self {
            version: VERSION,
            kerf: String::new(),
            revision: 0,
            stop_port: 0,
            drawing_only: false,
            machine: Machine::default(),
            motion: Motion::default(),
            units: Units::default(),
            setup: Setup::default(),
            speeds: Speeds::default(),
            io: Io::default(),
            opened: None,
            job: None,
            typed: TypedPath::default(),
            together: Vec::new(),
            interrupted: None,
            start: None,
            asked: None,
            pause: None,
            sound: None,
            overrides: Overrides::default(),
            zeros: Vec::new(),
            controller_steps: Vec::new(),
            controller_settings: Vec::new(),
            controller_card: ControllerCard::default(),
            tools: ToolTable::default(),
            height_map: None,
            wiring: None,
            printed: Vec::new(),
            messages: Vec::new(),
            lease: None,
            clients: Vec::new(),
            drawing: None,
            files: 0,
            folder: Folder::default(),
            recorder: Recorder::default(),
            watched: Vec::new(),
            settings: 0,
            hand_console: HandConsole::default(),
            digitized: None,
            looked: None,
        }
    }
}

impl Snapshot {
    /// Takes a change over, as every page does.
    pub fn apply(&mut self, change: Change) {
        self.revision = self.revision.wrapping_add(1);
        match change {
            Change::Machine { machine } => self.machine = machine,
            Change::Motion { motion } => self.motion = motion,
            Change::Units { units } => self.units = units,
            Change::Setup { setup } => self.setup = setup,
            Change::Speeds { speeds } => self.speeds = speeds,
            Change::Io { io } => self.io = io,
            Change::Opened { opened } => self.opened = opened,
            Change::Job { job } => self.job = job,
            Change::Typed { typed } => self.typed = typed,
            Change::Together { together } => self.together = together,
            Change::Interrupted { interrupted } => self.interrupted = interrupted,
            Change::Start { start } => self.start = start,
            Change::Asked { asked } => self.asked = asked,
            Change::Pause { pause } => self.pause = pause,
            Change::Sound { sound } => self.sound = sound,
            Change::Overrides { overrides } => self.overrides = overrides,
            Change::Zeros { zeros } => self.zeros = zeros,
            Change::ControllerSettings { controller_settings } => {
                self.controller_settings = controller_settings;
            }
            Change::ControllerSteps { controller_steps } => {
                self.controller_steps = controller_steps;
            }
            Change::ControllerCard { controller_card } => {
                self.controller_card = controller_card;
            }
            Change::Tools { tools } => self.tools = tools,
            Change::HeightMap { height_map } => self.height_map = height_map,
            Change::Wiring { wiring } => self.wiring = wiring,
            Change::Printed { lines } => keep_last(&mut self.printed, lines, PRINTED),
            Change::ClearPrinted => self.printed.clear(),
            Change::Messages { messages } => keep_last(&mut self.messages, messages, MESSAGES),
            Change::Lease { lease } => self.lease = lease,
            Change::Clients { clients } => self.clients = clients,
            Change::Drawing { drawing } => self.drawing = drawing,
            Change::Files { files } => self.files = files,
            Change::Folder { folder } => self.folder = folder,
            Change::Recorder { recorder } => self.recorder = recorder,
            Change::Watched { watched } => self.watched = watched,
            Change::Settings { settings } => self.settings = settings,
            Change::HandConsole { hand_console } => self.hand_console = hand_console,
            Change::Digitized { digitized } => self.digitized = digitized,
            Change::Looked { looked } => self.looked = looked,
        }
    }
}

/// Adds to a list that does not grow for ever.
fn keep_last<T>(list: &mut Vec<T>, more: Vec<T>, most: usize) {
    list.extend(more);
    list.drain(..list.len().saturating_sub(most));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_print_window_keeps_its_last_lines() {
        let mut snapshot = Snapshot::default();
        for n in 0..PRINTED + 5 {
            snapshot.apply(Change::Printed { lines: vec![n.to_string()] });
        }
        assert_eq!(snapshot.printed.len(), PRINTED);
        assert_eq!(snapshot.printed.first().map(String::as_str), Some("5"));
        snapshot.apply(Change::ClearPrinted);
        assert!(snapshot.printed.is_empty());
    }
}
