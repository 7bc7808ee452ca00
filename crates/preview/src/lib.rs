//! kerf-preview
