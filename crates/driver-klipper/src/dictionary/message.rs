//! A message of a board, read by its format.

use super::{Format, Kind};
use crate::wire::vlq;

/// The content of a field.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Value {
    /// A number, as its 32 bits.
    Number(u32),
    /// Bytes.
    Bytes(Vec<u8>),
}

/// A message of a board.
#[derive(Clone, Debug, PartialEq)]
pub struct Message<'a> {
    format: &'a Format,
    values: Vec<Value>,
}

impl<'a> Message<'a> {
    /// Reads the fields behind a message's number; nothing where they do not fill the bytes.
    pub fn read(format: &'a Format, mut bytes: &[u8]) -> Option<Self> {
        let fields = format.fields.iter();
        let values: Option<Vec<_>> = fields.map(|field| value(field.kind, &mut bytes)).collect();
        values.filter(|_| bytes.is_empty()).map(|values| Self { format, values })
    }

    /// Its name.
    pub fn name(&self) -> &'a str {
        &self.format.name
    }

    /// A field that is a number, as its 32 bits.
    pub fn number(&self, name: &str) -> Option<u32> {
        match self.value(name)? {
            Value::Number(number) => Some(*number),
            Value::Bytes(_) => None,
        }
    }

    /// A field that is bytes.
    pub fn bytes(&self, name: &str) -> Option<&[u8]> {
        match self.value(name)? {
            Value::Bytes(bytes) => Some(bytes),
            Value::Number(_) => None,
        }
    }

    /// All fields in their order.
    pub fn values(&self) -> &[Value] {
        &self.values
    }

    fn value(&self, name: &str) -> Option<&Value> {
        let at = self.format.fields.iter().position(|field| field.name == name)?;
        self.values.get(at)
    }
}

fn value(kind: Kind, bytes: &mut &[u8]) -> Option<Value> {
    let number = vlq::take(bytes)?;
    if kind != Kind::Bytes {
        return Some(Value::Number(cut(kind, number)));
    }
    let (data, rest) = bytes.split_at_checked(number as usize)?;
    *bytes = rest;
    Some(Value::Bytes(data.to_vec()))
}

/// Cuts a number to the width of its field.
fn cut(kind: Kind, number: u32) -> u32 {
    match kind {
        Kind::Byte => number & 0xff,
        Kind::Word => number & 0xffff,
        Kind::SignedWord => i32::from(number as i16) as u32,
        Kind::Long | Kind::SignedLong | Kind::Bytes => number,
    }
}
