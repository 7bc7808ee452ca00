//! The parts of a server, and what they share.
//!
//! Each part is a value of its own that knows only what it is lent: [`Driving`] and [`Orders`] the way to the machine,
//! [`MachineSettings`] what it is set to, [`PartFiles`] and [`Loader`] the files, [`DrawingDesk`] and [`Jobs`] drawings
//! and the jobs made from them, [`Runs`] and [`Hands`] what moves the machine.

use crate::awaited::Works;
use crate::clock::Clock;
use crate::configure::MachineSettings;
use crate::controller_card::CardDesk;
use crate::desk::DrawingDesk;
use crate::draft;
use crate::driving::Driving;
use crate::driving_turn::DrivingTurn;
use crate::files::PartFolder;
use crate::handconsole::Keys;
use crate::hands::Hands;
use crate::http::Bodies;
use crate::hub::Hub;
use crate::job::Jobs;
use crate::loader::Loader;
use crate::locks::{Lock, lock};
use crate::machine::{LastState, Link, Order};
use crate::memory::Memory;
use crate::orders::Orders;
use crate::part_files::PartFiles;
use crate::people::{Devices, Here, Pages};
use crate::pool::Pool;
use crate::preview::{Charts, Preview};
use crate::protect::Unlocked;
use crate::reading::Readings;
use crate::runs::Runs;
use crate::saving::Saves;
use crate::setting_changes::SettingChanges;
use crate::setup::{Builders, Options};
use crate::texts::Texts;
use crate::thumbnails::Thumbnails;
use crate::unsaved_shapes::UnsavedShapes;
use crate::wirings::Wirings;
use kerf_control::controller::LineLog;
use kerf_wire::Tone;
use std::io;
use std::sync::atomic::AtomicU32;
use std::sync::mpsc::Sender;
use std::sync::{Arc, Mutex, OnceLock};

/// Everything that requests share.
pub struct App {
    /// Options with which the server was started.
    pub options: Options,
    /// Record of the lines to the controller and of its answers; nothing where none speaks in lines.
    pub log: Option<Arc<LineLog>>,
    /// State that pages show.
    pub hub: Arc<Hub>,
    /// Requests for the running machine.
    pub link: Arc<Link>,
    /// The machine and its files as the last run left them.
    pub left: Arc<Mutex<LastState>>,
    /// The clock by which all ends that has to end in time; pages reckon with it.
    pub clock: Clock,
    /// Orders for the machine's thread.
    pub orders: Arc<Orders>,
    /// Turns at driving.
    pub driving: Arc<Driving>,
    /// Settings of the machine.
    pub settings: Arc<MachineSettings>,
    /// The part folder.
    pub files: Arc<PartFiles>,
    /// Texts that are typed in the editor and not saved.
    pub texts: Texts,
    /// The file that is open.
    pub loader: Arc<Loader>,
    /// The drawing that is open.
    pub drawing: Arc<DrawingDesk>,
    /// The job that is open.
    pub jobs: Arc<Jobs>,
    /// Runs of files, jobs and typed lines.
    pub runs: Runs,
    /// Motion by hand.
    pub hands: Hands,
    /// The hand console.
    pub keys: Keys,
    /// A board that is being wired.
    pub wirings: Wirings,
    /// The card of the controller.
    pub card: CardDesk,
    /// Paired devices.
    pub devices: Devices,
    /// Token of whoever sits at the machine, where others may connect as well.
    pub here: Option<Here>,
    /// Connected pages.
    pub pages: Arc<Pages>,
    /// Does what takes longer than a moment.
    pub pool: Arc<Pool>,
    /// State of the memory: tight or not.
    pub memory: Memory,
    /// Room for what is sent.
    pub bodies: Bodies,
    /// Long work that somebody waits for.
    pub works: Works,
}

/// Parts that an app is made of, besides its options.
pub struct Parts {
    pub hub: Arc<Hub>,
    pub link: Arc<Link>,
    pub orders: Sender<Order>,
    pub left: Arc<Mutex<LastState>>,
    pub builders: Builders,
    pub changes: Arc<SettingChanges>,
    pub log: Option<Arc<LineLog>>,
}

impl App {
    /// Nothing is open, nobody is connected.
    ///
    /// # Errors
    /// The part folder or the list of devices cannot be read.
    pub fn new(options: Options, parts: Parts) -> io::Result<Self> {
        let Parts { hub, link, orders, left, builders, changes, log } = parts;
        let clock = link.clock().clone();
        let (devices, told) = Devices::read(&options.data, clock.clone())?;
        told.into_iter().for_each(|told| hub.say(Tone::Warning, told));
        if let Err(error) = hub.ran.keep_in(&options.data) {
            hub.say(Tone::Warning, format!("when files ran last is not known any more: {error}"));
        }
        if let Err(error) = hub.history.keep_in(&options.data) {
            hub.say(Tone::Warning, format!("the history of runs is not known any more: {error}"));
        }
        let here = options.lan.then(|| Here::of(&options.data)).transpose()?;
        let memory = Memory::default();
        let pool = Arc::new(Pool::begin(memory.clone())?);
        let lent = Lent { hub: hub.clone(), link: link.clone(), left: left.clone() };
        let (pages, turn) = (Arc::new(Pages::default()), Arc::new(DrivingTurn::by(clock.clone())));
        let orders = Arc::new(Orders::new(hub.clone(), link.clone(), turn.clone(), orders));
        let driving = Driving::new(hub.clone(), link.clone(), pages.clone(), turn);
        let settings = Arc::new(lent.settings(changes, &orders, &clock));
        let loader = Arc::new(lent.loader(&options, &pool, builders)?);
        let drawing = Arc::new(lent.drawing(&options, &loader, &settings));
        let jobs = Arc::new(lent.jobs(&drawing));
        Ok(Self {
            runs: lent.runs(&orders, &jobs),
            hands: lent.hands(&orders, &loader, &pages, &clock),
            files: loader.files.clone(),
            card: CardDesk::new(
                (hub.clone(), link.clone(), left.clone()),
                orders.clone(),
                loader.clone(),
            ),
            wirings: Wirings::new(hub.clone(), link.clone(), left.clone(), loader.files.clone()),
            texts: Texts::new(&options.data),
            driving: Arc::new(driving),
            keys: Keys::default(),
            bodies: Bodies::default(),
            works: Works::default(),
            options,
            log,
            hub,
            link,
            left,
            clock,
            orders,
            settings,
            loader,
            drawing,
            jobs,
            devices,
            here,
            pages,
            pool,
            memory,
        })
    }

    /// Takes a device off the list: what it has of the machine is gone at once.
    ///
    /// # Errors
    /// Whatever the disk says.
    pub fn revoke(&self, device: u32) -> io::Result<()> {
        self.devices.revoke(device)?;
        let of_device = |client| self.pages.device_of(client) == Some(device);
        self.driving
            .drop_lease(|lease| of_device(lease.client), "the controlling device was revoked");
        self.pages.of_device(device).for_each(|client| self.settings.unlocked.remove(client));
        // Pages look whether they are still paired when something is told.
        self.files.changed();
        Ok(())
    }

    /// A run is over. A file that a tool made is opened; a preview that no longer begins where the machine stands is made again.
    pub fn after_run(&self, made: Option<String>) {
        if let Some(name) = made {
            // It was written a moment ago; where it cannot be read nothing is opened.
            drop(self.loader.open_file(&name));
        }
        self.jobs.keep_taken();
        let session = lock(&self.left).session.clone();
        let map = self.hub.read(|now| now.height_map.clone());
        let is_stale = |made: &Preview| made.is_stale(&session) || made.height_map != map;
        let stale = self.loader.open.lock().preview.as_deref().is_some_and(is_stale);
        if stale {
            self.loader.preview_again();
        }
        self.drawing.tell_drawing();
        self.files.changed();
    }
}

/// Values that most parts are lent.
struct Lent {
    hub: Arc<Hub>,
    link: Arc<Link>,
    left: Arc<Mutex<LastState>>,
}

impl Lent {
    fn settings(
        &self,
        changes: Arc<SettingChanges>,
        orders: &Arc<Orders>,
        clock: &Clock,
    ) -> MachineSettings {
        MachineSettings {
            hub: self.hub.clone(),
            left: self.left.clone(),
            orders: orders.clone(),
            unlocked: Unlocked::by(clock.clone()),
            clock: clock.clone(),
            passwords: Mutex::default(),
            changes,
        }
    }

    fn loader(
        &self,
        options: &Options,
        pool: &Arc<Pool>,
        builders: Builders,
    ) -> io::Result<Loader> {
        let (folder, saves) = (PartFolder::new(&options.parts)?, Saves::new(&options.data));
        let files = Arc::new(PartFiles { folder, saves, hub: self.hub.clone() });
        let (hub, data) = (self.hub.clone(), options.data.clone());
        Ok(Loader {
            thumbnails: Thumbnails::in_data(&options.data),
            added: UnsavedShapes { hub, files: files.clone(), data },
            hub: self.hub.clone(),
            link: self.link.clone(),
            left: self.left.clone(),
            files,
            pool: pool.clone(),
            builders,
            open: Lock::default(),
            charts: Charts::default(),
            previews: AtomicU32::new(0),
        })
    }

    fn drawing(
        &self,
        options: &Options,
        loader: &Arc<Loader>,
        settings: &Arc<MachineSettings>,
    ) -> DrawingDesk {
        DrawingDesk {
            hub: self.hub.clone(),
            left: self.left.clone(),
            files: loader.files.clone(),
            loader: loader.clone(),
            settings: settings.clone(),
            desk: Lock::default(),
            reading: Readings::default(),
            draft: draft::file_in(&options.data),
            changed: OnceLock::new(),
        }
    }

    fn jobs(&self, drawing: &Arc<DrawingDesk>) -> Jobs {
        Jobs {
            hub: self.hub.clone(),
            left: self.left.clone(),
            files: drawing.files.clone(),
            loader: drawing.loader.clone(),
            settings: drawing.settings.clone(),
            drawing: drawing.clone(),
            taken: Lock::default(),
        }
    }

    fn runs(&self, orders: &Arc<Orders>, jobs: &Arc<Jobs>) -> Runs {
        Runs {
            hub: self.hub.clone(),
            link: self.link.clone(),
            left: self.left.clone(),
            files: jobs.files.clone(),
            orders: orders.clone(),
            settings: jobs.settings.clone(),
            loader: jobs.loader.clone(),
            jobs: jobs.clone(),
        }
    }

    fn hands(
        &self,
        orders: &Arc<Orders>,
        loader: &Arc<Loader>,
        pages: &Arc<Pages>,
        clock: &Clock,
    ) -> Hands {
        Hands {
            hub: self.hub.clone(),
            link: self.link.clone(),
            left: self.left.clone(),
            orders: orders.clone(),
            loader: loader.clone(),
            pages: pages.clone(),
            clock: clock.clone(),
        }
    }
}
