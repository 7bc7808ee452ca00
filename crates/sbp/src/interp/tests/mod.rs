//! Tests of the interpreter, by the rows of the ledger.
