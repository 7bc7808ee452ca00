//! The pages that are connected.

use super::hand::{Grip, GripError, Hand};
use crate::locks::lock;
use crate::pool::{HERE, KERF};
use crate::stop::Presses;
use kerf_wire::{Client, Role, Who};
use std::collections::BTreeMap;
use std::sync::Mutex;
use std::time::Duration;

/// Numbers of scripts as drivers: those of pages count from 1.
const SCRIPTS: u32 = u32::MAX;

/// More devices than this are never paired.
const MOST_DEVICES: u32 = 1 << 30;

/// The number of the scripts of a device as a driver; 0 for those of the machine itself.
pub const fn script(device: u32) -> u32 {
    SCRIPTS - device
}

/// Returns `true` if a driver is a script.
pub const fn is_script(client: u32) -> bool {
    client >= SCRIPTS - MOST_DEVICES
}

/// Pages of a paired device at the same time.
const A_DEVICE: usize = 8;
/// Pages at the machine itself.
const AT_THE_MACHINE: usize = 64;

/// The pages that are connected, by their numbers.
#[derive(Debug, Default)]
pub struct Pages {
    inner: Mutex<Inner>,
}

#[derive(Debug, Default)]
struct Inner {
    last: u32,
    pages: BTreeMap<u32, Page>,
}

#[derive(Debug)]
struct Page {
    role: Role,
    device: String,
    /// The number of the device; [`HERE`] for the machine itself, [`KERF`] for a hand console.
    number: u32,
    /// Its presses that only stop.
    presses: Presses,
    hand: Hand,
}

impl Inner {
    fn add(&mut self, role: Role, device: String, number: u32) -> (Who, Presses) {
        self.last += 1;
        let (client, presses) = (self.last, Presses::default());
        let name = device.clone();
        let hand = Hand::default();
        let page = Page { role, device: name, number, presses: presses.clone(), hand };
        self.pages.insert(client, page);
        (Who { client, role, device }, presses)
    }
}

impl Pages {
    /// A page has connected, of a device that is known by a number; nothing where it has too many.
    pub fn enter(&self, role: Role, device: String, number: u32) -> Option<(Who, Presses)> {
        let mut inner = lock(&self.inner);
        let most = if number == HERE { AT_THE_MACHINE } else { A_DEVICE };
        let full = inner.pages.values().filter(|page| page.number == number).count() >= most;
        (!full).then(|| inner.add(role, device, number))
    }

    /// The hand console has connected, over its cable.
    pub fn enter_by_cable(&self, role: Role, device: String) -> Who {
        lock(&self.inner).add(role, device, KERF).0
    }

    /// Returns what a page pressed on its own socket, if it is one of that device.
    pub fn presses(&self, client: u32, number: u32) -> Option<Presses> {
        let inner = lock(&self.inner);
        let page = inner.pages.get(&client).filter(|page| page.number == number);
        page.map(|page| page.presses.clone())
    }

    /// The device that a driver belongs to, be it a page or a script.
    pub fn device_of(&self, client: u32) -> Option<u32> {
        if is_script(client) {
            return Some(SCRIPTS - client);
        }
        let number = lock(&self.inner).pages.get(&client)?.number;
        (number != KERF).then_some(number)
    }

    /// Everybody of a device: its pages, and its scripts.
    pub fn of_device(&self, device: u32) -> impl Iterator<Item = u32> {
        let inner = lock(&self.inner);
        let own = inner.pages.iter().filter(|(_, page)| page.number == device);
        let pages: Vec<u32> = own.map(|(client, _)| *client).collect();
        pages.into_iter().chain([script(device)])
    }

    /// A page has gone.
    pub fn remove(&self, client: u32) {
        lock(&self.inner).pages.remove(&client);
    }

    /// Everybody.
    pub fn list(&self) -> Vec<Client> {
        let inner = lock(&self.inner);
        let client = |(client, page): (&u32, &Page)| Client {
            client: *client,
            role: page.role,
            device: page.device.clone(),
        };
        inner.pages.iter().map(client).collect()
    }

    /// A sign of the hand of a page, which it stamped with the server's clock, ms.
    ///
    /// # Errors
    /// Its clock is ahead, or the page has gone.
    pub fn grip(
        &self,
        client: u32,
        seq: u64,
        clock_ms: f64,
        now: Duration,
    ) -> Result<Grip, GripError> {
        let now_ms = now.as_secs_f64() * 1e3;
        let age = self.hand(client, |hand| hand.age(clock_ms, now_ms));
        // Older than the server runs: older than anything that counts.
        let at = now.checked_sub(age.ok_or(GripError::Over)??);
        at.map(|at| Grip { seq, at }).ok_or(GripError::Over)
    }

    /// A jog of a page begins; gives the newest sign that it is held.
    ///
    /// # Errors
    /// It began or ended before, or its number is out of reach.
    pub fn jog_begins(&self, client: u32, grip: Grip) -> Result<Grip, GripError> {
        self.hand(client, |hand| hand.begins(grip)).unwrap_or(Err(GripError::Over))
    }

    /// A key is still held at a page.
    pub fn jog_holds(&self, client: u32, grip: Grip) {
        self.hand(client, |hand| hand.holds(grip));
    }

    /// A jog of a page is over: its start, should it still come, is too late.
    pub fn jog_over(&self, client: u32, seq: u64) {
        self.hand(client, |hand| hand.ends(seq));
    }

    /// Does something with the hand of a page that is connected.
    fn hand<T>(&self, client: u32, does: impl FnOnce(&mut Hand) -> T) -> Option<T> {
        lock(&self.inner).pages.get_mut(&client).map(|page| does(&mut page.hand))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn entered(pages: &Pages, device: u32) -> u32 {
        pages.enter(Role::Owner, String::new(), device).unwrap().0.client
    }

    #[test]
    fn a_hand_is_that_of_its_page() {
        let pages = Pages::default();
        let [one, other] = [(); 2].map(|()| entered(&pages, HERE));
        let grip = |client| pages.grip(client, 1, 5.0, Duration::from_millis(5)).unwrap();
        assert!(pages.jog_begins(one, grip(one)).is_ok());
        pages.jog_over(other, 1);
        assert_eq!(pages.jog_begins(other, grip(other)), Err(GripError::Over));
        pages.remove(one);
        assert_eq!(
            pages.grip(one, 2, 5.0, Duration::from_millis(5)),
            Err(GripError::Over),
            "nobody"
        );
    }

    #[test]
    fn pages_and_scripts_belong_to_their_device() {
        let pages = Pages::default();
        let [first, other] = [7, 8].map(|device| entered(&pages, device));
        let console = pages.enter_by_cable(Role::Setter, String::new()).client;
        assert_eq!(pages.of_device(7).collect::<Vec<_>>(), [first, script(7)]);
        assert_eq!([first, other, console].map(|it| pages.device_of(it)), [Some(7), Some(8), None]);
        assert_eq!([script(0), script(7)].map(|it| pages.device_of(it)), [Some(0), Some(7)]);
        assert!(is_script(script(0)) && is_script(script(40)) && !is_script(first));
    }

    #[test]
    fn a_device_has_so_many_pages_and_knows_only_its_own_presses() {
        let pages = Pages::default();
        let enter = |number| pages.enter(Role::Observer, String::new(), number);
        let open: Vec<_> = std::iter::from_fn(|| enter(3)).collect();
        assert_eq!(open.len(), A_DEVICE);
        assert!(enter(4).is_some());
        let client = open[0].0.client;
        assert!(pages.presses(client, 3).is_some());
        assert!(pages.presses(client, 4).is_none(), "of another device");
        pages.remove(client);
        assert!(enter(3).is_some());
    }
}
