//! Lets connections in: they are counted, and those that say nothing are shown out.
//!
//! ```text
//!  accept ─► Door: places of strangers, of an address ─► guard: known? ─► places of a device
//!             └─ the stranger who has waited longest makes room
//! ```
//!
//! Until its first request has come, a connection of a paired device is one of a stranger too. So that strangers can never
//! take all places, this computer has places of its own, and so have the addresses from which paired devices came before.

use super::guard::Peer;
use crate::descriptors;
use crate::locks::lock;
use axum::Router;
use axum::extract::connect_info::ConnectInfo;
use hyper::body::Incoming;
use hyper::server::conn::http1;
use hyper::service::{Service, service_fn};
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use std::collections::{BTreeMap, VecDeque};
use std::net::IpAddr;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::Notify;

/// The head of a request has come within this time.
const HEAD: Duration = Duration::from_secs(5);
/// A wait where the system has no descriptor for a connection.
const FULL: Duration = Duration::from_millis(50);

/// Connections that have not shown yet whose they are, of addresses that nobody knows; and as many of those from which
/// paired devices came before.
const STRANGERS: usize = 32;
/// Those of one address: a browser opens six.
const AN_ADDRESS: usize = 8;
/// Those of this computer itself.
const HERE: usize = 16;
/// Addresses from which paired devices came and that are remembered: the newest.
const ACQUAINTED: usize = 64;
/// A stranger whose request is answered for longer makes room as one does who has not asked yet.
const SLOW: Duration = Duration::from_secs(1);
/// Descriptors that no connection takes: files, listeners, the journal.
const OF_FILES: usize = 64;
/// Descriptors that paired devices leave to strangers and to this computer.
const OF_OTHERS: usize = 2 * STRANGERS + HERE + A_DEVICE;
/// Connections of one paired device.
const A_DEVICE: usize = 24;
/// Connections at the machine itself.
const AT_THE_MACHINE: usize = 200;

/// Whose a connection is, as long as nobody knows.
const NOBODY: u32 = u32::MAX;

/// Counts connections.
#[derive(Debug)]
pub struct Door {
    places: Mutex<Places>,
    /// The most of all paired devices together.
    of_devices: usize,
}

#[derive(Debug, Default)]
struct Places {
    /// Those that nobody knows, the oldest first.
    strangers: VecDeque<Arc<Visitor>>,
    /// Number of connections of each device.
    known: BTreeMap<u32, usize>,
    /// From where paired devices came, the newest last.
    acquainted: VecDeque<IpAddr>,
}

/// Strangers by where they come from: those of one sort take no place of another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sort {
    Here,
    Acquainted,
    Unknown,
}

impl Sort {
    fn of(address: IpAddr, acquainted: &VecDeque<IpAddr>) -> Self {
        if address.is_loopback() {
            return Self::Here;
        }
        if acquainted.contains(&address) { Self::Acquainted } else { Self::Unknown }
    }
}

/// A connection.
#[derive(Debug)]
pub struct Visitor {
    address: IpAddr,
    /// The device, by its number; 0 at the machine itself.
    whose: AtomicU32,
    /// Since when a request of it is being answered.
    served: Mutex<Option<Instant>>,
    leaves: Notify,
}

impl Visitor {
    fn stranger(address: IpAddr) -> Self {
        let (whose, served) = (AtomicU32::new(NOBODY), Mutex::default());
        Self { address, whose, served, leaves: Notify::new() }
    }

    /// A request of it is being answered, and has not been for long.
    fn is_served(&self) -> bool {
        lock(&self.served).is_some_and(|since| since.elapsed() < SLOW)
    }
}

/// A place at the door, given back when it is dropped.
#[derive(Clone, Debug)]
pub struct DoorSlot(Arc<Held>);

#[derive(Debug)]
struct Held {
    door: Arc<Door>,
    visitor: Arc<Visitor>,
}

impl DoorSlot {
    /// Notes whose the connection is. Returns `true` if there is room for one more of that device.
    pub fn is_of(&self, device: u32) -> bool {
        self.0.door.know(&self.0.visitor, device)
    }
}

impl Drop for Held {
    fn drop(&mut self) {
        self.door.leave(&self.visitor);
    }
}

impl Door {
    /// A door of a process that may have so many descriptors open.
    fn of(descriptors: usize) -> Arc<Self> {
        let of_devices = descriptors.saturating_sub(OF_FILES + OF_OTHERS).max(A_DEVICE);
        Arc::new(Self { places: Mutex::default(), of_devices })
    }

    /// A connection comes in; nothing where there is no room for it.
    fn enter(self: &Arc<Self>, address: IpAddr) -> Option<DoorSlot> {
        let mut places = lock(&self.places);
        let sort = Sort::of(address, &places.acquainted);
        let most = if sort == Sort::Here { HERE } else { AN_ADDRESS };
        let all = if sort == Sort::Here { HERE } else { STRANGERS };
        let acquainted = places.acquainted.clone();
        if !places.make_room(most, |it| it == address)
            || !places.make_room(all, |it| Sort::of(it, &acquainted) == sort)
        {
            return None;
        }
        let visitor = Arc::new(Visitor::stranger(address));
        places.strangers.push_back(visitor.clone());
        drop(places);
        Some(DoorSlot(Arc::new(Held { door: self.clone(), visitor })))
    }

    fn know(&self, visitor: &Arc<Visitor>, device: u32) -> bool {
        let mut places = lock(&self.places);
        if visitor.whose.load(Ordering::Relaxed) == device {
            return true;
        }
        let most = if device == 0 { AT_THE_MACHINE } else { A_DEVICE };
        if places.known.get(&device).is_some_and(|number| *number >= most) {
            return false;
        }
        if device != 0 {
            if places.of_devices() >= self.of_devices {
                return false;
            }
            places.meets(visitor.address);
        }
        places.forget(visitor);
        *places.known.entry(device).or_default() += 1;
        visitor.whose.store(device, Ordering::Relaxed);
        true
    }

    fn leave(&self, visitor: &Arc<Visitor>) {
        lock(&self.places).forget(visitor);
    }
}

impl Places {
    /// A paired device came from an address.
    fn meets(&mut self, address: IpAddr) {
        if address.is_loopback() {
            return;
        }
        self.acquainted.retain(|known| *known != address);
        self.acquainted.push_back(address);
        if self.acquainted.len() > ACQUAINTED {
            self.acquainted.pop_front();
        }
    }

    /// Connections of all paired devices.
    fn of_devices(&self) -> usize {
        self.known.iter().filter(|(device, _)| **device != 0).map(|(_, number)| number).sum()
    }

    /// Has room for one more where so many strangers of some addresses are let in.
    fn make_room(&mut self, most: usize, which: impl Fn(IpAddr) -> bool) -> bool {
        let count = self.strangers.iter().filter(|it| which(it.address)).count();
        count < most || self.show_out(|it| which(it.address))
    }

    /// The stranger who has waited longest makes room, if one is there who is not being served.
    fn show_out(&mut self, which: impl Fn(&Arc<Visitor>) -> bool) -> bool {
        let idle = |it: &Arc<Visitor>| which(it) && !it.is_served();
        let place = self.strangers.iter().position(idle);
        let shown = place.and_then(|place| self.strangers.remove(place));
        shown.inspect(|visitor| visitor.leaves.notify_one()).is_some()
    }

    fn forget(&mut self, visitor: &Arc<Visitor>) {
        match visitor.whose.load(Ordering::Relaxed) {
            NOBODY => self.strangers.retain(|other| !Arc::ptr_eq(other, visitor)),
            device => {
                if let Some(number) = self.known.get_mut(&device) {
                    *number = number.saturating_sub(1);
                }
            }
        }
    }
}

/// Lets connections in for as long as the task lives.
pub async fn serve(listener: TcpListener, router: Router) {
    let door = Door::of(descriptors::limit());
    loop {
        let Ok((stream, remote)) = listener.accept().await else {
            tokio::time::sleep(FULL).await;
            continue;
        };
        // A reply that waits for the acknowledgement of the one before is late.
        drop(stream.set_nodelay(true));
        let local = stream.local_addr().unwrap_or(remote);
        if let Some(place) = door.enter(remote.ip().to_canonical()) {
            tokio::spawn(converse(stream, Peer { remote, local }, place, router.clone()));
        }
    }
}

/// Answers what comes over a connection, until it ends or has to make room.
async fn converse(stream: TcpStream, peer: Peer, place: DoorSlot, router: Router) {
    let (routes, visitor) = (TowerToHyperService::new(router), place.0.visitor.clone());
    let serve = service_fn(move |mut request: hyper::Request<Incoming>| {
        request.extensions_mut().insert(ConnectInfo(peer));
        request.extensions_mut().insert(place.clone());
        let (answer, visitor) = (routes.call(request), place.0.visitor.clone());
        *lock(&visitor.served) = Some(Instant::now());
        async move {
            let answer = answer.await;
            *lock(&visitor.served) = None;
            answer
        }
    });
    let mut http = http1::Builder::new();
    http.timer(TokioTimer::new()).header_read_timeout(HEAD).max_buf_size(64 << 10);
    let connection = http.serve_connection(TokioIo::new(stream), serve).with_upgrades();
    tokio::select! {
        // Whoever breaks off a request has gone.
        _ = connection => {}
        () = visitor.leaves.notified() => {}
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn from(last: u8) -> IpAddr {
        [192, 0, 2, last].into()
    }

    fn strangers(door: &Door) -> usize {
        lock(&door.places).strangers.len()
    }

    #[test]
    fn strangers_of_one_address_make_room_for_each_other() {
        let door = Door::of(1024);
        let places: Vec<DoorSlot> = (0..100).map(|_| door.enter(from(1)).unwrap()).collect();
        assert_eq!(strangers(&door), AN_ADDRESS);
        assert!(door.enter(from(2)).is_some(), "another address has its own");
        drop(places);
        assert_eq!(strangers(&door), 0);
    }

    #[test]
    fn strangers_of_all_addresses_are_bounded_and_the_newest_comes_in() {
        let door = Door::of(1024);
        let places: Vec<DoorSlot> = (0..100).map(|n| door.enter(from(n)).unwrap()).collect();
        assert_eq!(strangers(&door), STRANGERS);
        let newest = places.last().unwrap();
        assert!(newest.is_of(3), "a device that is known takes no place of strangers");
        assert_eq!(strangers(&door), STRANGERS - 1);
    }

    #[test]
    fn who_is_being_served_is_not_shown_out() {
        let door = Door::of(1024);
        let places: Vec<DoorSlot> = (0..AN_ADDRESS).map(|_| door.enter(from(1)).unwrap()).collect();
        serve(&places, Duration::ZERO);
        assert!(door.enter(from(1)).is_none());
        // But for one whose request does not come to its end.
        serve(&places, SLOW);
        assert!(door.enter(from(1)).is_some());
    }

    /// Requests of theirs are being answered for so long.
    fn serve(places: &[DoorSlot], since: Duration) {
        let began = Instant::now().checked_sub(since);
        places.iter().for_each(|place| *lock(&place.0.visitor.served) = began);
    }

    #[test]
    fn strangers_take_no_place_of_this_computer_and_of_paired_devices() {
        let door = Door::of(1024);
        let device = door.enter(from(200)).unwrap();
        assert!(device.is_of(3));
        let strangers: Vec<DoorSlot> = (0..100).filter_map(|n| door.enter(from(n))).collect();
        serve(&strangers, Duration::ZERO);
        assert!(door.enter(from(201)).is_none(), "strangers have used up theirs");
        let here: Vec<DoorSlot> =
            (0..HERE).map(|_| door.enter([127, 0, 0, 1].into()).unwrap()).collect();
        let again: Vec<DoorSlot> =
            (0..AN_ADDRESS).map(|_| door.enter(from(200)).unwrap()).collect();
        assert!(
            here.iter().all(|place| place.is_of(0)) && again.iter().all(|place| place.is_of(3))
        );
    }

    #[test]
    fn devices_leave_descriptors_to_others() {
        let door = Door::of(OF_FILES + OF_OTHERS + 2 * A_DEVICE);
        let places: Vec<DoorSlot> =
            (0..3 * A_DEVICE).map(|_| door.enter(from(1)).unwrap()).collect();
        let of = |(n, place): (usize, &DoorSlot)| place.is_of(1 + (n / A_DEVICE) as u32);
        assert_eq!(places.iter().enumerate().map(of).filter(|known| *known).count(), 2 * A_DEVICE);
        assert!(door.enter([127, 0, 0, 1].into()).is_some_and(|place| place.is_of(0)));
    }

    #[test]
    fn a_device_has_so_many_connections_and_gets_them_back() {
        let door = Door::of(1024);
        let mut places: Vec<DoorSlot> =
            (0..A_DEVICE).map(|_| door.enter(from(1)).unwrap()).collect();
        assert!(places.iter().all(|place| place.is_of(4)));
        let more = door.enter(from(1)).unwrap();
        assert!(!more.is_of(4));
        assert!(more.is_of(5), "another device");
        places.pop();
        assert!(door.enter(from(1)).unwrap().is_of(4));
    }
}
