//! Bytes as what a board says. The test of this crate and the fuzz target share it: nothing panics, nothing grows
//! without end, and whatever was said, nothing moves by itself.

use crate::world::{Motion, World, setup};
use kerf_driver_klipper::board::{Board, News, Options};
use kerf_driver_klipper::dictionary::Dictionary;
use kerf_driver_klipper::fake::{Faults, reader};

/// Longest input that is looked at.
const LONGEST: usize = 4096;

/// The first byte chooses who hears the others: the reader of dictionaries, a host that looks for a board, one that
/// is ready, or one that moves.
pub fn check(bytes: &[u8]) {
    let Some((choice, rest)) = bytes.split_first() else { return };
    let rest = &rest[..rest.len().min(LONGEST)];
    match choice % 4 {
        0 => drop(Dictionary::read(rest)),
        1 => raw(rest),
        2 => messages(rest, false),
        _ => messages(rest, true),
    }
}

/// Bytes as they come, to a host that looks for a board.
fn raw(bytes: &[u8]) {
    let mut host = Board::new(setup(), Options::default(), 0.0);
    let mut now_s = 0.0;
    for piece in bytes.chunks(7) {
        host.receive(piece, now_s);
        let out = host.transmit(now_s);
        assert!(out.bytes.len() <= 64 * 13, "a host says little at a time");
        now_s += 0.02;
    }
}

/// Messages in sound frames, to a host that is ready: each begins with its length.
fn messages(mut bytes: &[u8], moves: bool) {
    let mut world = World::new(1, Faults::default(), setup(), Options::default());
    world.wait(|news| matches!(news, News::Ready { .. }));
    if moves {
        let motion = Motion::straight(3000.0, 2.0);
        let mut feed = world.begin(&motion, &[]);
        for _ in 0..700 {
            world.feed(&motion, &mut feed);
            world.pass();
        }
    }
    let before = world.fake.ran.get("queue_step").copied();
    while let Some((length, rest)) = bytes.split_first() {
        let (content, rest) = rest.split_at(usize::from(*length % 60).min(rest.len()));
        world.fake.say_content(content);
        world.pass();
        bytes = rest;
    }
    world.pass_for(0.3);
    let after = world.fake.ran.get("queue_step").copied();
    assert!(moves || before == after, "nothing moves by itself");
    assert!(world.news.len() <= LONGEST * 8, "news are no more than was said");
    assert_eq!(reader::crc(&[]), 0xffff);
}
