//! A dictionary from the bytes that a board sends.

use super::{Dictionary, DictionaryError, Format};
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// Longest dictionary, bytes as JSON. Known ones have 12 thousand.
const LONGEST: usize = 1 << 20;
/// Most words of a range of numbers, such as the pins of a port.
const LONGEST_RANGE: u64 = 1 << 12;

type Read<T> = Result<T, DictionaryError>;

/// Reads a zlib stream of JSON.
pub fn dictionary(packed: &[u8]) -> Read<Dictionary> {
    let text = miniz_oxide::inflate::decompress_to_vec_zlib_with_limit(packed, LONGEST)
        .map_err(|_| DictionaryError::Packed)?;
    let all: Value = serde_json::from_slice(&text).map_err(|_| bad("no JSON"))?;
    let part = |key: &str| all.get(key).and_then(Value::as_object);
    let version = all.get("version").and_then(Value::as_str).unwrap_or_default().to_owned();
    let mut found = Dictionary { version, ..Dictionary::default() };
    for (text, number) in part("commands").ok_or_else(|| bad("no commands"))? {
        let format = Format::read(text, whole(number)?).map_err(DictionaryError::Content)?;
        found.commands.insert(format.name.clone(), format);
    }
    for (text, number) in part("responses").ok_or_else(|| bad("no responses"))? {
        let format = Format::read(text, whole(number)?).map_err(DictionaryError::Content)?;
        found.responses.insert(format.number, format);
    }
    for (text, number) in part("output").into_iter().flatten() {
        let format = Format::line(text, whole(number)?);
        found.responses.insert(format.number, format);
    }
    for (name, value) in part("config").into_iter().flatten() {
        constant(&mut found, name, value);
    }
    for (name, words) in part("enumerations").into_iter().flatten() {
        let words = words.as_object().ok_or_else(|| bad(&format!("enumeration `{name}`")))?;
        found.enumerations.insert(name.clone(), enumeration(words)?);
    }
    Ok(found)
}

fn bad(what: &str) -> DictionaryError {
    DictionaryError::Content(what.to_owned())
}

fn whole(number: &Value) -> Read<u32> {
    let whole = number.as_i64().filter(|n| (i64::from(i32::MIN)..=i64::from(u32::MAX)).contains(n));
    whole.map(|n| n as u32).ok_or_else(|| bad(&format!("number {number}")))
}

fn constant(found: &mut Dictionary, name: &str, value: &Value) {
    if let Some(text) = value.as_str() {
        found.texts.insert(name.to_owned(), text.to_owned());
    } else if let Some(number) = value.as_f64() {
        found.numbers.insert(name.to_owned(), number);
    }
}

fn enumeration(words: &Map<String, Value>) -> Read<BTreeMap<String, u32>> {
    let mut found = BTreeMap::new();
    for (word, value) in words {
        match value.as_array().map(Vec::as_slice) {
            None => _ = found.insert(word.clone(), whole(value)?),
            Some([first, count]) => found.extend(range(word, whole(first)?, count.as_u64())?),
            Some(_) => return Err(bad(&format!("range `{word}`"))),
        }
    }
    Ok(found)
}

/// Names the words of a range: `gpio0` with 3 gives `gpio0`, `gpio1`, `gpio2`.
fn range(word: &str, first: u32, count: Option<u64>) -> Read<Vec<(String, u32)>> {
    let count = count.filter(|count| *count <= LONGEST_RANGE);
    let stem = word.trim_end_matches(|c: char| c.is_ascii_digit());
    let (Some(count), Ok(start)) = (count, word[stem.len()..].parse::<u32>()) else {
        return Err(bad(&format!("range `{word}`")));
    };
    let name = |n: u32| (format!("{stem}{}", start.wrapping_add(n)), first.wrapping_add(n));
    Ok((0..count as u32).map(name).collect())
}
