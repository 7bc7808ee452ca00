//! The pages that are connected.

use crate::app::lock;
use crate::pool::{HERE, KERF};
use crate::stop::Presses;
use kerf_wire::{Client, Role, Who};
use std::collections::BTreeMap;
use std::sync::Mutex;

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
    /// The number of the device.
    number: u32,
    /// What it pressed that only stops.
    presses: Presses,
    /// The jog with the greatest number that began or ended.
    jog: u32,
}

impl Inner {
    fn add(&mut self, role: Role, device: String, number: u32) -> (Who, Presses) {
        self.last += 1;
        let (client, presses) = (self.last, Presses::default());
        let name = device.clone();
        self.pages
            .insert(client, Page { role, device: name, number, jog: 0, presses: presses.clone() });
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

    /// What a page pressed on its own socket, if it is one of that device.
    pub fn presses(&self, client: u32, number: u32) -> Option<Presses> {
        let inner = lock(&self.inner);
        let page = inner.pages.get(&client).filter(|page| page.number == number);
        page.map(|page| page.presses.clone())
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

    /// Whether a jog of a page may start: not one that began or ended before.
    pub fn may_start(&self, client: u32, seq: u32) -> bool {
        let mut inner = lock(&self.inner);
        let Some(page) = inner.pages.get_mut(&client) else { return false };
        let may = seq > page.jog;
        page.jog = page.jog.max(seq);
        may
    }

    /// A jog of a page is over: its start, should it still come, is too late.
    pub fn jog_over(&self, client: u32, seq: u32) {
        if let Some(page) = lock(&self.inner).pages.get_mut(&client) {
            page.jog = page.jog.max(seq);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_start_behind_its_own_stop_is_too_late() {
        let pages = Pages::default();
        let client = pages.enter(Role::Owner, String::new(), HERE).map_or(0, |(who, _)| who.client);
        assert!(pages.may_start(client, 1));
        assert!(!pages.may_start(client, 1), "twice");
        pages.jog_over(client, 2);
        assert!(!pages.may_start(client, 2));
        assert!(pages.may_start(client, 3));
        assert!(!pages.may_start(client + 1, 1), "nobody");
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
