//! The keys.

/// One of the sixteen keys.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// 0 … 9.
    Digit(u8),
    /// The sign.
    PlusMinus,
    /// Enter.
    Enter,
    /// File; in numbers the point, for which there is no key.
    File,
    /// Start.
    Start,
    /// Stop.
    Stop,
    /// Func.
    Func,
}

impl Key {
    /// Every key.
    pub const ALL: [Self; 16] = [
        Self::Digit(0),
        Self::Digit(1),
        Self::Digit(2),
        Self::Digit(3),
        Self::Digit(4),
        Self::Digit(5),
        Self::Digit(6),
        Self::Digit(7),
        Self::Digit(8),
        Self::Digit(9),
        Self::PlusMinus,
        Self::Enter,
        Self::File,
        Self::Start,
        Self::Stop,
        Self::Func,
    ];

    /// The character that stands for it on a serial link and in messages: a digit, `-`, carriage return, `F`
    /// File, `S` Start, `P` Stop, `U` Func.
    pub const fn character(self) -> char {
        match self {
            Self::Digit(digit) => (b'0' + digit % 10) as char,
            Self::PlusMinus => '-',
            Self::Enter => '\r',
            Self::File => 'F',
            Self::Start => 'S',
            Self::Stop => 'P',
            Self::Func => 'U',
        }
    }

    /// The key of a character; nothing for a character that none has.
    pub fn of(character: char) -> Option<Self> {
        Self::ALL.into_iter().find(|key| key.character() == character)
    }
}
