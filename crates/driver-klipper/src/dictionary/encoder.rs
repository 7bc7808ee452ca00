//! A command as bytes, in the order and with the number that a board's dictionary gives it.

use super::{Format, Kind, Value};
use crate::wire::{frame::CONTENT, vlq};

/// A command that Kerf sends: its name, and its fields in the order in which Kerf names them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wanted {
    /// Name.
    pub name: &'static str,
    /// Fields.
    pub fields: &'static [&'static str],
}

/// The reason for which a command cannot be written.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum EncodeError {
    /// A field got too many, too few, or other values than it holds.
    #[error("`{command}` cannot be told {field} = {value}")]
    Field {
        /// Name of the command.
        command: String,
        /// Name of the field.
        field: String,
        /// The value.
        value: String,
    },
    /// Too long for a frame.
    #[error("`{0}` would be longer than a frame")]
    Long(String),
}

/// Writes one command of a board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Encoder {
    format: Format,
    /// For each field of the board, its place among those that Kerf names.
    order: Vec<usize>,
}

impl Encoder {
    /// Writes a command by its format; nothing where the fields are not those that are meant.
    pub(super) fn new(format: &Format, wanted: &Wanted) -> Option<Self> {
        let place = |name: &str| wanted.fields.iter().position(|field| *field == name);
        let order: Option<Vec<_>> = format.fields.iter().map(|field| place(&field.name)).collect();
        let order = order.filter(|order| order.len() == wanted.fields.len())?;
        Some(Self { format: format.clone(), order })
    }

    /// Writes the command with numbers, each as its 32 bits, in the order in which Kerf names the fields.
    ///
    /// # Errors
    ///
    /// A number does not fit its field.
    pub fn numbers<const N: usize>(&self, numbers: [u32; N]) -> Result<Vec<u8>, EncodeError> {
        self.values(&numbers.map(Value::Number))
    }

    /// Writes the command with any values, in the order in which Kerf names the fields.
    ///
    /// # Errors
    ///
    /// A value does not fit its field, or all do not fit a frame.
    pub fn values(&self, values: &[Value]) -> Result<Vec<u8>, EncodeError> {
        let mut bytes = Vec::new();
        vlq::put(self.format.number, &mut bytes);
        for (field, at) in self.format.fields.iter().zip(&self.order) {
            match values.get(*at) {
                Some(Value::Number(number)) if fits(field.kind, *number) => {
                    vlq::put(*number, &mut bytes)
                }
                Some(Value::Bytes(data)) if field.kind == Kind::Bytes => {
                    vlq::put(data.len() as u32, &mut bytes);
                    bytes.extend_from_slice(data);
                }
                other => return Err(self.refused(&field.name, other)),
            }
        }
        if bytes.len() > CONTENT {
            return Err(EncodeError::Long(self.format.name.clone()));
        }
        Ok(bytes)
    }

    fn refused(&self, field: &str, value: Option<&Value>) -> EncodeError {
        EncodeError::Field {
            command: self.format.name.clone(),
            field: field.to_owned(),
            value: value.map_or_else(|| "nothing".to_owned(), |value| format!("{value:?}")),
        }
    }
}

/// A board cuts a number to its field without a word, so it has to fit before. One of 8 bits may have a sign: some
/// fields mean −1 by it.
fn fits(kind: Kind, number: u32) -> bool {
    let signed = number as i32;
    match kind {
        Kind::Byte => (-128..=255).contains(&signed),
        Kind::Word => (0..=0xffff).contains(&signed),
        Kind::SignedWord => i16::try_from(signed).is_ok(),
        Kind::Long | Kind::SignedLong => true,
        Kind::Bytes => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const QUEUE: Wanted =
        Wanted { name: "queue_step", fields: &["oid", "interval", "count", "add"] };

    fn encoder(text: &str, number: i32) -> Option<Encoder> {
        Encoder::new(&Format::read(text, number as u32).ok()?, &QUEUE)
    }

    fn check(text: &str, number: i32, numbers: [i32; 4], expected: &[u8]) {
        let bytes = encoder(text, number).map(|e| e.numbers(numbers.map(|n| n as u32)));
        assert_eq!(bytes, Some(Ok(expected.to_vec())), "{text}");
    }

    #[test]
    fn fields_are_written_in_the_order_of_the_board() {
        let usual = "queue_step oid=%c interval=%u count=%hu add=%hi";
        check(usual, 22, [0, 25_000, 1000, 0], &[0x16, 0x00, 0x81, 0xc3, 0x28, 0x87, 0x68, 0x00]);
        let other = "queue_step add=%hi count=%hu oid=%c interval=%u";
        check(other, -3, [5, 95, 2, -1], &[0x7d, 0x7f, 0x02, 0x05, 0x5f]);
    }

    #[test]
    fn commands_with_other_fields_are_not_taken() {
        assert_eq!(encoder("queue_step oid=%c interval=%u count=%hu", 1), None);
        assert_eq!(encoder("queue_step oid=%c interval=%u count=%hu add=%hi add2=%hi", 1), None);
        assert_eq!(encoder("queue_step oid=%c interval=%u count=%hu plus=%hi", 1), None);
    }

    #[test]
    fn numbers_that_a_board_would_cut_are_refused() {
        let encoder =
            encoder("queue_step oid=%c interval=%u count=%hu add=%hi", 1).expect("a format");
        let refused = |numbers: [i32; 4]| encoder.numbers(numbers.map(|n| n as u32)).is_err();
        assert!(refused([256, 1, 1, 0]));
        assert!(refused([0, 1, 65_536, 0]));
        assert!(refused([0, 1, 1, 32_768]));
        assert!(!refused([-1, -1, 65_535, -32_768]));
    }
}
