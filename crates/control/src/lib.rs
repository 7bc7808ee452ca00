//! kerf-control
