//! The `kerf` command: part files and drawings in, a running machine or a report out.

fn main() {}
