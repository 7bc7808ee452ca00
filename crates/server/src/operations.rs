//! The operations of a drawing as forms, for the sheets of pages.

use kerf_drawing::{ENTRIES, Part, Value, Variant};
use kerf_wire::{OperationEntry, OperationPart, OperationValue, OperationVariant};

/// Every operation, by chapter.
pub fn operations() -> Vec<OperationEntry> {
    ENTRIES
        .iter()
        .map(|entry| OperationEntry {
            name: entry.name.into(),
            doc: entry.doc.into(),
            variants: entry.variants().into_iter().map(variant).collect(),
        })
        .collect()
}

fn variant(Variant { form, parts }: Variant) -> OperationVariant {
    OperationVariant { form, parts: parts.into_iter().map(part).collect() }
}

fn part(Part { lead, value, optional, repeats }: Part) -> OperationPart {
    OperationPart { lead, value: value.map(entered), optional, repeats }
}

fn entered(value: Value) -> OperationValue {
    match value {
        Value::Pair => OperationValue::Pair,
        Value::Vertex => OperationValue::Vertex,
        Value::Triple => OperationValue::Triple,
        Value::Length(name) => OperationValue::Length { name },
        Value::Number(name) => OperationValue::Number { name },
        Value::Arc => OperationValue::Arc,
        Value::Grid => OperationValue::Grid,
        Value::Shape => OperationValue::Shape,
        Value::Shapes => OperationValue::Shapes,
        Value::Group => OperationValue::Group,
        Value::Groups => OperationValue::Groups,
        Value::Words(words, None) => OperationValue::Words { words },
        Value::Words(words, Some(number)) => {
            OperationValue::WordsOr { words, length: matches!(*number, Value::Length(_)) }
        }
        Value::File => OperationValue::File,
        Value::Text => OperationValue::Text,
    }
}
