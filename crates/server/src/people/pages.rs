//! The pages that are connected.

use super::hand::{Grip, GripError, Hand};
use crate::app::lock;
use kerf_wire::{Client, Role, Who};
use std::collections::BTreeMap;
use std::sync::Mutex;
use std::time::Instant;

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
    hand: Hand,
}

impl Pages {
    /// A page has connected.
    pub fn add(&self, role: Role, device: String) -> Who {
        let mut inner = lock(&self.inner);
        inner.last += 1;
        let client = inner.last;
        inner.pages.insert(client, Page { role, device: device.clone(), hand: Hand::default() });
        Who { client, role, device }
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
        now_ms: f64,
    ) -> Result<Grip, GripError> {
        let now = Instant::now();
        let age = self.hand(client, |hand| hand.age(clock_ms, now_ms));
        // Older than the computer runs: older than anything that counts.
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

    #[test]
    fn a_hand_is_that_of_its_page() {
        let pages = Pages::default();
        let [one, other] = [(); 2].map(|()| pages.add(Role::Owner, String::new()).client);
        let grip = |client| pages.grip(client, 1, 5.0, 5.0).unwrap();
        assert!(pages.jog_begins(one, grip(one)).is_ok());
        pages.jog_over(other, 1);
        assert_eq!(pages.jog_begins(other, grip(other)), Err(GripError::Over));
        pages.remove(one);
        assert_eq!(pages.grip(one, 2, 5.0, 5.0), Err(GripError::Over), "nobody");
    }
}
