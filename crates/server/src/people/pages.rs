//! The pages that are connected.

use crate::app::lock;
use kerf_wire::{Client, Role, Who};
use std::collections::BTreeMap;
use std::sync::Mutex;

/// Numbers of scripts as drivers: those of pages count from 1.
const SCRIPTS: u32 = u32::MAX;

/// More devices than this are never paired.
const MOST_DEVICES: u32 = 1 << 30;

/// The number of the scripts of a device as a driver; 0 for those of the machine itself.
pub const fn script(device: u32) -> u32 {
    SCRIPTS - device
}

/// Whether a driver is a script.
pub const fn is_script(client: u32) -> bool {
    client >= SCRIPTS - MOST_DEVICES
}

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
    /// Number of the device, 0 for the machine itself; nothing for a hand console.
    number: Option<u32>,
    /// The jog with the greatest number that began or ended.
    jog: u32,
}

impl Pages {
    /// A page of a device with this number has connected.
    pub fn add(&self, role: Role, device: String, number: Option<u32>) -> Who {
        let mut inner = lock(&self.inner);
        inner.last += 1;
        let client = inner.last;
        inner.pages.insert(client, Page { role, device: device.clone(), number, jog: 0 });
        Who { client, role, device }
    }

    /// The device that a driver belongs to, be it a page or a script.
    pub fn device_of(&self, client: u32) -> Option<u32> {
        if is_script(client) {
            return Some(SCRIPTS - client);
        }
        lock(&self.inner).pages.get(&client)?.number
    }

    /// Everybody of a device: its pages, and its scripts.
    pub fn of_device(&self, device: u32) -> impl Iterator<Item = u32> {
        let inner = lock(&self.inner);
        let own = inner.pages.iter().filter(|(_, page)| page.number == Some(device));
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
        let client = pages.add(Role::Owner, String::new(), Some(0)).client;
        assert!(pages.may_start(client, 1));
        assert!(!pages.may_start(client, 1), "twice");
        pages.jog_over(client, 2);
        assert!(!pages.may_start(client, 2));
        assert!(pages.may_start(client, 3));
        assert!(!pages.may_start(client + 1, 1), "nobody");
    }

    #[test]
    fn pages_and_scripts_belong_to_their_device() {
        let pages = Pages::default();
        let [first, other] =
            [7, 8].map(|device| pages.add(Role::Owner, String::new(), Some(device)).client);
        let console = pages.add(Role::Setter, String::new(), None).client;
        assert_eq!(pages.of_device(7).collect::<Vec<_>>(), [first, script(7)]);
        assert_eq!([first, other, console].map(|it| pages.device_of(it)), [Some(7), Some(8), None]);
        assert_eq!([script(0), script(7)].map(|it| pages.device_of(it)), [Some(0), Some(7)]);
        assert!(is_script(script(0)) && is_script(script(40)) && !is_script(first));
    }
}
