//! Blanks, line ends and comments.

/// True for what separates words: blanks, tabs and the control characters old editors left behind.
pub(crate) const fn is_blank(byte: u8) -> bool {
    // Nearly every byte that is asked for is a printed sign.
    byte <= b' ' && matches!(byte, b' ' | b'\t' | 0x0B | 0x0C | 0x1A)
}

/// The same for a character.
pub(crate) fn blank(c: char) -> bool {
    u8::try_from(c).is_ok_and(is_blank)
}

/// Returns the end of the line that begins at `start`, and the beginning of the next one.
pub(super) fn line_end(bytes: &[u8], start: usize) -> (usize, usize) {
    let Some(length) = memchr::memchr2(b'\n', b'\r', &bytes[start..]) else {
        return (bytes.len(), bytes.len());
    };
    let end = start + length;
    (end, after_line_end(bytes, end))
}

/// Returns the beginning of the next line when the line end starts at `end`.
pub(super) fn after_line_end(bytes: &[u8], end: usize) -> usize {
    let both = bytes.get(end) == Some(&b'\r') && bytes.get(end + 1) == Some(&b'\n');
    (end + 1 + usize::from(both)).min(bytes.len())
}

/// Returns the end of the code of a line: before its comment, trailing blanks left out.
///
/// An apostrophe between quotes is text.
pub(crate) fn code_end(line: &[u8]) -> usize {
    let mut from = 0;
    let mut end = line.len();
    while let Some(at) = memchr::memchr2(b'\'', b'"', &line[from..]) {
        let at = from + at;
        if line[at] == b'\'' {
            end = at;
            break;
        }
        match memchr::memchr(b'"', &line[at + 1..]) {
            Some(length) => from = at + 1 + length + 1,
            None => break,
        }
    }
    while end > 0 && is_blank(line[end - 1]) {
        end -= 1;
    }
    end
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_in_three_ways() {
        for (bytes, ends) in [
            (&b"ab"[..], (2, 2)),
            (b"ab\nc", (2, 3)),
            (b"ab\r\nc", (2, 4)),
            (b"ab\rc", (2, 3)),
            (b"ab\r", (2, 3)),
        ] {
            assert_eq!(line_end(bytes, 0), ends, "{bytes:?}");
        }
    }

    #[test]
    fn comments_begin_outside_quotes() {
        for (line, code) in [
            ("MX,1 'right", "MX,1"),
            ("MX,1'tight", "MX,1"),
            ("PRINT \"it's\" 'x", "PRINT \"it's\""),
            ("PRINT it's", "PRINT it"),
            ("PRINT \"open 'x  ", "PRINT \"open 'x"),
            ("'all", ""),
        ] {
            assert_eq!(&line[..code_end(line.as_bytes())], code);
        }
    }
}
