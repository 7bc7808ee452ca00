//! From bytes of a file to what people count: lines and columns.

/// Starts of the lines of a text.
#[derive(Clone, Debug)]
pub struct Places<'a> {
    text: &'a str,
    starts: Vec<usize>,
}

impl<'a> Places<'a> {
    pub fn of(text: &'a str) -> Self {
        let ends = memchr::memchr_iter(b'\n', text.as_bytes());
        Self { text, starts: std::iter::once(0).chain(ends.map(|end| end + 1)).collect() }
    }

    /// Line and column of a byte, both counted from 1.
    pub fn of_byte(&self, at: usize) -> (u32, u32) {
        let line = self.starts.partition_point(|start| *start <= at);
        let before = self.text.get(self.starts[line - 1]..at).unwrap_or_default();
        (line as u32, before.chars().count() as u32 + 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_and_columns_are_counted_from_one() {
        let places = Places::of("ab\ncé|d\n");
        assert_eq!(
            [0, 2, 3, 6, 9].map(|at| places.of_byte(at)),
            [(1, 1), (1, 3), (2, 1), (2, 3), (3, 1)]
        );
    }
}
