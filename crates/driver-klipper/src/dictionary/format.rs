//! The format of a message: `name field=%u other=%*s`.

/// Width and sign of a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// 8 bits.
    Byte,
    /// 16 bits without sign.
    Word,
    /// 16 bits with sign.
    SignedWord,
    /// 32 bits without sign.
    Long,
    /// 32 bits with sign.
    SignedLong,
    /// Bytes behind their number.
    Bytes,
}

/// A field of a message.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Field {
    /// Its name; empty in a line for people.
    pub name: String,
    /// Its kind.
    pub kind: Kind,
}

/// The format of a message with its number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Format {
    /// The number, as its 32 bits.
    pub number: u32,
    /// The name: its first word.
    pub name: String,
    /// The fields in their order.
    pub fields: Vec<Field>,
}

impl Format {
    /// Reads the text of a command or an answer; the error is the word that is no field.
    pub fn read(text: &str, number: u32) -> Result<Self, String> {
        let mut words = text.split_whitespace();
        let name = words.next().ok_or("a message without a name")?.to_owned();
        let field = |word: &str| {
            let (name, code) = word.split_once('=')?;
            Some(Field { name: name.to_owned(), kind: kind(code)? })
        };
        let fields: Result<_, _> =
            words.map(|word| field(word).ok_or(format!("`{word}` in `{text}`"))).collect();
        Ok(Self { number, name, fields: fields? })
    }

    /// Reads a line for people, which has codes within its words.
    pub fn line(text: &str, number: u32) -> Self {
        let codes = text.split('%').skip(1).filter_map(|rest| {
            let end = rest.find(|c: char| c.is_ascii_alphabetic() && c != 'h')?;
            kind(&format!("%{}", &rest[..=end]))
        });
        let fields = codes.map(|kind| Field { name: String::new(), kind }).collect();
        Self { number, name: text.to_owned(), fields }
    }
}

fn kind(code: &str) -> Option<Kind> {
    Some(match code {
        "%c" => Kind::Byte,
        "%hu" => Kind::Word,
        "%hi" => Kind::SignedWord,
        "%u" => Kind::Long,
        "%i" => Kind::SignedLong,
        "%s" | "%*s" | "%.*s" => Kind::Bytes,
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(format: &Format, fields: &[(&str, Kind)]) {
        let found: Vec<_> = format.fields.iter().map(|f| (f.name.as_str(), f.kind)).collect();
        assert_eq!(found, fields);
    }

    #[test]
    fn formats_are_read() -> Result<(), String> {
        let text = "queue_step oid=%c interval=%u count=%hu add=%hi";
        let fields = [
            ("oid", Kind::Byte),
            ("interval", Kind::Long),
            ("count", Kind::Word),
            ("add", Kind::SignedWord),
        ];
        check(&Format::read(text, 7)?, &fields);
        check(
            &Format::read("spi_send oid=%c data=%*s", 7)?,
            &[("oid", Kind::Byte), ("data", Kind::Bytes)],
        );
        check(
            &Format::line("at %hu of %i: %*s!", 7),
            &[("", Kind::Word), ("", Kind::SignedLong), ("", Kind::Bytes)],
        );
        Ok(())
    }

    #[test]
    fn words_that_are_no_fields_are_named() {
        let refused = |text| Format::read(text, 7).err();
        assert_eq!(refused("a b=%q"), Some("`b=%q` in `a b=%q`".to_owned()));
        assert_eq!(refused("a b"), Some("`b` in `a b`".to_owned()));
        assert_eq!(refused(" "), Some("a message without a name".to_owned()));
    }
}
