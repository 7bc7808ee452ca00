//! The tests of this crate from outside, one program: linking one a file would cost more than running them.

mod families;
mod glossary;
mod offset;
mod properties;
