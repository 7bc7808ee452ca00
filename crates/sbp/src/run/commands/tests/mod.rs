//! Commands by the rows of the ledger.

mod cuts;
mod moves;
mod properties;
mod settings;
mod values;
