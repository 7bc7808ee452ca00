//! The table of boards, read.

use super::{KnownBoard, MotorPlug, Plug, Wire};
use toml::{Table, Value};

/// The table.
const TABLE: &str = include_str!("boards.toml");

/// The reason for which a board is not known.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum BoardsError {
    /// No board has this name.
    #[error("no board is called {name}; {hint}")]
    Unknown {
        /// The name.
        name: String,
        /// The nearest one, or where to look.
        hint: String,
    },
    /// A row of the table cannot be read.
    #[error("the table of boards is damaged at {0}: install Kerf anew")]
    Damaged(String),
}

/// Returns every board, in the order of the table.
///
/// # Errors
/// Never, as a test holds: the table is a part of the program.
pub fn all() -> Result<Vec<KnownBoard>, BoardsError> {
    let table: Table =
        TABLE.parse().map_err(|why: toml::de::Error| BoardsError::Damaged(why.to_string()))?;
    let rows = table.get("board").and_then(Value::as_array);
    rows.into_iter().flatten().filter_map(Value::as_table).map(Row::board).collect()
}

/// A board of the table, with its name.
struct Row<'a>(&'a Table);

impl Row<'_> {
    fn board(table: &Table) -> Result<KnownBoard, BoardsError> {
        let row = Row(table);
        Ok(KnownBoard {
            name: row.text("name").to_owned(),
            title: row.text("title").to_owned(),
            chips: row.words("chip"),
            uart: row.uart(),
            spi: row.words("spi").try_into().ok(),
            motors: row.motors()?,
            ends: row.plugs("ends")?,
            outputs: row.plugs("outputs")?,
            servo: row.words("servo").pop(),
            probe: row.words("probe").pop(),
        })
    }

    fn text(&self, key: &str) -> &str {
        self.0.get(key).and_then(Value::as_str).unwrap_or_default()
    }

    fn words(&self, key: &str) -> Vec<String> {
        self.text(key).split_whitespace().map(str::to_owned).collect()
    }

    fn damaged(&self, what: &str) -> BoardsError {
        BoardsError::Damaged(format!("{}: {what}", self.text("name")))
    }

    fn uart(&self) -> Option<[String; 2]> {
        let words = self.words("uart");
        Some([words.first()?.clone(), words.last()?.clone()])
    }

    fn plugs(&self, key: &str) -> Result<Vec<Plug>, BoardsError> {
        let plug = |entry: &str| {
            let (name, pin) = entry.trim().split_once(' ').ok_or_else(|| self.damaged(entry))?;
            Ok(Plug { name: name.to_owned(), pin: pin.to_owned() })
        };
        self.text(key).split(',').map(plug).collect()
    }

    fn motors(&self) -> Result<Vec<MotorPlug>, BoardsError> {
        let rows = self.0.get("motors").and_then(Value::as_array);
        let texts = rows.into_iter().flatten().filter_map(Value::as_str);
        texts.map(|text| motor(text).ok_or_else(|| self.damaged(text))).collect()
    }
}

/// Reads a motor: its name, step, direction, enable, its wire or address, then the driver and its resistors.
fn motor(text: &str) -> Option<MotorPlug> {
    let mut words = text.split(' ').map(str::to_owned);
    let [name, step, dir, enable] = [words.next()?, words.next()?, words.next()?, words.next()?];
    let wire = words.next()?;
    let wire = match &*wire {
        "-" => Wire::None,
        _ => wire.parse().map_or(Wire::Own(wire), Wire::Shared),
    };
    let driver = words.next();
    let ohms = words.next().map(|ohms| ohms.parse()).transpose().ok()?;
    Some(MotorPlug { name, step, dir, enable, wire, driver, ohms })
}
