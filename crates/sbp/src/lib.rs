//! kerf-sbp
