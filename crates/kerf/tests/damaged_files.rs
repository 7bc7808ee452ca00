//! Each file of the data folder emptied, halved, changed in one bit, gone, or replaced by an older one; then `kerf serve`
//! starts. Nothing is lost without a word. Makes the page docs/book/damaged-files.md: `KERF_BLESS=1 cargo test -p kerf
//! --test all damaged_files::` writes it anew.

#![cfg(unix)]

use crate::shop::console::Console;
use crate::shop::{Shop, until};
use kerf_journal::Journal;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Files by their names; those that are locks or beside the journal are made anew by every start.
type Files = BTreeMap<String, Vec<u8>>;

fn files_of(folder: &Path) -> Files {
    let file = |entry: fs::DirEntry| {
        let name = entry.file_name().into_string().unwrap();
        entry.path().is_file().then(|| (name, fs::read(entry.path()).unwrap()))
    };
    let made_anew = |name: &String| {
        name.ends_with(".lock") || name.ends_with("-shm") || name == "served-at.txt"
    };
    let entries = fs::read_dir(folder).unwrap().map(Result::unwrap);
    entries.filter_map(file).filter(|(name, _)| !made_anew(name)).collect()
}

/// Values that are kept, X in inches, the speed of cuts in `machine.toml`, shapes of the drawing that is not saved, paired
/// devices.
const WHOLE: (usize, f64, &str, usize, usize) = (60, 2.0, "50", 2, 2);

/// A text with its digest before it, as Kerf writes it.
fn with_digest(text: &str) -> String {
    let digest: String = Sha256::digest(text).iter().map(|byte| format!("{byte:02x}")).collect();
    format!("digest {digest}\n{text}")
}

/// Writes a list of so many paired devices as Kerf does, which has written as many lists.
fn write_devices(shop: &Shop, many: usize) {
    let hash = |n: usize| format!("{n:064x}");
    let device = |n| json!({ "number": n, "name": "pad", "role": "operator", "hash": hash(n) });
    let list = serde_json::to_string_pretty(&(1..=many).map(device).collect::<Vec<_>>()).unwrap();
    let list = with_digest(&format!("written {many}\n{list}"));
    shop.write("data/devices.json", list.as_bytes());
    shop.write("data/devices.json.mark", with_digest(&format!("{many} kept\n")).as_bytes());
}

/// A data folder as a kill leaves it, with the newest changes in the write-ahead file; and the same at an earlier time.
fn folders() -> (Files, Files) {
    let shop = Shop::new(&[]);
    let data = shop.file("data");
    let values = |numbers: std::ops::Range<u32>| {
        let (journal, _) = Journal::open(&data).unwrap();
        numbers.for_each(|n| journal.registry.set_value(&format!("key{n}"), Some("kept")).unwrap());
        journal
    };
    let drawn = |clauses: &str| {
        let console = Console::begin(&shop, &[]);
        let op = format!("{{\"op\":{{\"op\":\"do\",\"clauses\":\"{clauses}\"}}}}");
        let bytes = || fs::read(data.join("drawing.draft")).map_or(0, |it| it.len());
        let mark = || fs::read(data.join("drawing.draft.mark")).ok();
        let (before, marked) = (bytes(), mark());
        console.ask("POST /api/do/draw", &op);
        // The mark follows the file: a kill between both leaves a file of which an older copy is not noticed.
        until("the draft and its mark", || bytes() > before && mark() != marked);
    };
    shop.kerf("machine set speeds.cut.xy 101.6").exits(0);
    shop.kerf("send MX,1 --quiet").exits(0);
    values(0..30).rest().unwrap();
    shop.kerf("send MX,1 --quiet").exits(0);
    drawn("line 0,0 10,0");
    write_devices(&shop, 1);
    let older = files_of(&data);
    write_devices(&shop, 2);
    drawn("line 0,5 10,5");
    shop.kerf("machine set speeds.cut.xy 50").exits(0);
    shop.kerf("send MX,2 --quiet").exits(0);
    let journal = values(30..60);
    let newer = files_of(&data);
    drop(journal);
    (older, newer)
}

/// The start of a server in a data folder.
#[derive(Debug, PartialEq)]
struct Start {
    told: Vec<String>,
    verified: bool,
    armed: bool,
    kept: (usize, f64, String, usize, usize),
}

impl Start {
    /// A server is started; `None` where it refuses.
    fn of(files: &Files) -> Result<Self, String> {
        let shop = Shop::new(&[]);
        files.iter().for_each(|(name, bytes)| shop.write(&format!("data/{name}"), bytes));
        let console = Console::begin(&shop, &[]);
        if console.url.is_empty() {
            let did = shop.kerf("serve --listen 127.0.0.1:0");
            return Err(plain(&did.exits(1).err(), &shop.file("data")));
        }
        let state = console.ask("GET /api/state", "");
        let values = console.ask("GET /api/registry", "");
        let paired = console.ask("GET /api/devices", "").as_array().map_or(0, Vec::len);
        let kept = |it: &&Value| it["value"] == "kept";
        let values = values.as_array().map_or(0, |values| values.iter().filter(kept).count());
        drop(console);
        let speed = shop.kerf("machine get speeds.cut.xy").out();
        let told = |message: &Value| plain(message["text"].as_str().unwrap(), &shop.file("data"));
        let shapes = state["drawing"]["shapes"].as_u64().unwrap_or_default() as usize;
        let x = state["motion"]["at"]["working"][0].as_f64().unwrap() / 25.4;
        Ok(Self {
            told: state["messages"].as_array().unwrap().iter().map(told).collect(),
            verified: state["machine"]["why"].is_null(),
            armed: state["machine"]["armed"] == true,
            kept: (values, (x * 1000.0).round() / 1000.0, speed.trim().to_owned(), shapes, paired),
        })
    }

    fn is_whole(&self) -> bool {
        let (values, x, speed, shapes, paired) = WHOLE;
        self.kept == (values, x, speed.to_owned(), shapes, paired)
    }

    /// Tells of the damage: lines that an undamaged folder does not have.
    fn news(&self, usual: &Self) -> Vec<String> {
        let news = self.told.iter().filter(|line| !usual.told.contains(line));
        // The page has columns for that.
        let also = [
            "rows saved",
            "row saved",
            "from the copy",
            "ocations are not verified",
            "machine stands",
        ];
        let said = |line: &&String| {
            line.contains("machine.toml") || !also.iter().any(|it| line.contains(it))
        };
        news.filter(said).cloned().collect()
    }

    fn kept(&self) -> String {
        let (values, x, speed, shapes, paired) = &self.kept;
        if self.is_whole() {
            return "everything".into();
        }
        let devices = if *paired == 2 { String::new() } else { format!(", {paired} of 2 devices") };
        format!("{values} of 60 values, X {x}, cut speed {speed}, {shapes} shapes{devices}")
    }
}

/// A message without what changes from one machine to another.
fn plain(text: &str, data: &Path) -> String {
    let text = text.replace(&format!("{}/", data.display()), "");
    let mut words = text.split_whitespace().collect::<Vec<_>>();
    if let Some(at) = words.iter().position(|word| *word == "last") {
        words.retain({
            let mut place = 0;
            move |_| {
                place += 1;
                place != at + 2
            }
        });
    }
    words.join(" ")
}

/// Damage to a file.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Damage {
    Emptied,
    Halved,
    Gone,
    Older,
    Flipped(usize),
}

/// So many places of a file are changed in one bit, one after the other.
const FLIPS: usize = 5;

impl Damage {
    fn does(self, files: &Files, older: &Files, name: &str) -> Option<Files> {
        let mut files = files.clone();
        let bytes = files.get_mut(name)?;
        match self {
            Self::Emptied => bytes.clear(),
            Self::Halved => *bytes = half(bytes, name),
            Self::Gone => drop(files.remove(name)),
            Self::Older => *bytes = older.get(name).filter(|it| *it != bytes)?.clone(),
            Self::Flipped(place) => {
                let at = (2 * place + 1) * bytes.len() / (2 * FLIPS);
                *bytes.get_mut(at)? ^= 4;
            }
        }
        Some(files)
    }

    const fn word(self) -> &'static str {
        match self {
            Self::Emptied => "emptied",
            Self::Halved => "halved",
            Self::Gone => "gone",
            Self::Older => "an older one",
            Self::Flipped(_) => "one bit",
        }
    }
}

/// Half of a file: of the seal, whose two lines are written in turn, the newer one.
fn half(bytes: &[u8], name: &str) -> Vec<u8> {
    let (first, second) = bytes.split_at(bytes.len() / 2);
    let kept = if name == "journal.seal" { first.max(second) } else { first };
    kept.to_vec()
}

/// Files that only say what happened, or what is told anew at every start: nothing is read from them.
fn is_log(name: &str) -> bool {
    name.ends_with(".log") || name == "registry.txt"
}

/// Nothing is lost without a word; what concerns the machine makes its location unverified; nothing is armed.
fn check(what: &str, start: &Start, usual: &Start) {
    let news = start.news(usual);
    assert!(!start.armed, "{what}");
    assert!(start.is_whole() || !news.is_empty(), "{what}: lost without a word: {start:?}");
    let (_, x, ref speed, ..) = start.kept;
    let doubtful = x != WHOLE.1 || speed != WHOLE.2;
    assert!(!doubtful || !start.verified, "{what}: trusted: {start:?}");
}

fn row(name: &str, damage: Damage, start: &Result<Start, String>, usual: &Start) -> String {
    let (told, location, kept) = match start {
        Err(told) => (told.clone(), "nothing starts", "the file as it is".to_owned()),
        Ok(start) => {
            let told = start.news(usual).join(" · ");
            let location = if start.verified { "as it was" } else { "not verified" };
            (if told.is_empty() { "nothing".into() } else { told }, location, start.kept())
        }
    };
    format!("| {name} | {} | {} | {location} | {kept} |\n", damage.word(), told.replace('|', "\\|"))
}

/// One bit in several places; the page says what holds for all of them.
fn flipped(name: &str, files: &Files, older: &Files, usual: &Start) -> String {
    for place in 0..FLIPS {
        let damage = Damage::Flipped(place);
        let Some(files) = damage.does(files, older, name) else { continue };
        if let Ok(start) = Start::of(&files) {
            check(&format!("{name}, bit {place}"), &start, usual);
        }
    }
    let told = match name {
        _ if is_log(name) || name.ends_with(".mark") => "nothing",
        "drawing.draft" | "devices.json" | "journal.seal" => "as when it is halved",
        _ => "nothing where nothing is lost, else as when it is halved",
    };
    format!("| {name} | one bit | {told} | | |\n")
}

const HEAD: &str = "# When a file of the data folder is damaged

Made by a test (`crates/kerf/tests/damaged_files.rs`), which does this to each file of a data folder that a killed `kerf serve` left,
and starts the server in it. The machine is disarmed after every start. Where its location is *not verified*, nothing cuts before
somebody has homed it, zeroed its axes, or said that the location is right.

Not noticed is the folder whole as it was at an earlier time: then every file fits every other. Whoever brings back a whole folder homes
the machine.

| file | what happened to it | what is told | location | what is left |
|---|---|---|---|---|
";

/// Without the line and column of a file that grows with every version of Kerf.
fn without_places(page: &str) -> String {
    let mut parts = page.split(" at line ");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |page, part| {
        page + part.trim_start_matches(|c: char| c.is_ascii_digit() || " column".contains(c))
    })
}

#[test]
fn nothing_is_lost_without_a_word() {
    let (older, newer) = folders();
    assert!(
        newer["journal.db-wal"].len() > 10_000,
        "the newest changes are in the write-ahead file"
    );
    let usual = Start::of(&newer).unwrap();
    assert!(usual.is_whole() && usual.verified && !usual.armed, "{usual:?}");
    let mut page = HEAD.to_owned();
    for name in newer.keys() {
        for damage in [Damage::Emptied, Damage::Halved, Damage::Gone, Damage::Older] {
            let Some(files) = damage.does(&newer, &older, name) else { continue };
            let start = Start::of(&files);
            if let Ok(start) = &start {
                check(&format!("{name} {}", damage.word()), start, &usual);
            }
            page += &row(name, damage, &start, &usual);
        }
        page += &flipped(name, &newer, &older, &usual);
    }
    let page = without_places(&page);
    println!("{page}");
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../docs/book/damaged-files.md");
    if std::env::var_os("KERF_BLESS").is_some() {
        fs::write(&path, &page).unwrap();
    }
    assert_eq!(page, fs::read_to_string(&path).unwrap(), "KERF_BLESS=1 writes it anew");
}
