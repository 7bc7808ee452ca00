//! The tests of this crate from outside, one program: linking one a file would cost more than running them.

#![allow(clippy::unwrap_used)]

mod common;
mod html;
mod png;
mod svg;
