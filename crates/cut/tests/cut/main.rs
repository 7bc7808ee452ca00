//! The cuts seen from outside: the ledger's rows and worked tables, what holds for all shapes, and
//! what a pocket removes.
// Two underscores in a name set off which part of a row a test shows; the tables have four decimals,
// also of the root of 2.
#![allow(clippy::unwrap_used, clippy::approx_constant, non_snake_case)]

mod any_numbers;
mod arcs;
mod circle_passes;
mod circles;
mod common;
mod pockets;
mod point_circles;
mod properties;
mod rectangles;
mod tab_properties;
mod tables;
mod tabs;
