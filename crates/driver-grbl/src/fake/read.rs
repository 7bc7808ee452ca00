//! Lines of G-code that the fake understands.

/// The way in which places are reached; it holds until another is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// `G0`.
    Rapid,
    /// `G1`.
    Cut,
    /// `G2`, `G3`.
    Arc {
        /// Counter-clockwise.
        counter: bool,
    },
    /// `G38.2` and the others.
    Probe,
}

/// Words of a line.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Words {
    /// Its places are ways.
    pub relative: Option<bool>,
    /// Its lengths are inches, from then on.
    pub inches: Option<bool>,
    /// It moves until its probe is in this state.
    pub probes: Option<bool>,
    pub to: [Option<f64>; 3],
    /// The centre of an arc, from where it begins.
    pub centre: [f64; 2],
    /// The number of the line.
    pub number: u32,
    pub feed_mm_min: Option<f64>,
    pub spindle_rpm: Option<f64>,
    pub spindle: Option<bool>,
    /// 0 for all off, or the bit of what comes on.
    pub coolant: Option<u8>,
    /// An auxiliary output, and its state.
    pub aux: Option<(u8, bool)>,
    /// The way in which places are reached from then on.
    pub way: Option<Way>,
    /// Its places are those of the machine.
    pub machine: bool,
    /// It changes the tool.
    pub changes_tool: bool,
    /// Everything before it is made first.
    pub waits: bool,
}

impl Words {
    /// Takes its lengths for inches.
    pub fn in_inches(&mut self) {
        const MM: f64 = 25.4;
        self.to.iter_mut().flatten().chain(&mut self.feed_mm_min).for_each(|mm| *mm *= MM);
        self.centre.iter_mut().for_each(|mm| *mm *= MM);
    }
}

/// Reads a line; the number of the error where it is none that is understood.
pub fn read(line: &str) -> Result<Words, u16> {
    let mut words = Words::default();
    let mut rest = line;
    while let Some(letter) = rest.chars().next() {
        let body = &rest[letter.len_utf8()..];
        let end = body.find(|c: char| c.is_ascii_alphabetic()).unwrap_or(body.len());
        let value: f64 = body[..end].trim().parse().map_err(|_| 2_u16)?;
        take(&mut words, letter, value)?;
        rest = &body[end..];
    }
    Ok(words)
}

fn take(words: &mut Words, letter: char, value: f64) -> Result<(), u16> {
    match (letter, value as i64) {
        ('G', 38) => {
            (words.probes, words.waits, words.way) = (Some(value < 38.4), true, Some(Way::Probe));
        }
        ('G', 53) => words.machine = true,
        ('G', 90 | 91) => words.relative = Some(value == 91.0),
        ('G', 0 | 1) => {
            words.way = Some(if value == 0.0 { Way::Rapid } else { Way::Cut });
        }
        ('G', 2 | 3) => {
            words.way = Some(Way::Arc { counter: value == 3.0 });
        }
        ('I', _) => words.centre[0] = value,
        ('J', _) => words.centre[1] = value,
        ('N', _) => words.number = value as u32,
        ('G', 20 | 21) => words.inches = Some(value == 20.0),
        ('G', 4 | 17 | 40 | 49 | 54 | 64 | 80 | 94) => {}
        ('M', 0 | 2 | 30) => {}
        ('M', 3) => (words.spindle, words.waits) = (Some(true), true),
        ('M', 5) => (words.spindle, words.waits) = (Some(false), true),
        ('M', 6) => (words.changes_tool, words.waits) = (true, true),
        ('T', _) => {}
        ('M', 7) => (words.coolant, words.waits) = (Some(2), true),
        ('M', 8) => (words.coolant, words.waits) = (Some(1), true),
        ('M', 9) => (words.coolant, words.waits) = (Some(0), true),
        ('M', 64 | 65) => (words.aux, words.waits) = (Some((0, value == 64.0)), true),
        ('P', _) => words.aux = words.aux.map(|(_, on)| (value as u8, on)),
        ('F', _) => words.feed_mm_min = Some(value),
        ('S', _) => (words.spindle_rpm, words.waits) = (Some(value), true),
        ('X', _) => words.to[0] = Some(value),
        ('Y', _) => words.to[1] = Some(value),
        ('Z', _) => words.to[2] = Some(value),
        ('G' | 'M', _) => return Err(20),
        _ => return Err(1),
    }
    Ok(())
}
