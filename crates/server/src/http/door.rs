//! Who comes in: connections are counted, and those that say nothing are shown out.
//!
//! ```text
//!  accept ─► Door: places of strangers, of an address ─► guard: known? ─► places of a device
//!             └─ the stranger who has waited longest makes room
//! ```

use super::guard::Peer;
use crate::app::lock;
use axum::Router;
use axum::extract::connect_info::ConnectInfo;
use hyper::body::Incoming;
use hyper::server::conn::http1;
use hyper::service::{Service, service_fn};
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use std::collections::{BTreeMap, VecDeque};
use std::net::IpAddr;
use std::sync::atomic::{AtomicBool, AtomicU32, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Duration;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::Notify;

/// The head of a request has come within this time.
const HEAD: Duration = Duration::from_secs(5);
/// A wait where the system has no descriptor for a connection.
const FULL: Duration = Duration::from_millis(50);

/// Connections that have not shown yet whose they are.
const STRANGERS: usize = 32;
/// Those of one address: a browser opens six.
const AN_ADDRESS: usize = 8;
/// Those of this computer itself.
const HERE: usize = 16;
/// Connections of one paired device.
const A_DEVICE: usize = 24;
/// Connections at the machine itself.
const AT_THE_MACHINE: usize = 200;

/// Whose a connection is, as long as nobody knows.
const NOBODY: u32 = u32::MAX;

/// Counts connections.
#[derive(Debug, Default)]
pub struct Door(Mutex<Places>);

#[derive(Debug, Default)]
struct Places {
    /// Those that nobody knows, the oldest first.
    strangers: VecDeque<Arc<Visitor>>,
    /// How many each device has.
    known: BTreeMap<u32, usize>,
}

/// A connection.
#[derive(Debug)]
pub struct Visitor {
    address: IpAddr,
    /// The device, by its number; 0 at the machine itself.
    whose: AtomicU32,
    /// A request of it is being answered.
    served: AtomicBool,
    leaves: Notify,
}

impl Visitor {
    fn stranger(address: IpAddr) -> Self {
        let (whose, served) = (AtomicU32::new(NOBODY), AtomicBool::new(false));
        Self { address, whose, served, leaves: Notify::new() }
    }
}

/// A place at the door, given back when it is dropped.
#[derive(Clone, Debug)]
pub struct Place(Arc<Held>);

#[derive(Debug)]
struct Held {
    door: Arc<Door>,
    visitor: Arc<Visitor>,
}

impl Place {
    /// It is known whose the connection is.  Whether there is room for one more of that device.
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
    /// A connection comes in; nothing where there is no room for it.
    fn enter(self: &Arc<Self>, address: IpAddr) -> Option<Place> {
        let mut places = lock(&self.0);
        let most = if address.is_loopback() { HERE } else { AN_ADDRESS };
        let of_it = |stranger: &Arc<Visitor>| stranger.address == address;
        let full = places.strangers.iter().filter(|it| of_it(it)).count() >= most;
        if full && !places.show_out(of_it) {
            return None;
        }
        if places.strangers.len() >= STRANGERS && !places.show_out(|_| true) {
            return None;
        }
        let visitor = Arc::new(Visitor::stranger(address));
        places.strangers.push_back(visitor.clone());
        drop(places);
        Some(Place(Arc::new(Held { door: self.clone(), visitor })))
    }

    fn know(&self, visitor: &Arc<Visitor>, device: u32) -> bool {
        let mut places = lock(&self.0);
        if visitor.whose.load(Ordering::Relaxed) == device {
            return true;
        }
        let most = if device == 0 { AT_THE_MACHINE } else { A_DEVICE };
        if places.known.get(&device).is_some_and(|number| *number >= most) {
            return false;
        }
        places.forget(visitor);
        *places.known.entry(device).or_default() += 1;
        visitor.whose.store(device, Ordering::Relaxed);
        true
    }

    fn leave(&self, visitor: &Arc<Visitor>) {
        lock(&self.0).forget(visitor);
    }
}

impl Places {
    /// The stranger who has waited longest makes room, if one is there who is not being served.
    fn show_out(&mut self, which: impl Fn(&Arc<Visitor>) -> bool) -> bool {
        let idle = |it: &Arc<Visitor>| which(it) && !it.served.load(Ordering::Relaxed);
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
    let door = Arc::<Door>::default();
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
async fn converse(stream: TcpStream, peer: Peer, place: Place, router: Router) {
    let (routes, visitor) = (TowerToHyperService::new(router), place.0.visitor.clone());
    let serve = service_fn(move |mut request: hyper::Request<Incoming>| {
        request.extensions_mut().insert(ConnectInfo(peer));
        request.extensions_mut().insert(place.clone());
        let (answer, visitor) = (routes.call(request), place.0.visitor.clone());
        visitor.served.store(true, Ordering::Relaxed);
        async move {
            let answer = answer.await;
            visitor.served.store(false, Ordering::Relaxed);
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
        lock(&door.0).strangers.len()
    }

    #[test]
    fn strangers_of_one_address_make_room_for_each_other() {
        let door = Arc::<Door>::default();
        let places: Vec<Place> = (0..100).map(|_| door.enter(from(1)).unwrap()).collect();
        assert_eq!(strangers(&door), AN_ADDRESS);
        assert!(door.enter(from(2)).is_some(), "another address has its own");
        drop(places);
        assert_eq!(strangers(&door), 0);
    }

    #[test]
    fn strangers_of_all_addresses_are_bounded_and_the_newest_comes_in() {
        let door = Arc::<Door>::default();
        let places: Vec<Place> = (0..100).map(|n| door.enter(from(n)).unwrap()).collect();
        assert_eq!(strangers(&door), STRANGERS);
        let newest = places.last().unwrap();
        assert!(newest.is_of(3), "a device that is known takes no place of strangers");
        assert_eq!(strangers(&door), STRANGERS - 1);
    }

    #[test]
    fn who_is_being_served_is_not_shown_out() {
        let door = Arc::<Door>::default();
        let serve = |place: &Place| place.0.visitor.served.store(true, Ordering::Relaxed);
        let places: Vec<Place> = (0..AN_ADDRESS).map(|_| door.enter(from(1)).unwrap()).collect();
        places.iter().for_each(serve);
        assert!(door.enter(from(1)).is_none());
    }

    #[test]
    fn a_device_has_so_many_connections_and_gets_them_back() {
        let door = Arc::<Door>::default();
        let mut places: Vec<Place> = (0..A_DEVICE).map(|_| door.enter(from(1)).unwrap()).collect();
        assert!(places.iter().all(|place| place.is_of(4)));
        let more = door.enter(from(1)).unwrap();
        assert!(!more.is_of(4));
        assert!(more.is_of(5), "another device");
        places.pop();
        assert!(door.enter(from(1)).unwrap().is_of(4));
    }
}
