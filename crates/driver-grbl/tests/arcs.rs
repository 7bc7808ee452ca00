//! Arcs as the controller makes them.

use crate::wire::{Wire, run, to};
use kerf_driver_grbl::fake::{Board, Fake};
use kerf_machine::driver::{Axes, Link, LinkState, Order, Wired};
use std::f64::consts::{PI, TAU};

fn arc(to: Axes, centre: [f64; 2], sweep_rad: f64) -> Order {
    Order::Arc { to, centre, sweep_rad, speed_mm_s: 40.0 }
}

/// Makes orders, and tells the way that was made, mm.
#[track_caller]
fn made(board: Board, orders: &[Order]) -> (f64, Axes) {
    let mut link = Link::new(Wire::new(Fake::of(board, &[(10, 511.0)])));
    link.driver().fake.offsets.systems[0] = Axes::xyz(100.0, 50.0, -20.0);
    for order in orders {
        link.order(*order);
    }
    let mut done = 0;
    run(&mut link, 0.0, |link, _| {
        let standing = link.driver().grbl.stands().unwrap();
        assert!(standing.done >= done);
        done = standing.done;
    });
    let Wire { grbl, fake, .. } = link.driver();
    assert_eq!((grbl.trouble(), fake.overflowed), (None, 0), "{:?}", fake.lines);
    let made = (fake.way_mm(), fake.position());
    assert_eq!((link.state(), done), (LinkState::Up, orders.len() as u32));
    made
}

#[test]
fn arcs_are_made_by_the_controller() {
    for board in [Board::grbl(), Board::hal(0), Board::fluid()] {
        let orders = [
            to(10.0, 0.0),
            arc(Axes::xyz(10.0, 40.0, 0.0), [10.0, 20.0], PI),
            arc(Axes::xyz(10.0, 40.0, -1.0), [10.0, 20.0], -TAU),
            to(0.0, 40.0),
            to(0.0, 0.0),
        ];
        let (way_mm, place) = made(board, &orders);
        assert!((way_mm - 60.0 - 60.0 * PI).abs() < 0.2, "{way_mm}");
        assert_eq!((place.0[0], place.0[1]), (0.0, 0.0));
    }
}

#[test]
fn an_arc_that_is_begun_is_known_to_be() {
    let mut link = Link::new(Wire::new(Fake::of(Board::grbl(), &[(12, 0.000_1)])));
    link.order(to(10.0, 0.0));
    link.order(arc(Axes::xyz(10.0, 0.0, 0.0), [10.0, 20.0], TAU));
    let mut told = false;
    run(&mut link, 0.0, |link, _| {
        let Wire { grbl, fake, .. } = link.driver();
        told |= grbl.stands().unwrap().done == 1 && fake.position().0[1] < 20.0;
    });
    assert!(told, "the move before it is made, and the arc is not in the planner yet");
}
