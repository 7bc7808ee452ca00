//! The bytes of a text: where lines end, and what separates words.

/// Returns the end of the line that begins at `start`, and the beginning of the next one.
pub(super) fn line_end(bytes: &[u8], start: usize) -> (usize, usize) {
    let Some(length) = memchr::memchr2(b'\n', b'\r', &bytes[start..]) else {
        return (bytes.len(), bytes.len());
    };
    let end = start + length;
    (end, after_line_end(bytes, end))
}

/// Returns the beginning of the next line.
pub(crate) fn next_line(bytes: &[u8], start: usize) -> usize {
    line_end(bytes, start.min(bytes.len())).1
}

/// Returns the beginning of the next line when the line end starts at `end`.
pub(crate) fn after_line_end(bytes: &[u8], end: usize) -> usize {
    let both = bytes.get(end) == Some(&b'\r') && bytes.get(end + 1) == Some(&b'\n');
    (end + 1 + usize::from(both)).min(bytes.len())
}

/// True for what separates words: blanks, tabs and the control characters old editors left behind.
pub(crate) const fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | 0x0B | 0x0C | 0x1A)
}
