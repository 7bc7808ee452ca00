//! kerf-motion
