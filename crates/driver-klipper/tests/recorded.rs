//! Sessions that were recorded of a real board, where they lie beside the checkout: the crate reads and writes the same
//! bytes, and the fake board does what the real one did.

use crate::shared;
use kerf_driver_klipper::dictionary::{Dictionary, Value, Wanted};
use kerf_driver_klipper::fake::words::Words;
use kerf_driver_klipper::fake::{Board, reader};
use kerf_driver_klipper::identify::Identify;
use kerf_driver_klipper::wire::frame::{Reader, frame};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

fn folder() -> Option<PathBuf> {
    let folder = shared::shared("anchors/step-queue");
    if folder.is_none() {
        println!("skipped: no recorded sessions");
    }
    folder
}

/// A line of a record.
struct Told {
    at_us: f64,
    host: bool,
    bytes: Vec<u8>,
    meaning: String,
}

fn record(name: &str) -> Option<Vec<Told>> {
    let text = fs::read_to_string(folder()?.join(name)).expect("a record");
    Some(text.lines().filter_map(told).collect())
}

fn told(line: &str) -> Option<Told> {
    let (head, meaning) = line.split_once(" | ")?;
    let mut words = head.split(' ');
    let at_us = words.next()?.parse().ok()?;
    let host = words.next()? == "H";
    let hex = words.next()?;
    let bytes = (0..hex.len() / 2).map(|n| u8::from_str_radix(&hex[2 * n..2 * n + 2], 16));
    Some(Told {
        at_us,
        host,
        bytes: bytes.collect::<Result<_, _>>().ok()?,
        meaning: meaning.to_owned(),
    })
}

fn dictionary() -> Option<Dictionary> {
    let mut identify = Identify::new(0.0);
    for told in record("01-connect.txt")?.into_iter().filter(|told| !told.host) {
        for frame in Reader::default().read(&told.bytes) {
            if let Some(found) = identify.heard(&frame.content, 0.0).expect("pieces") {
                return Some(found);
            }
        }
    }
    panic!("the record has the whole dictionary");
}

/// `name a=1 b=2` without what is said to people behind it.
fn said(text: &str) -> (String, Vec<(String, String)>) {
    let mut words = text.split(" -- ").next().unwrap_or_default().split(' ');
    let name = words.next().unwrap_or_default().to_owned();
    let field = |word: &str| word.split_once('=').map(|(a, b)| (a.to_owned(), b.to_owned()));
    (name, words.map_while(field).collect())
}

fn bytes_of(hex: &str) -> Vec<u8> {
    (0..hex.len() / 2)
        .map(|n| u8::from_str_radix(&hex[2 * n..2 * n + 2], 16).expect("hex"))
        .collect()
}

const FILES: [&str; 7] = [
    "02-configure.txt",
    "03-move.txt",
    "04-home.txt",
    "05-silent-host.txt",
    "06-emergency-stop.txt",
    "09-outputs-inputs.txt",
    "12-more.txt",
];

#[test]
fn what_a_real_board_said_is_read_with_the_same_fields() {
    let Some(dictionary) = dictionary() else { return };
    let mut read = 0;
    for told in FILES.iter().filter_map(|file| record(file)).flatten().filter(|told| !told.host) {
        for frame in Reader::default().read(&told.bytes).iter().filter(|f| !f.content.is_empty()) {
            let message = dictionary.message(&frame.content).expect("a message");
            let (name, fields) = said(&told.meaning);
            assert_eq!(message.name(), name);
            for (field, value) in fields.iter().filter(|(_, value)| !value.is_empty()) {
                match message.number(field) {
                    Some(number) if field == "pos" => {
                        assert_eq!((number as i32).to_string(), *value)
                    }
                    Some(number) => assert_eq!(number.to_string(), *value, "{field}"),
                    None => assert_eq!(message.bytes(field), Some(&bytes_of(value)[..]), "{field}"),
                }
            }
            read += 1;
        }
    }
    assert!(read > 50, "{read}");
}

#[test]
fn what_a_host_said_to_a_real_board_is_written_with_the_same_bytes() {
    let Some(dictionary) = dictionary() else { return };
    let mut written = 0;
    for told in FILES.iter().filter_map(|file| record(file)).flatten().filter(|told| told.host) {
        let Some((number, commands)) =
            told.meaning.strip_prefix("seq ").and_then(|m| m.split_once(": "))
        else {
            continue;
        };
        let commands = commands.split(" -- ").next().unwrap_or_default();
        let content: Vec<u8> =
            commands.trim().split("; ").flat_map(|command| encoded(&dictionary, command)).collect();
        let number = number.parse().expect("a number");
        assert_eq!(frame(number, &content), told.bytes, "{}", told.meaning);
        written += 1;
    }
    assert!(written > 150, "{written}");
}

fn encoded(dictionary: &Dictionary, command: &str) -> Vec<u8> {
    let (name, fields) = said(command);
    let leaked = |text: &str| -> &'static str { Box::leak(text.to_owned().into_boxed_str()) };
    let names: Vec<&'static str> = fields.iter().map(|(name, _)| leaked(name)).collect();
    let wanted = Wanted { name: leaked(&name), fields: Box::leak(names.into_boxed_slice()) };
    let value = |(field, text): &(String, String)| match text.parse::<i64>() {
        Ok(number) if field != "write" && field != "data" => Value::Number(number as u32),
        _ => Value::Bytes(bytes_of(text)),
    };
    let values: Vec<Value> = fields.iter().map(value).collect();
    dictionary.command(&wanted).expect(command).values(&values).expect(command)
}

/// The real board's words, for the fake one.
fn words(folder: &Path) -> Words {
    let text = fs::read_to_string(folder.join("messages.tsv")).expect("messages");
    let (mut commands, mut responses, mut reasons) = (vec![], vec![], vec![]);
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let parts: Vec<&str> = line.split('\t').collect();
        let Ok(number) = parts[1].parse::<i64>() else { continue };
        match parts[0] {
            ">" => commands.push((number, parts[3])),
            "<" => responses.push((number, parts[3])),
            _ => reasons.push((number as u32, parts[3])),
        }
    }
    Words::listed(&commands, &responses, &reasons)
}

/// A response with its fields, but for clocks, which are compared with a margin.
fn spoken(dictionary: &Dictionary, content: &[u8]) -> Option<(String, Option<u32>, Vec<Value>)> {
    let message = dictionary.message(content)?;
    let clocks = ["clock", "next_clock"];
    let clock = clocks.iter().find_map(|field| message.number(field));
    let values = message.values().iter().filter(|v| clock.is_none_or(|c| **v != Value::Number(c)));
    Some((message.name().to_owned(), clock, values.cloned().collect()))
}

#[test]
fn the_board_that_is_none_answers_as_the_real_one() {
    let (Some(folder), Some(dictionary)) = (folder(), dictionary()) else { return };
    for file in ["03-move.txt", "04-home.txt", "05-silent-host.txt", "06-emergency-stop.txt"] {
        let mut board = Board::new(words(&folder), 50e6, (1 << 32) - 50_000_000);
        board.stops_at = if file.starts_with("04") { vec![(10, 0, 600)] } else { vec![] };
        for told in record("02-configure.txt").expect("a record").iter().filter(|t| t.host).take(11)
        {
            run(&mut board, told);
        }
        board.take();
        board.expect(12);
        let expected: Vec<u8> = {
            let told = record(file).expect("a record");
            told.iter().filter(|told| told.host).for_each(|told| run(&mut board, told));
            told.iter().filter(|told| !told.host).flat_map(|told| told.bytes.clone()).collect()
        };
        let mut found = board.take();
        found.extend({
            let later = board.now + 50_000_000;
            board.run_to(later);
            board.take()
        });
        compare(&dictionary, file, &found, &expected);
    }
}

fn run(board: &mut Board, told: &Told) {
    // The real one reads bytes about a microsecond after they came.
    let clock = board.clock_at((told.at_us + 1.0) * 1e-6);
    board.run_to(clock);
    board.feed(&told.bytes);
}

fn compare(dictionary: &Dictionary, file: &str, found: &[u8], expected: &[u8]) {
    let list = |bytes: &[u8]| -> Vec<_> {
        let frames = Reader::default().read(bytes);
        let spoken = frames.iter().filter_map(|frame| spoken(dictionary, &frame.content));
        spoken.filter(|(name, _, _)| name != "stats").collect()
    };
    let (found, expected) = (list(found), list(expected));
    for (found, expected) in found.iter().zip(&expected) {
        assert_eq!((&found.0, &found.2), (&expected.0, &expected.2), "{file}");
        let apart = found.1.zip(expected.1).map_or(0, |(a, b)| a.wrapping_sub(b) as i32).abs();
        assert!(apart < 400, "{file}: {} {apart} ticks apart", found.0);
    }
    assert!(found.len() >= expected.len(), "{file}: {} of {}", found.len(), expected.len());
}

#[test]
fn the_board_that_is_none_steps_when_the_real_one_does() {
    let Some(folder) = folder() else { return };
    let mut board = Board::new(words(&folder), 50e6, (1 << 32) - 50_000_000);
    for file in ["02-configure.txt", "03-move.txt"] {
        let take = if file.starts_with("02") { 11 } else { usize::MAX };
        board.expect(if take == 11 { 0 } else { 12 });
        record(file)
            .expect("a record")
            .iter()
            .filter(|t| t.host)
            .take(take)
            .for_each(|t| run(&mut board, t));
    }
    let pins = fs::read_to_string(folder.join("03-move.pins.txt")).expect("pins");
    let mut expected: BTreeMap<u32, Vec<(u32, bool)>> = BTreeMap::new();
    for line in pins.lines().filter(|line| !line.starts_with('#')) {
        let n: Vec<u32> = line.split(' ').map(|word| word.parse().expect("a number")).collect();
        expected.entry(n[1]).or_default().push((n[0], n[2] == 1));
    }
    for (pin, expected) in expected {
        let found: Vec<_> = board.edges.iter().filter(|edge| edge.pin == pin).collect();
        assert_eq!(found.len(), expected.len(), "pin {pin}");
        for (found, (clock, level)) in found.iter().zip(expected) {
            assert_eq!(found.level, level, "pin {pin} at {clock}");
            let apart = (found.clock as u32).wrapping_sub(clock) as i32;
            assert!(apart.abs() < 60, "pin {pin} at {clock}: {apart}");
        }
    }
    assert_eq!(board.steppers[&0].position, 1575);
    assert_eq!(reader::crc(b"123456789"), 0x6f91);
}
