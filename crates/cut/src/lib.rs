//! kerf-cut
