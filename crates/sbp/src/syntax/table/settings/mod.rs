//! S commands: modes, switches and what belongs to a session.

mod modes;
mod operator;
mod switches;

use super::CommandSpec;

pub(super) static SPECS: [&CommandSpec; 14] = [
    &modes::SA,
    &modes::SR,
    &modes::SM,
    &modes::SP,
    &modes::ST,
    &modes::SC,
    &modes::SL,
    &modes::SV,
    &switches::SF,
    &switches::SO,
    &switches::SW,
    &switches::TR,
    &operator::SI,
    &operator::SK,
];
