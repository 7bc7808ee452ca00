//! Boards that the fake pretends to be.

use super::card::Card;

/// What a board tells of itself, and how much it holds.
#[derive(Clone, Debug)]
pub struct Board {
    /// The line with which it greets.
    pub greeting: &'static str,
    /// Its answer to `$I`.
    pub tells: Vec<String>,
    /// Bytes that its receive buffer holds.
    pub rx: usize,
    /// Moves that its planner holds.
    pub planner: usize,
    /// Auxiliary outputs (`M64`).
    pub aux: u8,
    /// It tells the line that it makes.
    pub numbers: bool,
    /// It knows the bits of `$10` and `$22` of grblHAL.
    pub hal: bool,
    /// Its card, where it has one.
    pub card: Option<Card>,
}

impl Board {
    /// grbl 1.1h on an Arduino, built as it comes.
    pub fn grbl() -> Self {
        let tells = vec!["[VER:1.1h.20190825:]".into(), "[OPT:V,15,128]".into()];
        let greeting = "Grbl 1.1h ['$' for help]";
        Self {
            greeting,
            tells,
            rx: 128,
            planner: 15,
            aux: 0,
            numbers: false,
            hal: false,
            card: None,
        }
    }

    /// grbl 1.1h with other letters of options.
    pub fn grbl_with(options: &str) -> Self {
        let tells = vec!["[VER:1.1h.20190825:]".into(), format!("[OPT:{options},15,128]")];
        Self { tells, ..Self::grbl() }
    }

    /// grblHAL, with so many auxiliary outputs; it says nothing of them when there are none.
    pub fn hal(aux: u8) -> Self {
        let mut tells: Vec<String> = [
            "[VER:1.1f.20260817:]",
            "[OPT:VNML+,100,1024,3,0]",
            "[AXS:3:XYZ]",
            "[NEWOPT:ENUMS,RT+,TC,SED]",
            "[FIRMWARE:grblHAL]",
            "[SIGNALS:D]",
        ]
        .map(String::from)
        .into();
        if aux > 0 {
            tells.push(format!("[AUX IO:2,{aux},0,0]"));
        }
        let greeting = "GrblHAL 1.1f ['$' or '$HELP' for help]";
        Self { greeting, tells, rx: 1024, planner: 100, aux, numbers: true, hal: true, card: None }
    }

    /// The same with a card, on which these files are.
    pub fn hal_with_card(files: &[(&str, &str)]) -> Self {
        let mut board = Self { card: Some(Card::with(files)), ..Self::hal(0) };
        for line in board.tells.iter_mut().filter(|line| line.starts_with("[NEWOPT:")) {
            *line = line.replace(']', ",SD,YM,FS]");
        }
        board
    }

    /// `FluidNC`, which tells no sizes.
    pub fn fluid() -> Self {
        let tells = ["[VER:4.0 FluidNC v4.0.0 (posix-) :]", "[OPT:MPHS]", "[MSG:Machine: Table]"];
        let greeting = "Grbl 4.0 [FluidNC v4.0.0 (posix) '$' for help]";
        let tells = tells.map(String::from).into();
        Self {
            greeting,
            tells,
            rx: 255,
            planner: 16,
            aux: 0,
            numbers: false,
            hal: false,
            card: None,
        }
    }

    /// The same with a card, on which these files are.
    pub fn fluid_with_card(files: &[(&str, &str)]) -> Self {
        Self { card: Some(Card::with(files).of_fluid()), ..Self::fluid() }
    }
}

/// Lists in words, of a board that has them: alarms, errors, groups of settings, settings.
pub const fn listed(command: &str) -> &'static [&'static str] {
    match command.as_bytes() {
        b"EA" => &["[ALARMCODE:1||A switch at the end of an axis closed.]"],
        b"EE" => &["[ERRORCODE:0||]", "[ERRORCODE:20||This board has no such word.]"],
        b"EG" => &["[SETTINGGROUP:43|0|X]"],
        _ => &["[SETTING:110|43|Quickest way|mm/min|6|####0.0|1|9000|0|0]"],
    }
}

/// The description of a setting, of a board that has such.
pub fn described(number: &str) -> String {
    let text = if number == "110" { r"How quick X may be.\n\nNOTE: rapid moves are." } else { "" };
    format!("[SETTINGDESCR:{number}|{text}]")
}
