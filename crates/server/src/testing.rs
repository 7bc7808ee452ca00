//! Pages and scripts of a server without a network, for tests.

#![allow(clippy::unwrap_used)]

use crate::app::{App, Parts};
use crate::hub::Hub;
use crate::machine::{Link, Order};
use crate::machine_and_app;
use crate::setting_changes::SettingChanges;
use crate::setup::{Builders, Options, Workshop};
use kerf_control::Session;
use kerf_files::{Folders, RealDisk};
use kerf_wire::{Act, Change, Machine, Role, Snapshot, State, Who};
use kerf_workspace::{Workspace, stored::Stored};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, channel};
use std::thread::JoinHandle;
use tempfile::TempDir;

/// Pages of a machine that takes orders and does nothing.
pub struct Bench {
    pub app: Arc<App>,
    pub orders: Receiver<Order>,
    /// Drives; the machine is armed.
    pub driver: Who,
    pub other: Who,
    _folder: TempDir,
}

/// The same with a machine that moves; its thread ends with the second value.
pub fn moving() -> (Bench, JoinHandle<()>) {
    let folder = tempfile::tempdir().unwrap();
    let (parts, data) = (folder.path().to_owned(), folder.path().join("data"));
    let workshop = move || {
        let folders = Folders::new(parts.clone(), Vec::new(), Vec::new());
        let stored = Stored::in_memory(Default::default());
        let workspace = Workspace::new(Box::new(RealDisk), folders, stored, data.clone());
        Ok(Workshop {
            session: Session::default(),
            workspace,
            controller: None,
            told: Default::default(),
            kept: false,
            started: || None,
        })
    };
    let preview = || Err(std::io::Error::other("none"));
    let builders = Builders { workshop: Arc::new(workshop), preview: Arc::new(preview) };
    let made = machine_and_app(options(&folder), builders, Default::default(), None);
    let (app, machine) = made.unwrap();
    (driven(app, channel().1, folder), machine)
}

/// A page drives; the machine is armed.
pub fn bench() -> Bench {
    let folder = tempfile::tempdir().unwrap();
    let (sender, orders) = channel();
    let nothing = || std::io::Error::other("none");
    let builders = Builders {
        workshop: Arc::new(move || Err(nothing())),
        preview: Arc::new(move || Err(nothing())),
    };
    let hub = Arc::new(Hub::new(Snapshot::default()));
    let (link, left) = (Arc::<Link>::default(), Arc::default());
    let changes = Arc::new(SettingChanges::new(folder.path()));
    let parts = Parts { hub, link, orders: sender, left, builders, changes, log: None };
    driven(Arc::new(App::new(options(&folder), parts).unwrap()), orders, folder)
}

fn driven(app: Arc<App>, orders: Receiver<Order>, folder: TempDir) -> Bench {
    let [driver, other] =
        [(); 2].map(|()| app.pages.enter(Role::Owner, String::new(), 0).unwrap().0);
    let bench = Bench { app, orders, driver, other, _folder: folder };
    bench.does(&bench.driver, Act::TakeLease { force: false });
    bench.arms();
    bench
}

fn options(folder: &TempDir) -> Options {
    Options {
        listen: ([127, 0, 0, 1], 0).into(),
        lan: false,
        names: Vec::new(),
        parts: folder.path().into(),
        data: folder.path().join("data"),
        drawing_only: false,
        open: None,
        start: None,
        begin_with: Vec::new(),
        closes_with_program: false,
        webhook: None,
        rate: 1.0,
    }
}

impl Bench {
    pub fn does(&self, who: &Who, act: Act) {
        self.app.act(&self.app.hears(who), act).unwrap();
    }

    pub fn lease(&self) -> u32 {
        self.app.hub.read(|now| now.lease.as_ref().unwrap().number)
    }

    pub fn arms(&self) {
        self.does(&self.driver, Act::Arm { lease: self.lease() });
    }

    /// Puts the machine at rest: what it did is over.
    pub fn stands(&self) {
        self.app.hub.changing(|now| {
            let machine = Machine { state: State::Idle, ..now.machine.clone() };
            vec![Change::Machine { machine }]
        });
    }

    pub fn ordered(&self) -> bool {
        self.orders.try_recv().is_ok()
    }
}
